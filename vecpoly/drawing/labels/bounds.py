"""Upright rectangles about many things, and which of them overlap."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

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
        """The pairs (ours, theirs) that overlap; `groups`: which of ours lie close together."""
        found = [self._over(other, some) for some in groups if some.stop > some.start]
        if not found:
            return np.zeros(0, dtype=np.intp), np.zeros(0, dtype=np.intp)
        return np.concatenate([ours for ours, _ in found]), np.concatenate([theirs for _, theirs in found])

    def _over(self, other: Bounds, some: slice) -> tuple[Indices, Indices]:
        """Those of one group: first of all what of theirs lies about the whole of it."""
        x0, y0, x1, y1 = self.x0[some], self.y0[some], self.x1[some], self.y1[some]
        near = np.flatnonzero(
            (other.x0 <= x1.max()) & (other.x1 >= x0.min()) & (other.y0 <= y1.max()) & (other.y1 >= y0.min())
        )
        across = (x0[:, None] <= other.x1[near]) & (x1[:, None] >= other.x0[near])
        across &= y0[:, None] <= other.y1[near]
        across &= y1[:, None] >= other.y0[near]
        ours, theirs = np.nonzero(across)
        return ours + some.start, near[theirs]
