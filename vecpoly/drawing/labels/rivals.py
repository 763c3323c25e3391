"""A label belongs to what it is nearest to: what it costs to stand nearer to another thing than to one's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from .obstacles import Complexes, Floats, clip
from .want import Spot, Thing, Want

WRONG = 55.0  # nearer to another than to its own, with no leader to tell
DOUBTFUL = 0.6  # mm: nearly as near
REACH = 20.0  # mm from what it names within which a label without a leader stands


def rivals(want: Want, others: Sequence[Want], unnamed: Sequence[Spot]) -> tuple[Complexes, Complexes, Floats]:
    """The lines a -> b and half the widths of all other things of the same kind for which its label could be taken,
    points without a name among them."""
    found = [w for w in others if w.thing is want.thing and w.own != want.own] if want.thing is not Thing.OTHER else []
    places = [(*w.own, w.radius) for w in found]
    if want.thing is Thing.POINT:
        places += [(at, at, radius) for at, radius in unnamed]
    a, b = np.array([p[0] for p in places], dtype=complex), np.array([p[1] for p in places], dtype=complex)
    radius = np.array([p[2] for p in places], dtype=float)
    reach = REACH + abs(want.own[1] - want.own[0]) / 2
    middle = (want.own[0] + want.own[1]) / 2
    near = np.abs(middle - _on(np.full(len(a), middle), a, b)) < reach
    return a[near], b[near], radius[near]


def misled(want: Want, others: Sequence[Want], unnamed: Sequence[Spot], centre: Complexes) -> Floats:
    """What each place of a label without a leader costs for the other things that it could be taken to name."""
    a, b, radius = rivals(want, others, unnamed)
    if not len(a):
        return np.zeros(len(centre))
    half = complex(want.width / 2, want.height / 2)
    p, q = want.own
    gap = distance(centre, half, np.append(p, a), np.append(q, b))
    return _cost(gap[:, 0] - want.radius, (gap[:, 1:] - radius).min(axis=1))


def misled_here(wanted: Sequence[Want], at: Mapping[int, complex], unnamed: Sequence[Spot]) -> Floats:
    """The same of labels that stand already; at: where the middle is of some of those that are wanted."""
    lines = [*(want.own for want in wanted), *((spot, spot) for spot, _ in unnamed)]
    radius = np.array([*(want.radius for want in wanted), *(size for _, size in unnamed)])
    things = np.array([*(want.thing.value for want in wanted), *[Thing.POINT.value] * len(unnamed)])
    centre, which = np.array(list(at.values()), dtype=complex), np.array(list(at), dtype=np.intp)
    if not len(centre):
        return np.zeros(0)
    half = np.array([complex(wanted[i].width / 2, wanted[i].height / 2) for i in at])[:, None]
    gap = distance(centre, half, *np.array(lines, dtype=complex).T) - radius
    alike = (things == things[which, None]) & (things != Thing.OTHER.value)
    others = np.array([[line != wanted[i].own for line in lines] for i in at])
    return _cost(gap[np.arange(len(which)), which], np.where(alike & others, gap, np.inf).min(axis=1))


def _cost(own: Floats, rival: Floats) -> Floats:
    """Of labels so far from what they name and from the nearest other thing, mm."""
    result: Floats = WRONG * np.clip((own + DOUBTFUL - rival) / DOUBTFUL, 0.0, 1.0)
    return result


def distance(centre: Complexes, half: complex | Complexes, a: Complexes, b: Complexes) -> Floats:
    """From each rectangle (centre ± half; of all, or a column) to each line a -> b, mm; shape (rectangles, lines)."""
    c = centre[:, None]
    ends = np.minimum(_outside(a - c, half), _outside(b - c, half))
    corners = c[:, :, None] + np.stack([half, -half, np.conjugate(half), -np.conjugate(half)], axis=-1)
    touch = np.abs(corners - _on(corners, a[None, :, None], b[None, :, None])).min(axis=2)
    start, end, middle = np.broadcast_arrays(a, b, c)
    _, hit = clip(start, end, middle, half.real, half.imag)
    result: Floats = np.where(hit, 0.0, np.minimum(ends, touch))
    return result


def _outside(d: Complexes, half: complex | Complexes) -> Floats:
    """Distance of points, seen from the middle of a rectangle, from it."""
    result: Floats = np.hypot(np.maximum(np.abs(d.real) - half.real, 0.0), np.maximum(np.abs(d.imag) - half.imag, 0.0))
    return result


def _on(p: Complexes, a: Complexes, b: Complexes) -> Complexes:
    """The points of lines a -> b nearest to points p."""
    d = b - a
    t = ((p - a) * d.conjugate()).real / np.maximum(np.abs(d) ** 2, 1e-12)
    result: Complexes = a + np.clip(t, 0.0, 1.0) * d
    return result
