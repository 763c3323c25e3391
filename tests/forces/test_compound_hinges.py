"""At a multiple joint one link carries the pin, whatever the numbers of the links;
every other link presses on that one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.at_once import exactly
from tests.forces.test_pins_in_slots import agreeing, exact_hand
from tests.generators.forces import friction, moment, numbered, renumbering, simple, some, template
from tests.generators.loaded import rrp, rrr
from tests.laws import few
from tests.texts import SIX_BAR
from vecpoly import loads
from vecpoly.errors import ProblemFileError, VecpolyError
from vecpoly.mechanism.asked.forces import apart, pairs
from vecpoly.mechanism.model import FRAME, Mechanism, Revolute
from vecpoly.mechanism.seats import seat, seated
from vecpoly.report.statement.structure import numbering

RUBBING = "friction: {A: {rho: 3 mm}, B: {rho: 3 mm}, C: {rho: 4 mm}, D: {rho: 3 mm}, E: {rho: 3 mm}, F: {rho: 3 mm}}\n"
TWO_ROCKERS = """
id: two-rockers
title: two rockers on one fixed pin
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links:
  1: {AB: 50 mm, G: {along: AB, at: 40 mm, left: 20 mm}}
  2: {BC: 170 mm}
  3: {DC: 130 mm}
  4: {GE: 160 mm}
  5: {DE: 150 mm}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD, E left of GD]
