"""The stroke of a point along a direction: its least and greatest coordinate over the drive's whole range."""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ....errors import EquilibriumError
from ....mechanism.laws.told import no_stroke
from ....mechanism.model import Mechanism
from ...state import Reals
from .drives import drive_range, unit_drive
from .returning import over_a_period

STEPS = 1440
HALVINGS = 60


@lru_cache(maxsize=256)
def stroke(mech: Mechanism, link: str, point: str, direction: float) -> tuple[float, float]:
    """Least and greatest coordinate of the point along the direction (m); EquilibriumError where it has no stroke."""
    _, _, whole = drive_range(mech)
    local, along = mech.link(link).points[point], complex(np.exp(-1j * direction))
    grid = over_a_period(mech, STEPS)
    even = unit_drive(mech)  # once: a plan is kept for as long as its mechanism is the same object
    turns = zeros(lambda q: _rate(even, link, local, along, q), grid)
    places = np.concatenate([turns, grid if not whole else grid[:1]])
    gone = _coordinate(mech, link, local, along, places)
    least, most = float(np.nanmin(gone)), float(np.nanmax(gone))
    if (why := no_stroke(link, point, direction, most - least, mech.scale)) is not None:
        raise EquilibriumError(why, code="contradiction")
    return least, most


def zeros(f: Callable[[Reals], Reals], grid: Reals, fine: Callable[[Reals], Reals] | None = None) -> Reals:
    """Where a function changes its sign on this grid, by halving; a value that is 0 counts with those above.

    fine: the same function with nothing taken for 0, for where it passes from one side to the other and does not rest:
    between the two its sign is certain, however near.
    """
    found = f(grid)
    values, known = found >= 0, np.isfinite(found)
    at = np.flatnonzero((values[:-1] != values[1:]) & known[:-1] & known[1:])
    passes = found[at] * found[at + 1] < 0
    sharp = _halved(f if fine is None else fine, grid, at[passes], values)
    return np.sort(np.concatenate([sharp, _halved(f, grid, at[~passes], values)]))


def _halved(f: Callable[[Reals], Reals], grid: Reals, at: NDArray[np.intp], values: NDArray[np.bool_]) -> Reals:
    """The changes of sign behind these places of the grid."""
    left, right, first = grid[at], grid[at + 1], values[at]
    for _ in range(HALVINGS if len(at) else 0):
        middle = (left + right) / 2
        same = (f(middle) >= 0) == first
        left, right = np.where(same, middle, left), np.where(same, right, middle)
    return np.asarray((left + right) / 2, np.float64)


def _coordinate(mech: Mechanism, link: str, local: complex, along: complex, q: Reals) -> Reals:
    from ... import solve

    place = solve(mech, q, order=0, strict=False).body(link).point(local)
    return np.broadcast_to(np.real(place * along), q.shape)


def _rate(mech: Mechanism, link: str, local: complex, along: complex, q: Reals) -> Reals:
    from ... import solve

    velocity = solve(mech, q, order=1, strict=False).body(link).velocity_of(local)
    return np.broadcast_to(np.real(velocity * along), q.shape)
