"""Vectors of a polygon that lie on one line are inked side by side, as a hand draws them, so that each can be seen.

Nothing else moves: what is measured, the letters of points and the points themselves stay on the true line.
"""

from __future__ import annotations

from collections.abc import Sequence

from ..board.construction import View
from ..board.paper.marks import Mark, Vector
from ..board.paper.tones import key_of, whose
from ..foundation.slotted import replace

ASIDE = 1.5  # mm between two vectors on one line
ON_LINE, OVERLAP = 0.15, 1.0  # mm beside a line that is still the line; of two vectors that must lie on each other
LANES = (0.0, ASIDE, -ASIDE)  # beside the true line, in order
SHORT = 2.0  # mm: shorter vectors stay
SAME = 1e-6  # mm


def beside(view: View, marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks with vectors that cover each other drawn apart, the longest on the true line as a rule."""
    if view.bodies:
        return marks  # there forces stand where they act
    vectors = [mark for mark in marks if isinstance(mark, Vector) and abs(mark.b - mark.a) > SHORT]
    order = sorted(range(len(vectors)), key=lambda n: (-round(abs(vectors[n].b - vectors[n].a), 6), n))
    lanes = _lanes([vectors[n] for n in order])
    moved = {id(vectors[n]): aside for n, aside in zip(order, lanes, strict=True) if aside}
    return tuple(_moved(mark, moved.get(id(mark), 0.0)) for mark in marks) if moved else marks


def _lanes(vectors: Sequence[Vector]) -> list[float]:
    """Where each is drawn, first beside longer ones; then beside shorter ones, too, that only its own line holds."""
    lanes: dict[int, float] = {}
    for _ in range(2):
        for n, one in enumerate(vectors):
            twin = next((m for m in range(n) if _are_one(one, vectors[m])), None)
            others = [(vectors[m], lanes[m]) for m in lanes if not _are_one(one, vectors[m])]
            lanes[n] = lanes[twin] if twin is not None else _lane(one, lanes.get(n, 0.0), others)
    return [lanes[n] for n in range(len(vectors))]


def _lane(one: Vector, own: float, others: Sequence[tuple[Vector, float]]) -> float:
    """Its own place where it covers none, or the first where no vector is; its own where all are taken."""
    if own not in {lane for other, lane in others if _covers(one, other)}:
        return own
    taken = {lane for other, lane in others if _covers(one, other) or _covers(other, one)}
    return next((lane for lane in LANES if lane not in taken), own)


def _covers(one: Vector, other: Vector) -> bool:
    """Whether a part of the other lies on the line of one."""
    along = (one.b - one.a) / abs(one.b - one.a)
    p, q = ((end - one.a) * along.conjugate() for end in (other.a, other.b))
    if max(abs(p.imag), abs(q.imag)) > ON_LINE:
        return False
    return bool(min(abs(one.b - one.a), max(p.real, q.real)) - max(0.0, min(p.real, q.real)) > OVERLAP)


def _are_one(one: Vector, other: Vector) -> bool:
    """Whether a vector is drawn twice: known first, then as the result."""
    return whose(key_of(one)) == whose(key_of(other)) and abs(one.a - other.a) + abs(one.b - other.b) < SAME


def _moved(mark: Mark, aside: float) -> Mark:
    if not aside or not isinstance(mark, Vector):
        return mark
    by = aside * _normal(mark)
    return replace(mark, a=mark.a + by, b=mark.b + by)


def _normal(mark: Vector) -> complex:
    """Square to the line, and the same for both ways along it."""
    along = (mark.b - mark.a) / abs(mark.b - mark.a)
    up = along.imag > SAME or (along.imag > -SAME and along.real > 0)
    return complex(1j * (along if up else -along))
