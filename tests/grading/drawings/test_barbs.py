"""Arrow heads drawn as lines, as many do by hand: they are heads, and no vectors."""

from __future__ import annotations

from cmath import rect
from dataclasses import replace

import pytest

from tests.grading.drawings.made import drawn, key_of, marked
from tests.laws import few
from vecpoly.grading.drawings.judging.mark import Verdict
from vecpoly.grading.drawings.matching.barbs import headed_by_barbs
from vecpoly.grading.drawings.segment import Drawing, Segment

LONG = 3.0  # mm, a barb


def barbed(drawing: Drawing, *, closed: bool, turned: str = "") -> Drawing:
    """Each head as two lines, or three; of one vector at the wrong end."""
    lines: list[Segment] = []
    for one in drawing.segments:
        lines.append(replace(one, headed=False))
        if one.headed:
            way = one.turned() if one.where == turned else one
            size = min(LONG, 0.3 * abs(way.along))
            back = -way.along / abs(way.along) * size
            left, right = (way.end + back * rect(1, side * 0.3) for side in (1, -1))
            bare = replace(one, headed=False, name="", where="barb")
            lines += [replace(bare, start=way.end, end=end) for end in (left, right)]
            lines += [replace(bare, start=left, end=right)] * closed
    return replace(drawing, segments=tuple(lines))


@pytest.mark.parametrize("closed", [False, True])
@pytest.mark.parametrize("problem", few(["3-9", "3-12", "4-3a", "A-27"], 2))
def test_heads_drawn_as_lines_are_heads(problem: str, closed: bool) -> None:
    key = key_of(problem)
    mark = marked(key, barbed(drawn(key.exact), closed=closed))
    assert mark.right and not any(figure.extra or figure.remarks for figure in mark.figures)
    assert all(one.verdict is Verdict.RIGHT and one.sense for one in mark.vectors if one.figure != "mechanism")


def test_a_head_of_lines_at_the_wrong_end_is_a_reversed_arrow() -> None:
    key = key_of("3-9")
    mark = marked(key, barbed(drawn(key.exact), closed=False, turned="velocity:v_C2B"))
    assert [(one.key, one.sense) for one in mark.vectors if one.verdict is not Verdict.RIGHT] == [("v_C2B", False)]


def test_a_polygon_without_heads_keeps_all_its_lines() -> None:
    for problem in few(("3-9", "3-12", "4-3a", "A-27", "4-5"), 2):
        lines = drawn(key_of(problem).exact, heads=False).segments
        assert headed_by_barbs(lines) == (lines, ())
