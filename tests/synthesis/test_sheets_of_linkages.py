"""What the sheets of linkages that are found, or whose limits are, show: strokes, offsets, dashes that stay dashes."""

from __future__ import annotations

import re

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Point, Role, Segment, Vector
from vecpoly.designs.base import Design
from vecpoly.designs.inversion.positions import Positions

DESIGNS = Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Design)])
ON, LEAST = 0.2, 2.0  # mm: lines that are one; of dashes over dashes


def over(one: Segment, other: Segment) -> float:
    """How much of a line (mm) lies on another one."""
    along = other.b - other.a
    if abs(along) < LEAST:
        return 0.0
    shares = [(end - other.a) / along for end in (one.a, one.b)]
    if max(abs(share.imag) for share in shares) * abs(along) > ON:
        return 0.0
    low, high = sorted(share.real for share in shares)
    return (min(1.0, high) - max(0.0, low)) * abs(along)


@each(DESIGNS)
def test_no_dashed_bar_of_a_position_lies_on_another_of_it(name: str) -> None:
    for figure in drawn(name).figures(View.MECHANISM):
        dashed = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.OTHER]
        for i, one in enumerate(dashed):
            doubled = [other for other in dashed[i + 1 :] if other.step == one.step and over(one, other) > LEAST]
            assert not doubled, (figure.name, one.a, one.b)


def spanned(name: str, symbol: str) -> list[float]:
    """The lengths (m) of the dimension lines that this letter stands beside the middle of."""
    found = []
    for figure in drawn(name).figures(View.MECHANISM):
        letters = [m.at for m in figure.marks if isinstance(m, Point) and m.label == symbol]
        lines = [m for m in figure.marks if isinstance(m, Vector) and m.role is Role.CONSTRUCTION]
        found += [
            abs(m.b - m.a) * figure.scale.value for m in lines for at in letters if abs((m.a + m.b) / 2 - at) < ON
        ]
    return found


def test_the_stroke_and_the_offset_of_a_slider_crank_stand_on_its_sheet() -> None:
    reading = drawn("8-3b").solution.answers["H"].drawn
    assert reading is not None
    assert any(abs(size - reading * 1e-3) < 1e-4 for size in spanned("8-3b", "H")), spanned("8-3b", "H")
    assert any(abs(size - 0.028) < 1e-6 for size in spanned("8-3b", "e"))


@each(Later(lambda: [name for name in LIBRARY if isinstance(given(name).subject, Positions)]))
def test_the_origin_of_a_body_in_each_position_is_a_point_of_its_sheet(name: str) -> None:
    """ "Draw the three positions of the body S" was said, and no S was drawn."""
    subject, (figure, *_) = given(name).subject, drawn(name).figures(View.MECHANISM)
    assert isinstance(subject, Positions)
    marks = [mark for mark in figure.marks if isinstance(mark, Point) and mark.label]
    first = next(iter(drawn(name).construction.steps)).words.en
    origins = [pose.position.at / figure.scale.value for pose in subject.poses]
    start = next(mark.at for mark in marks if re.fullmatch("[BCPS]_1", mark.label) and abs(mark.at - origins[0]) < ON)
    for at in origins:
        (mark, *_) = (mark for mark in marks if abs(mark.at - start - (at - origins[0])) < ON)
        assert mark.label[0] != "S" or "$S_i$" in first
