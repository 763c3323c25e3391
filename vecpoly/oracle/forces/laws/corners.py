"""Where loads jump or bend over the cycle: windows open and close, a table turns a corner."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import assert_never

import numpy as np

from ....mechanism.laws.sizes import Table, Travel
from ....mechanism.laws.windows import During, Moving, Turning, Window
from ....mechanism.loads import Load, Loads
from ....mechanism.model import Mechanism
from ...state import Reals
from .drives import drive_range, unit_drive
from .returning import laps, over_a_period, turns_of
from .stands import ROUNDING, Stands
from .strokes import STEPS, zeros

SAME = 1e-12  # rad, or of the range: corners nearer than this are one
Watched = Callable[[Stands], Reals]


def corners(mech: Mechanism, loads: Loads) -> Reals:
    """The places of the drive (rad, or m) at which a load jumps or bends, in order, from the beginning of its range on.

    Over a whole turn, or as many turns as loads and mechanism need to repeat themselves (`turns_of`).
    """
    low, high, whole = drive_range(mech)
    moving = mech if mech.drive.rate else unit_drive(mech)
    count, turns = (laps(mech, low), turns_of(mech, loads, low)) if whole else (1, 1)
    grid = over_a_period(mech, STEPS)
    once = [
        zeros(partial(_at, moving, watched), grid, partial(_at, moving, watched, rounding=0.0))
        for watched in _watched(loads)
    ]
    found = [part + 2 * np.pi * k for part in once for k in range(0, turns, count)]
    found += [np.array(list(_of_the_drive(load, low, high + 2 * np.pi * (turns - 1), whole))) for load in loads.all]
    places = np.sort(np.concatenate([np.empty(0), *found]))
    return np.asarray(places[np.append(True, np.diff(places) > SAME * max(high - low, 1e-300))[: len(places)]])


def _at(mech: Mechanism, watched: Watched, q: Reals, rounding: float = ROUNDING) -> Reals:
    from ... import solve

    found = watched(Stands(mech, solve(mech, q, order=1, strict=False).bodies, q, rounding))
    return np.broadcast_to(found, q.shape)


def _watched(loads: Loads) -> Iterator[Watched]:
    """What changes its sign where a load that follows the motion jumps or bends."""
    for load in loads.all:
        for window in load.law.windows if load.law is not None else ():
            yield from _openings(window)
        yield from _bends(load)


def _openings(window: Window) -> Iterator[Watched]:
    match window:
        case Moving(link=link, point=point, direction=way):
            over = Travel(link=link, point=point, direction=way)
            yield partial(_speed, over)
            for part in (window.low, window.high) if window.is_part else ():
                yield partial(_past, over, part)
        case Turning(link=link):
            yield partial(_spin, link)
        case During():
            pass
        case other:
            assert_never(other)


def _bends(load: Load) -> Iterator[Watched]:
    table = load.law.size if load.law is not None else None
    if not isinstance(table, Table) or table.over is None:
        return
    if table.back[0]:
        yield partial(_speed, table.over)
    for place in sorted({*table.places[1:-1], *table.back[0][1:-1]}):
        yield partial(_gone, table.over, place)


def _speed(over: Travel, at: Stands) -> Reals:
    return at.speed(over.link, over.point, over.direction)


def _spin(link: str, at: Stands) -> Reals:
    return at.spin(link)


def _gone(over: Travel, place: float, at: Stands) -> Reals:
    return at.travelled(over.link, over.point, over.direction)[0] - place


def _past(over: Travel, part: float, at: Stands) -> Reals:
    gone, stroke = at.travelled(over.link, over.point, over.direction)
    return gone - part * stroke


def _of_the_drive(load: Load, low: float, high: float, whole: bool) -> Iterator[float]:
    """Corners at given places of the drive."""
    if load.law is None:
        return
    table = load.law.size
    given = [
        (place, window.period)
        for window in load.law.windows
        if isinstance(window, During)
        for place in (window.low, window.high)
    ]
    if isinstance(table, Table) and table.over is None:
        given += [(place, table.period) for place in table.places]
    for place, period in given:
        first = low + (place - low) % period if whole and period else place
        while first <= high:
            if first >= low:
                yield first
            if not (whole and period):
                break
            first += period
