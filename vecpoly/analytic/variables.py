"""The names under which a mechanism's points and links appear in formulas,
and the formulas of points fixed on a link."""

from __future__ import annotations

import cmath
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from math import pi

from ..mechanism.asked.forces import slide_named
from ..mechanism.model import FRAME, Mechanism, Prismatic
from .equations import Equation
from .expr import ZERO, Const, Expr, Var
from .functions import cos, sin, square

_STRAIGHT = 1e-12  # rad


@dataclass(slots=True)
class Scope:
    """What is known so far, by its symbol. at, turned:
    places of letters (m) and angles of links at the given position, which tell the assembly."""

    mech: Mechanism
    at: Mapping[str, complex]
    turned: Mapping[str, float]
    angles: dict[str, Expr] = field(default_factory=lambda: {FRAME: ZERO})
    still: set[str] = field(default_factory=lambda: {FRAME})  # links that do not turn
    anchors: dict[str, str] = field(default_factory=dict)  # a located letter of each link
    done: set[str] = field(default_factory=set)  # letters located
    lengths: frozenset[str] = frozenset()  # symbols of the given lengths: l_CD

    # -- symbols ----------------------------------------------------------------------------------------------

    def name(self, link: str) -> str:
        """A link's subscript: its number; that of what stands for a higher pair,
        or for a pin in a slot, is the letter there."""
        pin = self.mech.slot_pins.get(link)
        return next((c.point for c in self.mech.contacts if c.substitute == link), link if pin is None else pin.point)

    def pair(self, link: str, parent: str) -> str:
        """The subscript of a link's sliding along another, as in the tables: 45."""
        if link in self.mech.slot_pins:
            return slide_named(
                self.mech, next(j for j in self.mech.joints if isinstance(j, Prismatic) and j.block == link)
            )
        one, two = (self.name(name) if name != FRAME else self.mech.number(name) for name in (link, parent))
        return one + two

    def phi(self, link: str) -> Expr:
        """The angle of a link's axis."""
        return self.angles.get(link) or Var(f"φ_{{{self.name(link)}}}")

    def omega(self, link: str) -> Expr:
        """ω, nothing where the link cannot turn."""
        link = self._turning(link)
        return ZERO if link in self.still else Var(f"ω_{{{self.name(link)}}}")

    def alpha(self, link: str) -> Expr:
        """α, nothing where the link cannot turn or rotates uniformly."""
        drive, link = self.mech.drive, self._turning(link)
        steady = link == drive.link and not drive.between and not drive.accel
        return ZERO if link in self.still or steady else Var(f"α_{{{self.name(link)}}}")

    def _turning(self, link: str) -> str:
        """The link with which this one turns where that needs no symbol of its own:
        the block thought about a pin turns with its slot."""
        pin = self.mech.slot_pins.get(link)
        return link if pin is None else pin.guide

    def xy(self, point: str) -> tuple[Expr, Expr]:
        """Coordinates of a letter."""
        if point in self.mech.frame:
            place = self.mech.frame[point]
            return Const(f"x_{{{point}}}", place.real), Const(f"y_{{{point}}}", place.imag)
        return Var(f"x_{{{point}}}"), Var(f"y_{{{point}}}")

    def v(self, point: str) -> tuple[Expr, Expr]:
        """Velocity of a letter."""
        return self._rates("v", point)

    def a(self, point: str) -> tuple[Expr, Expr]:
        """Acceleration of a letter."""
        return self._rates("a", point)

    def _rates(self, stem: str, point: str) -> tuple[Expr, Expr]:
        if point in self.mech.frame:
            return ZERO, ZERO
        return Var(f"{stem}_{{{point}x}}"), Var(f"{stem}_{{{point}y}}")

    def is_located(self, letter: str) -> bool:
        """Whether the coordinates of a letter are known already."""
        return letter in self.done or letter in self.mech.frame

    # -- points of a link ---------------------------------------------------------------------------------------

    def arm(self, link: str, start: str, end: str) -> tuple[Const, Expr]:
        """Length from one letter of a link to another, and its angle against the link's axis."""
        points = self.mech.link(link).points
        return polar(points[end] - points[start], self.length(start, end), f"β_{{{start}{end}}}")

    def length(self, start: str, end: str) -> str:
        """The symbol of a length, its letters in the order in which it is given, else in that of the alphabet."""
        first, second = (
            (start, end)
            if f"l_{start}{end}" in self.lengths
            else (end, start)
            if f"l_{end}{start}" in self.lengths
            else sorted((start, end))
        )
        return f"l_{{{first}{second}}}"

    def direction(self, link: str, start: str, end: str) -> Expr:
        """The angle of the ray between two letters of a link."""
        return self.phi(link) + self.arm(link, start, end)[1]

    def place(self, link: str, start: str, end: str) -> tuple[Expr, Expr]:
        """Coordinates of one letter of a link from another: x + l cos(φ + β), y + l sin(φ + β)."""
        (x, y), length, angle = self.xy(start), self.arm(link, start, end)[0], self.direction(link, start, end)
        return x + length * cos(angle), y + length * sin(angle)

    def velocity(self, link: str, start: str, end: str) -> tuple[Expr, Expr]:
        """Velocity of one letter of a link from another's: v + ω × r."""
        (x, y), (x0, y0), (vx, vy), w = self.xy(end), self.xy(start), self.v(start), self.omega(link)
        return vx - w * (y - y0), vy + w * (x - x0)

    def acceleration(self, link: str, start: str, end: str) -> tuple[Expr, Expr]:
        """Acceleration of one letter of a link from another's: a + α × r − ω² r."""
        (x, y), (x0, y0), (ax, ay) = self.xy(end), self.xy(start), self.a(start)
        w, e = square(self.omega(link)), self.alpha(link)
        return ax - e * (y - y0) - w * (x - x0), ay + e * (x - x0) - w * (y - y0)

    def further(self, links: Iterable[str]) -> list[tuple[str, str, str]]:
        """(link, anchor, letter) of every letter of these links that is not located yet;
        it counts as located from now on."""
        found = []
        for link in links:
            for letter in self.mech.link(link).points:
                if not self.is_located(letter):
                    found.append((link, self.anchors[link], letter))
                    self.done.add(letter)
        return found


def polar(vector: complex, length: str, angle: str) -> tuple[Const, Expr]:
    """|vector| and its angle as named constants; a straight angle is 0 or π."""
    turn = cmath.phase(vector)
    if abs(turn) < _STRAIGHT or vector == 0:
        return Const(length, abs(vector)), ZERO
    if abs(abs(turn) - pi) < _STRAIGHT:
        return Const(length, abs(vector)), Const("π", pi, "rad")
    return Const(length, abs(vector)), Const(angle, turn, "rad")


def both(left: tuple[Expr, Expr], right: tuple[Expr, Expr], gives: bool = True) -> tuple[Equation, Equation]:
    """An equation in x and one in y."""
    return Equation(left[0], right[0], gives), Equation(left[1], right[1], gives)
