"""A centre drawn far away that truly lies at infinity, or the other way round, is compared by its direction."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import replace
from math import degrees, nan
from typing import Any

import numpy as np

from ...board.construction import Reading
from ...mechanism.asked.centres import ENDLESS

Exact = Mapping[str, complex | float]


def comparable(
    readings: Mapping[str, Reading], exact: Exact, spread: Mapping[str, Any]
) -> tuple[dict[str, Reading], dict[str, complex | float], dict[str, Any]]:
    """Readings, exact values and repetitions of which each pair is of one kind;
    where kinds differed, no error can be promised."""
    drawn, true, errors = dict(readings), dict(exact), dict(spread)
    for key, reading in readings.items():
        value = exact[key]
        if reading.vector is not None and not isinstance(value, complex):
            drawn[key] = replace(reading, unit=ENDLESS, scalar=_direction(reading.vector), vector=None, scale="")
            errors[key] = nan
        elif reading.unit == ENDLESS and isinstance(value, complex):
            true[key], errors[key] = _direction(value), nan
        if drawn[key].unit == ENDLESS:
            true[key] = float(_half_turned(true[key], drawn[key].scalar))
            errors[key] = _half_turned(np.asarray(errors.get(key, nan)), drawn[key].scalar)
    return drawn, true, errors


def _half_turned(direction: Any, near: float) -> Any:
    """The same directions of lines (deg), each by that of its two numbers which lies nearer:
    179.9° and 0.1° are neighbours."""
    return direction - 180.0 * np.round((direction - near) / 180.0)


def _direction(at: complex) -> float:
    """The direction (deg, 0 to 180) in which a far place is seen."""
    return degrees(cmath.phase(at)) % 180.0
