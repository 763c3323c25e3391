"""Solving a problem: drawn and exact side by side, within the hand's own accuracy, or a refusal that names the part."""

from __future__ import annotations

import re
from dataclasses import replace
from math import radians
from pathlib import Path

import pytest

from tests.at_once import exactly
from tests.drawn_library import DRAFTED, IDS, drafted
from tests.drawn_library import drawn as by_exact_hand
from tests.each import each
from tests.laws import few, often
from vecpoly import load, loads
from vecpoly.errors import AssemblyError, DeadPointError
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import solve

FOUR_BAR = """
id: four-bar
title: {{zh: 四杆机构, en: four-bar}}
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links:
  1: {{AB: {ab} mm}}
  2: {{BC: {bc} mm}}
  3: {{CD: {cd} mm}}
input: {{link: 1, phi: {phi} deg, omega: 10 rad/s ccw}}
{branch}
find: [v_C, omega_2, omega_3, a_C, alpha_2, alpha_3]
"""


def four_bar(
    ab: float = 60,
    bc: float = 120,
    cd: float = 90,
    ad: float = 120,
    phi: float = 50,
    branch: str = "branch: [C above AD]",
) -> str:
    return FOUR_BAR.format(ab=ab, bc=bc, cd=cd, ad=ad, phi=phi, branch=branch)


LOST = 1e-4  # of what a sum was made of: forces of an engine that balance each other


@each(IDS)
def test_the_exact_hand_agrees_with_the_oracle(name: str) -> None:
    for key, a in by_exact_hand(name).solution.answers.items():
        drawn = a.drawn_vector if a.drawn_vector is not None else a.drawn
        exact = a.exact_vector if a.exact_vector is not None else a.exact
        assert abs(drawn - exact) <= 1e-9 * max(abs(exact), 1e-4, LOST * a.weighed.size), key


@each(DRAFTED)
def test_drafting_readings_lie_within_their_expected_error(name: str) -> None:
    solution = drafted(name)
    assert solution is not None
    for key, a in solution.answers.items():
        assert abs(a.deviation) <= a.expected_error + 1e-12 * max(1.0, abs(a.exact)), key


@pytest.mark.parametrize("name", few(["3-5", "3-9", "3-12"], 3))
def test_most_pencil_readings_lie_within_their_expected_error(name: str) -> None:
    inside = total = 0
    for seed in range(often(10, 20)):
        for a in solve(load(name), by="pencil", seed=seed).answers.values():
            total += 1
            inside += abs(a.deviation) <= a.expected_error + 1e-12
    assert inside / total > 0.97


def test_a_pencil_hand_is_repeatable_by_its_seed() -> None:
    one, two, other = (solve(load("3-9"), by="pencil", seed=s).as_json() for s in (3, 3, 4))
    assert one == two != other


def test_gears_rolling_on_a_rack_and_on_each_other_have_drawn_accelerations_too() -> None:
    problem = load("3-13")
    text = re.sub(
        r"find: \[.*\]",
        "find: [a_C, a_E, alpha_2, alpha_3, alpha_4, alpha_6]",
        Path(str(problem.path)).read_text(encoding="utf-8"),
    )
    for key, a in exactly(loads(text)).answers.items():
        assert a.drawn == pytest.approx(a.exact, rel=1e-9), key


def test_links_that_cannot_meet_are_refused_with_gap_and_range() -> None:
    with pytest.raises(AssemblyError, match=r"joint C: .* mm .* 180°.*within 296\.85° to 423\.15°"):
        solve(loads(four_bar(ab=100, bc=150, cd=120, ad=300, phi=180)))


def test_an_unsaid_branch_is_refused_with_the_words_that_help() -> None:
    with pytest.raises(AssemblyError, match="say which: 'C left of"):
        solve(loads(four_bar(branch="")))


def test_the_change_point_of_a_parallelogram_is_refused_as_a_dead_point() -> None:
    with pytest.raises(DeadPointError):
        solve(loads(four_bar(ab=60, bc=120, cd=60, ad=120, phi=0, branch="branch: [C right of D]")))


