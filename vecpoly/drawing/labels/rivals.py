"""A label belongs to what it is nearest to: what it costs to stand nearer to another thing than to one's own."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from .about.bounds import Complexes, Floats, Indices
from .about.clipping import enters
from .want import Line, Spot, Thing, Want

WRONG = 55.0  # nearer to another than to its own, with no leader to tell
DOUBTFUL = 0.6  # mm: nearly as near
NOWHERE = complex(np.nan, np.nan)
PRESSED, CLEAR = 9.0, 3.2  # a number that stands on a joint; mm from its middle beyond which that costs nothing
EDGES = 2.0  # mm between both edges of hatching
ON = 0.3  # mm: a point so near to a line is on it


@dataclass(frozen=True, slots=True)
class Named:
    """All that labels of a figure name, points without a name and edges of hatching after them: lines a -> b, and of
    which of all things each is a part; the place of each thing that is a point, of another nan."""

    wanted: Sequence[Want]
    a: Complexes
    b: Complexes
    radius: Floats
    of: Indices
    points: Complexes
    fixed: int  # from this of all things on they are hatched

    @classmethod
    def by(cls, wanted: Sequence[Want], unnamed: Sequence[Spot], grounds: Sequence[Line] = ()) -> Named:
        """What these labels name, the points that have none, and the hatching that has none."""
        free = [line for line in grounds if not any(_near(line, want.own) for want in wanted)]
        fixed = len(wanted) + len(unnamed)
        lines = [(a, b, want.radius, i) for i, want in enumerate(wanted) for a, b in pairwise(want.course)]
        lines += [(at, at, radius, len(wanted) + i) for i, (at, radius) in enumerate(unnamed)]
        lines += [(a, b, 0.0, fixed + i) for i, (a, b) in enumerate(free)]
        a, b, radius, of = zip(*lines, strict=True) if lines else ((), (), (), ())
        points = [want.own[0] if want.thing is Thing.POINT else NOWHERE for want in wanted]
        return cls(
            wanted,
            np.array(a, dtype=complex),
            np.array(b, dtype=complex),
            np.array(radius, float),
            np.array(of, dtype=np.intp),
            np.array([*points, *(at for at, _ in unnamed), *(NOWHERE for _ in free)], dtype=complex),
            fixed,
        )

    def rivals(self, want: Want, some: Indices) -> NDArray[np.bool_]:
        """For which of some of these lines the label could be taken: others of its kind; and points, if they do not lie
        on the line that it names."""
        if want.thing is Thing.OTHER:
            return np.zeros(len(some), dtype=bool)
        a, b = np.array([*pairwise(want.course)], dtype=complex).T
        things = self.of[some]
        points = self.points[things, None]
        strange = np.abs(_on(points, a, b) - points).min(axis=1) > ON
        alike = [k < len(self.wanted) and _alike(want, self.wanted[k]) for k in things.tolist()]
        result: NDArray[np.bool_] = np.where(things < self.fixed, strange | alike, want.thing is Thing.LINK)
        return result

    def about(self, low: complex, high: complex) -> Indices:
        """Which of these lines, as thick as what is drawn there, reach into a rectangle."""
        x0, x1 = np.minimum(self.a.real, self.b.real), np.maximum(self.a.real, self.b.real)
        y0, y1 = np.minimum(self.a.imag, self.b.imag), np.maximum(self.a.imag, self.b.imag)
        level = (x0 - self.radius < high.real) & (x1 + self.radius > low.real)
        return np.flatnonzero(level & (y0 - self.radius < high.imag) & (y1 + self.radius > low.imag))


def _near(one: Line, other: Line) -> bool:
    """Whether a line is an edge of the hatching along another."""
    return max(abs(a - b) for a, b in zip(one, other, strict=True)) < EDGES


def _alike(want: Want, other: Want) -> bool:
    return want.thing is other.thing and (want.own != other.own or want.bow != other.bow)


def misled(want: Want, named: Named, centre: Complexes) -> Floats:
    """What each place of a label without a leader costs for the other things that it could be taken to name."""
    at, half = np.array(want.course, dtype=complex), complex(want.width / 2, want.height / 2)
    pressed = _pressed(named, half, centre) if want.thing is Thing.LINK else np.zeros(len(centre))
    if want.thing is Thing.OTHER:
        return pressed
    own = distance(centre, half, at[:-1], at[1:]).min(axis=1) - want.radius
    reach = half + complex(1.0, 1.0) * (float(own.max()) + DOUBTFUL)
    x, y = centre.real, centre.imag
    near = named.about(complex(x.min(), y.min()) - reach, complex(x.max(), y.max()) + reach)
    rival = near[named.rivals(want, near)]
    if not len(rival):
        return pressed
    other = distance(centre, half, named.a[rival], named.b[rival]) - named.radius[rival]
    return _cost(own, other.min(axis=1)) + pressed


def _pressed(named: Named, half: complex, centre: Complexes) -> Floats:
    """What each place of a number costs that stands close to a joint, even if it cannot be taken for its letter."""
    at = named.points[~np.isnan(named.points.real)]
    if not len(at):
        return np.zeros(len(centre))
    result: Floats = PRESSED * np.clip(1.0 - distance(centre, half, at, at).min(axis=1) / CLEAR, 0.0, 1.0)
    return result


def misled_here(named: Named, at: Mapping[int, complex]) -> Floats:
    """The same of labels that stand already; at: where the middle is of some of those that are wanted."""
    if not at:
        return np.zeros(0)
    wanted, centre = [named.wanted[i] for i in at], np.array(list(at.values()), dtype=complex)
    half = np.array([complex(want.width / 2, want.height / 2) for want in wanted])[:, None]
    gap = distance(centre, half, named.a, named.b) - named.radius
    mine = np.array(list(at))[:, None] == named.of
    own = np.where(mine, gap, np.inf).min(axis=1)
    other, close = np.full(len(own), np.inf), (gap < own[:, None] + DOUBTFUL) & ~mine
    for n in np.flatnonzero(close.any(axis=1)).tolist():
        some = np.flatnonzero(close[n])
        other[n] = gap[n, some[named.rivals(wanted[n], some)]].min(initial=np.inf)
    return _cost(own, other)


def _cost(own: Floats, rival: Floats) -> Floats:
    """Of labels so far from what they name and from the nearest other thing, mm."""
    result: Floats = WRONG * np.clip((own + DOUBTFUL - rival) / DOUBTFUL, 0.0, 1.0)
    return result


def distance(centre: Complexes, half: complex | Complexes, a: Complexes, b: Complexes) -> Floats:
    """From each rectangle (centre ± half; of all, or a column) to each line a -> b, mm; shape (rectangles, lines)."""
    spots = a == b
    if spots.all():
        return _outside(a - centre[:, None], half)
    result = np.empty((len(centre), len(a)))
    result[:, spots] = _outside(a[spots] - centre[:, None], half)
    result[:, ~spots] = _from_lines(centre[:, None], half, a[~spots], b[~spots])
    return result


def _from_lines(c: Complexes, half: complex | Complexes, a: Complexes, b: Complexes) -> Floats:
    ends = np.minimum(_outside(a - c, half), _outside(b - c, half))
    corners = c[:, :, None] + np.stack([half, -half, np.conjugate(half), -np.conjugate(half)], axis=-1)
    touch = np.abs(corners - _on(corners, a[None, :, None], b[None, :, None])).min(axis=2)
    hit = enters(a, b, c, half.real, half.imag)
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
