"""A free body has all its forces: one whose line passes far from its block is drawn at it, with its couple."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import drawn
from vecpoly import oracle
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import TurnArrow, Vector
from vecpoly.oracle.forces import forces
from vecpoly.plane import cross
from vecpoly.problem.library import find
from vecpoly.problem.load import loads
from vecpoly.solution import solve


def test_a_block_with_two_slides_has_both_reactions_and_their_couples() -> None:
    body = next(figure for figure in drawn("plate-two-slides").figures(View.BODY) if figure.name == "5")
    forces = {mark.label: (mark.a + mark.b) / 2 for mark in body.marks if isinstance(mark, Vector)}
    assert {"R_{65}", "R_{25}", "Q_{5}"} <= set(forces)
    middle = sum(forces.values()) / len(forces)
    assert all(abs(at - middle) < 30 for at in forces.values())
    turning = {mark.label: mark.ccw for mark in body.marks if isinstance(mark, TurnArrow)}
    assert {"M(R_{65})", "M(R_{25})", "M_{5}"} <= set(turning)
    assert turning["M(R_{65})"] is not turning["M(R_{25})"]  # ΣM_K = 0: the larger of them is against M_5 and the other


def test_the_line_of_a_guide_bar_is_not_moved() -> None:
    """4-6's bar goes on to where its block presses on it."""
    assert not any("of its transfer" in step.words.en for step in drawn("4-6").construction.steps)


@pytest.mark.parametrize(("x", "y"), [(0, 0), (-500, 300), (500, -400)])
def test_the_couple_of_a_force_brought_near_turns_as_the_force_does_about_the_block(x: int, y: int) -> None:
    """Wherever the origin of the coordinates lies; the oracle tells where the force acts."""
    found = find("plate-two-slides")
    assert found is not None
    text = re.sub(
        r"(\b[A-Z]: )\[(-?\d+) mm, (-?\d+) mm\]",
        lambda m: f"{m[1]}[{int(m[2]) + x} mm, {int(m[3]) + y} mm]",
        found.read_text(encoding="utf-8"),
    )
    solution = solve(loads(text), by="exact", repeats=0, precise=False)
    problem = solution.problem
    assert problem.loads is not None
    exact, block = forces(problem.mechanism, problem.loads), oracle.solve(problem.mechanism, order=0).position("K")
    (body,) = (one for one in solution.construction.figures if one.view is View.BODY and one.name == "5")
    turning = {mark.label: mark.ccw for mark in body.marks if isinstance(mark, TurnArrow)}
    for by in "62":
        about = cross(exact.line(by, "5") - block, exact.value(f"R_{by}5"))
        assert turning[f"M(R_{{{by}5}})"] is bool(about > 0)
