"""Units that a table does not write: found by the size of its numbers, or by fit to the exact ones."""

from __future__ import annotations

from math import pi

import numpy as np

from ...oracle.run import wrapped
from ...words import Words
from .header import Unit
from .target import Reals, Target

DEG, RAD = Unit(name="deg", factor=pi / 180), Unit(name="rad", factor=1.0)
MM, M = Unit(name="mm", factor=1e-3), Unit(name="m", factor=1.0)
_CHOICES = {
    "rad": (RAD, DEG), "m": (MM, M), "m/s": (Unit(name="m/s", factor=1.0), Unit(name="mm/s", factor=1e-3)),
    "m/s^2": (Unit(name="m/s^2", factor=1.0), Unit(name="mm/s^2", factor=1e-3)),
    "rad/s": (Unit(name="rad/s", factor=1.0),), "rad/s^2": (Unit(name="rad/s^2", factor=1.0),),
}  # fmt: skip


def unit_by_size(target: Target, values: Reals) -> Unit:
    """Degrees where a number is larger than a full turn in radians; SI else."""
    if target.is_angle and np.nanmax(np.abs(values)) > 2 * pi + 0.02:
        return DEG
    return _CHOICES.get(target.unit, (Unit(name=target.unit, factor=1.0),))[-1 if target.unit == "m" else 0]


def fitting(target: Target, values: Reals, exact: Reals) -> Unit:
    """The unit in which the column fits best."""
    if target.is_angle and np.nanmax(np.abs(values)) > 2 * pi + 0.02:
        return DEG

    def off(unit: Unit) -> float:
        if target.is_angle:
            return float(np.nanmedian(np.abs(wrapped(values * unit.factor - exact))))
        return abs(
            float(
                np.log((np.nanmedian(np.abs(values)) * unit.factor + 1e-300) / (np.nanmedian(np.abs(exact)) + 1e-300))
            )
        )

    return min(_CHOICES.get(target.unit, (Unit(name=target.unit, factor=1.0),)), key=off)


def guessed(header: str, unit: Unit) -> Words:
    return Words(f"{header}：未注单位，按 {unit.name} 处理", f"{header}: no unit is written; taken as {unit.name}")
