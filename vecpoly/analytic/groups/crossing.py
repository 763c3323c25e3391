"""PRP and RPP: a point slides on two known lines at once and is found where they cross."""

from __future__ import annotations

from ...words import Words
from ..equations import Equation, Part, Stage
from ..expr import Expr, Var
from ..stages import ACCELERATION, POSITION, VELOCITY, Solved
from ..track import Track, Turning
from ..variables import Scope, both

_KEEPS = Words("两移动副使构件间的夹角保持不变：", "The slides keep the angles between the links:")


def crossing(scope: Scope, one: Track, two: Track, c: str, first: Turning | None = None) -> Solved:
    """C on both lines: two linear equations in both travels at every order.
    first: how the links turn on whose angles the lines depend."""
    (u1, w1), (u2, w2) = one.unit, two.unit
    determinant, known = u1 * w2 - w1 * u2, first or Turning()
    return Solved(
        (
            Stage(POSITION, (*_kept(known.position), *_position(scope, one, two, c, determinant))),
            Stage(VELOCITY, (*_kept(known.velocity), *_velocity(scope, one, two, c))),
            Stage(ACCELERATION, (*_kept(known.acceleration), *_acceleration(scope, one, two, c))),
        ),
        determinant,
        Words(
            "$G_1$ 为两导路夹角的正弦；两导路平行时 $G_1$ = 0，杆组处于奇异位置，接近平行时方程组病态。",
            "The determinant $G_1$ is the sine of the angle between both guides; where they are parallel the group is "
            "singular, and near there ill-conditioned.",
        ),
    )


def _kept(equations: tuple[Equation, ...]) -> tuple[Part, ...]:
    """What must be known of the angles before the lines are; nothing where no link turns."""
    return (Part(_KEEPS, equations),) if equations else ()


def _position(scope: Scope, one: Track, two: Track, c: str, determinant: Expr) -> tuple[Part, ...]:
    (x1, y1), (x2, y2) = one.foot(scope), two.foot(scope)
    dx, dy = Var("Δ_x"), Var("Δ_y")
    return (
        Part(
            Words(
                f"${c}$ 同在两导路上，${one.travel.symbol}$、${two.travel.symbol}$ 为其沿两导路的坐标，故",
                f"Point ${c}$ lies on both guides, at ${one.travel.symbol}$ and ${two.travel.symbol}$ along them:",
            ),
            both(one.point(scope), two.point(scope), gives=False),
        ),
        Part(
            Words("解此线性方程组得", "The solution of these linear equations is"),
            (
                Equation(Var("G_1"), determinant),
                Equation(dx, x2 - x1),
                Equation(dy, y2 - y1),
                *_solved(one, two, one.travel, two.travel, dx, dy),
                *both(scope.xy(c), one.point(scope)),
            ),
        ),
    )


def _solved(one: Track, two: Track, first: Expr, second: Expr, dx: Expr, dy: Expr) -> tuple[Equation, Equation]:
    """first u₁ − second u₂ = Δ."""
    (u1, w1), (u2, w2), g = one.unit, two.unit, Var("G_1")
    return Equation(first, (dx * w2 - dy * u2) / g), Equation(second, (dx * w1 - dy * u1) / g)


def _velocity(scope: Scope, one: Track, two: Track, c: str) -> tuple[Part, ...]:
    (x1, y1), (x2, y2) = one.carried(scope, c), two.carried(scope, c)
    dx, dy = Var("Δ_{vx}"), Var("Δ_{vy}")
    return (
        Part(
            Words("将位置方程对时间求导，得", "Differentiating the position equations with respect to time gives"),
            both(one.velocity(scope, c), two.velocity(scope, c), gives=False),
        ),
        Part(
            _sliding(one, two),
            (
                Equation(dx, x2 - x1),
                Equation(dy, y2 - y1),
                *_solved(one, two, one.speed, two.speed, dx, dy),
                *both(scope.v(c), one.velocity(scope, c)),
            ),
        ),
    )


def _sliding(one: Track, two: Track) -> Words:
    """What the speeds along the guides are called."""
    first, second = one.speed.symbol, two.speed.symbol
    return Words(
        f"其中 ${first}$、${second}$ 为沿导路的滑动速度。解为",
        f"Here ${first}$ and ${second}$ are the sliding speeds along the guides. The solution is",
    )


def _acceleration(scope: Scope, one: Track, two: Track, c: str) -> tuple[Part, ...]:
    (x1, y1), (x2, y2) = one.dragged(scope, c), two.dragged(scope, c)
    dx, dy = Var("Δ_{ax}"), Var("Δ_{ay}")
    return (
        Part(
            Words("再求导一次，得", "Differentiating once more gives"),
            both(one.acceleration(scope, c), two.acceleration(scope, c), gives=False),
        ),
        Part(
            Words("解为", "The solution is"),
            (
                Equation(dx, x2 - x1),
                Equation(dy, y2 - y1),
                *_solved(one, two, one.push, two.push, dx, dy),
                *both(scope.a(c), one.acceleration(scope, c)),
            ),
        ),
    )
