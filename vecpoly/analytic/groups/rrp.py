"""RRP: one link pinned to a known point B, the other sliding on a known line; they are pinned to each other at C."""

from __future__ import annotations

from ...words import Words
from ..equations import Equation, Part, Stage
from ..expr import Const, Expr, Var
from ..functions import SquareRoot, square
from ..stages import ACCELERATION, POSITION, VELOCITY, Arm, Solved
from ..track import Track
from ..variables import Scope, both


def slider(scope: Scope, j: Arm, k: Track, c: str) -> Solved:
    """C on the circle about the hinge and on the line."""
    (xb, yb), (xc, yc), (u, w) = scope.xy(j.outer), scope.xy(c), k.unit
    determinant = (xc - xb) * u + (yc - yb) * w
    return Solved(
        (
            Stage(POSITION, _position(scope, j, k, c)),
            Stage(VELOCITY, _velocity(scope, j, k, c, determinant)),
            Stage(ACCELERATION, _acceleration(scope, j, k, c)),
        ),
        determinant,
        Words(
            f"当 ${j.outer}{c}$ 垂直于导路时 $G_1$ = 0，杆组处于奇异位置；接近该位置时方程组病态。",
            f"Where ${j.outer}{c}$ is perpendicular to the guide, $G_1$ = 0 and the group is singular; "
            "near there the equations are ill-conditioned.",
        ),
    )


def _position(scope: Scope, j: Arm, k: Track, c: str) -> tuple[Part, ...]:
    (xb, yb), (xq, yq), (u, w) = scope.xy(j.outer), scope.xy(k.base), k.unit
    a, b = Var("A_0"), Var("B_0")
    ahead = (k.along.conjugate() * (scope.at[c] - scope.at[j.outer])).real > 0
    sign = Const("σ", 1.0 if ahead else -1.0, "")
    foot = (
        Words(f" ${k.base}$ ", f"${k.base}$")
        if not k.offset.size
        else Words(f" ${k.base}$ 在导路上的垂足", f"the foot of ${k.base}$ on it")
    )
    head, side = ("+1", Words("正", "positive")) if ahead else ("−1", Words("负", "negative"))
    return (
        Part(
            Words(
                f"${k.travel.symbol}$ 为 ${c}$ 沿导路的坐标，自{foot.zh}量起。封闭矢量方程的投影为",
                f"Here ${k.travel.symbol}$ is the coordinate of ${c}$ along the guide, measured from "
                f"{foot.en}. The vector loop projected on the axes gives",
            ),
            both(j.tip(scope), k.point(scope), gives=False),
        ),
        Part(
            Words(f"将 ${j.outer}{c}$ 之长代入，消去 ${j.angle_symbol}$，得", f"Eliminating ${j.angle_symbol}$,"),
            (
                Equation(a, (xb - xq) * u + (yb - yq) * w),
                Equation(b, (yb - yq) * u - (xb - xq) * w - k.offset),
                Equation(k.travel, a + sign * SquareRoot(square(j.length) - square(b))),
            ),
        ),
        Part(
            Words(
                f"装配模式系数 $σ$ = {head}（${c}$ 在 ${j.outer}$ 到导路的垂足的{side.zh}向一侧）。从而",
                f"with $σ$ = {head}, since ${c}$ lies to the {side.en} side of the foot of ${j.outer}$ "
                "on the guide. Then",
            ),
            (*both(scope.xy(c), k.point(scope)), Equation(j.angle, j.angle_from(scope, c))),
        ),
    )


def _velocity(scope: Scope, j: Arm, k: Track, c: str, determinant: Expr) -> tuple[Part, ...]:
    (xb, yb), (xc, yc), (u, w), g = scope.xy(j.outer), scope.xy(c), k.unit, Var("G_1")
    under, names = _named(scope, k, c, "v", k.carried(scope, c))
    dx, dy = (p - q for p, q in zip(names, scope.v(j.outer), strict=True))
    return (
        Part(
            Words("将位置方程对时间求导，得", "Differentiating the position equations with respect to time gives"),
            both(j.tip_velocity(scope, c), k.velocity(scope, c), gives=False),
        ),
        Part(
            Words(
                f"其中 ${k.speed.symbol}$ 为沿导路的滑动速度。解为",
                f"Here ${k.speed.symbol}$ is the sliding speed along the guide. The solution is",
            ),
            (
                *under,
                Equation(g, determinant),
                Equation(j.rate, (dy * u - dx * w) / g),
                Equation(k.speed, j.rate * ((xc - xb) * w - (yc - yb) * u) - dx * u - dy * w),
                *both(scope.v(c), k.velocity(scope, c) if _stands(scope, k) else j.tip_velocity(scope, c)),
            ),
        ),
    )


def _acceleration(scope: Scope, j: Arm, k: Track, c: str) -> tuple[Part, ...]:
    (xb, yb), (xc, yc), (u, w), (ax, ay) = scope.xy(j.outer), scope.xy(c), k.unit, scope.a(j.outer)
    (qx, qy), square_rate = k.dragged(scope, c), square(j.rate)
    gx, gy = Var("G_2"), Var("G_3")
    return (
        Part(
            Words("再求导一次，得", "Differentiating once more gives"),
            both(j.tip_acceleration(scope, c), k.acceleration(scope, c), gives=False),
        ),
        Part(
            Words("解为", "The solution is"),
            (
                Equation(gx, qx - ax + square_rate * (xc - xb)),
                Equation(gy, qy - ay + square_rate * (yc - yb)),
                Equation(j.bend, (gy * u - gx * w) / Var("G_1")),
                Equation(k.push, j.bend * ((xc - xb) * w - (yc - yb) * u) - gx * u - gy * w),
                *both(scope.a(c), k.acceleration(scope, c) if _stands(scope, k) else j.tip_acceleration(scope, c)),
            ),
        ),
    )


def _stands(scope: Scope, k: Track) -> bool:
    """Whether the guide is fixed: what slides on it moves as fast as it slides."""
    return k.parent in scope.still and k.base in scope.mech.frame


def _named(
    scope: Scope, k: Track, c: str, stem: str, values: tuple[Expr, Expr]
) -> tuple[tuple[Equation, ...], tuple[Expr, Expr]]:
    """The velocity of the point underneath under a name of its own, where it moves."""
    if _stands(scope, k):
        return (), values
    parent = scope.name(k.parent)
    names = Var(f"{stem}_{{{c}{parent}x}}"), Var(f"{stem}_{{{c}{parent}y}}")
    return both(names, values), names
