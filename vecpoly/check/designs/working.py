"""The least transmission angle of a linkage that rocks, from the first of its given positions to the last."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count, takewhile
from math import nan, tau

import numpy as np

from ...cycle.cycle import Cycle
from ...cycle.facts.found import facts
from ...cycle.facts.transmission import folded

PLACES = 361  # of the driver between the positions that are farthest apart
NEAR = 0.05  # rad: so far a position as read may lie beyond the end of the range


def least_between(turn: Cycle, pins: Mapping[str, complex], driver: str) -> float:
    """In rad; not a number where no positions are told, or the driver cannot come from one to another.

    pins: in every position, on paper; driver: the letters of its pivot and of its pin.
    """
    places = _places(turn, pins, driver)
    keys = [one.key for one in facts(turn).transmissions]
    if len(places) < 2 or not keys:
        return nan
    all_between = np.linspace(min(places), max(places), PLACES)
    angles = np.array([folded(np.asarray(turn.at(key, all_between), np.float64)) for key in keys])
    return float(np.min(angles)) if np.isfinite(angles).all() else nan


def _places(turn: Cycle, pins: Mapping[str, complex], driver: str) -> Sequence[float]:
    """The driver's angles in the given positions, all within its range; none where one of them lies outside."""
    pivot, letter = (*driver, "", "")[:2]
    at = pins.get(pivot)
    numbered = list(map(pins.__getitem__, takewhile(pins.__contains__, (f"{letter}{n}" for n in count(1)))))
    if at is None or len(numbered) < 2:
        return ()
    level = _frame_line(turn.mech.frame, pins)
    placed = [_within(float(np.angle((pin - at) * level)), turn) for pin in numbered]
    return () if any(place is None for place in placed) else [place for place in placed if place is not None]


def _frame_line(frame: Mapping[str, complex], pins: Mapping[str, complex]) -> complex:
    """By what a direction on paper is turned to be one of the linkage as it is built: along the line of its pivots."""
    one, other = (*(letter for letter in frame if letter in pins), "", "")[:2]
    return (frame[other] - frame[one]) / (pins[other] - pins[one]) if other else 1 + 0j


def _within(place: float, turn: Cycle) -> float | None:
    """The same angle on the turn on which the range lies, at its end where it is read a little beyond."""
    middle = (turn.low + turn.high) / 2
    near = place + tau * round((middle - place) / tau)
    if not turn.low - NEAR <= near <= turn.high + NEAR:
        return None
    return min(max(near, turn.low), turn.high)
