"""Where an output rests at a limit position, as a cam's follower does in its dwells: it stands there over a stretch of
the drive, and no place in it is the limit position."""

from __future__ import annotations

from math import isfinite

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..extremes import Extremes, Spot

# of the stroke: what does not change by more stands still; a smooth limit is so level over 1e-6 rad only
_LEVEL = 1e-12
_FEWEST = 3  # places of the grid in a rest
_HALVINGS = 40
Stretch = tuple[float, float]


def stood(cycle: Cycle, found: Extremes, spot: Spot) -> Stretch | None:
    """The stretch over which a column keeps an extreme value; None where it has it at one place alone."""
    top, low = found.highest, found.lowest
    if not cycle.whole or top is None or low is None or not isfinite(top.value - low.value):
        return None
    key = f"{found.key}.abs" if cycle.info(found.key).is_vector else found.key
    if (stretch := rest(cycle, key, spot, top.value - low.value)) is None:
        return None
    begin, end = stretch
    late = cycle.period if begin < cycle.low - 1e-6 else 0.0  # begins where the turn has not begun: in that before
    return begin + late, end + late


def rest(cycle: Cycle, key: str, spot: Spot, swing: float) -> Stretch | None:
    """The stretch of the drive (rad, its end may lie beyond a turn) in which the output stands at this limit;
    None where it turns round at once."""
    phi, values = cycle.on_grid(key)
    level = np.abs(np.asarray(values, np.float64) - spot.value) <= _LEVEL * swing
    moving = np.flatnonzero(~level)
    if level.sum() < _FEWEST or not moving.size:
        return None
    away = phi[moving] - spot.phi
    period = cycle.period
    ahead, behind = float(np.min(away % period)), float(np.min(-away % period))
    if ahead + behind < (_FEWEST - 1) * float(np.median(np.diff(phi))):
        return None
    begin, end = _edges(cycle, key, spot, swing, np.array([-behind, ahead]))
    return spot.phi + begin, spot.phi + end


def _edges(cycle: Cycle, key: str, spot: Spot, swing: float, outside: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far before and after the spot it leaves the limit: between there and these places it does."""
    inside = np.zeros(2)
    for _ in range(_HALVINGS):
        middle = (inside + outside) / 2
        places = cycle.low + (spot.phi + middle - cycle.low) % cycle.period
        gap = np.abs(np.asarray(cycle.at(key, places), np.float64) - spot.value)
        still = gap <= _LEVEL * swing
        inside, outside = np.where(still, middle, inside), np.where(still, outside, middle)
    return inside
