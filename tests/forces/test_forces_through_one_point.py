"""Where all other forces on a link pass through one point, the reaction of its slide does too, and is drawn there."""

from __future__ import annotations

import pytest

from tests.at_once import exactly
from vecpoly import load, problem
from vecpoly.board.paper.marks import Vector
from vecpoly.problem.values.vary import data_of
from vecpoly.solution import Solution

HEAVY = "boom-heavy-cylinder"


def asked(**changed: object) -> Solution:
    """The heavy cylinder, of which the forces between barrel and piston are asked too."""
    data = data_of(load(HEAVY))
    return exactly(problem(data | {"find": [*data["find"], "R_32", "R_23"]} | changed))


def told(solution: Solution) -> str:
    return " ".join(step.words.en for step in solution.construction.steps)


def weighing(centre: object) -> dict[str, object]:
    """Its masses, that of the piston at this centre."""
    masses: dict[str, object] = data_of(load(HEAVY))["masses"]
    return masses | {"3": {"mass": "110 kg", "centre": centre}}


@pytest.mark.parametrize("size", ["200 N", "500 N", "3 kN"])
def test_the_side_force_in_a_cylinder_passes_through_the_pin_where_all_else_on_the_piston_does(size: str) -> None:
    given = data_of(load(HEAVY))["loads"]
    solution = asked(loads=given | {"Q": given["Q"] | {"size": size}})
    pin = solution.construction.readings["R_31"].acts
    assert pin is not None and "All other forces on link 3 pass through $C$" in told(solution)
    for key in ("R_32", "R_23"):
        at = solution.construction.readings[key].acts
        assert at is not None and abs(at.point - pin.point) < 1e-9
        assert solution.answers[key].drawn == pytest.approx(solution.answers[key].exact, rel=1e-9)


def test_a_piston_whose_weight_misses_the_pin_is_held_where_moments_say() -> None:
    solution = asked(masses=weighing({"along": "C", "at": "-300 mm"}))
    pin, at = (solution.construction.readings[key].acts for key in ("R_31", "R_32"))
    assert pin is not None and at is not None and abs(at.point - pin.point) > 1e-3
    assert "give the distance of the line" in told(solution) and "pass through $C$" not in told(solution)
    assert solution.answers["R_32"].drawn == pytest.approx(solution.answers["R_32"].exact, rel=1e-9)


def test_a_polygon_that_goes_on_with_the_other_link_states_its_equilibrium() -> None:
    said = " ".join(step.words.zh for step in exactly(load(HEAVY)).construction.steps)
    assert "再列构件 3 的力平衡方程 $R_{23}$ + $F_{c}$ + $G_{3}$ + $R_{13}$ = 0" in said


def test_several_forces_that_the_frame_alone_answers_have_a_resultant_in_its_line() -> None:
    steps = exactly(load(HEAVY)).construction.steps
    said = next(step.words for step in steps if "acts elsewhere" in step.words.en)
    assert "其合力与 $R_{41}$ 等值、反向、共线" in said.zh and "二者" not in said.zh
    assert "the resultant of the former and $R_{41}$" in said.en


@pytest.mark.parametrize("name", [HEAVY, "boom-thrust"])
def test_the_two_ends_of_a_thrust_have_names_of_their_own_on_the_lever(name: str) -> None:
    given = data_of(load(name))
    construction = exactly(problem(given | {"find": ["F_c", "F_c_lever"]})).construction
    (lever,) = (figure for figure in construction.figures if "lever" in figure.title.en)
    arrows = [mark.label for mark in lever.marks if isinstance(mark, Vector) and mark.label.startswith("F_{c")]
    assert sorted(arrows) == ["F_{c}", "F_{c′}"]


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({}, "whose links have masses, is no two-force member"),
        ({"friction": {"C": {"rho": "4 mm"}}}, "whose links have masses and in which there is friction, is no"),
        ({"masses": {1: {"mass": "220 kg", "centre": "C"}}, "friction": {"2-3": {"f": 0.1}}}, "3, in which there is"),
    ],
)
def test_a_cylinder_that_is_no_two_force_member_is_told_for_what_holds(changed: dict[str, object], said: str) -> None:
    find = {"find": ["F_c"]}
    assert said in told(exactly(problem(data_of(load(HEAVY)) | find | changed)))
