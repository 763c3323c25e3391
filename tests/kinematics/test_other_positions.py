"""Claims about other positions of the drive: the mechanism comes there from its own, where its statements are read."""

from __future__ import annotations

import numpy as np
import pytest

from tests.at_once import exactly
from tests.each import each
from tests.laws import few
from vecpoly import load, loads, oracle
from vecpoly.board.acts import Curve
from vecpoly.board.paper.marks import Role
from vecpoly.errors import AssemblyError, NoMethodError
from vecpoly.mechanism.assembly.branch import margin
from vecpoly.mechanism.model import Mechanism
from vecpoly.methods.exchange.profile import osculated
from vecpoly.methods.positions.following import follower
from vecpoly.problem.problem import Problem
from vecpoly.solution import Solution

ROCKER = """id: rocker
title: rocker
frame: {A: [0 mm, 0 mm], D: [160 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 140 mm, E: {along: BC, at: 60 mm, left: 30 mm}}, 3: {CD: 120 mm}}
input: {link: 1, phi: 330 deg, omega: 100 r/min cw}
"""
PLAIN, LOCAL = (
    "branch: [C left of BD]\n",
    "branch: [C right of BA]\n",
)  # the same at 330°; the second in half of the turn only
TURN = np.radians(np.arange(-355.0, 360.0, 10.0))


def made(text: str) -> Problem:
    problem = loads(text if "find:" in text else text + "find: [omega_3]\n")
    assert isinstance(problem, Problem)
    return problem


def drawn(text: str) -> Solution:
    return exactly(made(text))


def farthest(mech: Mechanism, ways: np.ndarray = TURN) -> float:
    """How far the followed letters are from the oracle's, over the mechanism's size."""
    one, at = follower(mech), mech.drive.position + ways
    motion = oracle.solve(mech, at, order=0)
    letters = {p for link in mech.links for p in link.points}
    places = [one.at(q).places for q in at]
    exact = {p: np.broadcast_to(motion.position(p), at.shape) for p in letters}
    return max(float(abs(there[p] - exact[p][k])) for k, there in enumerate(places) for p in letters) / mech.scale


def test_the_local_statement_is_false_in_much_of_the_turn_and_true_where_it_is_told() -> None:
    mech = made(ROCKER + LOCAL).mechanism
    told = [follower(mech).at(q).places for q in mech.drive.position + TURN]
    assert margin(mech.branches[0], follower(mech).at(mech.drive.position).places) > 0
    assert sum(margin(mech.branches[0], at) < 0 for at in told) > 20


@pytest.mark.parametrize("branch", [PLAIN, LOCAL])
def test_a_statement_is_read_at_the_given_position_only(branch: str) -> None:
    assert farthest(made(ROCKER + branch).mechanism) < 1e-9


def test_all_positions_that_follow_from_each_other_are_followed_once() -> None:
    here, there = (made(ROCKER.replace("330 deg", phi) + PLAIN).mechanism for phi in ("330 deg", "200 deg"))
    assert follower(here) is follower(there)
    assert follower(here) is not follower(made(ROCKER + "branch: [C right of BD]\n").mechanism)


ROLL = (
    "curv-9", "crank-rack-pinion", "geared-five-bar", "hypocycloid-drive", "planet-drive", "planetary-reactions",
    "planetary-sun-drives", "rack-drives-pinion", "rack-lift", "stepped-planet", "travel-doubler",
    "two-trains-one-sun", "winch-gears",
)  # fmt: skip


@each(few(ROLL, 12))
def test_gears_that_are_told_in_the_given_position_roll_on_to_all_others(name: str) -> None:
    mech = load(name).mechanism
    far = 0.05 if mech.drive.slide else 4 * np.pi
    assert mech.starts and farthest(mech, np.linspace(-far, far, 9)) < 1e-9


STROKE = """loads:
  F_q: {on: 3, at: C, size: 300 N, direction: 200 deg, while: C moves left, between: [0 %, 90 %]}
  M: {on: 1, size: WHAT}
"""


@pytest.mark.parametrize(("name", "size"), few([("M_b", '"?"'), ("M_c", "constant")], 2))
def test_a_stroke_is_that_of_the_assembly_that_is_told(name: str, size: str) -> None:
    text = ROCKER + STROKE.replace("M: {", f"{name}: {{").replace("WHAT", size) + f"find: [{name}]\n"
    plain, local = (drawn(text + branch).answers[name] for branch in (PLAIN, LOCAL))
    assert local.drawn == pytest.approx(local.exact, rel=1e-9)
    assert local.drawn == pytest.approx(plain.drawn, rel=1e-9)
    assert abs(local.drawn) > 0.1


def path(text: str, role: Role) -> tuple[complex, ...]:
    return max((a.points for a in drawn(text).construction.acts if isinstance(a, Curve) and a.role is role), key=len)


