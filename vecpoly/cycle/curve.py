"""A column as a function of the drive's position, with its slope."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..mechanism.asked.forces import quantities
from .cycle import Cycle
from .sample import sample

Reals = NDArray[np.float64]
_WEIGHTS = np.array([-1.0, 9.0, -45.0, 0.0, 45.0, -9.0, 1.0]) / 60


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A real function of the drive's position; size: the natural magnitude below which a change is rounding."""

    cycle: Cycle
    key: str
    rate: str  # key of the time derivative, "" where there is none
    size: float

    @classmethod
    def of(cls, cycle: Cycle, key: str) -> Curve:
        """The curve of a column; of a vector's magnitude."""
        info = cycle.info(key)
        base = key
        if info.is_vector:
            key = f"{key}.abs"
        elif key.endswith(".abs"):
            base = key.removesuffix(".abs")
        drive = cycle.mech.drive
        even = drive.rate != 0.0 and drive.accel == 0.0
        return cls(cycle, key, cycle.info(base).rate if even and key != cycle.drive.key else "", _size(cycle, base))

    @property
    def presses(self) -> bool:
        """Whether it is a force, or what follows from forces."""
        return self.cycle.loads is not None and self.key.removesuffix(".abs") in quantities(
            self.cycle.mech, self.cycle.loads
        )

    def grid(self) -> tuple[Reals, Reals]:
        """Positions all round, and f there."""
        phi, values = self.cycle.on_grid(self.key)
        return phi, np.asarray(values, np.float64)

    def value(self, phi: Reals) -> Reals:
        """f(φ)."""
        return np.asarray(self.cycle.at(self.key, phi), np.float64)

    def slope(self, phi: Reals, step: Reals) -> Reals:
        """A positive multiple of df/dφ; step: of the grid about each place, in which f is as good as a cubic."""
        if not self.rate:
            return self._difference(phi, step)
        here = sample(self.cycle.mech, None, phi)
        sense = np.sign(self.cycle.mech.drive.rate)
        if not self.key.endswith(".abs"):
            return np.asarray(sense * here.value(self.rate), np.float64)
        vector, rate = here.value(self.key.removesuffix(".abs")), here.value(self.rate)
        return np.asarray(sense * np.real(np.conj(vector) * rate), np.float64)

    def _difference(self, phi: Reals, step: Reals) -> Reals:
        """Seven-point central difference; of a magnitude f·f', f' the vector's difference:
        smooth where the magnitude has a corner."""
        around = (phi[:, None] + step[:, None] * np.arange(-3, 4)).ravel()
        values = np.asarray(self.cycle.at(self.key.removesuffix(".abs"), around)).reshape(-1, 7)
        rise = values @ _WEIGHTS
        return np.asarray(np.real(np.conj(values[:, 3]) * rise) if self.key.endswith(".abs") else rise, np.float64)

    def reduced(self, phi: Reals) -> Reals:
        """Within the drive's range; what is a hair below a whole turn is its start."""
        if not self.cycle.whole:
            return np.clip(phi, self.cycle.low, self.cycle.high)
        low, full = self.cycle.low, self.cycle.high - self.cycle.low
        turned = np.mod(phi - low, full)
        return low + np.where(full - turned < 1e-9, 0.0, turned)


def _size(cycle: Cycle, key: str) -> float:
    """The natural magnitude of a quantity: below 1e-10 of it, a change is rounding."""
    spins = np.stack([np.abs(cycle.on_grid(f"omega_{name}")[1]) for name in cycle.mech.numbered])
    spin = _usual(np.nan_to_num(spins).max(axis=0)) or abs(cycle.mech.drive.rate) / cycle.mech.scale
    match cycle.info(key).unit:
        case "m":
            return cycle.mech.scale
        case "rad":
            return 1.0
        case "m/s":
            return spin * cycle.mech.scale
        case "m/s^2":
            return spin**2 * cycle.mech.scale
        case "rad/s":
            return spin
        case "rad/s^2":
            return spin**2
        case _:
            return _usual(np.abs(cycle.on_grid(key.partition(".")[0])[1]))


def _usual(sizes: Reals) -> float:
    """The middle one of the sizes, for the largest may run away; the largest where that is 0."""
    known = sizes[np.isfinite(sizes)]
    return (float(np.median(known)) or float(known.max())) if known.size else 0.0
