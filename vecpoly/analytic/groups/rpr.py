"""RPR: a guide pinned to a known point G, and a block that slides along it, pinned to a known point F."""

from __future__ import annotations

import cmath
from dataclasses import dataclass

from ...mechanism.model import Prismatic
from ...words import Words
from ..equations import Equation, Part, Stage
from ..expr import TWO, Const, Expr, Var
from ..functions import Arctan, SquareRoot, cos, sin, square
from ..stages import ACCELERATION, POSITION, VELOCITY, Solved
from ..track import Turning, settle
from ..variables import Scope, both

_NONE = 1e-12


@dataclass(frozen=True, slots=True, kw_only=True)
class Swing:
    """Guide and block with their pivots G and F; psi: direction of the guide line;
    offset: how far F stays to the left of the line through G."""

    guide: str
    block: str
    g: str
    f: str
    psi: Expr
    offset: Const
    ahead: bool  # F lies ahead of G along the line
    name: str

    @property
    def travel(self) -> Var:
        return Var(f"s_{{{self.name}}}")

    @property
    def speed(self) -> Var:
        return Var(f"v_{{{self.name}}}")

    @property
    def push(self) -> Var:
        return Var(f"a_{{{self.name}}}")


def swinging(scope: Scope, joint: Prismatic, g: str, f: str) -> Solved:
    """The guide turns so that the block's pivot is where it is."""
    it, turning = _swing(scope, joint, g, f)
    return Solved(
        (
            Stage(POSITION, _position(scope, it, turning)),
            Stage(VELOCITY, _velocity(scope, it, turning)),
            Stage(ACCELERATION, _acceleration(scope, it, turning)),
        ),
        it.travel,
        Words(
            f"当 ${f}$ 通过 ${g}$（$s_{{{it.name}}}$ = 0）时杆组处于奇异位置；$s_{{{it.name}}}$ 越小，"
            "角速度和角加速度越大，方程越病态。",
            f"Where ${f}$ passes through ${g}$, $s_{{{it.name}}}$ = 0 and the group is singular; the smaller "
            f"$s_{{{it.name}}}$, the larger ω and α, and the worse the conditioning.",
        ),
    )


def _swing(scope: Scope, joint: Prismatic, g: str, f: str) -> tuple[Swing, Turning]:
    guide, block, back = scope.mech.link(joint.guide), scope.mech.link(joint.block), cmath.rect(1.0, -joint.direction)
    line = (joint.origin - guide.points[g]) * back
    pin = (block.points[joint.pin] - block.points[f]) * cmath.rect(1.0, joint.turn)
    offset = line.imag + joint.offset - pin.imag
    along = cmath.rect(1.0, scope.turned[joint.guide] + joint.direction)
    lean = 0.0 if abs(joint.direction) < _NONE else joint.direction
    name = scope.name(joint.guide)
    psi = Var(f"ψ_{{{name}}}") if lean else scope.phi(joint.guide)
    own = (Equation(scope.phi(joint.guide), psi - Const(f"γ_{{{name}}}", lean, "rad")),) if lean else ()
    it = Swing(
        guide=joint.guide,
        block=joint.block,
        g=g,
        f=f,
        psi=psi,
        offset=Const(f"e_{{{name}}}", 0.0 if abs(offset) < _NONE else offset),
        ahead=(along.conjugate() * (scope.at[f] - scope.at[g])).real > 0,
        name=scope.pair(joint.block, joint.guide),
    )
    turning = settle(scope, joint.block, joint.guide, joint.direction + joint.turn)
    return it, Turning((*own, *turning.position), turning.velocity, turning.acceleration)


