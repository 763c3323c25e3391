"""What the groups' models share: the titles of their stages, and an arm that turns about a known hinge."""

from __future__ import annotations

from dataclasses import dataclass

from ..words import Words
from .equations import Stage
from .expr import ZERO, Const, Expr, Var, product
from .functions import Arctan, cos, sin, square
from .variables import Scope

POSITION = Words("位置分析", "Position")
VELOCITY = Words("速度分析", "Velocity")
ACCELERATION = Words("加速度分析", "Acceleration")


@dataclass(frozen=True, slots=True)
class Solved:
    """The stages of a group, the determinant of its linear equations, and where that vanishes."""

    stages: tuple[Stage, ...]
    determinant: Expr
    singular: Words


@dataclass(frozen=True, slots=True, kw_only=True)
class Arm:
    """A link, or the line of two gears' centres, from a known hinge to the inner hinge of the group.

    name: the subscript of its angle; turn: of the arm against the axis by which its angle is told.
    """

    name: str
    outer: str
    length: Const
    turn: Expr = ZERO

    @property
    def straight(self) -> bool:
        """Whether the angle told is the arm's own."""
        return self.turn == ZERO

    @property
    def angle_symbol(self) -> str:
        return f"φ_{{{self.name}}}"

    @property
    def rate_symbol(self) -> str:
        return f"ω_{{{self.name}}}"

    @property
    def angle(self) -> Expr:
        return Var(self.angle_symbol)

    @property
    def rate(self) -> Expr:
        return Var(self.rate_symbol)

    @property
    def bend(self) -> Expr:
        return Var(f"α_{{{self.name}}}")

    def angle_from(self, scope: Scope, c: str) -> Expr:
        """The angle told, from the places of both hinges."""
        (xo, yo), (xc, yc) = scope.xy(self.outer), scope.xy(c)
        if isinstance(self.turn, Const) and self.turn.symbol == "π":
            return Arctan(yo - yc, xo - xc)
        return Arctan(yc - yo, xc - xo) - self.turn

    def tip(self, scope: Scope) -> tuple[Expr, Expr]:
        """The inner hinge from the outer: x + l cos θ, y + l sin θ."""
        (x, y), theta = scope.xy(self.outer), self.angle + self.turn
        return x + self.length * cos(theta), y + self.length * sin(theta)

    def tip_velocity(self, scope: Scope, c: str) -> tuple[Expr, Expr]:
        """v + ω × r."""
        (xo, yo), (xc, yc), (vx, vy) = scope.xy(self.outer), scope.xy(c), scope.v(self.outer)
        return vx - self.rate * (yc - yo), vy + self.rate * (xc - xo)

    def tip_acceleration(self, scope: Scope, c: str) -> tuple[Expr, Expr]:
        """a + α × r − ω² r."""
        (xo, yo), (xc, yc), (ax, ay) = scope.xy(self.outer), scope.xy(c), scope.a(self.outer)
        return ax - self.bend * (yc - yo) - product(square(self.rate), xc - xo), ay + self.bend * (xc - xo) - product(
            square(self.rate), yc - yo
        )
