"""A label belongs to what it is nearest to: what it costs to stand nearer to another thing than to one's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from .obstacles import Complexes, Floats, Indices, clip
from .want import Spot, Thing, Want

WRONG = 55.0  # nearer to another than to its own, with no leader to tell
DOUBTFUL = 0.6  # mm: nearly as near
REACH = 20.0  # mm from what it names within which a label without a leader stands
ON = 0.3  # mm: a point so near to a line is on it


@dataclass(frozen=True, slots=True)
class Named:
    """All that labels of a figure name, points without a name among them: lines a -> b, and of which label each is."""

    a: Complexes
    b: Complexes
    radius: Floats
    of: Indices  # the number of the label, or of the point after all labels

    @classmethod
    def by(cls, wanted: Sequence[Want], unnamed: Sequence[Spot]) -> Named:
        """What these labels name, and the points that have none."""
        lines = [(a, b, want.radius, i) for i, want in enumerate(wanted) for a, b in pairwise(want.course)]
        lines += [(at, at, radius, len(wanted) + i) for i, (at, radius) in enumerate(unnamed)]
        a, b, radius, of = zip(*lines, strict=True) if lines else ((), (), (), ())
        return cls(
            np.array(a, dtype=complex), np.array(b, dtype=complex), np.array(radius, float), np.array(of, dtype=np.intp)
        )


def rivals(want: Want, wanted: Sequence[Want], unnamed: Sequence[Spot]) -> NDArray[np.bool_]:
    """For which of all named things the label could be taken: others of its kind; and points, if they do not lie on
    the line that it names."""
    line = np.array([*pairwise(want.course)], dtype=complex)
    others = [_alike(want, other) or (other.thing is Thing.POINT and _off(line, other.own[0])) for other in wanted]
    return np.array([*others, *(_off(line, at) for at, _ in unnamed)], dtype=bool) & (want.thing is not Thing.OTHER)


def _alike(want: Want, other: Want) -> bool:
    return want.thing is other.thing and (want.own != other.own or want.bow != other.bow)


def _off(line: Complexes, at: complex) -> bool:
    return bool(np.abs(_on(np.full(len(line), at), line[:, 0], line[:, 1]) - at).min() > ON)


def misled(want: Want, others: Sequence[Want], unnamed: Sequence[Spot], centre: Complexes) -> Floats:
    """What each place of a label without a leader costs for the other things that it could be taken to name."""
    named, at = Named.by(others, unnamed), np.array(want.course, dtype=complex)
    far = np.abs(at - at.mean()).max() + REACH
    near = np.abs(_on(np.full(len(named.a), at.mean()), named.a, named.b) - at.mean()) < far
    rival = rivals(want, others, unnamed)[named.of] & near
    if not rival.any():
        return np.zeros(len(centre))
    half = complex(want.width / 2, want.height / 2)
    own = distance(centre, half, at[:-1], at[1:]).min(axis=1) - want.radius
    other = distance(centre, half, named.a[rival], named.b[rival]) - named.radius[rival]
    return _cost(own, other.min(axis=1))


def misled_here(wanted: Sequence[Want], at: Mapping[int, complex], unnamed: Sequence[Spot]) -> Floats:
    """The same of labels that stand already; at: where the middle is of some of those that are wanted."""
    if not at:
        return np.zeros(0)
    named, centre = Named.by(wanted, unnamed), np.array(list(at.values()), dtype=complex)
    half = np.array([complex(wanted[i].width / 2, wanted[i].height / 2) for i in at])[:, None]
    gap = distance(centre, half, named.a, named.b) - named.radius
    own = np.array(list(at))[:, None] == named.of
    other = np.array([rivals(wanted[i], wanted, unnamed)[named.of] for i in at])
    return _cost(*(np.where(which, gap, np.inf).min(axis=1) for which in (own, other)))


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