loads: {M_3: {on: 3, size: 10 N*m}, F: {on: 5, at: E, size: 100 N, direction: 20 deg}, M_1: {on: 1, size: "?"}}
"""


def mechanism(text: str) -> Mechanism:
    return loads(text).mechanism


def test_the_rocker_carries_the_pin_not_the_connecting_rods() -> None:
    mech = mechanism(SIX_BAR)
    assert seat(mech, "C") == "3"
    assert {frozenset(p) for p in pairs(mech)} >= {frozenset("32"), frozenset("34")}
    assert apart(mech) == (("2", "4"),)


def test_the_frame_carries_the_pin_where_it_is_there() -> None:
    mech = mechanism(TWO_ROCKERS)
    assert seat(mech, "D") == FRAME
    assert apart(mech) == (("3", "5"),)


def test_the_driving_link_carries_the_pin_of_two_rods() -> None:
    twin = SIX_BAR.replace("4: {CE", "4: {BE").replace("E left of CF", "E left of BF")
    assert seat(mechanism(twin), "B") == "1"


def test_a_pin_of_two_links_has_no_carrier() -> None:
    assert seat(mechanism(SIX_BAR), "E") is None
    assert seated(mechanism(SIX_BAR)) == mechanism(SIX_BAR)


def test_drawn_and_exact_agree_at_the_hinge_of_three_links() -> None:
    found = exact_hand(SIX_BAR + "find: [M_1, R_23, R_32, R_43, R_24, R_42]\n").answers
    for answer in found.values():
        assert abs(answer.drawn - answer.exact) <= 1e-9 * 104
    assert found["R_23"].exact == pytest.approx(104.14, abs=0.01)
    assert found["R_43"].exact > 100  # what the old attribution gave to R_24
    assert found["R_24"].drawn == found["R_24"].exact == 0


def test_links_that_only_share_the_pin_press_with_nothing_and_are_told_why() -> None:
    told = exact_hand(SIX_BAR + "find: [R_24]\n").answers["R_24"].reading.remark
    assert told is not None and "3" in told.en and "属于构件 3" in told.zh


def test_the_report_says_which_link_carries_the_pin() -> None:
    told = numbering(loads(SIX_BAR))
    assert "$C$ 处的销轴属于构件 3" in told.zh and "the pin at $C$ belongs to link 3" in told.en
    assert (
        "销轴"
        not in numbering(
            loads(
                SIX_BAR.replace("4: {CE", "4: {GE")
                .replace("{BC: 170 mm}", "{BC: 170 mm, G: {along: BC, at: 60 mm, left: 20 mm}}")
                .replace("E left of CF", "E left of GF")
            )
        ).zh
    )
    assert "the pin at $D$ belongs to the frame" in numbering(loads(TWO_ROCKERS)).en


def test_what_is_asked_where_nothing_is_said_are_the_pairs_that_press() -> None:
    asked = {ask.rel.key for ask in loads(SIX_BAR).asks}
    assert {"R_23", "R_34"} <= asked or {"R_32", "R_43"} <= asked
    assert not {"R_24", "R_42"} & asked
    assert exact_hand(SIX_BAR).suspect is False


def test_the_file_may_give_the_pin_to_another_link() -> None:
    rod = mechanism(SIX_BAR + "pins: {C: 2}\n")
    assert seat(rod, "C") == "2"
    found = exact_hand(SIX_BAR + "pins: {C: 2}\nfind: [M_1, R_24, R_23, R_34]\n").answers
    assert all(abs(a.drawn - a.exact) <= 1e-9 * 104 for a in found.values())
    assert found["R_34"].exact == 0 < found["R_24"].exact
    assert found["M_1"].exact == pytest.approx(exact_hand(SIX_BAR).answers["M_1"].exact, rel=1e-12)


def test_with_friction_it_matters_who_carries_the_pin() -> None:
    rocker, rod = (
        exact_hand(SIX_BAR + RUBBING + pins + "find: [M_1]\n").answers["M_1"] for pins in ("", "pins: {C: 2}\n")
    )
    assert rocker.drawn == pytest.approx(rocker.exact, rel=1e-9)
    assert rod.drawn == pytest.approx(rod.exact, rel=1e-9)
    assert abs(rocker.exact - rod.exact) > 1e-3 * abs(rocker.exact)


@pytest.mark.parametrize(
    ("pins", "said", "gesagt"),
    [
        ("{E: 4}", "no multiple joint", "不是复合铰链"),
        ("{C: 5}", "is not at hinge C", "不在铰链"),
        ("{Z: 1}", "no multiple joint", "不是复合铰链"),
    ],
)
def test_a_pin_given_to_the_wrong_link_is_refused_in_both_languages(pins: str, said: str, gesagt: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        loads(SIX_BAR + f"pins: {pins}\n")
    assert said in refused.value.words.en and gesagt in refused.value.words.zh


def test_every_link_at_a_hinge_turns_on_its_carrier_alone() -> None:
    mech = mechanism(SIX_BAR)
    at_c = [{j.a, j.b} for j in mech.joints if isinstance(j, Revolute) and j.point == "C"]
    assert at_c == [{"2", "3"}, {"3", "4"}]


@pytest.mark.parametrize("seed", few(range(12), 3))
def test_any_numbering_of_the_links_gives_the_same_physics(seed: int) -> None:
    rng = np.random.default_rng(seed)
    c = simple(rng, (rrr, rrp))
    text = template(c, some(c, 2) + moment(c, "M_b", "L0", size='"?"'), friction(c) if seed % 2 else "")
    found = [_named(numbered(c, text, numbers), numbers) for numbers in (renumbering(rng, c), renumbering(rng, c))]
    assert found[0].keys() == found[1].keys()
    largest = max(map(abs, found[0].values()), default=1.0)
    for key, one in found[0].items():
        assert abs(one - found[1][key]) <= 1e-9 * largest, key


def _named(text: str, numbers: dict[str, str]) -> dict[str, complex]:
    """What is asked where nothing is said, drawn, by the links' own names, each pair in one order;
    nothing where the program declines."""
    own = {number: name for name, number in numbers.items()}
    try:
        forces = exact_hand(text).construction.forces
    except VecpolyError as refusal:
        return {type(refusal).__name__: 0j}
    found: dict[str, complex] = {}
    for key, reading in forces.items():
        if key.startswith("R_"):
            by, on = own[key[2]], own[key[3]]
            found[f"{by} {on}{key[4:]}"] = reading.vector or 0j
        else:
            found[key] = complex(reading.scalar)
    return {key: value for key, value in found.items() if value == value}


def test_a_mechanism_that_python_builds_keeps_the_joints_it_was_given() -> None:
    mech = mechanism(SIX_BAR)
    chained = replace(
        mech,
        joints=tuple(
            replace(j, a="2", b="4") if isinstance(j, Revolute) and j.point == "C" and "4" in (j.a, j.b) else j
            for j in mech.joints
        ),
    )
    assert seat(chained, "C") == "2"


CARRIED = """
id: carried
title: carried
frame: {A: [0 mm, 0 mm], D: [75 mm, 76 mm], F: [91 mm, 24 mm], I: [59 mm, 28 mm]}
links: {1: {AB: 71 mm}, 2: {BE: 87 mm}, 3: {block: E}, 4: {EG: 192 mm}, 5: {block: G}, 6: {EH: 105 mm}, 7: {IH: 54 mm}}
joints: [3 slides on line through D at -38 deg, 5 slides on line through F at 41 deg]
branch: [E left of BD, G left of EF, H right of EI]
input: {link: 1, phi: 52 deg, omega: 4 rad/s}
loads: {M_6: {on: 6, size: 31 N*m}, M_1: {on: 1, size: "?"}}
find: [M_1]
"""


def test_a_pin_with_whose_owner_the_groups_would_be_of_class_iii_is_thought_by_itself() -> None:
    free, owned = (exactly(loads(CARRIED + more)).answers["M_1"] for more in ("", "pins: {E: 6}\n"))
    assert free.drawn == pytest.approx(free.exact) and free.drawn != 0
    assert owned.drawn == pytest.approx(free.drawn, rel=1e-9)


@pytest.mark.parametrize("rubs", few(["", "friction: {A: {rho: 3 mm}, B: {rho: 3 mm}, E: {rho: 4 mm}}\n"], 2))
def test_every_reaction_about_a_pin_that_is_given_back_to_its_owner_is_drawn_as_exact(rubs: str) -> None:
    """The force on the link on which the groups hung is the closing side of the pin's own polygon."""
    more = "Q: {on: 5, at: G, size: 90 N, direction: 20 deg}, P: {on: 3, at: E, size: 50 N, direction: 200 deg}, M_1"
    text = CARRIED.replace("find: [M_1]\n", "").replace("M_1", more, 1)
    found = exact_hand(f"{text}pins: {{E: 6}}\n{rubs}")
    assert agreeing(found) == (13 if rubs else 11)
    assert {"R_26", "R_36", "R_46"} <= found.answers.keys() and found.answers["R_36"].exact > 100
    told = found.construction.forces["R_24"].remark
    assert told is not None and "belongs to link 6" in told.en and "属于构件 6" in told.zh
