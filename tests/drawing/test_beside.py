"""Vectors on one line are seen side by side; what they stand for stays where it was."""

from __future__ import annotations

from itertools import combinations

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import Role, Segment, Vector
from vecpoly.board.paper.tones import key_of, whose
from vecpoly.drawing.beside import LANES, ON_LINE, _off_bars, beside

LONG, BY = 2.0, 2.0  # mm: vectors that are claimed about; how far one is drawn beside its line at most


def _pairs(figure: Figure) -> list[tuple[Vector, Vector]]:
    """Vectors as they are drawn and as they are."""
    inked = beside(figure.view, figure.marks)
    both = zip(inked, figure.marks, strict=True)
    return [(one, true) for one, true in both if isinstance(one, Vector) and isinstance(true, Vector)]


def _covered(one: Vector, other: Vector) -> float:
    """How far two vectors lie on each other (mm)."""
    along = (one.b - one.a) / abs(one.b - one.a)
    p, q = ((end - one.a) * along.conjugate() for end in (other.a, other.b))
    if max(abs(p.imag), abs(q.imag)) > ON_LINE:
        return 0.0
    return float(min(abs(one.b - one.a), max(p.real, q.real)) - max(0.0, min(p.real, q.real)))


@each(IDS)
def test_no_vector_of_a_polygon_covers_another_unless_more_lie_on_one_line_than_can_be_told_apart(name: str) -> None:
    for figure in drawn(name).construction.figures:
        if figure.view.bodies:
            continue
        inked = [(one, true) for one, true in _pairs(figure) if abs(true.b - true.a) > LONG]
        for (one, true), (other, others_true) in combinations(inked, 2):
            if whose(key_of(one)) == whose(key_of(other)):
                continue
            on_line = [t for _, t in inked if _covered(true, t) > LONG or _covered(others_true, t) > LONG]
            kinds = {whose(key_of(t)) for t in on_line}
            assert _covered(one, other) <= LONG or len(kinds) > len(LANES), (figure.name, one.key, other.key)


@each(IDS)
def test_a_vector_is_drawn_beside_its_line_by_two_millimetres_at_most_with_its_length_and_direction(name: str) -> None:
    for figure in drawn(name).construction.figures:
        inked = beside(figure.view, figure.marks)
        for one, true in zip(inked, figure.marks, strict=True):
            if isinstance(one, Vector) and isinstance(true, Vector):
                assert abs((one.b - one.a) - (true.b - true.a)) < 1e-9 and abs(one.a - true.a) <= BY
            else:
                assert one is true
        bars = [m for m in figure.marks if isinstance(m, Segment) and m.role is Role.LINK]
        moved = [true for one, true in _pairs(figure) if one is not true and not _off_bars(true, bars)]
        assert all(
            any(_covered(true, other) > 0.9 for _, other in _pairs(figure) if other is not true) for true in moved
        )