def test_the_path_beside_a_given_curve_is_that_of_the_assembly_that_is_told() -> None:
    target = "target: {point: E, through: [[0 mm, 90 mm], [40 mm, 110 mm], [70 mm, 90 mm]]}\n"
    plain, local = (path(ROCKER + branch + target, Role.CONSTRUCTION) for branch in (PLAIN, LOCAL))
    assert len(local) == 121
    assert np.abs(np.subtract(local, plain)).max() < 1e-6


def test_the_path_of_a_crank_that_does_not_turn_round_goes_to_both_of_its_ends() -> None:
    text = ROCKER.replace("AB: 50 mm", "AB: 130 mm").replace("330 deg", "400 deg") + PLAIN
    (low, high), *_ = (span for span in oracle.spans(made(text).mechanism))
    run = path(
        text + "target: {point: E, through: [[0 mm, 90 mm], [40 mm, 110 mm], [70 mm, 90 mm]]}\n", Role.CONSTRUCTION
    )
    assert len(run) == pytest.approx(np.degrees(high - low) / 3, abs=2)


def test_beyond_the_end_of_its_range_a_mechanism_cannot_be_followed() -> None:
    mech = made(ROCKER.replace("AB: 50 mm", "AB: 130 mm").replace("330 deg", "400 deg") + PLAIN).mechanism
    (_, high), *_ = oracle.spans(mech)
    assert follower(mech).at(high - 1e-5).places
    for beyond in (high + 1e-5, high + 1.0):
        with pytest.raises(AssemblyError):
            follower(mech).at(beyond)


GUIDE = """id: guide
title: guide
frame: {A: [0 mm, 0 mm], D: [AD mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {block: B}, 3: {slot: D, E: {along: D, at: 80 mm, left: 20 mm}}}
joints: [2 slides in 3]
input: {link: 1, phi: 70 deg, omega: 100 r/min}
"""


def test_a_guide_keeps_its_way_where_the_pin_of_its_block_passes_its_pivot_closely() -> None:
    assert farthest(made(GUIDE.replace("AD", "60.05")).mechanism) < 1e-9


def test_a_guide_that_is_told_to_point_backward_points_backward_everywhere() -> None:
    mech = made(GUIDE.replace("AD", "100") + "branch: [E right of D]\n").mechanism
    assert farthest(mech) < 1e-9


@pytest.mark.parametrize("sizes", [("60", "100", "60", "100"), ("60", "60", "100", "100"), ("60", "100", "80", "120")])
def test_a_change_point_is_passed_as_the_motion_goes_on(sizes: tuple[str, ...]) -> None:
    ab, bc, cd, ad = sizes
    text = f"""id: change
title: change
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links: {{1: {{AB: {ab} mm}}, 2: {{BC: {bc} mm}}, 3: {{CD: {cd} mm}}}}
input: {{link: 1, phi: 70 deg, omega: 100 r/min}}
branch: [C right of BD]
"""
    assert farthest(made(text).mechanism, np.radians(np.arange(3.0, 360.0, 13.0))) < 1e-6


LIFTED = """id: lifted
title: lifted
frame: {A: [0 mm, 0 mm], D: [70 mm, 0 mm]}
links:
  1: {AB: 35 mm}
  2: {BC: 51 mm, F: {along: BC, at: 20 mm, left: 25 mm}}
  3: {DC: 69 mm, G: {along: DC, at: 20 mm, left: -25 mm}}
  4: {cylinder: G}
  5: {piston: F}
joints: [5 slides in 4]
input: {cylinder: 4-5, length: 88.890449 mm, v: 10 mm/s}
branch: [C left of BD]
guesses: {B: [6.08 mm, 34.47 mm], C: [51.7 mm, 66.6 mm], F: [8.2 mm, 66.4 mm], G: [89.5 mm, 26.2 mm]}
method: curvature
"""


def test_positions_of_an_input_between_moving_links_are_not_taken_for_those_of_the_link_thought_to_drive() -> None:
    with pytest.raises(NoMethodError, match="other positions of the input"):
        drawn(LIFTED + "find: [{centrodes: 2, positions: 5, over: [87.4 mm, 90.4 mm]}]\n")


@each(few(("cam-face-load", "cam-knife-load", "cam-moves-arm", "cam-moves-flat-arm", "cam-roller-load"), 5))
def test_a_cam_s_follower_is_followed_all_round_with_a_disc_that_touches_in_each_place(name: str) -> None:
    mech = load(name).mechanism
    one, at = follower(osculated(mech)[0]), mech.drive.position + np.linspace(-7, 7, 15)
    motion, centres = oracle.solve(mech, at, order=0), {profile.centre for profile in mech.cams}
    for letter in {p for link in mech.links for p in link.points} - centres:
        exact = np.broadcast_to(motion.position(letter), at.shape)
        assert max(abs(one.at(q).places[letter] - exact[k]) for k, q in enumerate(at)) < 1e-9 * mech.scale
