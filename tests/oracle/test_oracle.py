"""The oracle's rates are the derivatives of its positions; its refusals name joint, gap and remedy."""

from __future__ import annotations

from cmath import exp
from collections.abc import Callable
from math import pi, radians

import numpy as np
import pytest
from hypothesis import assume, example, given, settings
from hypothesis import strategies as st

from tests.laws import often
from tests.oracle.test_oracle_models import (
    MM,
    a16,
    a26,
    a27,
    class_three,
    crank_and_slot,
    fourbar,
    geared,
    guide_rod,
    guided,
    link,
    make,
    pins,
    rocker,
    says,
    sine,
    sloped_slot,
    swinging_block,
)
from vecpoly import load
from vecpoly.errors import AssemblyError, DeadPointError, MobilityError, NotAskedError, UnknownNameError
from vecpoly.mechanism.model import FRAME, Circle, Drive, Mechanism, Rack, Rolling
from vecpoly.names import parse_rel
from vecpoly.oracle import feasible, solve

FIRST = np.array([-1, 9, -45, 0, 45, -9, 1]) / 60
SECOND = np.array([2, -27, 270, -490, 270, -27, 2]) / 180


def rates_agree(mech: Mechanism, position: float | None = None, tolerance: float = 1e-6, step: float = 4e-3) -> None:
    """Every letter's and link's rates against seven-point central differences in time, to `tolerance` of their size."""
    drive = mech.drive
    q = drive.position if position is None else position
    h = step * (mech.scale if drive.slide else 1.0) / max(abs(drive.rate), 1e-9)
    t = h * np.arange(-3, 4)
    motion, near = solve(mech, q), solve(mech, q + drive.rate * t + drive.accel * t * t / 2, order=0)
    size = mech.scale
    for li in mech.links:
        turn = np.unwrap(near.angle(li.name))
        omega, alpha = motion.omega(li.name), motion.alpha(li.name)
        pace = abs(drive.rate) / (size if drive.slide else 1.0)
        assert abs(turn @ FIRST / h - omega) < tolerance * (pace + abs(omega)), li.name
        assert abs(turn @ SECOND / h**2 - alpha) < 30 * tolerance * (pace**2 + abs(alpha)), li.name
        for letter in li.points:
            key = f"{letter}{li.name}"
            path = near.position(key)
            v, a = motion.value(parse_rel(f"v_{key}")), motion.value(parse_rel(f"a_{key}"))
            assert abs(path @ FIRST / h - v) < tolerance * (pace * size + abs(v)), key
            assert abs(path @ SECOND / h**2 - a) < 30 * tolerance * (pace**2 * size + abs(a)), key


CASES: dict[str, Callable[[], Mechanism]] = {
    "3-8 slotted rocker with a point C": lambda: rocker(0.06, 0.02 - 0.12j, 35.0, 8.0, P=0.15 + 0.055j),
    "3-11 driving guide rod": guide_rod,
    "3-12 slider-crank and slotted rocker": crank_and_slot,
    "3-13 gears on a rack": geared,
    "3-14 bar with a sloped slot": lambda: sloped_slot(0.4, 45.0, 100.0, 60.0),
    "sine mechanism": lambda: sine(0.05, 33.0, 10.0),
    "class III group": class_three,
    "A 16": a16,
    "A 26": a26,
    "A 27": a27,
    "slotted link 31 mm from its pivot": lambda: rocker(0.12, 0.2 - 0.1j, 70.0, 5.0, 0.031),
    "accelerated drive": lambda: fourbar(0.04, 0.1, 0.08, 0.11, (68.0, 10.0), accel=-40.0, E=0.03 - 0.05j),
}


@pytest.mark.parametrize("name", CASES)
def test_rates_are_the_derivatives_of_positions(name: str) -> None:
    rates_agree(CASES[name]())


