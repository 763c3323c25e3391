"""Upright rectangles about many things, and which of them overlap."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ....foundation.slotted import dataclass

Complexes = NDArray[np.complex128]
Floats = NDArray[np.float64]
Indices = NDArray[np.intp]
Groups = Sequence[slice]  # which places lie close together: those of one label


@dataclass(frozen=True, slots=True)
class Bounds:
    """The upright rectangles about many things."""

    x0: Floats
    y0: Floats
    x1: Floats
    y1: Floats

    @classmethod
    def between(cls, a: Complexes, b: Complexes) -> Bounds:
        """About straight lines a -> b."""
        return cls(
            np.minimum(a.real, b.real),
            np.minimum(a.imag, b.imag),
            np.maximum(a.real, b.real),
            np.maximum(a.imag, b.imag),
        )

    @classmethod
    def about(cls, centre: Complexes, width: Floats, height: Floats, by: float) -> Bounds:
        """About rectangles of one size, and `by` mm further out."""
        return cls.within(centre, width / 2 + by, height / 2 + by)

    @classmethod
    def within(cls, centre: Complexes, w: Floats, h: Floats) -> Bounds:
        """About what lies so far about these middles."""
        x, y = centre.real, centre.imag
        return cls(x - w, y - h, x + w, y + h)

    def some(self, which: Indices) -> Bounds:
        """Some of them."""
        return Bounds(self.x0[which], self.y0[which], self.x1[which], self.y1[which])

    @property
    def middle(self) -> Complexes:
        """The middle of each."""
        result: Complexes = (self.x0 + self.x1) / 2 + 0.5j * (self.y0 + self.y1)
        return result

    def with_points(self, points: Complexes) -> Bounds:
        """Each with one point more."""
        x, y = points.real, points.imag
        return Bounds(np.minimum(self.x0, x), np.minimum(self.y0, y), np.maximum(self.x1, x), np.maximum(self.y1, y))

    def hold(self, points: Complexes) -> NDArray[np.bool_]:
        """Whether each holds the point of the same number."""
        return self.touch(Bounds(points.real, points.imag, points.real, points.imag))

    def touch(self, other: Bounds) -> NDArray[np.bool_]:
        """Whether each overlaps that of the same number."""
        across = (self.x0 <= other.x1) & (self.x1 >= other.x0)
        across &= self.y0 <= other.y1
        across &= self.y1 >= other.y0
        return across

    def meet(self, other: Bounds) -> NDArray[np.bool_]:
        """Whether each overlaps each of theirs; shape (ours, theirs)."""
        x0, y0, x1, y1 = (side[:, None] for side in (self.x0, self.y0, self.x1, self.y1))
        return Bounds(x0, y0, x1, y1).touch(other)

    def over(self, other: Bounds, groups: Groups) -> tuple[Indices, Indices]:
        """The pairs (ours, theirs) that overlap; `groups`: which of ours lie close together, all in a row."""
        some = [group for group in groups if group.stop > group.start]
        starts = [group.start for group in some]
        nothing = np.zeros(0, dtype=np.intp)
        if not some or not len(other.x0):
            return nothing, nothing
        low, high = (np.minimum.reduceat, np.maximum.reduceat)
        about = Bounds(low(self.x0, starts), low(self.y0, starts), high(self.x1, starts), high(self.y1, starts))
        near = about.meet(other)
        found = [self._over(other, group, np.flatnonzero(row)) for group, row in zip(some, near, strict=True)]
        return np.concatenate([nothing, *(ours for ours, _ in found)]), np.concatenate(
            [nothing, *(theirs for _, theirs in found)]
        )

    def _over(self, other: Bounds, group: slice, near: Indices) -> tuple[Indices, Indices]:
        """Those of one group, of what lies about the whole of it."""
        if not len(near):
            return near, near
        x0, y0, x1, y1 = (side[group, None] for side in (self.x0, self.y0, self.x1, self.y1))
        found = np.flatnonzero(Bounds(x0, y0, x1, y1).touch(other.some(near)))  # far quicker than of two axes at once
        ours = found // len(near)
        return ours + group.start, near[found - ours * len(near)]
