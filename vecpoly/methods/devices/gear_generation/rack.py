"""The rack over the gear, its line of action, and where a point of the flank comes to stand on the gear."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, pi, sin, tan

import numpy as np

from ....board.board import Board
from ....board.construction import View
from ....devices.gears.generation import GearGeneration
from ....plane import Line, Points, Reals, dot
from ....words import Words

VIEW = View.MECHANISM


@dataclass(frozen=True, slots=True, kw_only=True)
class Rack:
    """All in mm on paper, O at the origin, the pitch point P straight above it, a tooth of the gear under P.

    datum: height of the rack's middle line; tip: that of its corners; flank: of the tooth to the right, from its middle
    line down; corner: its end; action: the line of action through P, along the way of the contact; foot: N on it.
    """

    gear: GearGeneration
    mm: float
    pole: Points
    datum: float
    tip: float
    flank: Line
    corner: Points
    action: Line
    foot: Points

    @property
    def r(self) -> float:
        """The pitch radius."""
        return self.gear.m.si * self.gear.z / 2 / self.mm

    @property
    def module(self) -> float:
        """m on paper."""
        return self.gear.m.si / self.mm


def place_rack(board: Board, gear: GearGeneration, mm: float) -> Rack:
    """Lay the rack on: its middle line shifted by x m from the rolling line, a space over P."""
    alpha, m, r = gear.alpha.si, gear.m.si / mm, gear.m.si * gear.z / 2 / mm
    pole = board.lay_off(0j, 1j, r)
    datum = board.lay_off(pole, 1j if gear.x >= 0 else -1j, abs(gear.x) * m, key="xm")
    start = board.lay_off(datum, 1 + 0j, pi * m / 4)
    flank = board.parallel(start, complex(sin(alpha), -cos(alpha)))
    low = board.lay_off(datum, -1j, gear.ha.si * m)
    corner = board.meet(flank, board.parallel(low, 1 + 0j), Words("齿条的齿顶", "the tip of the rack"))
    action = board.parallel(pole, np.exp(1j * alpha))
    foot = board.meet(action, board.parallel(0j, 1j * np.exp(1j * alpha)), Words("基圆切点 $N$", "the point $N$"))
    return Rack(
        gear=gear, mm=mm, pole=pole, datum=r + gear.x * m, tip=r + (gear.x - gear.ha.si) * m, flank=flank,
        corner=corner, action=action, foot=foot,
    )  # fmt: skip


def contact(board: Board, rack: Rack, radius: Reals) -> tuple[Points, Reals]:
    """Where the line of action is as far from O as this, beyond N; and how far that is from P, beyond it positive."""
    told = Words("啮合线与圆", "the line of action and the circle")
    at = board.arc_on_line(rack.action, 0j, radius, told)[0]
    return at, dot(rack.action.along, at - rack.pole)


def on_gear(rack: Rack, at: Points, way: Reals, half: Reals, base: Reals) -> Points:
    """The flank's point that touches at this place, on the gear whose tooth stands upright: turned back."""
    return at * np.exp(1j * (way / base - half / rack.r))


def corner_at(rack: Rack, aside: Reals) -> tuple[Points, Points]:
    """The corner when it stands so far to the left of OP; and where that is on the gear."""
    at = -aside + 1j * rack.tip
    return at, at * np.exp(1j * (-aside - _middle(rack)) / rack.r)


def half_thickness(rack: Rack) -> float:
    """Half the width of the rack's space on the rolling line."""
    return (pi / 4 + rack.gear.x * tan(rack.gear.alpha.si)) * rack.module


def _middle(rack: Rack) -> float:
    """From the rack's space to the corner of the tooth at its right."""
    gear = rack.gear
    return (pi / 4 + gear.ha.si * tan(gear.alpha.si)) * rack.module
