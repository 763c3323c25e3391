"""The straight path of a point of a sliding link on the other link of the pair: x = x_Q + s cos ψ − e sin ψ."""

from __future__ import annotations

import cmath
from collections.abc import Mapping
from dataclasses import dataclass

from ..errors import NoMethodError
from ..foundation.slotted import replace
from ..mechanism.model import FRAME, Prismatic
from ..words import Words
from .equations import Equation
from .expr import TWO, ZERO, Const, Expr, Var
from .functions import cos, sin, square
from .variables import Scope

_NONE = 1e-12  # m, rad


@dataclass(frozen=True, slots=True, kw_only=True)
class Track:
    """A line fixed on a known link.

    name: subscript of the sliding link; pair: of the sliding motion, 45 of link 4 along link 5, nothing where the point
    only rolls along; base: letter of the known link from whose foot on the line s counts; offset: of the line
    to the left of it; psi: direction of the line; along: the same at the given position.
    """

    name: str
    parent: str
    base: str
    offset: Const
    psi: Expr
    along: complex
    pair: str = ""

    @property
    def travel(self) -> Var:
        return Var(f"s_{{{self.pair or self.name}}}")

    @property
    def speed(self) -> Var:
        return Var(f"v_{{{self.pair or f'r{self.name}'}}}")

    @property
    def push(self) -> Var:
        return Var(f"a_{{{self.pair or f'r{self.name}'}}}")

    @property
    def unit(self) -> tuple[Expr, Expr]:
        """cos ψ, sin ψ."""
        return cos(self.psi), sin(self.psi)

    def foot(self, scope: Scope) -> tuple[Expr, Expr]:
        """Where s is zero."""
        (x, y), (c, s) = scope.xy(self.base), self.unit
        return x - self.offset * s, y + self.offset * c

    def point(self, scope: Scope) -> tuple[Expr, Expr]:
        """The sliding point."""
        (x, y), (c, s) = self.foot(scope), self.unit
        return x + self.travel * c, y + self.travel * s

    def carried(self, scope: Scope, at: str) -> tuple[Expr, Expr]:
        """Velocity of the known link's point that is under the sliding one."""
        (x, y), (x0, y0), (vx, vy), w = scope.xy(at), scope.xy(self.base), scope.v(self.base), scope.omega(self.parent)
        return vx - w * (y - y0), vy + w * (x - x0)

    def velocity(self, scope: Scope, at: str) -> tuple[Expr, Expr]:
        """v = v of the point underneath + v_r."""
        (wx, wy), (c, s) = self.carried(scope, at), self.unit
        return wx + self.speed * c, wy + self.speed * s

    def dragged(self, scope: Scope, at: str) -> tuple[Expr, Expr]:
        """Acceleration of the point underneath, and Coriolis'."""
        (x, y), (x0, y0), (ax, ay) = scope.xy(at), scope.xy(self.base), scope.a(self.base)
        w, e, (c, s) = scope.omega(self.parent), scope.alpha(self.parent), self.unit
        coriolis = TWO * w * self.speed
        return (
            ax - e * (y - y0) - square(w) * (x - x0) - coriolis * s,
            ay + e * (x - x0) - square(w) * (y - y0) + coriolis * c,
        )

    def acceleration(self, scope: Scope, at: str) -> tuple[Expr, Expr]:
        """a = a of the point underneath + a^k + a_r."""
        (qx, qy), (c, s) = self.dragged(scope, at), self.unit
        return qx + self.push * c, qy + self.push * s


@dataclass(frozen=True, slots=True)
class Turning:
    """The equations of φ, ω and α of a link whose angle follows from a known link's."""

    position: tuple[Equation, ...] = ()
    velocity: tuple[Equation, ...] = ()
    acceleration: tuple[Equation, ...] = ()


