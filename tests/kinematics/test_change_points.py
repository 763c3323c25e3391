"""Four-bars whose assemblies meet: the branch is a choice, and the whole motion keeps it."""

from __future__ import annotations

import numpy as np
import pytest

from tests.at_once import exactly
from vecpoly import loads, oracle
from vecpoly.cycle import cycle, facts
from vecpoly.cycle.facts.closing import laps_of
from vecpoly.cycle.facts.sentences import sentences
from vecpoly.cycle.pose import posed
from vecpoly.errors import DeadPointError, ProblemFileError
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

FIND = "find: [omega_2, alpha_2, omega_3, alpha_3, v_C, a_C, v_CB, an_CB, at_CB, an_C, at_C]\n"
ROUND = np.radians(np.arange(-720.0, 720.5, 7.5))


def four_bar(phi: float, branch: str, bc: int = 200, cd: int = 50, ad: int = 200) -> Problem:
    return loads(
        f"""
id: change
title: change
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links: {{1: {{AB: 50 mm}}, 2: {{BC: {bc} mm}}, 3: {{DC: {cd} mm}}}}
input: {{link: 1, phi: {phi} deg, omega: 10 rad/s ccw}}
branch: [{branch}]
"""
        + FIND
    )


@pytest.mark.parametrize("branch", ["C above AD", "ABCD parallelogram", "ABCD 为平行四边形", "parallelogram ABCD"])
def test_a_parallelogram_remains_one_right_round(branch: str) -> None:
    motion = oracle.solve(four_bar(60, branch).mechanism, ROUND)
    assert motion.position("C") == pytest.approx(motion.position("B") + 0.2, abs=1e-15)
    assert np.all(motion.omega("3") == 10.0) and np.all(motion.alpha("3") == 0.0) and np.all(motion.omega("2") == 0.0)


@pytest.mark.parametrize("branch", ["C below AD", "ABCD antiparallelogram", "ABCD 为反平行四边形"])
def test_an_antiparallelogram_remains_one_right_round(branch: str) -> None:
    motion = oracle.solve(four_bar(60, branch).mechanism, ROUND)
    diagonal, other = (motion.position(p) - motion.position(q) for p, q in (("C", "A"), ("D", "B")))
    assert (diagonal * other.conj()).imag == pytest.approx(0.0, abs=1e-15)  # AC remains parallel to BD
    assert np.all(motion.omega("3") < -5.9) and motion.omega("3").min() == pytest.approx(-50 / 3)


@pytest.mark.parametrize("branch", ["C below AD", "C above AD"])
def test_the_motion_is_smooth_through_its_change_points(branch: str) -> None:
    q = np.radians(np.linspace(-200, 400, 2401))
    motion = oracle.solve(four_bar(60, branch).mechanism, q)
    for value, rate in ((motion.position("C"), motion.velocity("C")), (motion.velocity("C"), motion.acceleration("C"))):
        assert np.abs(np.gradient(value, q)[1:-1] * 10 - rate[1:-1]).max() < 1e-4 * np.abs(rate).max()


def test_a_kite_turns_half_as_fast_and_is_back_after_two_turns() -> None:
    turn = cycle(four_bar(60, "C left of BD", bc=120, cd=120, ad=50))
    assert laps_of(turn) == 2 and facts(turn).turns == {"1": 1, "2": 0.5, "3": 0.5}


def test_a_folded_kite_stays_folded() -> None:
    motion = oracle.solve(four_bar(60, "C right of BD", bc=50, cd=200).mechanism, ROUND)
    assert (
        np.abs(motion.position("C")).max() < 1e-15
        and np.all(motion.omega("2") == 10.0)
        and np.all(motion.omega("3") == 0.0)
    )


@pytest.mark.parametrize("phi", [0.0, 1e-4, 40.0, 180.0, 277.0])
def test_a_parallelogram_is_drawn_where_it_lies_in_one_line(phi: float) -> None:
    found = exactly(four_bar(phi, "ABCD parallelogram")).answers
    assert found["alpha_3"].drawn == found["alpha_3"].exact == 0.0 and found["omega_3"].drawn == pytest.approx(10.0)
    assert found["v_C"].drawn == pytest.approx(0.5) and found["v_CB"].drawn == pytest.approx(0.0, abs=1e-12)
    assert found["an_C"].drawn == pytest.approx(5.0) and found["at_C"].drawn == pytest.approx(0.0, abs=1e-9)


def test_what_no_side_can_tell_at_a_change_point_is_refused() -> None:
    for branch in ("C above AD", "ABCD antiparallelogram"):
        with pytest.raises(DeadPointError):
            solve(four_bar(180.0, branch), by="exact", repeats=0, precise=False)


def test_a_parallelogram_of_unlike_sides_is_refused_with_both_lengths() -> None:
    with pytest.raises(ProblemFileError, match=r"AB = 50 mm and CD = 60 mm are unlike"):
        four_bar(60, "ABCD parallelogram", cd=60)
    with pytest.raises(ProblemFileError, match="no link has both A and C"):
        four_bar(60, "ACBD parallelogram")


def test_the_facts_tell_that_the_rocker_turns_round_and_which_figure_remains() -> None:
    for branch, count, figure in (("C above AD", 1, "a parallelogram"), ("C below AD", -1, "an antiparallelogram")):
        turn = cycle(four_bar(60, branch))
        found = facts(turn)
        assert found.turns == {"1": 1, "2": 0, "3": count} and found.laps == 1
        assert f"ABCD$ remains {figure}." in " ".join(one.en for one in sentences(turn, found))
    assert np.all(cycle(four_bar(60, "C above AD")).real("phi_2") == 0.0)


def test_a_pose_beyond_a_change_point_keeps_the_figure() -> None:
    for problem, side in ((four_bar(60, "C above AD"), 1), (four_bar(60, "C below AD"), -1)):
        (there,) = posed(problem, np.radians([250.0]))
        assert there is not None
        assert exactly(there).answers["omega_3"].drawn * side > 5.9


def test_an_isosceles_slider_crank_runs_through_the_crank_pivot() -> None:
    """BC is as long as AB: C runs from 160 mm to -160 mm, and the rod turns backwards as fast as the crank."""
    problem = loads("""
id: isosceles
title: isosceles
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 80 mm}, 2: {BC: 80 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 40 deg, omega: 10 rad/s ccw}
branch: [C right of B]
find: [v_C]
""")
    motion = oracle.solve(problem.mechanism, ROUND)
    assert motion.position("C") == pytest.approx(0.16 * np.cos(ROUND), abs=1e-12) and motion.omega(
        "2"
    ) == pytest.approx(-10.0)
    assert facts(cycle(problem)).turns == {"1": 1, "2": -1, "3": 0}
