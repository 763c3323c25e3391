"""Centres and the lines through them, at infinity too:
a centre there is a direction, and all of these lie on the line at infinity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...plane import Line, Points, cross, lines_meet, nominal, unit

SAME = 1e-6  # mm: centres nearer than this are one
SHORT = 15.0  # mm: two centres nearer than this make an uncertain line
NONE = 1e-8  # sine below which lines are parallel, for the most exact hand


@dataclass(frozen=True, slots=True, kw_only=True)
class Centre:
    """A centre at a point of the paper, or at infinity in the direction `along` (unit vector, either sense)."""

    at: Points | None = None
    along: Points | None = None

    @property
    def endless(self) -> bool:
        """Whether it is at infinity."""
        return self.at is None

    def spot(self) -> complex:
        """Its nominal place; only of one that is not at infinity."""
        assert self.at is not None
        return complex(nominal(self.at))

    def way(self) -> complex:
        """Its nominal direction; only of one at infinity."""
        assert self.along is not None
        return complex(nominal(self.along))


HORIZON = None  # the line at infinity
Through = Line | None


def same(a: Centre, b: Centre) -> bool:
    """Whether two centres are one, point or direction."""
    if a.endless != b.endless:
        return False
    return abs(float(cross(a.way(), b.way()))) < NONE if a.endless else abs(a.spot() - b.spot()) < SAME


def through(a: Centre, b: Centre) -> Through:
    """The line through two centres: a parallel where one is at infinity, the line at infinity where both are."""
    if a.at is not None and b.at is not None:
        return Line(a.at, unit(b.at - a.at))
    if a.at is not None and b.along is not None:
        return Line(a.at, b.along)
    if b.at is not None and a.along is not None:
        return Line(b.at, a.along)
    return HORIZON


def parallel(g: Line, h: Line, accuracy: float = 0.0) -> bool:
    """Whether two lines cannot be told from parallels by a set square of this accuracy (rad)."""
    return abs(float(nominal(cross(g.along, h.along)))) < max(NONE, 3 * accuracy)


def meeting(g: Through, h: Through, endless: bool) -> Centre:
    """Where two lines meet; `endless`: at infinity, in the direction of both, or of the one that is no horizon."""
    lines = [line for line in (g, h) if line is not None]
    if len(lines) == 2 and not endless:
        return Centre(at=lines_meet(lines[0], lines[1]))
    ahead = [line.along * np.sign(nominal(np.real(np.conj(lines[0].along) * line.along))) for line in lines]
    return Centre(along=unit(sum(ahead[1:], ahead[0])))


def sharpness(g: Through, h: Through) -> float:
    """How well two lines meet: the sine of their angle; 0 where they are one line."""
    if g is None or h is None:
        return 1.0 if g is not h else 0.0
    sine = abs(float(nominal(cross(g.along, h.along))))
    if sine >= NONE:
        return sine
    apart = abs(float(nominal(cross(g.along, h.at - g.at))))
    return NONE if apart > SHORT / 100 else 0.0
