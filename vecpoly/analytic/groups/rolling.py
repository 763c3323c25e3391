"""A gear that rolls on a known gear or rack: its centre keeps its distance,
and pure rolling tells how fast it turns."""

from __future__ import annotations

import cmath

from ...mechanism.model import Circle, Rack, Rolling, Side
from ..equations import Equation
from ..expr import Const, Expr, Var
from ..stages import Arm
from ..track import Track, Turning, line_through
from ..variables import Scope


def rolling(scope: Scope, joint: Rolling, link: str, parent: str, c: str) -> tuple[Arm | Track, Turning]:
    """The locus of the gear's centre C, and the gear's ω and α by pure rolling."""
    mine, other = (joint.gear, joint.on) if joint.gear.link == link else (joint.on, joint.gear)
    assert isinstance(mine, Circle)
    scope.anchors[link] = c
    name = scope.name(link)
    radius = Const(f"r_{{{name}}}", mine.radius)
    if isinstance(other, Rack):
        side = 1.0 if joint.side is Side.LEFT else -1.0
        base = other.origin + 1j * side * mine.radius * cmath.rect(1.0, other.direction)
        line = line_through(scope, parent, base, other.direction, f"H{name}")
        return line, _rolls(
            scope,
            link,
            _on_rack(scope, parent, line.speed, radius, side),
            _on_rack(scope, parent, line.push, radius, side, "α"),
        )
    reach = abs(other.radius - mine.radius) if joint.internal else other.radius + mine.radius
    arm = Arm(name=f"H{name}", outer=other.centre, length=Const(f"l_{{{other.centre}{c}}}", reach))
    partner = Const(f"r_{{{scope.name(parent)}}}", other.radius)
    if scope.name(parent) == "0":
        partner = Const(f"r_{{{scope.mech.frame_number}}}", other.radius)
    ratio = partner / radius
    sign = -1 if joint.internal else 1
    omega = _share(arm.rate, ratio * (arm.rate - scope.omega(parent)), sign)
    alpha = _share(arm.bend, ratio * (arm.bend - scope.alpha(parent)), sign)
    return arm, _rolls(scope, link, omega, alpha)


def _on_rack(scope: Scope, parent: str, speed: Expr, radius: Const, side: float, order: str = "ω") -> Expr:
    """ω of the rack ∓ v_r / r."""
    base = scope.omega(parent) if order == "ω" else scope.alpha(parent)
    return _share(base, speed / radius, -1 if side > 0 else 1)


def _share(first: Expr, second: Expr, sign: int) -> Expr:
    return first + second if sign > 0 else first - second


def _rolls(scope: Scope, link: str, omega: Expr, alpha: Expr) -> Turning:
    return Turning((), (Equation(scope.omega(link), omega),), (Equation(Var(f"α_{{{scope.name(link)}}}"), alpha),))
