"""Vectors on one line may be drawn side by side: such a polygon closes, one with a true gap does not."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tests.grading.drawings.made import changed, drawn, key_of
from vecpoly.grading.drawings.grade import grade_drawing
from vecpoly.grading.drawings.segment import Segment

KEY = key_of("3-12")  # v_F and v_D5 lie on one line through the pole


def laid(one: Segment, off: complex) -> Segment:
    """The line elsewhere, seen along it."""
    by = off * one.along / abs(one.along)
    return replace(one, start=one.start + by, end=one.end + by)


def said_of(moved: str, across: float, ahead: float = 0.0) -> str:
    """What is remarked of the velocity polygon with one of its vectors this far (mm) beside and ahead of its place."""
    made = changed(drawn(KEY.exact), f"velocity:{moved}", lambda one: laid(one, ahead + 1j * across))
    mark = grade_drawing(KEY, made)
    velocities = next(one for one in mark.figures if one.figure == "velocity")
    return " ".join(words.en for words in velocities.remarks)


@pytest.mark.parametrize("moved", ["v_F", "v_D5"])
@pytest.mark.parametrize("across", [1.5, -2.5])
def test_a_vector_beside_another_on_its_line_leaves_no_gap(moved: str, across: float) -> None:
    assert "close" not in said_of(moved, across)


@pytest.mark.parametrize(
    ("moved", "across", "ahead"), [("v_C", 1.5, 0.0), ("v_D5D4", -2.5, 0.0), ("v_F", 1.5, 2.0), ("v_D5", 4.0, 0.0)]
)
def test_another_gap_is_told(moved: str, across: float, ahead: float) -> None:
    assert "does not close" in said_of(moved, across, ahead)