def test_collinear_joints_are_no_obstacle() -> None:
    """Crank and coupler in line (limit position of the rocker): ω_3 = 0, and both ways say so."""
    answers = exactly(loads(four_bar(phi=26.38425))).answers
    assert answers["omega_3"].drawn == pytest.approx(answers["omega_3"].exact, abs=1e-9)
    assert abs(answers["omega_3"].exact) < 1e-4


def test_equal_ordinates_are_no_obstacle() -> None:
    """A slider-crank with crank pin and piston at one height."""
    text = """
id: level
title: {zh: 曲柄滑块, en: slider-crank}
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {BC: 80 mm}, 3: {block: C}}
joints: [3 slides on y = 30 mm]
input: {link: 1, phi: 90 deg, omega: 10 rad/s ccw}
branch: [C right of B]
find: [v_C, a_C, omega_2, alpha_2]
"""
    for key, a in exactly(loads(text)).answers.items():
        assert a.drawn == pytest.approx(a.exact, rel=1e-9, abs=1e-12), key


def test_a_drag_link_turns_through_every_position() -> None:
    for phi in few(range(5, 360, 15), 2):
        text = four_bar(ab=280, bc=350, cd=320, ad=160, phi=phi, branch="branch: [C right of BD]")
        answers = exactly(loads(text)).answers
        assert answers["alpha_3"].drawn == pytest.approx(answers["alpha_3"].exact, rel=1e-8, abs=1e-8)


def test_the_conveyor_at_120_degrees_agrees_with_the_report_s_whole_cycle_table() -> None:
    text = Path(str(load("C-conveyor").path)).read_text(encoding="utf-8").replace("127.35 deg", "120 deg")
    answers = exactly(loads(text)).answers
    assert answers["omega_2"].drawn == pytest.approx(0.17035286169192615, rel=1e-9)
    assert answers["omega_3"].drawn == pytest.approx(1.3108645229856541, rel=1e-9)
    assert answers["alpha_3"].drawn == pytest.approx(0.5090096637699539, rel=1e-9)
    assert answers["a_E"].drawn_vector == pytest.approx(0.10418828837077336 - 0.9801714318790871j, rel=1e-9)


def test_what_is_replaced_in_python_is_printed_as_it_is() -> None:
    problem = load("3-9")
    mech = problem.mechanism
    longer = replace(mech.link("1"), points={"A": 0j, "B": 0.04 + 0j})
    faster = replace(mech.drive, rate=-20.0, position=mech.drive.position + radians(30))
    changed = replace(
        problem,
        subject=replace(
            mech, links=tuple(longer if link.name == "1" else link for link in mech.links), drives=(faster,)
        ),
    )
    given = {datum.symbol: datum.text for datum in (*changed.given.lengths, *changed.given.motion)}
    assert given["l_AB"] == "40 mm"
    assert given["ω_1"] == "20 rad/s cw"
    assert given["φ_1"] == "75 deg"
    untouched = {datum.symbol: datum for datum in problem.given.lengths}
    assert all(datum is untouched[datum.symbol] for datum in changed.given.lengths if datum.symbol != "l_AB")
    assert exactly(changed).answers["v_B"].exact == pytest.approx(0.8)


def test_data_of_which_nothing_was_replaced_stay_as_they_were_written() -> None:
    bound = 0
    for name in IDS:
        problem = load(name)
        if isinstance(problem.subject, Mechanism):
            bound += len(problem.given.bound or ())
            assert replace(problem, subject=replace(problem.subject)).given == problem.given
    assert bound > 250


def test_what_is_no_vector_or_vanishes_has_no_direction() -> None:
    answers = by_exact_hand("3-9").solution.answers
    assert answers["omega_3"].direction is None and replace(answers["v_E"], drawn_vector=0j).direction is None
    south = replace(answers["v_E"], drawn_vector=-1j).direction
    assert south is not None and south % 360 == pytest.approx(270)


def test_a_place_at_infinity_says_so_in_json_and_has_no_coordinates() -> None:
    place = by_exact_hand("3-2").solution.answers["p_E2"]
    assert "drawn_xy" in place.as_json() and "at_infinity" not in place.as_json()
    away = replace(place, drawn_vector=None, exact_vector=None).as_json()
    assert away["at_infinity"] is True and "drawn_xy" not in away
