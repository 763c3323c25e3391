"""What acts at this pose and these velocities: the one place that knows, for the oracle and for the drawing alike.

Only arithmetic and comparisons: a number, an array of positions, or a length that was read off a sheet may come in.
"""

from __future__ import annotations

from itertools import pairwise
from typing import assert_never

from ..loads import Force, Moment
from .sizes import Motor, Table
from .springs import Coil, Spring
from .standing import Reals, Standing
from .windows import During, Moving, Turning, Window

ROUNDING = 1e-9  # of the length of a table: how far beyond its ends a place may lie by rounding


def acts(load: Force | Moment, at: Standing) -> Reals:
    """Whether a load acts: 1 or 0."""
    found: Reals = True
    for window in load.law.windows if load.law is not None else ():
        found = found * is_within(window, at)
    return found


def size_of(load: Force | Moment, at: Standing) -> Reals:
    """The size of a load that is known (N along its direction, or N·m): 0 where it does not act."""
    assert load.size is not None
    match load.law.size if load.law is not None else None:
        case None:
            return acts(load, at) * load.size
        case Motor(stall=stall, slope=slope):
            return acts(load, at) * (stall - slope * at.spin(load.link))
        case Table() as table:
            return acts(load, at) * tabulated(table, at)
        case other:
            assert_never(other)


def is_within(window: Window, at: Standing) -> Reals:
    """Whether the mechanism is within a window."""
    match window:
        case During(low=low, high=high, period=period):
            place = at.drive()
            return (place - low) % period < (high - low) % period if period else (place >= low) * (place < high)
        case Turning(link=link, sense=sense):
            return sense * at.spin(link) > 0
        case Moving(link=link, point=point, direction=way):
            moves = at.speed(link, point, way) > 0
            if not window.is_part:
                return moves
            gone, stroke = at.travelled(link, point, way)
            begun: Reals = gone >= window.low * stroke if window.low > 0 else True
            goes_on: Reals = gone < window.high * stroke if window.high < 1 else True  # a stroke ends with its motion
            return moves * begun * goes_on
        case other:
            assert_never(other)


def place_in(table: Table, at: Standing) -> Reals:
    """The place at which a table is read: of the travel (m), or of the drive (rad, or m), within the table's period."""
    if table.over is not None:
        return at.travelled(table.over.link, table.over.point, table.over.direction)[0]
    place = at.drive()
    return (place - table.places[0]) % table.period + table.places[0] if table.period else place


def is_beyond(load: Force | Moment, at: Standing) -> Reals:
    """Whether a load acts where its table says nothing."""
    table = load.law.size if load.law is not None else None
    if not isinstance(table, Table):
        return False
    place, slack = place_in(table, at), ROUNDING * (table.places[-1] - table.places[0])
    beyond = (place < table.places[0] - slack) | (place > table.places[-1] + slack)
    return acts(load, at) * beyond == 1


def tabulated(table: Table, at: Standing) -> Reals:
    """The size that a table gives, on straight lines between its places."""
    place = place_in(table, at)
    there = broken_line(table.places, table.sizes, place)
    if not table.back[0]:
        return there
    assert table.over is not None
    goes = at.speed(table.over.link, table.over.point, table.over.direction) > 0
    return goes * there + (1 - goes) * broken_line(*table.back, place)


def stretch(table: Table, at: Standing) -> tuple[Reals, ...]:
    """On which straight part of a table of a travel the mechanism is: corners left behind, and whether on the way back.

    Nothing of a table of the drive, whose corners need no mechanism.
    """
    if table.over is None:
        return ()
    place, back = place_in(table, at), table.back[0]
    passed: Reals = sum(place >= one for one in sorted({*table.places[1:-1], *back[1:-1]}))
    if not back:
        return (passed,)
    return (passed, at.speed(table.over.link, table.over.point, table.over.direction) > 0)


def broken_line(places: tuple[float, ...], sizes: tuple[float, ...], x: Reals) -> Reals:
    """The broken line through these points at x, level beyond its ends."""
    found: Reals = (x < places[0]) * sizes[0] + (x >= places[-1]) * sizes[-1]
    for (a, from_), (b, to) in pairwise(zip(places, sizes, strict=True)):
        found = found + (x >= a) * (x < b) * (from_ + (to - from_) / (b - a) * (x - a))
    return found


def tension(spring: Spring, at: Standing) -> Reals:
    """T = F_0 + k (l - l_0) + c dl/dt (N), positive where it pulls its ends together."""
    found: Reals = spring.preload
    if spring.stiffness:
        found = found + spring.stiffness * (at.length(spring) - spring.free)
    return found + spring.damping * at.lengthening(spring) if spring.damping else found


def couple(coil: Coil, at: Standing) -> Reals:
    """M = -(M_0 + k (φ - φ_0) + c (ω - ω')) on the coil's link (N·m)."""
    found: Reals = coil.preload
    if coil.stiffness:
        found = found + coil.stiffness * at.turned(coil)
    return -(found + coil.damping * at.turning(coil) if coil.damping else found)
