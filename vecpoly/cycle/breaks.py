"""Where what the loads press breaks off or jumps: found once, for all columns."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from .cycle import Cycle
from .duties import Cause, duties, stills
from .sample import sample

Reals = NDArray[np.float64]
HAIR = 1e-12  # rad, or part of the range: beside a place that is found to 1e-13
LADDER = np.geomspace(HAIR, 1e-3, 54)  # beside a change of slip, next to which friction has no sense


@lru_cache(maxsize=4)
def breaks(cycle: Cycle) -> Reals:
    """Last place before and first place after every break (rows of two), on the turn of the grid and in its order; none without loads."""
    phi = cycle.on_grid(cycle.drive.key)[0].real
    unit = 1.0 if not cycle.mech.drive.slide else cycle.high - cycle.low
    cuts = np.array([one.low for one in duties(cycle)][0 if cycle.whole else 1 :], np.float64)
    sides = np.array([still.phi for still in stills(cycle)], np.float64)
    found = np.concatenate([np.stack([cuts - HAIR * unit, cuts + HAIR * unit], axis=1), _sides(cycle, sides, unit)])
    if cycle.whole:
        found = np.concatenate([found + 2 * np.pi * k for k in (-1, 0, 1)])
    found = found[(found[:, 0] > phi[0]) & (found[:, 1] < phi[-1])]
    return np.asarray(found[np.argsort(found[:, 0])], np.float64)


def _sides(cycle: Cycle, at: Reals, unit: float) -> Reals:
    """The nearest places on either side of each at which there is an answer."""
    if not at.size:
        return np.empty((0, 2))
    steps = unit * LADDER * np.array([[-1.0], [1.0]])
    tried = at[:, None, None] + steps
    lost = sample(cycle.mech, cycle.loads, tried.ravel()).statics.causes.reshape(tried.shape) != Cause.NONE
    first = np.argmin(lost, axis=2)
    return np.asarray(np.take_along_axis(tried, first[..., None], axis=2)[..., 0], np.float64)
