"""Vectors that lie on one line, or on a bar, are inked side by side, as a hand draws them, so that each can be seen.

Nothing else moves: what is measured, the letters of points and the points themselves stay on the true line.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import NDArray

from ..board.construction import View
from ..board.paper.marks import Mark, Role, Segment, Vector
from ..board.paper.tones import key_of, whose
from ..foundation.slotted import replace

ASIDE = 1.5  # mm between two vectors on one line
ON_LINE, OVERLAP = 0.15, 1.0  # mm beside a line that is still the line; of two vectors that must lie on each other
LANES = (0.0, ASIDE, -ASIDE)  # beside the true line, in order
SHORT = 2.0  # mm: shorter vectors stay
SAME = 1e-6  # mm


def beside(view: View, marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks with vectors that cover each other drawn apart, the longest on the true line as a rule; on a mechanism
    those apart that lie on a bar."""
    if view is View.MECHANISM:
        bars = [mark for mark in marks if isinstance(mark, Segment) and mark.role is Role.LINK]
        aside = [_off_bars(mark, bars) for mark in marks]
        return tuple(map(_moved, marks, aside)) if any(aside) else marks
    if view.bodies:
        return marks  # there forces stand where they act
    vectors = [mark for mark in marks if isinstance(mark, Vector) and abs(mark.b - mark.a) > SHORT]
    order = sorted(range(len(vectors)), key=lambda n: (-round(abs(vectors[n].b - vectors[n].a), 6), n))
    lanes = _lanes([vectors[n] for n in order])
    moved = {id(vectors[n]): aside for n, aside in zip(order, lanes, strict=True) if aside}
    return tuple(_moved(mark, moved.get(id(mark), 0.0)) for mark in marks) if moved else marks


def _off_bars(vector: Mark, bars: Sequence[Segment]) -> float:
    """Beside the bar on which a vector lies, which would hide it."""
    if not isinstance(vector, Vector) or abs(vector.b - vector.a) <= SHORT:
        return 0.0
    along = ((vector.b - vector.a) / abs(vector.b - vector.a)).conjugate()
    for bar in bars:
        p, q = (bar.a - vector.a) * along, (bar.b - vector.a) * along
        shared = min(abs(vector.b - vector.a), max(p.real, q.real)) - max(0.0, min(p.real, q.real))
        if max(abs(p.imag), abs(q.imag)) <= ON_LINE and shared > OVERLAP:
            return ASIDE
    return 0.0


def _lanes(vectors: Sequence[Vector]) -> list[float]:
    """Where each is drawn, first beside longer ones; then beside shorter ones, too, that only its own line holds."""
    lanes: dict[int, float] = {}
    covers, known = _covers(vectors), [whose(key_of(one)) for one in vectors]
    twins = [_twins(n, vectors, known) for n in range(len(vectors))]
    others = [
        set(np.flatnonzero(row).tolist()).difference(some) for row, some in zip(covers | covers.T, twins, strict=True)
    ]
    for _ in range(2):
        for n, (first, *_) in enumerate(twins):
            there = {m: lanes[m] for m in others[n] if m in lanes}
            covered = {lane for m, lane in there.items() if covers[n, m]}
            lanes[n] = lanes[first] if first < n else _lane(lanes.get(n, 0.0), covered, there.values())
    return list(lanes.values())


def _lane(own: float, covered: Collection[float], taken: Collection[float]) -> float:
    """Its own place where it covers none, or the first where no vector is; its own where all are taken."""
    return own if own not in covered else next((lane for lane in LANES if lane not in taken), own)


def _covers(vectors: Sequence[Vector]) -> NDArray[np.bool_]:
    """Whether a part of the second lies on the line of the first, of each two."""
    a, b = np.array([(one.a, one.b) for one in vectors], dtype=complex).reshape(-1, 2).T[:, None]
    long = np.abs(b - a).T
    along = ((b - a) / np.abs(b - a)).conjugate().T
    p, q = (a - a.T) * along, (b - a.T) * along
    shared = np.minimum(long, np.maximum(p.real, q.real)) - np.maximum(0.0, np.minimum(p.real, q.real))
    result: NDArray[np.bool_] = (np.maximum(abs(p.imag), abs(q.imag)) <= ON_LINE) & (shared > OVERLAP)
    return result


def _twins(n: int, vectors: Sequence[Vector], known: Sequence[str]) -> list[int]:
    """Where a vector is drawn once more, itself included: known first, then as the result."""
    one, alike = vectors[n], (m for m, name in enumerate(known) if name == known[n])
    return [m for m in alike if abs(one.a - vectors[m].a) + abs(one.b - vectors[m].b) < SAME]


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
