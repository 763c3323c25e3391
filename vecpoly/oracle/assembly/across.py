"""Positions and rates beside a change point: from either side of it, for its own equations leave no digits there.

There α is lost to rounding with the cube of the distance. A motion that goes smoothly through is, near the point, the
polynomial through eight positions about it; with steps of 0.01 rad it errs by no more than rounding does just outside.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import fields

import numpy as np

from ...mechanism.model import Drive
from ..state import Body, Points, Reals
from .changes import Changes

BESIDE = 1e-2  # rad, or of the scale
ROOM = 6.0  # steps to the next change point, at least
SAME = 1e-7  # rad, or of the scale: change points of several dyads that are one
NODES = np.array([-4.0, -3.0, -2.0, -1.0, 1.0, 2.0, 3.0, 4.0])
_RATES = ("at", "unit", "velocity", "omega", "acceleration", "alpha")

Solve = Callable[[Reals], dict[str, Body]]


def across(changes: Sequence[Changes], asked: Reals, drive: Drive, scale: float, solve: Solve) -> dict[str, Body]:
    """The driven links at the positions asked for;
    beside change points of these dyads as the motion goes through them."""
    if not changes or not asked.size:
        return solve(asked)
    unit = BESIDE * (scale if drive.slide else 1.0)
    place = _nearest(changes, asked)
    beside = np.flatnonzero(np.abs(asked - place) < unit)
    if not beside.size:
        return solve(asked)
    step = np.minimum(unit, _room(changes, place[beside], scale if drive.slide else 1.0) / ROOM)
    beside, step = (part[np.abs(asked - place)[beside] < step] for part in (beside, step))
    away = (asked[beside] - place[beside]) / step
    nodes = place[beside][:, None] + step[:, None] * NODES
    moved = asked.copy()
    moved[beside] = nodes[:, -1]
    found, about = solve(moved), solve(nodes.ravel())
    weights = _weights(away)
    return {name: _joined(body, about[name], beside, weights) for name, body in found.items()}


def _nearest(changes: Sequence[Changes], q: Reals) -> Reals:
    """The change point of any dyad nearest to each position."""
    found = np.array([one.nearest(q) for one in changes])
    return np.asarray(np.take_along_axis(found, np.abs(found - q).argmin(axis=0)[None], axis=0)[0])


def _room(changes: Sequence[Changes], at: Reals, scale: float) -> Reals:
    """How far it is from each of these change points to another."""
    ways = [np.abs(place - at) for one in changes for turn in (-1, 0, 1) for place in _places(one, at, turn)]
    return np.asarray(np.min([np.where(way > SAME * scale, way, np.inf) for way in ways], axis=0))


def _places(one: Changes, at: Reals, turn: int) -> list[Reals]:
    """The places of one dyad on the turn of these positions, or the next or last but one."""
    if one.period is None:
        return [np.full(at.shape, place) for place in one.places]
    return [place + one.period * (np.round((at - place) / one.period) + turn) for place in one.places]


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
