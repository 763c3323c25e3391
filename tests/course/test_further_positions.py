"""What the drawings of further positions hold belongs to them."""

from __future__ import annotations

import pytest

from tests.studies import studied
from vecpoly.board.construction import Construction, View
from vecpoly.board.paper.marks import Curve, Role
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.report.course.results.positions import at_position, draw_there

CENTRODES = tuple(
    one.id for one in library() if (asked := getattr(load(one.id), "curvature", None)) is not None and asked.centrodes
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