def track(scope: Scope, joint: Prismatic, link: str, local: complex, name: str = "") -> tuple[Track, Turning]:
    """The path of a point of `link` (given in its own coordinates) on the other link, and how the link turns.

    name: another subscript than the link's own.
    """
    block = joint.block == link
    parent = joint.guide if block else joint.block
    pin = scope.mech.link(joint.block).points.get(joint.pin, 0j)
    if block:
        lean, turn = joint.direction, joint.direction + joint.turn
        base = joint.origin + cmath.rect(1.0, lean) * (1j * joint.offset + cmath.rect(1.0, joint.turn) * (local - pin))
    else:
        lean, turn = -joint.turn, -joint.turn - joint.direction
        across = ((local - joint.origin) * cmath.rect(1.0, -joint.direction)).imag - joint.offset
        base = pin + 1j * across * cmath.rect(1.0, lean)
    line = line_through(
        scope,
        parent,
        base,
        lean,
        name or scope.name(link),
        joint.through if block else joint.pin,
        joint.origin if block else None,
    )
    return replace(line, pair=scope.pair(link, parent)), settle(scope, link, parent, turn)


def line_through(
    scope: Scope, parent: str, base: complex, lean: float, name: str, wanted: str = "", zero: complex | None = None
) -> Track:
    """The line through a place of a known link, in its coordinates, at an angle to its axis;
    zero: where the joint's own travel is zero."""
    letter, offset = _base(scope, parent, base, cmath.rect(1.0, lean), wanted, base if zero is None else zero)
    psi = _turned(scope, parent, lean, f"ψ_{{{name}}}" if parent == FRAME else f"γ_{{{name}}}")
    return Track(
        name=name,
        parent=parent,
        base=letter,
        offset=Const(f"e_{{{name}}}", offset),
        psi=psi,
        along=cmath.rect(1.0, scope.turned.get(parent, 0.0) + lean),
    )


def settle(scope: Scope, link: str, parent: str, turn: float) -> Turning:
    """The angle of a link that slides on a known one: φ = φ_parent + const; it turns as the known one does."""
    name = scope.name(link)
    if parent in scope.still:
        base = scope.turned.get(parent, 0.0)
        scope.angles[link] = Const(f"φ_{{{name}}}", _clean(base + turn), "rad")
        scope.still.add(link)
        return Turning()
    if link in scope.mech.slot_pins:
        scope.angles[link] = _turned(scope, parent, turn, f"δ_{{{name}}}")
        return Turning()
    position = Equation(scope.phi(link), _turned(scope, parent, turn, f"δ_{{{name}}}"))
    return Turning(
        (position,),
        (Equation(scope.omega(link), scope.omega(parent)),),
        (Equation(Var(f"α_{{{name}}}"), scope.alpha(parent)),),
    )


def _turned(scope: Scope, parent: str, turn: float, symbol: str) -> Expr:
    turn = _clean(turn)
    return scope.phi(parent) + (Const(symbol, turn, "rad") if turn else ZERO)


def _clean(turn: float) -> float:
    """−π < turn ≤ π, and zero for what rounding leaves."""
    turn = cmath.phase(cmath.rect(1.0, turn))
    return 0.0 if abs(turn) < _NONE else turn


def lettered(scope: Scope, link: str) -> Mapping[str, complex]:
    """The letters of a link with their coordinates on it.
    Raises NoMethodError where it carries none: there is nothing to tell its place by."""
    if not (points := scope.mech.link(link).points):
        raise NoMethodError(
            Words(
                f"没有构件 {scope.name(link)} 的数学模型：其上没有标字母的点；请在该构件上给出一点",
                f"no mathematical model on file for link {scope.name(link)}: it carries no letter; name a point on it",
            )
        )
    return points


def _base(scope: Scope, parent: str, base: complex, along: complex, wanted: str, zero: complex) -> tuple[str, float]:
    """The letter from which the line is told, and its distance from the line: the one abreast of the travel's zero,
    else one on the line if there is any. On a link of the group itself only its hinge is located yet."""
    points = lettered(scope, parent)
    points = {letter: place for letter, place in points.items() if scope.is_located(letter)} or points
    gaps = {letter: (along.conjugate() * (base - place)).imag for letter, place in points.items()}
    abreast = {letter: abs((along.conjugate() * (zero - place)).real) < _NONE for letter, place in points.items()}
    letter = min(gaps, key=lambda p: (not abreast[p], round(abs(gaps[p]), 9), p != wanted))
    return letter, 0.0 if abs(gaps[letter]) < _NONE else gaps[letter]
