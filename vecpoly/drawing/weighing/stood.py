"""One label at one place, and what two such labels cost each other: lettering on lettering, leaders that strike it."""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ..labels.about.obstacles import crossed
from ..labels.spots import SHORT
from ..labels.want import Thing

APART = 0.7  # mm between two labels
AS_ONE, MISREAD = 1.8, 39.0  # mm side by side below which two labels are read as one, and what that costs
RUN, RUNS_ON, LEVEL = 4.2, 6.0, 1.5  # the same in one line, within so many mm: D 2 of one thing, or of two
STACK, STACKED = 2.2, 9.0  # mm one over the other below which they look like a fraction, and what that costs
LISTED = 1.3  # the same of numbers of an axis
CORNER, CORNERED = 1.7, 6.0  # mm from corner to corner below which one is taken for the other's, and what that costs
FRACTION, READ_SO = 3.2, 30.0  # the same of the letter of a point and the number of a link: D over 4
TIGHT = 0.9  # mm one over the other below which they are taken for one
OVER = {Thing.POINT: Thing.LINK, Thing.LINK: Thing.POINT}
OVERLAP, PER_AREA = 120.0, 8.0
LEADER_ON_LABEL, LEADERS_CROSS = 180.0, 80.0  # a letter struck through is read wrongly, dearer than one on a line
CLEAR = 0.4  # mm between a leader and lettering that is not its own
STRAIGHT = 1e-6  # mm²: whether leaders cross that touch is told where all are weighed together
STEEP = 1e-12  # mm: a leader that goes less far to a side goes straight on


@dataclass(frozen=True, slots=True)
class Stood:
    """A label at a place: its middle, half its size, foot and tip of its leader, what it names; about it all from the
    lower left corner to the upper right."""

    centre: complex
    half: complex
    foot: complex | None
    tip: complex | None
    thing: Thing
    low: complex
    high: complex

    @classmethod
    def at(cls, centre: complex, half: complex, foot: complex | None, thing: Thing) -> Stood:
        """The leader ends just short of the label."""
        low, high = centre - half, centre + half
        if foot is None:
            return cls(centre, half, None, None, thing, low, high)
        w, h, off = half.real + SHORT, half.imag + SHORT, foot - centre
        tip = complex(centre.real + min(max(off.real, -w), w), centre.imag + min(max(off.imag, -h), h))
        low = complex(min(low.real, foot.real), min(low.imag, foot.imag))
        high = complex(max(high.real, foot.real), max(high.imag, foot.imag))
        return cls(centre, half, foot, tip, thing, low, high)

    def nears(self, low: complex, high: complex) -> bool:
        """Whether it reaches into a rectangle, or nearly."""
        level = self.low.real < high.real + RUN and self.high.real > low.real - RUN
        return level and self.low.imag < high.imag + FRACTION and self.high.imag > low.imag - FRACTION

    def meets(self, other: Stood) -> float:
        """What the two cost each other."""
        if not self.nears(other.low, other.high):
            return 0.0
        apart, room = self.centre - other.centre, other.half + self.half
        dx, dy = room.real + APART - abs(apart.real), room.imag + APART - abs(apart.imag)
        near = dx > APART - RUN and dy > APART - FRACTION
        fraction, level = OVER.get(self.thing) is other.thing, abs(apart.imag) < LEVEL
        stack = LISTED if self.thing is other.thing is Thing.OTHER else STACK
        cost = _crowded(dx, dy, fraction, level, stack) if near else 0.0
        cost += LEADER_ON_LABEL * _strikes(self, other) + LEADER_ON_LABEL * _strikes(other, self)
        return cost + LEADERS_CROSS * _cross(self, other)


def _crowded(dx: float, dy: float, fraction: bool, level: bool, stack: float) -> float:
    """What it costs that two labels are on, beside or one over the other; dx, dy: mm by which they are too near;
    fraction: whether one over the other they would be read as one; level: whether they stand in one line; stack: mm
    between them, one over the other, that are enough."""
    if dy > 0:
        if dx > APART - AS_ONE:
            return OVERLAP + PER_AREA * dx * dy if dx > 0 else MISREAD
        return RUNS_ON if level else 0.0
    if dx <= APART:
        return CORNERED if min(dx, dy) > APART - CORNER else 0.0
    stacked = (MISREAD if dy > APART - TIGHT else STACKED) if dy > APART - stack else 0.0
    return stacked + (READ_SO if fraction else 0.0)


def _strikes(one: Stood, other: Stood) -> bool:
    """Whether the leader of one runs through the other."""
    if one.foot is None or one.tip is None:
        return False
    d, start = one.tip - one.foot, one.foot - other.centre
    low, high = _passed(d.real, start.real, other.half.real + CLEAR)
    sooner, later = _passed(d.imag, start.imag, other.half.imag + CLEAR)
    return min(high, later, 1.0) - max(low, sooner, 0.0) > 0.0


def _passed(p: float, s: float, half: float) -> tuple[float, float]:
    """Where on its way a leader passes into the strip ± half and out of it."""
    steep = STEEP if abs(p) < STEEP else p
    one, other = (-half - s) / steep, (half - s) / steep
    return (one, other) if one < other else (other, one)


def _cross(one: Stood, other: Stood) -> bool:
    """Whether their leaders cross."""
    if one.foot is None or one.tip is None or other.foot is None or other.tip is None:
        return False
    (a, b), (p, q) = (one.foot, one.tip), (other.foot, other.tip)
    if max(a.real, b.real) < min(p.real, q.real) or max(p.real, q.real) < min(a.real, b.real):
        return False
    if max(a.imag, b.imag) < min(p.imag, q.imag) or max(p.imag, q.imag) < min(a.imag, b.imag):
        return False
    sides = _turned(b - a, p - a), _turned(b - a, q - a), _turned(q - p, a - p), _turned(q - p, b - p)
    if min(map(abs, sides)) > STRAIGHT:
        return sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0
    return bool(crossed(*(np.array([end]) for end in (a, b, p, q)))[0])


def _turned(d: complex, e: complex) -> float:
    """Whether one goes to the left of the other (more than nothing), or to its right."""
    return d.real * e.imag - d.imag * e.real
