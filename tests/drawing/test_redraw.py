"""A drawing that follows its problem: scales held, letters carried on, nothing weighed."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.laws import few
from vecpoly import redraw
from vecpoly.errors import VecpolyError
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.solution import scales_of, solve

DRAWN = ("3-9", "six-bar-dynamic", "A-27", "4-3a")


def turned(problem: Problem, by: float) -> Problem:
    """The problem with its drive a little further on."""
    mech = problem.mechanism
    return replace(
        problem,
        subject=replace(mech, drives=(replace(mech.drive, position=mech.drive.position + by), *mech.drives[1:])),
    )


@pytest.mark.parametrize("name", few(DRAWN, 2))
def test_a_problem_redrawn_unchanged_has_the_marks_and_readings_it_had(name: str) -> None:
    solution = solve(load(name), repeats=0, precise=False)
    again = redraw(solution, solution.problem)
    assert [f.marks for f in again.construction.figures] == [f.marks for f in solution.construction.figures]
    assert {k: r.scalar for k, r in again.construction.readings.items()} == {
        k: r.scalar for k, r in solution.construction.readings.items()
    }


@pytest.mark.parametrize("name", few(DRAWN, 2))
def test_scales_are_held_while_the_drive_turns(name: str) -> None:
    last = solve(load(name), repeats=0, precise=False)
    then = redraw(last, turned(last.problem, 0.02))
    assert scales_of(then.construction) == scales_of(last.construction)
    assert [f.marks for f in then.construction.figures] != [f.marks for f in last.construction.figures]


@pytest.mark.parametrize("name", few(DRAWN, 2))
def test_nearly_all_letters_stay_beside_what_they_name_on_the_same_side(name: str) -> None:
    first = redraw(solve(load(name), repeats=0, precise=False), load(name))
    then = redraw(first, turned(first.problem, 0.002))
    kept = [
        then.letters[figure].get(label) == choice
        for figure, labels in first.letters.items()
        for label, choice in labels.items()
    ]
    assert sum(kept) >= 0.9 * len(kept)


@pytest.mark.parametrize("name", few(DRAWN, 2))
def test_what_is_redrawn_is_what_would_be_drawn_afresh_at_these_scales(name: str) -> None:
    last = solve(load(name), repeats=0, precise=False)
    moved = turned(last.problem, -0.03)
    afresh = solve(replace(moved, scales=scales_of(last.construction)), repeats=0, precise=False).construction
    assert [f.marks for f in redraw(last, moved).construction.figures] == [f.marks for f in afresh.figures]


def test_a_place_that_cannot_be_assembled_is_refused_and_the_last_drawing_remains() -> None:
    problem = load("4-3a")
    first = redraw(solve(problem, repeats=0, precise=False), problem)
    mech = problem.mechanism
    short = replace(
        mech,
        links=tuple(
            replace(li, points={p: z / 50 for p, z in li.points.items()}) if li.name == "2" else li for li in mech.links
        ),
    )
    with pytest.raises(VecpolyError):
        redraw(first, replace(problem, subject=short))
    assert redraw(first, problem).construction == first.construction


def test_checking_what_is_redrawn_sets_exact_values_beside_it() -> None:
    first = redraw(solve(load("3-9"), repeats=0, precise=False), turned(load("3-9"), 0.1))
    checked = first.check()
    assert not checked.suspect
    assert {key: answer.drawn for key, answer in checked.answers.items()} == {
        key: r.scalar for key, r in first.construction.readings.items()
    }


@pytest.mark.parametrize("name", ("2-1", "2-10"))
def test_devices_are_redrawn_too(name: str) -> None:
    problem = load(name)
    assert redraw(solve(problem, repeats=0, precise=False), problem).scenes
