"""RRR: two links pinned to known points J and K, and to each other at C."""

from __future__ import annotations

from ...words import Words
from ..equations import Equation, Part, Stage
from ..expr import TWO, Const, Expr, Var
from ..functions import Arctan, SquareRoot, square
from ..stages import ACCELERATION, POSITION, VELOCITY, Arm, Solved
from ..variables import Scope, both


def hinged(scope: Scope, j: Arm, k: Arm, c: str) -> Solved:
    """Both arms turn about known hinges and meet in C."""
    if not j.straight and k.straight:
        j, k = k, j
    (xj, yj), (xk, yk), (xc, yc) = scope.xy(j.outer), scope.xy(k.outer), scope.xy(c)
    determinant = (xc - xj) * (yc - yk) - (xc - xk) * (yc - yj)
    return Solved(
        (
            Stage(POSITION, _position(scope, j, k, c)),
            Stage(VELOCITY, _velocity(scope, j, k, c, determinant)),
            Stage(ACCELERATION, _acceleration(scope, j, k, c)),
        ),
        determinant,
        Words(
            f"当 ${j.outer}{c}$ 与 ${k.outer}{c}$ 共线（$∠{j.outer}{c}{k.outer}$ 为 0° 或 180°）时 $G_1$ = 0，"
            "杆组处于奇异位置，速度、加速度无确定解；接近该位置时方程组病态。",
            f"Where ${j.outer}{c}$ and ${k.outer}{c}$ are in one line ($∠{j.outer}{c}{k.outer}$ is 0° or "
            "180°), $G_1$ = 0: the group is singular and its velocities are not determined; near there the "
            "equations are ill-conditioned.",
        ),
    )


def _position(scope: Scope, j: Arm, k: Arm, c: str) -> tuple[Part, ...]:
    a, b, rest = Var("A_0"), Var("B_0"), Var("C_0")
    at_j, at_k, at_c = (scope.at[p] for p in (j.outer, k.outer, c))
    left = ((at_k - at_j).conjugate() * (at_c - at_j)).imag > 0
    sign = Const("σ", 1.0 if left else -1.0, "")
    angle = TWO * Arctan(b + sign * SquareRoot(square(a) + square(b) - square(rest)), a + rest)
    side = Words("左", "left") if left else Words("右", "right")
    head = "+1" if left else "−1"
    return (
        Part(
            Words("由封闭矢量多边形在 $x$、$y$ 轴上的投影得", "The vector loop projected on the axes gives"),
            both(j.tip(scope), k.tip(scope), gives=False),
        ),
        _eliminated(scope, j, k, c),
        Part(
            Words(
                f"解得（装配模式系数 $σ$ = {head}：${c}$ 在矢量 ${j.outer}→{k.outer}$ 的{side.zh}侧）",
                f"whose solution is, with $σ$ = {head} since ${c}$ lies to the {side.en} of "
                f"${j.outer}→{k.outer}$ in this assembly,",
            ),
            (Equation(j.angle, angle - j.turn),),
        ),
        Part(Words("由此得", "hence"), (*both(scope.xy(c), j.tip(scope)), Equation(k.angle, k.angle_from(scope, c)))),
    )


def _eliminated(scope: Scope, j: Arm, k: Arm, c: str) -> Part:
    """The one equation in the direction of JC, and its coefficients."""
    (xj, yj), (xk, yk) = scope.xy(j.outer), scope.xy(k.outer)
    a, b, rest = Var("A_0"), Var("B_0"), Var("C_0")
    way = j.angle_symbol if j.straight else "ψ"
    told = (
        Words.same("")
        if j.straight
        else Words(f"（$ψ$ 为 ${j.outer}{c}$ 的方向角）", f", $ψ$ being the direction of ${j.outer}{c}$")
    )
    return Part(
        Words(
            f"消去 ${k.angle_symbol}$，得 $A_0 cos {way} + B_0 sin {way} − C_0 = 0${told.zh}，式中",
            f"Eliminating ${k.angle_symbol}$ leaves $A_0 cos {way} + B_0 sin {way} − C_0 = 0${told.en}, with",
        ),
        (
            Equation(a, TWO * j.length * (xk - xj)),
            Equation(b, TWO * j.length * (yk - yj)),
            Equation(rest, square(j.length) + square(xk - xj) + square(yk - yj) - square(k.length)),
        ),
    )


def _velocity(scope: Scope, j: Arm, k: Arm, c: str, determinant: Expr) -> tuple[Part, ...]:
    (xj, yj), (xk, yk), (xc, yc) = scope.xy(j.outer), scope.xy(k.outer), scope.xy(c)
    dx, dy = (b - a for a, b in zip(scope.v(j.outer), scope.v(k.outer), strict=True))
    g = Var("G_1")
    return (
        Part(
            Words("将位置方程对时间求导，得", "Differentiating the position equations with respect to time gives"),
            both(j.tip_velocity(scope, c), k.tip_velocity(scope, c), gives=False),
        ),
        Part(
            Words(
                f"这是 ${j.rate_symbol}$、${k.rate_symbol}$ 的线性方程组，解为",
                f"These are two linear equations in ${j.rate_symbol}$ and ${k.rate_symbol}$; their solution is",
            ),
            (
                Equation(g, determinant),
                Equation(j.rate, ((xc - xk) * dx + (yc - yk) * dy) / g),
                Equation(k.rate, ((xc - xj) * dx + (yc - yj) * dy) / g),
                *both(scope.v(c), j.tip_velocity(scope, c)),
            ),
        ),
    )


def _acceleration(scope: Scope, j: Arm, k: Arm, c: str) -> tuple[Part, ...]:
    (xj, yj), (xk, yk), (xc, yc) = scope.xy(j.outer), scope.xy(k.outer), scope.xy(c)
    (ajx, ajy), (akx, aky) = scope.a(j.outer), scope.a(k.outer)
    wj, wk, g, gx, gy = square(j.rate), square(k.rate), Var("G_1"), Var("G_2"), Var("G_3")
    return (
        Part(
            Words("再求导一次，得", "Differentiating once more gives"),
            both(j.tip_acceleration(scope, c), k.tip_acceleration(scope, c), gives=False),
        ),
        Part(
            Words("解为", "The solution is"),
            (
                Equation(gx, akx - ajx + wj * (xc - xj) - wk * (xc - xk)),
                Equation(gy, aky - ajy + wj * (yc - yj) - wk * (yc - yk)),
                Equation(j.bend, ((xc - xk) * gx + (yc - yk) * gy) / g),
                Equation(k.bend, ((xc - xj) * gx + (yc - yj) * gy) / g),
                *both(scope.a(c), j.tip_acceleration(scope, c)),
            ),
        ),
    )
