"""The mechanism comes apart into the textbook's groups, and its degrees of freedom are counted as the book does."""

from __future__ import annotations

from math import radians, tan

import pytest

from tests.oracle.test_oracle_models import (
    a16,
    a26,
    class_three,
    crank_and_slot,
    geared,
    guide_rod,
    guided,
    link,
    make,
    peaucellier,
    pins,
    sine,
)
from vecpoly import load, loads, solve
from vecpoly.errors import MobilityError
from vecpoly.mechanism.groups.assur import decompose, hinges
from vecpoly.mechanism.groups.mobility import check, mobility
from vecpoly.mechanism.model import Circle, Drive, Mechanism, Prismatic, Revolute, Rolling


def groups(mech: Mechanism) -> list[str]:
    return [f"{g.kind} {' '.join(g.links)}" for g in decompose(mech)]


def press_2_10(driving: str) -> Mechanism:
    """2-10: crank AB, four-bar with coupler point F, dyad 4-5, dyad 6-7 with a slider."""
    mech = make(
        {"A": 0, "D": 140 - 30j, "G": 230 + 60j},
        [
            link("1", A=0, B=40),
            link("2", B=0, C=103, F=70 + 50j),
            link("3", D=0, C=92),
            link("4", F=0, E=100),
            link("5", G=0, E=114, P=60),
            link("6", P=0, H=86),
            link("7", H=0),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, F 2 4, E 4 5, G 5 0, P 5 6, H 6 7") + guided("0", "7", "H", origin=130j),
        (60.0, 1.0),
    )
    return Mechanism(
        frame=mech.frame, links=mech.links, joints=mech.joints, drives=(Drive(link=driving, position=0.0, rate=1.0),)
    )


@pytest.mark.parametrize(
    ("mech", "expected"),
    [
        (a26(), ["RRR 2 3", "RRR 4 5"]),
        (sine(0.05, 33.0, 10.0), ["RPP 2 3"]),
        (guide_rod(), ["PRP 2 3"]),
        (crank_and_slot(), ["RRP 2 3", "RPR 4 5"]),
        (geared(), ["RRG 2 3", "RRG 6 4"]),
        (a16(), ["RRP 3 2", "RPR 4 5"]),
        (class_three(), ["class III 2 3 4 5"]),
        (
            peaucellier(0.05, 0.07, 0.15, 0.062, 0.14, 0.078, 0.066, -0.085 - 0.01j, 62.0),
            ["RRR 2 3", "RRR 4 5", "RRR 6 7"],
        ),
        (press_2_10("1"), ["RRR 2 3", "RRR 4 5", "RRP 6 7"]),
        (press_2_10("5"), ["RRP 6 7", "class III 1 2 3 4"]),
    ],
)
def test_mechanism_comes_apart_into_the_groups_of_the_book(mech: Mechanism, expected: list[str]) -> None:
    assert groups(mech) == expected
    assert mobility(mech).freedom == 1


def test_dyad_of_a_slider_has_its_outer_hinge_first() -> None:
    dyad = decompose(crank_and_slot())[0].dyad
    assert dyad is not None
    assert (dyad.link_j, dyad.link_k, dyad.parent_j, dyad.parent_k) == ("2", "3", "1", "0")
    assert (
        isinstance(dyad.outer_j, Revolute) and isinstance(dyad.inner, Revolute) and isinstance(dyad.outer_k, Prismatic)
    )


def test_sine_mechanism_has_outer_hinge_inner_slide_outer_slide() -> None:
    dyad = decompose(sine(0.05, 33.0, 10.0))[0].dyad
    assert dyad is not None
    assert (dyad.link_j, dyad.link_k, dyad.parent_j, dyad.parent_k) == ("2", "3", "1", "0")
    assert isinstance(dyad.inner, Prismatic) and isinstance(dyad.outer_k, Prismatic)


def test_rolling_gear_hangs_on_its_rack_or_gear() -> None:
    first, second = (group.dyad for group in decompose(geared()))
    assert first is not None and second is not None
    assert isinstance(first.outer_k, Rolling) and first.parent_k == "0"
    assert isinstance(second.outer_k, Rolling) and (second.link_k, second.parent_k) == ("4", "3")


def test_compound_hinge_pins_any_two_of_its_links() -> None:
    """2-4 and 1-2 are the written hinges at B, yet link 4 hangs on the crank, its first known neighbour."""
    mech = peaucellier(0.05, 0.07, 0.15, 0.062, 0.14, 0.078, 0.066, -0.085 - 0.01j, 62.0)
    assert hinges(mech)["B"] == ("1", "2", "4")
    second = decompose(mech)[1].dyad
    assert second is not None and second.parent_j == "1"


def test_held_gear_counts_as_higher_pair_and_forms_a_group_of_its_own() -> None:
    mech = make(
        {"O": 0, "P": 90},
        [link("1", O=0), link("2", P=0)],
        (
            *pins("O 0 1, P 0 2"),
            Rolling(
                point="K", gear=Circle(link="2", centre="P", radius=30), on=Circle(link="1", centre="O", radius=60)
            ),
        ),
        (0.0, 1.0),
    )
    count = check(mech)
    assert (count.lower, count.higher, count.freedom) == (2, 1, 1)
    assert groups(mech) == ["gear 2"]


def test_counts_of_the_geared_rack_mechanism() -> None:
    """3-13 with rolling contacts kept: n = 5, p_L = 7 of which two are rolling, F = 1."""
    count = mobility(geared())
    assert (count.links, count.lower, count.higher, count.freedom) == (5, 7, 0, 1)


@pytest.mark.parametrize(("missing", "text"), [(-1, "add the missing joint")])
def test_a_missing_joint_is_told_with_the_remedy(missing: int, text: str) -> None:
    mech = a26()
    loose = Mechanism(frame=mech.frame, links=mech.links, joints=mech.joints[:missing], drives=mech.drives)
    with pytest.raises(MobilityError, match=text) as told:
        check(loose)
    assert "F = 3n - 2p_L - p_H = 3·5 - 2·6 - 0 = 3, but 1 drive is given" in str(told.value)


def test_a_structure_and_a_drive_too_many_are_told() -> None:
    mech = a26()
    twice = Mechanism(
        frame=mech.frame,
        links=mech.links,
        joints=mech.joints,
        drives=(*mech.drives, Drive(link="5", position=0.0, rate=1.0)),
    )
    with pytest.raises(MobilityError, match="2 drives are given: keep only 1"):
        check(twice)
    stiff = Mechanism(
        frame=mech.frame,
        links=(*mech.links, link("9", B=0, G=1)),
        drives=mech.drives,
        joints=(*mech.joints, Revolute(point="B", a="2", b="9"), Revolute(point="G", a="0", b="9")),
    )
    with pytest.raises(MobilityError, match="nothing can move"):
        check(stiff)


CRANKS = """
id: cranks
title: cranks
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm], F: [FOOT, 0 mm]}
links: {1: {AB: 80 mm}, 2: {BC: 200 mm, E: {along: BC, at: 400 mm}}, 3: {DC: 80 mm}, 4: {FE: 80 mm}}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [ABCD parallelogram]
find: [omega_3]
"""


def test_a_third_crank_that_repeats_two_parallel_ones_is_named_as_redundant() -> None:
    with pytest.raises(MobilityError, match=r"Leave out link 4 \(ω_4 = ω_1\)"):
        loads(CRANKS.replace("FOOT", "400 mm"))
    with pytest.raises(MobilityError, match="nothing can move"):
        loads(CRANKS.replace("FOOT", "410 mm"))


WEDGE = """
id: wedge
title: wedge
frame: {A: [0 mm, 0 mm]}
links: {1: {block: P, slot: {through: P, angle: 25 deg from line}}, 2: {block: Q}}
joints: [1 slides on y = 0 mm, WEDGED, 2 slides on x = 80 mm]
input: {link: 1, s: 30 mm, v: 0.1 m/s}
find: [v_Q]
"""


def test_a_loop_of_slides_alone_moves_and_how_it_is_written_is_told() -> None:
    with pytest.raises(MobilityError, match="'Q runs in 1'"):
        loads(WEDGE.replace("WEDGED", "2 slides in 1"))
    found = solve(loads(WEDGE.replace("WEDGED", "Q runs in 1"))).answers["v_Q"]
    assert (
        found.exact == pytest.approx(0.1 * tan(radians(25))) and abs(found.drawn - found.exact) < found.expected_error
    )


def test_an_open_chain_is_named() -> None:
    arm = "id: arm\ntitle: arm\nframe: {A: [0 mm, 0 mm]}\nlinks: {1: {AB: 200 mm}, 2: {BC: 150 mm}}\ninput:\n"
    arm += "  - {link: 1, phi: 40 deg, omega: 1 rad/s ccw}\n  - {link: 2, on: 1, phi: -120 deg, omega: 2 rad/s cw}\n"
    with pytest.raises(MobilityError, match="an open chain"):
        solve(loads(arm + "find: [v_C]\n"))


def test_links_that_hang_on_nothing_known_are_named() -> None:
    """Right in number, wrong in place: a stiff triangle elsewhere hides a loose chain."""
    mech = make(
        {"A": 0, "D": 3, "E": 6},
        [link("1", A=0, B=1), link("2", B=0, C=1), link("3", C=0, P=1), link("4", D=0, E=3, Q=1j)],
        pins("A 0 1, B 1 2, C 2 3, D 0 4, E 0 4"),
        (0.0, 1.0),
    )
    with pytest.raises(MobilityError):
        check(mech)
        decompose(mech)


def test_the_links_of_a_group_are_told_in_both_languages_and_a_block_that_is_thought_as_its_pin() -> None:
    pinned = 0
    for name in ("3-1c", "4-5", "pin-in-two-slots", "3-9", "class-iii-slides"):
        for group in decompose(load(name).mechanism):
            names = {
                "zh": [f"销 {link.removeprefix('pin')}" if link.startswith("pin") else link for link in group.links],
                "en": [f"pin {link.removeprefix('pin')}" if link.startswith("pin") else link for link in group.links],
            }
            assert (group.told.zh, group.told.en) == ("、".join(names["zh"]), " and ".join(names["en"]))
            pinned += "pin" in group.told.en
    assert pinned >= 4
