"""The working range of a drive that cannot turn right round:
what lies between its dead points, without their neighbourhood."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...analytic.equations import Model
from ...cycle import Cycle
from ...foundation.slotted import replace

SOUND = 0.3  # of a group's largest determinant: below, rates run away towards the dead point


def working_range(cycle: Cycle, model: Model) -> Cycle:
    """The cycle cut to the stretch about the given position in which every
    group keeps three tenths of its largest determinant.

    A drive that turns right round keeps its whole cycle.
    """
    if cycle.whole:
        return cycle
    edge = 1e-4 * (cycle.high - cycle.low)
    phi = np.linspace(cycle.low + edge, cycle.high - edge, len(cycle.phi))
    sound = _sound(model, phi)
    own = int(np.argmin(np.abs(phi - cycle.mech.drive.position)))
    if not sound[own]:
        return cycle
    before, after = np.flatnonzero(~sound[:own]), np.flatnonzero(~sound[own:])
    first = int(before[-1]) + 1 if before.size else 0
    last = own + int(after[0]) - 1 if after.size else len(phi) - 1
    low = float(phi[first]) if before.size else cycle.low
    high = float(phi[last]) if after.size else cycle.high
    return replace(cycle, phi=np.linspace(low, high, len(phi)), low=low, high=high, _kept={})


def _sound(model: Model, phi: NDArray[np.float64]) -> NDArray[np.bool_]:
    values = model.values(phi)
    sound = np.ones(phi.shape, bool)
    for group in model.groups:
        if group.determinant is not None:
            with np.errstate(invalid="ignore"):
                size = np.abs(np.broadcast_to(np.asarray(group.determinant.value(values), np.float64), phi.shape))
                sound &= size >= SOUND * np.nanmax(size, initial=0.0)
    return sound
