"""The arrow of a velocity starts at its point; where it would lie on a link it starts beside it, and that is said."""

from __future__ import annotations

import re

from tests.drawn_library import drawn
from tests.each import each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Point, Vector
from vecpoly.drawing.legend.kinds import kinds_met

ASIDE = re.compile(r"So as to be seen, (.*?), which lies? nearly along a link")
CENTRES = ("D-1", "D-2", "D-3", "D-3-knife", "3-2", "class-iii")


@each(CENTRES)
def test_an_arrow_starts_at_its_point_or_that_it_does_not_is_said(name: str) -> None:
    here = drawn(name)
    said = " ".join(found for step in here.construction.steps for found in ASIDE.findall(step.words.en))
    for figure in here.figures(View.MECHANISM):
        spots = [mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label]
        arrows = [mark for mark in figure.marks if isinstance(mark, Vector) and mark.label.startswith("v_")]
        for arrow in arrows:
            assert (f"${arrow.label}$" in said) == (min(abs(arrow.a - spot) for spot in spots) > 0.5), arrow.label


def test_the_legend_tells_it_where_no_step_does() -> None:
    """In the report of a homework a further position has its figure and no steps."""
    for name, there in (("D-3", True), ("3-2", False)):
        told = {entry.words.zh for entry in kinds_met(drawn(name).figures(View.MECHANISM), "zh")}
        assert ("点的速度，画在点旁（以免与构件重合）" in told) is there and ("点的速度" in told or there)
