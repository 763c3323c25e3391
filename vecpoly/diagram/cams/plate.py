"""Symbols of a plate cam on its sheet: the cam's pivot with its sense, the follower where it starts. Lengths in mm."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from ...board.paper.marks import Arc, Dot, Point, Role, TurnArrow
from ...board.paper.symbols import Symbol
from ...board.strokes import amount, spot
from ...plane import Points, Reals
from ..owners import joint, link
from ..single import pivot, rail, rod

STEM, SHOE, PLAY, OUT = 22.0, 7.0, 1.6, 11.0  # mm: the stem beyond the tip; its guide: length, gap, how far out
SENSE = 11.0  # mm: radius of the arrow about the pivot
CAM, FOLLOWER, ROLLER = "1", "2", "3"


def cam_pivot(at: Points, sense: int, label: str = "ω") -> Iterator[Symbol]:
    """The pivot O on its ground, and the arrow of ω; of −ω, which brings the cam to rest, in the inversion."""
    start = 0.15 * pi if sense > 0 else 0.85 * pi
    yield pivot(at, "O")
    turning = TurnArrow(at=spot(at), radius=SENSE, start=start, ccw=sense > 0, label=label)
    yield Symbol.of(link(CAM), (turning,), key="omega")


def stem(tip: Points, way: Points, radius: Reals, face: float = 0.0) -> Iterator[Symbol]:
    """A follower that slides along `way` (unit vector) above its tip, with its roller or its flat face (half, mm)."""
    b, u, r = spot(tip), spot(way), amount(radius)
    yield rod(link(FOLLOWER), b, b + u * (STEM + r))
    low = b + u * (OUT + r)
    for side in (1, -1):
        ends = (low, low + u * SHOE)[::side]
        yield rail(ends[0] - 1j * side * u * PLAY, ends[1] - 1j * side * u * PLAY)
    if face:
        yield rod(link(FOLLOWER), b - 1j * u * face, b + 1j * u * face)
    yield from _roller(b, r)


def arm(at: Points, tip: Points, radius: Reals) -> Iterator[Symbol]:
    """A follower that swings about A, with its roller."""
    yield rod(link(FOLLOWER), at, tip)
    yield pivot(at, "A")
    yield from _roller(spot(tip), amount(radius))


def face_arm(at: Points, foot: Points, along: Points) -> Iterator[Symbol]:
    """A follower with a flat face that swings about A; foot: of A on the face, along: the face from there on."""
    start, end = spot(foot), spot(foot) + spot(along)
    if abs(start - spot(at)) > PLAY:
        yield rod(link(FOLLOWER), spot(at), start)
    yield rod(link(FOLLOWER), start, end)
    yield pivot(at, "A")


def _roller(at: complex, radius: float) -> Iterator[Symbol]:
    if radius:
        rim = Arc(centre=at, radius=radius, start=0.0, sweep=2 * pi, role=Role.GIVEN)
        yield Symbol.of(link(ROLLER), (rim,))
        yield Symbol.of(joint("B"), (Point(at=at, label="", dot=Dot.JOINT),))
