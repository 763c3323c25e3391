"""Directions come round: 359.9° and 0.1° are neighbours. A centre drawn far away that truly lies at infinity, or the
other way round, is compared by the direction of its line, which comes round after half a turn."""

from __future__ import annotations

import cmath
from collections.abc import Container, Mapping
from math import degrees, nan
from typing import Any

import numpy as np

from ...board.construction import Reading
from ...foundation.slotted import replace
from ...mechanism.asked.centres import ENDLESS

HALF, WHOLE = 180.0, 360.0  # deg: after which the direction of a line, and an angle, come round
Exact = Mapping[str, complex | float]


def comparable(
    readings: Mapping[str, Reading], exact: Exact, spread: Mapping[str, Any], places: Container[str]
) -> tuple[dict[str, Reading], dict[str, complex | float], dict[str, Any]]:
    """Readings, exact values and repetitions of which each pair is of one kind;
    where kinds differed, no error can be promised. places: keys of what is a place, if not at infinity."""
    drawn, true, errors = dict(readings), dict(exact), dict(spread)
    for key, reading in readings.items():
        value = exact[key]
        if reading.vector is not None and not isinstance(value, complex):
            drawn[key] = replace(reading, unit=ENDLESS, scalar=_direction(reading.vector), vector=None, scale="")
            errors[key] = nan
        elif reading.unit == ENDLESS and isinstance(value, complex):
            true[key], errors[key] = _direction(value), nan
        if drawn[key].unit == ENDLESS:
            turn = HALF if key in places else WHOLE
            true[key] = float(_turned(true[key], drawn[key].scalar, turn))
            errors[key] = _turned(np.asarray(errors.get(key, nan)), drawn[key].scalar, turn)
    return drawn, true, errors


def _turned(direction: Any, near: float, turn: float) -> Any:
    """The same directions (deg), each by that of its numbers which lies nearest."""
    return direction - turn * np.round((direction - near) / turn)


def _direction(at: complex) -> float:
    """The direction (deg, 0 to 180) in which a far place is seen."""
    return degrees(cmath.phase(at)) % 180.0
