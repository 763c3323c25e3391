"""A free body has all its forces: one whose line passes far from its block is drawn at it, with its couple."""

from __future__ import annotations

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import TurnArrow, Vector


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
