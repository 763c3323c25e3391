"""Where what the loads press breaks off or jumps: found once, for all columns."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..sample import sample
from .duties import Cause, duties, stills

Reals = NDArray[np.float64]
HAIR = 1e-12  # rad, or part of the range: beside a place that is found to 1e-13
HALVINGS = 12  # of the step of the ladder in which the answers begin
LADDER = np.geomspace(HAIR, 1e-3, 54)  # beside a change of slip, next to which friction has no sense


@lru_cache(maxsize=4)
def breaks(cycle: Cycle) -> Reals:
    """Last place before and first place after every break (rows of two),
    on the turn of the grid and in its order; none without loads."""
    phi = cycle.on_grid(cycle.drive.key)[0].real
    unit = 1.0 if not cycle.mech.drive.slide else cycle.high - cycle.low
    cuts = [one.low for one in duties(cycle)][0 if cycle.whole else 1 :]
    found = _sides(cycle, np.array([*cuts, *(still.phi for still in stills(cycle))], np.float64), unit)
    if cycle.whole:
        found = np.concatenate([found + cycle.period * k for k in (-1, 0, 1)])
    found = found[(found[:, 0] > phi[0]) & (found[:, 1] < phi[-1])]
    return np.asarray(found[np.argsort(found[:, 0])], np.float64)


def _sides(cycle: Cycle, at: Reals, unit: float) -> Reals:
    """The nearest places on either side of each at which there is an answer;
    a hair away where there is none on that side."""
    if not at.size:
        return np.empty((0, 2))
    steps = unit * LADDER * np.array([[-1.0], [1.0]])
    tried = at[:, None, None] + steps
    lost = _lost(cycle, tried)
    first = np.argmin(lost, axis=2)
    outer, inner = (
        np.take_along_axis(tried, place[..., None], axis=2)[..., 0] for place in (first, np.maximum(first - 1, 0))
    )
    for _ in range(HALVINGS if first.any() else 0):
        middle = (outer + inner) / 2
        beyond = _lost(cycle, middle)
        inner, outer = np.where(beyond, middle, inner), np.where(beyond, outer, middle)
    return np.asarray(outer, np.float64)


def _lost(cycle: Cycle, places: Reals) -> NDArray[np.bool_]:
    """Where there is no answer."""
    return np.asarray(
        sample(cycle.mech, cycle.loads, places.ravel()).statics.causes.reshape(places.shape) != Cause.NONE
    )
