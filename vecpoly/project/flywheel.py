"""The moment that must drive the crank over a cycle: its mean, the power, and the flywheel that evens out the rest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..mechanism.loads import Moment
from ..mechanism.machine import flywheel_of
from .working import Working

Reals = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True)
class Balance:
    """The driving moment M_d (N·m, positive as the crank turns) over the crank's angle (rad).

    mean: of a cycle. power: W. surplus: ∫ (mean − M_d) dφ from the first position, J; its range is [W], what a flywheel
    must store. inertia: J_F = [W] / (ω² [δ]), kg·m²; None without [δ].
    """

    key: str
    phi: Reals
    moment: Reals
    mean: float
    power: float
    surplus: Reals
    inertia: float | None

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
    moment = np.sign(drive.rate) * acting.real(free.name)
    steps = np.diff(turn.phi)
    mean = float(np.sum(_middles(moment) * steps) / (2 * np.pi))
    surplus = np.concatenate([[0.0], np.cumsum((mean - _middles(moment)) * steps)])
    needed = None if unevenness is None else flywheel_of(float(np.ptp(surplus)), drive.rate, unevenness)
    return Balance(
        key=free.name, phi=turn.phi, moment=moment, mean=mean, power=mean * abs(drive.rate), surplus=surplus,
        inertia=needed,
    )  # fmt: skip


def _middles(values: Reals) -> Reals:
    """Between two positions (trapezoidal rule)."""
    return (values[1:] + values[:-1]) / 2
