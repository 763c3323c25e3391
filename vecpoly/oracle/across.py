"""Positions and rates beside a change point: from either side of it, for its own equations leave no digits there.

A motion that goes smoothly through is, near the point, the polynomial through six positions about it: with steps of
2e-3 rad its error is below rounding.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields

import numpy as np

from ..mechanism.model import Drive
from .changes import Changes
from .state import Body, Points, Reals

BESIDE = 2e-3  # rad, or of the scale
NODES = np.array([-3.0, -2.0, -1.0, 1.0, 2.0, 3.0])
_RATES = ("at", "unit", "velocity", "omega", "acceleration", "alpha")

Solve = Callable[[Reals], dict[str, Body]]


def across(changes: Sequence[Changes], asked: Reals, drive: Drive, scale: float, solve: Solve) -> dict[str, Body]:
    """The driven links at the positions asked for; beside change points of these dyads as the motion goes through them."""
    if not changes or not asked.size:
        return solve(asked)
    unit = BESIDE * (scale if drive.slide else 1.0)
    nearest = np.array([one.nearest(asked) for one in changes])
    place = np.take_along_axis(nearest, np.abs(nearest - asked).argmin(axis=0)[None], axis=0)[0]
    beside = np.flatnonzero(np.abs(asked - place) < unit)
    if not beside.size:
        return solve(asked)
    away = (asked[beside] - place[beside]) / unit
    nodes = place[beside][:, None] + unit * NODES
    moved = asked.copy()
    moved[beside] = nodes[:, -1]
    found, about = solve(moved), solve(nodes.ravel())
    weights = _weights(away)
    return {name: _joined(body, about[name], beside, weights) for name, body in found.items()}


def _weights(away: Reals) -> Reals:
    """Lagrange's: positions × nodes."""
    parts = [np.prod([(away - other) / (node - other) for other in NODES if other != node], axis=0) for node in NODES]
    return np.stack(parts, axis=1)


def _joined(body: Body, about: Body, beside: np.ndarray[tuple[int, ...], np.dtype[np.intp]], weights: Reals) -> Body:
    """The link with its values beside change points interpolated."""
    values = {field.name: getattr(body, field.name) for field in fields(body)}
    for name in _RATES:
        given: Points | Reals = getattr(about, name)
        if len(given) > 1:
            row = np.array(values[name])
            row[beside] = (given.reshape(weights.shape) * weights).sum(axis=1)
            values[name] = row / np.abs(row) if name == "unit" else row
    return Body(**values)
