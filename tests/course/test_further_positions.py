"""What the drawings of further positions hold belongs to them."""

from __future__ import annotations

import pytest

from tests.studies import studied
from vecpoly.board.construction import Construction, View
from vecpoly.board.paper.marks import Curve, Role
from vecpoly.mechanism.asked.machine import machine_quantities, reduced_quantities
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.report.course.results.positions import at_position, draw_there

CENTRODES = tuple(
    one.id for one in library() if (asked := getattr(load(one.id), "curvature", None)) is not None and asked.centrodes
)


def of_the_period(problem: Problem) -> set[str]:
    """What is asked and is the same wherever the drive stands."""
    if problem.machine is None:
        return set()
    asked, mech = {ask.rel.key for ask in problem.asks}, problem.mechanism
    return asked & ({*machine_quantities(mech, problem.machine)} - {*reduced_quantities(mech)})


FLYWHEELS = tuple(
    one.id for one in library() if isinstance(problem := load(one.id), Problem) and of_the_period(problem)
)


def centrodes(drawn: Construction) -> list[Curve]:
    """The fixed and the moving one."""
    marks = (mark for figure in drawn.figures for mark in figure.marks)
    return [mark for mark in marks if isinstance(mark, Curve) and mark.role in (Role.LOCUS, Role.CARRIED)]


@pytest.mark.parametrize("name", CENTRODES)
def test_centrodes_about_the_given_position_are_drawn_there_alone(name: str) -> None:
    """The pole of another position lay on neither curve of the given one."""
    it = studied(name)
    assert len(centrodes(it.solution.construction)) == 2
    there = draw_there(at_position(it, float(it.turn.phi[len(it.turn.phi) // 3])), "exact")
    assert not centrodes(there.construction) and there.construction.figure(View.MECHANISM) is not None
    assert not {key for key in there.answers if key.startswith(("L_f", "L_m"))}
    assert there.answers, "what else the report finds is drawn there"


def test_of_the_library_three_problems_ask_centrodes() -> None:
    assert {"curv-5", "curv-6", "curv-7"} <= set(CENTRODES)


@pytest.mark.parametrize("name", FLYWHEELS)
def test_what_belongs_to_the_period_is_asked_at_the_given_position_alone(name: str) -> None:
    """A flywheel is the same wherever the crank stands; J_e and M_e are not."""
    it = studied(name)
    there = at_position(it, float(it.turn.phi[len(it.turn.phi) // 3]))
    asked = {ask.rel.key for ask in it.problem.asks}
    assert {ask.rel.key for ask in there.asks} == asked - of_the_period(it.problem) != asked
    assert not there.printed


def test_of_the_library_three_flywheels_are_sought_on_linkages() -> None:
    assert {"engine-flywheel", "press-flywheel", "shaper-flywheel"} <= set(FLYWHEELS)