def _position(scope: Scope, it: Swing, turning: Turning) -> tuple[Part, ...]:
    (xg, yg), (xf, yf), e, s = scope.xy(it.g), scope.xy(it.f), it.offset, it.travel
    u, w = cos(it.psi), sin(it.psi)
    root = SquareRoot(square(xf - xg) + square(yf - yg) - square(e))
    psi = (
        Arctan(s * (yf - yg) - e * (xf - xg), s * (xf - xg) + e * (yf - yg))
        if e.size
        else (Arctan(yf - yg, xf - xg) if it.ahead else Arctan(yg - yf, xg - xf))
    )
    sense = (
        Words(
            f"${it.f}$ 沿导路正向在 ${it.g}$ 之前，故取正号",
            f"${it.f}$ lies ahead of ${it.g}$ along the guide: the root is positive",
        )
        if it.ahead
        else Words(
            f"${it.f}$ 沿导路正向在 ${it.g}$ 之后，故取负号",
            f"${it.f}$ lies behind ${it.g}$ along the guide: the root is negative",
        )
    )
    return (
        Part(
            Words(
                f"$s_{{{it.name}}}$ 为 ${it.f}$ 沿导路到 ${it.g}$ 的坐标。${it.f}$ 已知，封闭矢量方程的投影为",
                f"Here $s_{{{it.name}}}$ is the coordinate of ${it.f}$ along the guide, measured from "
                f"${it.g}$. With ${it.f}$ known the vector loop gives",
            ),
            both((xf, yf), (xg + s * u - e * w, yg + s * w + e * u), gives=False),
        ),
        Part(
            Words(f"解得（{sense.zh}）", f"The solution is ({sense.en})"),
            (Equation(s, root if it.ahead else -root), Equation(it.psi, psi), *turning.position),
        ),
    )


def _velocity(scope: Scope, it: Swing, turning: Turning) -> tuple[Part, ...]:
    (vgx, vgy), (vfx, vfy), rate, s = scope.v(it.g), scope.v(it.f), scope.omega(it.guide), it.travel
    (xg, yg), (xf, yf), u, w = scope.xy(it.g), scope.xy(it.f), cos(it.psi), sin(it.psi)
    dx, dy = vfx - vgx, vfy - vgy
    return (
        Part(
            Words("将位置方程对时间求导，得", "Differentiating the position equations with respect to time gives"),
            both(
                (vfx, vfy), (vgx - rate * (yf - yg) + it.speed * u, vgy + rate * (xf - xg) + it.speed * w), gives=False
            ),
        ),
        Part(
            Words(
                f"其中 $v_{{{it.name}}}$ 为滑块沿导路的相对速度。解为",
                f"Here $v_{{{it.name}}}$ is the block's speed along the guide. The solution is",
            ),
            (
                Equation(rate, (dy * u - dx * w) / s),
                Equation(it.speed, dx * u + dy * w + rate * it.offset),
                *turning.velocity,
            ),
        ),
    )


def _acceleration(scope: Scope, it: Swing, turning: Turning) -> tuple[Part, ...]:
    (agx, agy), (afx, afy), rate, bend, s = (
        scope.a(it.g),
        scope.a(it.f),
        scope.omega(it.guide),
        scope.alpha(it.guide),
        it.travel,
    )
    (xg, yg), (xf, yf), u, w, e = scope.xy(it.g), scope.xy(it.f), cos(it.psi), sin(it.psi), it.offset
    dx, dy, coriolis = afx - agx, afy - agy, TWO * rate * it.speed
    return (
        Part(
            Words(
                "再求导一次（末项的系数 2 来自哥氏加速度），得",
                "Differentiating once more gives (the last term, with the factor 2, is the Coriolis acceleration)",
            ),
            both(
                (afx, afy),
                (
                    agx - bend * (yf - yg) - square(rate) * (xf - xg) - coriolis * w + it.push * u,
                    agy + bend * (xf - xg) - square(rate) * (yf - yg) + coriolis * u + it.push * w,
                ),
                gives=False,
            ),
        ),
        Part(
            Words("解为", "The solution is"),
            (
                Equation(bend, (dy * u - dx * w + square(rate) * e - coriolis) / s),
                Equation(it.push, dx * u + dy * w + bend * e + square(rate) * s),
                *turning.acceleration,
            ),
        ),
    )
