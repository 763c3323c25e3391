"""The moment that must drive the crank over a cycle: its mean, the power, and the flywheel that evens out the rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle, Spot, extremes
from ..mechanism.loads import Moment
from ..mechanism.machine import flywheel_of
from .working import Working

Reals = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class Balance:
    """The driving moment M_d (N·m, positive as the crank turns) over the crank's angle (rad).

    mean: of a cycle. power: W. surplus: ∫ (mean − M_d) dφ from the first position, J; its range is [W], what a flywheel
    must store. inertia: J_F = [W] / (ω² [δ]), kg·m²; None without [δ]. highest, lowest: M_d to full accuracy, where a
    load does not come or go.
    """

    key: str
    phi: Reals
    moment: Reals
    mean: float
    power: float
    surplus: Reals
    inertia: float | None
    highest: Spot
    lowest: Spot

    @property
    def stored(self) -> float:
        """[W], the greatest surplus less the least (J)."""
        return float(np.ptp(self.surplus))


def balance(turn: Cycle, acting: Working, unevenness: float | None) -> Balance | None:
    """The balance of a crank that turns right round, where a moment on it is what balances the loads; else None."""
    if turn.loads is None or not turn.whole or turn.mech.drive.slide:
        return None
    free, drive = turn.loads.unknown, turn.mech.drive
    if not isinstance(free, Moment) or free.link != drive.link:
        return None
    sense = float(np.sign(drive.rate))
    moment = sense * acting.real(free.name)
    steps = np.diff(turn.phi)
    mean = float(np.sum(_middles(moment) * steps) / (2 * np.pi))
    surplus = np.concatenate([[0.0], np.cumsum((mean - _middles(moment)) * steps)])
    needed = None if unevenness is None else flywheel_of(float(np.ptp(surplus)), drive.rate, unevenness)
    return Balance(
        key=free.name, phi=turn.phi, moment=moment, mean=mean, power=mean * abs(drive.rate), surplus=surplus,
        inertia=needed, highest=_farthest(acting, free.name, moment, sense, 1.0),
        lowest=_farthest(acting, free.name, moment, sense, -1.0),
    )  # fmt: skip


def _farthest(acting: Working, key: str, moment: Reals, sense: float, way: float) -> Spot:
    """The greatest M_d (way −1: the least): the turning point beside the greatest of the grid, or that one itself at an
    end of what acts there."""
    top = int(np.argmax(way * moment))
    turn = acting.loaded if acting.acts[top] else acting.idle
    phi, found = turn.phi, extremes(turn, key)
    step = float(phi[1] - phi[0])
    if np.unique(acting.acts[[top - 1, top, (top + 1) % len(phi)]]).size == 1:
        for one in (*found.maxima, *found.minima):
            off = abs((one.phi - float(phi[top]) + np.pi) % (2 * np.pi) - np.pi)
            if off <= step and way * (sense * one.value - float(moment[top])) >= 0:
                return Spot(one.phi, sense * one.value)
    return Spot(float(phi[top]), float(moment[top]))


def _middles(values: Reals) -> Reals:
    """Between two positions (trapezoidal rule)."""
    return (values[1:] + values[:-1]) / 2
