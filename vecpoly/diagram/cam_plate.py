"""Symbols of a plate cam on its sheet: the cam's pivot with its sense, the follower where it starts."""

from __future__ import annotations

from math import pi

from ..board.board import Board, spot
from ..board.construction import Place
from ..board.paper.marks import Arc, Dot, FixedGuide, Ground, Mark, Point, Role, Segment, TurnArrow
from ..plane import Points, Reals, nominal

STEM, SHOE, PLAY, OUT = 22.0, 7.0, 1.6, 11.0  # mm: the stem beyond the tip; its guide: length, gap, how far out
SENSE = 11.0  # mm: radius of the arrow about the pivot


def draw_pivot(board: Board, place: Place, at: Points, sense: int) -> None:
    """The pivot O on its ground, and the arrow of ω."""
    o = spot(at)
    start = 0.15 * pi if sense > 0 else 0.85 * pi
    board.mark(
        place,
        Ground(at=o, down=-1j),
        Point(at=o, label="O", dot=Dot.JOINT),
        TurnArrow(at=o, radius=SENSE, start=start, ccw=sense > 0, label="ω"),
    )


def draw_stem(board: Board, place: Place, tip: Points, way: Points, radius: Reals, face: float = 0.0) -> None:
    """A follower that slides along `way` (unit vector) above its tip, with its roller or its flat face (half, mm)."""
    b, u, r = spot(tip), spot(way), float(nominal(radius))
    marks: list[Mark] = [Segment(a=b, b=b + u * (STEM + r), role=Role.LINK)]
    low = b + u * (OUT + r)
    for side in (1, -1):
        ends = (low, low + u * SHOE)[::side]
        marks.append(FixedGuide(a=ends[0] - 1j * side * u * PLAY, b=ends[1] - 1j * side * u * PLAY))
    if face:
        marks.append(Segment(a=b - 1j * u * face, b=b + 1j * u * face, role=Role.LINK))
    board.mark(place, *marks, *_roller(b, r))


def draw_arm(board: Board, place: Place, pivot: Points, tip: Points, radius: Reals) -> None:
    """A follower that swings about A, with its roller."""
    a, b, r = spot(pivot), spot(tip), float(nominal(radius))
    board.mark(
        place,
        Segment(a=a, b=b, role=Role.LINK),
        Ground(at=a, down=-1j),
        Point(at=a, label="A", dot=Dot.JOINT),
        *_roller(b, r),
    )


def _roller(at: complex, radius: float) -> tuple[Mark, ...]:
    if not radius:
        return ()
    rim = Arc(centre=at, radius=radius, start=0.0, sweep=2 * pi, role=Role.GIVEN)
    return rim, Point(at=at, label="", dot=Dot.JOINT)