def inverted(slide: bool = True) -> Mechanism:
    """The slider drives: block 1 on a level guide, rod 2, crank 3."""
    return make(
        {"A": 0},
        [link("1", C=0), link("2", C=0, B=0.12), link("3", A=0, B=0.05)],
        guided("0", "1", "C") + pins("C 1 2, B 2 3, A 3 0"),
        (0.13, 0.8),
        "B above A",
        slide=slide,
        accel=1.5,
    )


def test_a_slider_drives() -> None:
    rates_agree(inverted())
    assert solve(inverted()).velocity("C") == 0.8


def test_a_slider_drives_where_the_moving_link_is_the_guide() -> None:
    mech = make(
        {"A": 0, "D": 0.02j},
        [link("1", C=0), link("2", C=0, B=0.12), link("3", A=0, B=0.05)],
        guided("1", "0", "D", origin=0.05, direction=20.0) + pins("C 1 2, B 2 3, A 3 0"),
        (-0.16, 0.8),
        "B above A",
        slide=True,
    )
    rates_agree(mech)


def test_guide_on_a_moving_link_carries_a_dyad() -> None:
    """Link 5 slides on the coupler of a four-bar (RRP on a moving guide)."""
    mech = make(
        {"A": 0, "D": 0.11, "G": 0.05 + 0.14j},
        [
            link("1", A=0, B=0.04),
            link("2", B=0, C=0.1),
            link("3", D=0, C=0.08),
            link("4", G=0, H=0.1),
            link("5", H=0, K=0.03),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, G 4 0, H 4 5") + guided("2", "5", "H", offset=0.01, turn=40.0),
        (68.0, 10.0),
        "C left B D, H right G",
    )
    rates_agree(mech)


def test_guides_fixed_to_moving_links_on_both_sides_meet() -> None:
    """PRP: sleeves on crank 1 and on coupler 2, pinned to each other."""
    mech = make(
        {"A": 0, "D": 0.11},
        [
            link("1", A=0, B=0.04),
            link("2", B=0, C=0.1),
            link("3", D=0, C=0.08),
            link("4", P=0),
            link("5", P=0, Q=0.02j),
        ],
        pins("A 0 1, B 1 2, C 2 3, D 3 0, P 4 5")
        + guided("3", "4", "P", direction=30.0)
        + guided("1", "5", "P", direction=-70.0, offset=0.01),
        (68.0, 10.0),
        "C left B D",
    )
    rates_agree(mech)


def test_collinear_joints_of_one_link_are_no_obstacle() -> None:
    """PMKSWeb 199: three joints of the coupler in line."""
    mech = fourbar(0.04, 0.1, 0.08, 0.11, (68.0, 10.0), E=0.15)
    rates_agree(mech)
    motion = solve(mech)
    assert motion.position("E") == pytest.approx(
        motion.position("B") + 1.5 * (motion.position("C") - motion.position("B"))
    )


def test_equal_ordinates_are_no_obstacle() -> None:
    """Pyslvs-UI 49: crank pin and slider at one height."""
    mech = make(
        {"A": 0},
        [link("1", A=0, B=0.05), link("2", B=0, C=0.15), link("3", C=0)],
        pins("A 0 1, B 1 2, C 2 3") + guided("0", "3", "C", origin=0.03j),
        (float(np.degrees(np.arcsin(0.6))), 10.0),
        "C right B",
    )
    motion = solve(mech)
    assert motion.position("B").imag == pytest.approx(motion.position("C").imag)
    rates_agree(mech)


def test_drag_link_turns_without_a_jump() -> None:
    motion = solve(a27(), np.linspace(0, 2 * pi, 721))
    for name in "235":
        steps = np.diff(np.unwrap(motion.angle(name)))
        assert abs(steps).max() < 0.5
    assert np.unwrap(motion.angle("5"))[-1] - motion.angle("5")[0] == pytest.approx(4 * pi)


def dyad_position(b: complex, d: complex, r: float, reach: float, side: float) -> complex:
    """Independent: law of cosines at B."""
    ray = d - b
    cosine = (r * r + abs(ray) ** 2 - reach * reach) / (2 * r * abs(ray))
    return b + r * ray / abs(ray) * exp(1j * side * np.arccos(cosine))


@pytest.mark.parametrize("side", ["left", "right"])
@pytest.mark.parametrize("left", [220.0, -220.0])
def test_all_four_assemblies_of_a27_against_another_closed_form(side: str, left: float) -> None:
    q = np.linspace(0, 2 * pi, 73)
    motion = solve(a27(-25.0, side, left), q)
    sign = 1.0 if side == "left" else -1.0
    for i, phi in enumerate(q):
        b = 280 * MM * exp(1j * phi)
        c = dyad_position(b, 160j * MM, 350 * MM, 320 * MM, sign)
        f = b + (c - b) * (175 + 1j * left) / 350
        assert abs(motion.position("C")[i] - c) < 1e-15
        assert abs(motion.position("F")[i] - f) < 1e-15
        ray = f - (-25 + 80j) * MM
        assert abs(exp(1j * motion.angle("5")[i]) - ray / abs(ray)) < 1e-14


def test_positions_close_to_the_last_digits() -> None:
    motion = solve(a26(), np.linspace(0, 2 * pi, 361), order=0)
    lengths = {"BC": ("B", "C", 0.2), "CD": ("C", "D", 0.2), "EF": ("E", "F", 0.32), "FG": ("F", "G", 0.162)}
    for a, b, length in lengths.values():
        assert abs(abs(motion.position(a) - motion.position(b)) / length - 1).max() < 2e-15


def test_one_position_gives_numbers_and_a_row_gives_rows() -> None:
    mech = a26()
    one, row = solve(mech, 0.3), solve(mech, np.array([0.3, 0.4]))
    assert isinstance(one.omega("3"), float) and isinstance(one.position("E"), complex)
    assert row.position("E").shape == row.velocity("A").shape == row.omega("0").shape == (2,)
    assert row.position("E")[0] == pytest.approx(one.position("E"), rel=1e-15)
    assert solve(mech, np.array([0.3])).alpha("4").shape == (1,)


def test_every_link_agrees_at_its_hinge() -> None:
    motion = solve(a26())
    for letter, a, b in (("B", "1", "2"), ("C", "2", "3"), ("E", "2", "4"), ("F", "4", "5")):
        for stem in "va":
            here, there = (motion.value(parse_rel(f"{stem}_{letter}{n}")) for n in (a, b))
            assert here == pytest.approx(there, rel=1e-12)


def test_components_of_a_rigid_link_add_up() -> None:
    motion = solve(a26())
    value = {
        k: motion.value(parse_rel(k))
        for k in ("a_C", "a_B", "a_CB", "an_CB", "at_CB", "an_C", "at_C", "v_CB", "v_C", "v_B")
    }
    assert value["an_CB"] + value["at_CB"] == pytest.approx(value["a_CB"], rel=1e-12)
    assert value["an_C"] + value["at_C"] == pytest.approx(value["a_C"], rel=1e-12)
    assert value["v_CB"] == pytest.approx(value["v_C"] - value["v_B"], rel=1e-12)


def test_both_links_of_a_slide_give_the_same_coriolis_term_but_for_its_sign() -> None:
    motion = solve(rocker(0.045, 0.115 - 0.02j, 63.0, 12.0, 0.025))
    assert motion.value(parse_rel("ak_B3B2")) == pytest.approx(-motion.value(parse_rel("ak_B2B3")), rel=1e-12)


def test_unknown_names_are_told_with_the_known_ones() -> None:
    motion = solve(a26())
    for key in ("v_X", "omega_9", "v_C9", "an_BX", "p_Q"):
        with pytest.raises(UnknownNameError, match="known"):
            motion.value(parse_rel(key))
    with pytest.raises(UnknownNameError, match="no link carries both"):
        motion.value(parse_rel("an_FC"))


def test_no_point_has_a_given_velocity_on_a_link_that_does_not_turn() -> None:
    with pytest.raises(NotAskedError, match="does not turn"):
        solve(sine(0.05, 33.0, 10.0)).velocity_pole("3")


def test_rates_are_refused_where_positions_alone_were_solved() -> None:
    with pytest.raises(NotAskedError, match="order=1"):
        solve(a26(), order=0).omega("2")


def triple(position: float = 90.0, branches: str = "C left B D") -> Mechanism:
    """A double rocker: cannot rotate fully."""
    mech = fourbar(0.1, 0.1, 0.08, 0.11, (position, 10.0))
    return Mechanism(
        frame=mech.frame, links=mech.links, joints=mech.joints, drives=mech.drives, branches=says(branches)
    )


def test_a_position_out_of_reach_names_joint_gap_and_range() -> None:
    with pytest.raises(
        AssemblyError, match=r"joint C: .* mm are missing where the drive stands at 180°; .* within .*° to .*°"
    ) as told:
        solve(triple(), np.radians([90.0, 180.0, 170.0]))
    assert "30 mm are missing" in str(told.value)


def test_ranges_of_a_double_rocker_are_those_of_the_triangle_inequality() -> None:
    def angle(reach: float) -> float:
        return float(np.degrees(np.arccos((0.1**2 + 0.11**2 - reach**2) / (2 * 0.1 * 0.11))))

    ends = [float(x) for span in feasible(triple()) for x in span.removesuffix(" deg").split("..")]
    near, far = angle(0.02), angle(0.18)
    assert ends == pytest.approx([near, far, 360 - far, 360 - near], abs=0.06)


def test_the_own_position_out_of_reach_is_refused_likewise() -> None:
    with pytest.raises(AssemblyError, match=r"30 mm are missing where the drive stands at 180°"):
        solve(triple(180.0))


def test_a_position_that_alone_does_not_close_is_told_so() -> None:
    """Crank and frame are equally long: at 0° the rod's pin falls on the block's, and any direction of the rod fits."""
    with pytest.raises(
        AssemblyError, match=r"at 0°: they can just before and just after it, .* joints fall together"
    ) as told:
        solve(swinging_block(0.03, 0.03, 0.0, 10.0))
    assert "within" not in str(told.value)


def test_a_motion_goes_smoothly_through_a_position_that_alone_does_not_close() -> None:
    """As above: the rod turns half as fast as the crank all the way round, and stands square to the frame at 0°."""
    motion = solve(swinging_block(0.03, 0.03, 57.0, 10.0), np.radians([57.0, 0.0, -40.0, 360.0]))
    assert motion.omega("2") == pytest.approx(5.0) and motion.alpha("2") == pytest.approx(0.0, abs=1e-7)
    assert np.degrees(motion.angle("2") - motion.angle("2")[0]) % 360 == pytest.approx(
        np.array([0.0, 331.5, 311.5, 151.5])
    )


@pytest.mark.parametrize("phi", [0.0, 90.0, -40.0])
def test_what_a_rack_at_a_given_place_cannot_reach_is_not_promised_at_another_position(phi: float) -> None:
    """The rack stands at s = 40 mm wherever the pinion is: its rocker's pivot is 13.27 mm too far away there."""
    away = load("pinion-drives-rack").vary(x_D="187.5 mm").vary(phi=f"{phi} deg")
    with pytest.raises(AssemblyError, match=r"at joint C: 13\.27 mm .*gears and racks .* go with it") as told:
        away.solve()
    assert "within" not in str(told.value)


def test_failing_positions_may_be_left_blank() -> None:
    motion = solve(triple(), np.radians([90.0, 180.0]), strict=False)
    assert np.isfinite(motion.alpha("2")[0]) and np.isnan(motion.alpha("2")[1]) and np.isnan(motion.position("C")[1])


def test_a_dead_point_names_links_and_angle() -> None:
    mech = fourbar(0.07, 0.08, 0.04, 0.11, (60.0, 10.0))
    limit = np.arccos((0.07**2 + 0.11**2 - 0.12**2) / (2 * 0.07 * 0.11))  # links 2 and 3 are stretched out
    with pytest.raises(DeadPointError, match=r"links 2 and 3 .*dead point .* 80.2\d*°"):
        solve(mech, limit - 1e-14)
    assert np.isfinite(solve(mech, limit - 1e-14, order=0).position("C"))


def test_rates_at_a_change_point_are_those_of_the_motion_on_both_sides() -> None:
    mech = fourbar(0.04, 0.08, 0.07, 0.11, (60.0, 10.0))  # 40 + 110 = 80 + 70
    before, here, behind = (solve(mech, pi + step) for step in (-0.01, 0.0, 0.01))
    for name in ("2", "3"):
        assert here.omega(name) == pytest.approx((before.omega(name) + behind.omega(name)) / 2, rel=1e-3)
        assert here.alpha(name) == pytest.approx(
            10 * (behind.omega(name) - before.omega(name)) / 0.02, rel=1e-3, abs=1e-6
        )


def test_assemblies_that_coincide_at_the_own_position_are_a_dead_point() -> None:
    with pytest.raises(DeadPointError, match=r"links 2 and 3 .* 180°: their two assemblies coincide"):
        solve(fourbar(0.04, 0.08, 0.07, 0.11, (180.0, 10.0)))


def test_two_assemblies_without_a_statement_are_refused_with_the_words_that_help() -> None:
    with pytest.raises(AssemblyError, match="say which: 'C left of BD' or 'C right of BD'"):
        solve(triple(90.0, ""))
    mech = make(
        {"A": 0},
        [link("1", A=0, B=0.05), link("2", B=0, C=0.15), link("3", C=0)],
        pins("A 0 1, B 1 2, C 2 3") + guided("0", "3", "C"),
        (40.0, 10.0),
    )
    with pytest.raises(AssemblyError, match="say which: 'C left of B' or 'C right of B'"):
        solve(mech)


def test_a_statement_that_tells_nothing_or_that_neither_fulfils_is_refused() -> None:
    with pytest.raises(AssemblyError, match="say which"):
        solve(triple(90.0, "C right A"))
    with pytest.raises(AssemblyError, match="neither assembly fulfils 'C left of A'"):
        solve(triple(60.0, "C left A"))
    with pytest.raises(UnknownNameError, match="unknown point X"):
        solve(triple(90.0, "X left B D"))


def test_slotted_link_lies_ahead_of_its_pivot_unless_it_is_said_otherwise() -> None:
    mech = rocker(0.05, -0.11j, 72.0, 10.0)
    ahead = solve(mech).angle("3")
    said = Mechanism(
        frame=mech.frame,
        links=(*mech.links[:2], link("3", C=0, T=0.2)),
        joints=mech.joints,
        drives=mech.drives,
        branches=says("T below C"),
    )
    assert solve(said).angle("3") == pytest.approx(ahead - pi)


def test_wrong_mobility_is_refused_with_its_count() -> None:
    mech = fourbar(0.04, 0.1, 0.08, 0.11, (68.0, 10.0))
    loose = Mechanism(frame=mech.frame, links=mech.links, joints=mech.joints[:-1], drives=mech.drives)
    with pytest.raises(MobilityError, match=r"3·3 - 2·3 - 0 = 3"):
        solve(loose)


def test_gear_angle_is_zero_at_the_own_position_and_continuous_over_two_turns() -> None:
    mech = geared()
    q = mech.drive.position + np.linspace(-4 * pi, 4 * pi, 1441)
    motion = solve(mech, q)
    assert solve(mech).angle("4") == 0.0
    for name in "34":
        assert abs(np.diff(motion.angle(name))).max() < 0.2
    assert motion.angle("4")[0] == pytest.approx(motion.angle("4")[-1], abs=1e-9)
    shuffled = np.random.default_rng(1).permutation(len(q))
    assert solve(mech, q[shuffled]).angle("4") == pytest.approx(motion.angle("4")[shuffled], abs=1e-12)


def test_planet_in_a_fixed_ring_turns_by_the_ratio() -> None:
    """Arm 1 driven, planet 2 in ring: held at its distance by the arm; ω_2 = -(R - r)/r ω_1."""
    mech = make(
        {"O": 0},
        [link("1", O=0, P=0.058), link("2", P=0, Q=0.032)],
        (
            *pins("O 0 1, P 1 2"),
            Rolling(
                point="K",
                gear=Circle(link="2", centre="P", radius=0.032),
                on=Circle(link="0", centre="O", radius=0.09),
                internal=True,
            ),
        ),
        (37.0, 2.0),
    )
    motion = solve(mech)
    assert motion.omega("2") == pytest.approx(-2.0 * 0.058 / 0.032)
    assert abs(motion.value(parse_rel("v_K2"))) < 1e-12
    rates_agree(mech)


def test_gear_train_between_moving_centres() -> None:
    """3-3: gears 1 (on the crank), 2 and 3 with hinges B, C, D of a four-bar 4, 5."""
    gears = tuple(
        Rolling(point=p, gear=Circle(link=g, centre=c, radius=r), on=Circle(link=h, centre=d, radius=s))
        for p, g, c, r, h, d, s in (("K", "2", "C", 0.1, "1", "B", 0.06), ("L", "3", "D", 0.05, "2", "C", 0.1))
    )
    mech = make(
        {"A": 0, "D": 0.2},
        [link("1", A=0, B=0.07), link("2", C=0), link("3", D=0), link("4", B=0, C=0.16), link("5", D=0, C=0.15)],
        pins("A 0 1, B 1 4, C 4 5, C 5 2, D 5 0, D 3 0") + gears,
        (78.0, 10.0),
        "C left B D",
    )
    motion = solve(mech)
    assert [motion.omega(n) for n in "2345"] == pytest.approx([-9.46438, 29.8612, -2.16524, 3.64415], rel=1e-5)
    rates_agree(mech)


def test_class_three_group_keeps_its_assembly_over_a_row_in_any_order() -> None:
    mech = class_three()
    q = np.radians(np.linspace(0.0, 360.0, 181))
    motion = solve(mech, q)
    assert abs(np.diff(motion.position("D"))).max() < 0.01
    assert solve(mech, q[::-1].copy()).position("D") == pytest.approx(motion.position("D")[::-1], abs=1e-12)
    assert motion.position("E")[0] == pytest.approx(motion.position("E")[-1], abs=1e-12)
    for a, b, length in (("B", "C", 0.1), ("F", "D", 0.08), ("G", "E", 0.08)):
        assert abs(motion.position(a) - motion.position(b)) == pytest.approx(length, abs=1e-14)


def test_class_three_group_without_guesses_is_refused() -> None:
    mech = class_three()
    bare = Mechanism(frame=mech.frame, links=mech.links, joints=mech.joints, drives=mech.drives)
    with pytest.raises(AssemblyError, match="guesses"):
        solve(bare)


def test_rocking_rack_drives_a_gear() -> None:
    """A gear held on the frame, its rack sliding: ω r = v."""
    mech = make(
        {"O": 0.05j},
        [link("1", P=0), link("2", O=0)],
        guided("0", "1", "P")
        + pins("O 0 2")
        + (
            Rolling(
                point="K", gear=Circle(link="2", centre="O", radius=0.05), on=Rack(link="1", origin=0, direction=0.0)
            ),
        ),
        (0.01, 0.3),
        slide=True,
    )
    assert solve(mech).omega("2") == pytest.approx(0.3 / 0.05)


def test_the_oracle_takes_two_drives() -> None:
    """Five-bar: F = 2."""
    mech = make(
        {"A": 0, "E": 0.1},
        [link("1", A=0, B=0.05), link("2", B=0, C=0.1), link("3", D=0, C=0.1), link("4", E=0, D=0.05)],
        pins("A 0 1, B 1 2, C 2 3, D 3 4, E 4 0"),
        (100.0, 10.0),
        "C left B D",
    )
    two = Mechanism(
        frame=mech.frame,
        links=mech.links,
        joints=mech.joints,
        drives=(*mech.drives, Drive(link="4", position=radians(70), rate=0.0)),
        branches=mech.branches,
    )
    rates_agree(two)
    assert solve(two).omega("4") == 0.0 and FRAME in solve(two).bodies


lengths = st.floats(0.05, 0.3)
angles = st.floats(-pi, pi)
CHECKED = settings(max_examples=often(60))


def well_conditioned(mech: Mechanism, guide: float | None = None) -> None:
    """Only positions that assemble, with some way to the next dead point: between links 2 and 3, or rod 2 and guide."""
    try:
        near = solve(mech, mech.drive.position + np.linspace(-0.1, 0.1, 81))
    except (AssemblyError, NotAskedError):
        assume(False)
        return
    assume(all(abs(near.omega(li.name)).max() < 20 * abs(mech.drive.rate) for li in mech.links))
    assume(all(abs(near.alpha(li.name)).max() < 400 * mech.drive.rate**2 for li in mech.links))
    if "D" in mech.links[2].points:
        assume(abs(np.sin(near.angle("2") - near.angle("3"))).min() > 0.05)
    if guide is not None:
        assume(abs(np.cos(near.angle("2") - guide)).min() > 0.05)


@CHECKED
@given(lengths, lengths, lengths, lengths, angles, angles, st.sampled_from(["left", "right"]), st.floats(-30, 30))
@example(0.25, 0.25, 0.25344607860476387, 0.25, 1.4382231048141742e-89, 0.0, "left", 0.0)  # B and D all but one
def test_random_fourbar(
    ab: float, bc: float, cd: float, ad: float, way: float, phi: float, side: str, accel: float
) -> None:
    mech = fourbar(ab, bc, cd, ad * exp(1j * way), (float(np.degrees(phi)), 3.0), side, accel=accel, E=0.1 - 0.07j)
    well_conditioned(mech)
    rates_agree(mech, tolerance=1e-5)


@CHECKED
@given(lengths, lengths, st.floats(-0.1, 0.1), angles, angles, st.floats(-0.05, 0.05), st.floats(-180, 180))
def test_random_slider_crank(
    ab: float, bc: float, away: float, way: float, phi: float, offset: float, turn: float
) -> None:
    """A guide in any direction, offset from its line, the block at any angle to it."""
    mech = make(
        {"A": 0, "D": 1j * away * exp(1j * way)},
        [link("1", A=0, B=ab), link("2", B=0, C=bc), link("3", C=0, E=0.02 + 0.03j)],
        pins("A 0 1, B 1 2, C 2 3")
        + guided(
            "0", "3", "C", origin=1j * away * exp(1j * way), direction=float(np.degrees(way)), offset=offset, turn=turn
        ),
        (float(np.degrees(phi)), 3.0),
    )
    for branches in ("C right B", "C left B", "C above B", "C below B"):
        said = Mechanism(
            frame=mech.frame, links=mech.links, joints=mech.joints, drives=mech.drives, branches=says(branches)
        )
        try:
            solve(said)
        except AssemblyError:
            continue
        well_conditioned(said, way)
        rates_agree(said, tolerance=1e-5)
        return
    assume(False)


@CHECKED
@given(lengths, lengths, angles, angles, st.floats(-0.04, 0.04), st.booleans())
def test_random_inverted_slider_crank(
    ab: float, ac: float, way: float, phi: float, offset: float, swings: bool
) -> None:
    """The guide on the rocker (offset), or on the rod through a swinging block."""
    c = ac * exp(1j * way)
    assume(abs(ab * exp(1j * phi) - c) > 0.02)  # with the pin at the pivot the guide has no direction
    mech = (
        rocker(ab, c, float(np.degrees(phi)), 3.0, offset, T=0.1 + 0.02j)
        if not swings
        else swinging_block(ab, c, float(np.degrees(phi)), 3.0, T=0.05 + 0.04j)
    )
    well_conditioned(mech)
    rates_agree(mech, tolerance=1e-5)
