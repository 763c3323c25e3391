"""Change points: positions where the two assemblies of a dyad meet though the drive goes on,
and how the motion goes through them.

Between its change points a dyad keeps to one side; at each it passes to the other, for so, and only so, its motion is
smooth:
h = ±√f with f = c² (q - q*)² + ... goes on as c (q - q*).
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...foundation.slotted import dataclass
from ..state import Reals

# of the drive's positions: not below zero where links close, zero where two assemblies meet
Fold = Callable[[Reals], Reals]
SAMPLES = 1440  # a turn
LOW = 1e-2  # a sampled fold that is larger is near no change point
TOUCHES = 1e-13  # a least fold from which rounding alone parts zero
PARTS = 16  # into which an interval is cut: many places at once cost hardly more than two
ROUGH = 3  # cuts: to a hundredth of a sample, where a fold above NEAR can come down to zero no more
FINE = 11  # cuts: to the last digit
NEAR = 1e-4
BESIDE = (1e-3, 1e-5)  # of a turn over 2π, or of the scale: where the fold's root is taken to find where it vanishes


@dataclass(frozen=True, slots=True)
class Changes:
    """Change points of one dyad. own: the problem's own position; places:
    (rad or m), within a period above own where there is a period."""

    own: float
    places: tuple[float, ...]
    period: float | None

    def signs(self, q: Reals) -> Reals:
        """+1 where an even number of change points lies between the own position and q, else -1."""
        count = np.zeros(q.shape)
        for place in self.places:
            if self.period is not None:
                count += np.floor((q - place) / self.period) + 1
            else:
                count += (q - place) * (self.own - place) < 0
        return np.where(count % 2 == 0, 1.0, -1.0)

    def nearest(self, q: Reals) -> Reals:
        """The change point nearest to each position."""
        places = np.array(self.places)
        if self.period is None:
            return np.asarray(places[np.abs(q[:, None] - places).argmin(axis=1)])
        turned = places + self.period * np.round((q[:, None] - places) / self.period)
        return np.asarray(np.take_along_axis(turned, np.abs(q[:, None] - turned).argmin(axis=1)[:, None], axis=1)[:, 0])


def touches(fold: Fold, low: float, high: float, unit: float) -> tuple[float, ...]:
    """Where the fold comes down to zero and goes up again, within low..high.
    unit: 1 of a turning drive (rad), the scale of a sliding one (m)."""
    step = 2 * np.pi * unit / SAMPLES
    q = np.asarray(low + step * (np.arange(round((high - low) / step) + 2) - 0.5), np.float64)
    sampled = fold(q)
    sampled = np.where(np.isfinite(sampled), sampled, np.inf)
    least = np.flatnonzero((sampled[1:-1] <= sampled[:-2]) & (sampled[1:-1] < sampled[2:]) & (sampled[1:-1] < LOW)) + 1
    if not least.size:
        return ()
    low_ends, high_ends = _least(fold, q[least - 1], q[least + 1], ROUGH)
    near = fold((low_ends + high_ends) / 2) < NEAR
    if not near.any():
        return ()
    ends = _least(fold, low_ends[near], high_ends[near], FINE)
    middle = (ends[0] + ends[1]) / 2
    middle = middle[np.abs(fold(middle)) < TOUCHES]
    for beside in BESIDE if middle.size else ():
        middle = _root(fold, middle, beside * unit)
    return tuple(float(place) for place in middle if low <= place < high)


def _least(fold: Fold, low: Reals, high: Reals, times: int) -> tuple[Reals, Reals]:
    """Where the least value lies, in all intervals at once: in the two parts beside the least of the places between."""
    for _ in range(times):
        part = (high - low) / PARTS
        places = low[:, None] + part[:, None] * np.arange(1, PARTS)
        found = fold(places.ravel()).reshape(places.shape)
        least = np.argmin(np.where(np.isnan(found), np.inf, found), axis=1)
        low, high = low + part * least, low + part * (least + 2)
    return low, high


def _root(fold: Fold, near: Reals, beside: float) -> Reals:
    """Where the root of the fold, negative before and positive behind, passes through zero; near as it is where the
    fold beside it is nothing, or ends."""
    before, behind = (np.sqrt(np.maximum(part, 0.0)) for part in _two(fold, near - beside, near + beside))
    both = before + behind
    share = np.divide(before - behind, both, out=np.zeros_like(both), where=both > 0)
    return np.asarray(near + beside * share)


def _two(fold: Fold, one: Reals, other: Reals) -> tuple[Reals, Reals]:
    """The fold at two rows of positions, found in one go."""
    both = fold(np.concatenate([one, other]))
    return both[: one.size], both[one.size :]
