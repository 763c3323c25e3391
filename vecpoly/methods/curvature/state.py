"""The figure of the curvatures while it is drawn, and what was found on it so far (mm on it)."""

from __future__ import annotations

from cmath import isfinite
from dataclasses import dataclass, field

import numpy as np

from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import Dot, Point, Role
from ...errors import DeadPointError, NotAskedError
from ...mechanism.asked.centres import centre
from ...mechanism.asked.curvature import inflection_pole
from ...mechanism.model import FRAME
from ...names import subscripted
from ...plane import Line, Points, cross, nominal, unit
from ...words import Words
from ..desk import Desk

BEYOND = 4.0  # mm that a thin line runs on beyond what it joins
STUB = 15.0  # mm that is drawn of a line to a point off the paper


@dataclass(frozen=True, slots=True, kw_only=True)
class Ray:
    """The normal of a path: of the point `moving` at `x` about `fixed` at `o`; None: at infinity along the normal."""

    moving: str
    fixed: str
    x: Points | None
    o: Points | None
    line: Line

    @property
    def whole(self) -> bool:
        """Whether neither end is at infinity."""
        return self.x is not None and self.o is not None

    @property
    def name(self) -> str:
        """What its points are lettered by: the moving point, or the pivot of the block through which a line passes."""
        return self.moving or self.fixed

    def spots(self) -> list[Points]:
        """Its points on the paper."""
        return [at for at in (self.x, self.o) if at is not None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """The collineation axis PQ of two normals; `at` is None where Q is at infinity."""

    line: Line
    letter: str
    at: Points | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Off:
    """The figure, `ratio` times as large as that of the curvatures, on which the points `names` are found, which lie
    off the paper: beyond these corners (mm)."""

    pane: Place
    ratio: float
    names: frozenset[str]
    corners: tuple[complex, complex]

    def holds(self, at: complex) -> bool:
        """Whether a point lies off the paper."""
        low, high = self.corners
        return not (low.real <= at.real <= high.real and low.imag <= at.imag <= high.imag)


@dataclass(slots=True)
class CurvatureFigure:
    """The figure `pane`, `factor` times as large as the diagram; pole, W, points found on it, in mm of this figure,
    also of what is drawn off the paper."""

    desk: Desk
    link: str
    pane: Place
    factor: float
    off: Off | None = None
    rays: tuple[Ray, ...] = ()
    pole: Points = 0j
    opposite: Points = 0j  # W
    returned: Points = 0j  # its mirror image in the pole, where that is asked
    undulating: Points = 0j  # U, where Ball's point is asked
    tangent: Points = 1 + 0j
    axis: Axis | None = None  # where it was drawn
    centres: dict[str, Points] = field(default_factory=dict)  # of curvature, by the point of the link
    taken: set[str] = field(default_factory=set)  # letters that stand on the figure
    spots: dict[str, complex] = field(default_factory=dict)  # where the points are that were found, by their letters
    homes: dict[str, tuple[Place, float]] = field(default_factory=dict)  # on which figure, how large against this

    @property
    def board(self) -> Board:
        """The sheet."""
        return self.desk.board

    @property
    def p(self) -> str:
        """P_{24}: the symbol of the pole."""
        return centre(self.desk.mech, self.link, FRAME).symbol

    @property
    def w(self) -> str:
        """W_{2}: the symbol of the inflection pole."""
        return inflection_pole(self.desk.mech, self.link).symbol

    def at(self, letter: str) -> Points:
        """A point of the mechanism on this figure."""
        return self.desk.at[letter] * self.factor

    def shown(self, letter: str) -> str:
        """A letter of the mechanism as printed."""
        return subscripted(letter)

    def free(self, letter: str, sub: str = "") -> str:
        """A letter that nothing else has: Q, Q′ where the mechanism has a Q of its own; Q_{E}."""
        while self._whole(letter, sub) in self.taken or (not sub and letter in self.desk.at):
            letter += "′"
        self.taken.add(self._whole(letter, sub))
        return self._whole(letter, sub)

    def _whole(self, letter: str, sub: str) -> str:
        return f"{letter}_{{{sub}}}" if sub else letter

    # -- marks --------------------------------------------------------------------------------------------------

    def sheet(self, *points: Points, name: str = "") -> tuple[Place, float]:
        """The figure on which these points lie, or the one of this name, and how large it is against this."""
        off = self.off
        if off is None or not (name in off.names or any(off.holds(complex(nominal(at))) for at in points)):
            return self.pane, 1.0
        return off.pane, off.ratio

    def letter(self, symbol: str, at: Points, dot: Dot = Dot.POINT, beside: str = "") -> Points:
        """A point is found, on the figure of the point `beside` it: it has its letter. Raises DeadPointError where
        lines without length lead nowhere."""
        if not isfinite(complex(nominal(at))):
            raise DeadPointError(Words(f"${symbol}$ 作不出", f"${symbol}$ is not found"))
        pane, ratio = self.sheet(name=symbol) if symbol in self._off else self.sheet(name=beside)
        found = self.board.locate(pane, symbol, at * ratio, found_on=True)
        self.board.plot(pane, found, symbol, dot)
        self.spots[symbol], self.homes[symbol] = complex(nominal(found)) / ratio, (pane, ratio)
        return found / ratio

    def centre(self, letter: str, symbol: str, at: Points) -> Points:
        """The centre of curvature of the path of a point is found; the point has its letter beside it."""
        self.name_once(letter)
        self.centres[letter] = self.letter(symbol, at)
        self.homes[letter] = self.homes[symbol]
        return self.centres[letter]

    @property
    def _off(self) -> frozenset[str]:
        return self.off.names if self.off else frozenset()

    def thin(self, line: Line, *points: Points, role: Role = Role.CONSTRUCTION) -> None:
        """A thin line, a little beyond the outermost of these points; of one that leaves the paper also a piece on
        it."""
        pane, ratio = self.sheet(*points)
        self._ruled(pane, line, [at * ratio for at in points], ratio, role)
        on = [at for at in points if self.off is not None and not self.off.holds(complex(nominal(at)))]
        if pane != self.pane and on:
            away = next(at for at in points if self.sheet(at)[0] != self.pane)
            self._ruled(self.pane, line, [*on, on[0] + STUB * unit(away - on[0])], 1.0, role)

    def _ruled(self, pane: Place, line: Line, points: list[Points], ratio: float, role: Role) -> None:
        start = line.at * ratio
        at, along = complex(nominal(start)), complex(nominal(line.along))
        reach = [float((along.conjugate() * (complex(nominal(p)) - at)).real) for p in points]
        low, high = min(reach) - BEYOND, max(reach) + BEYOND
        self.board.join(pane, start + line.along * low, start + line.along * high, role)

    def name(self, symbol: str, at: Points, by: Points = 0j, *, key: str = "") -> None:
        """A letter beside a point, `by` mm on paper from it."""
        pane, ratio = self.sheet(at)
        self.board.plot(pane, at * ratio + by, symbol, Dot.NONE, key=key)

    def name_once(self, letter: str) -> None:
        """The letter of a point of the mechanism, unless it stands there already."""
        there = {mark.label for mark in self.board.marks(self.pane) if isinstance(mark, Point)}
        if self.shown(letter) not in there:
            self.board.plot(self.pane, self.at(letter), self.shown(letter), Dot.NONE)

    def ring(self, over: tuple[Points, Points], role: Role) -> None:
        """The circle over a diameter."""
        pane, ratio = self.sheet(*over)
        middle = (over[0] + over[1]) / 2
        self.board.circle(pane, middle * ratio, np.abs(over[1] - middle) * ratio, role)

    def arrow(self, a: Points, b: Points, role: Role, label: str) -> None:
        """A vector, on the figure that holds it."""
        pane, ratio = self.sheet(a, b)
        self.board.arrow(pane, a * ratio, b * ratio, role, label=label)

    def through(self, a: Points, b: Points) -> Line:
        """The line through two points; raises NotAskedError where they are one."""
        if not abs(complex(nominal(b - a))):
            raise NotAskedError(
                Words(
                    "作图中有两点重合，不能连成直线；请检查机架上各点和各杆长，或另取原动件位置",
                    "two points of the construction lie in one place and give no line; check the points of the frame "
                    "and the lengths, or choose another position",
                ),
                code="coincident",
            )
        return Line(a, unit(b - a))

    def meet(self, g: Line, h: Line, zh: str, en: str) -> Points:
        """Where two lines of the construction meet."""
        return self.board.meet(g, h, Words(zh, en))

    def normal(self, line: Line, at: Points) -> Line:
        """The perpendicular to a line at a point, by set square."""
        return self.board.parallel(at, 1j * line.along)

    def ray_of(self, letter: str) -> Line:
        """The normal of the path of a point: its line to the pole."""
        return Line(self.pole, unit(self.at(letter) - self.pole))


def sine(g: Points, h: Points) -> float:
    """Of the angle between two directions, as the nominal hand sees it."""
    return abs(float(nominal(cross(g, h)))) / float(abs(nominal(g)) * abs(nominal(h)))
