"""Ball's point, on the inflection circle and on the curve of stationary curvature, by one straight line.

Of a point X of that curve let the perpendicular to PX at X cut the pole tangent t and the pole normal n; the fourth
corner Z of the rectangle over both sections lies on a straight line q, for 1/PX = 1/(M sin ψ) + 1/(N cos ψ). Both pins
whose paths are circles or straight lines are such points; so is Ball's point, whose section on n is PW.
"""

from __future__ import annotations

from ....board.paper.marks import Role
from ....errors import NoMethodError
from ....mechanism.asked.curvature import no_ball
from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..state import BEYOND, CurvatureFigure, Ray, sine

PARALLEL = 1e-7  # sine of lines that do not meet


def draw_ball_point(fig: CurvatureFigure, symbol: str) -> None:
    """U. NoMethodError where two such pins are not known, NotAskedError where q gives no point."""
    if len(fig.rays) < 2 or any(ray.x is None for ray in fig.rays):
        raise NoMethodError(_pins(fig.desk.mech.number(fig.link)), code="no-pins")
    seen = [ray for ray in fig.rays if _axis(fig, ray) is None]
    if not seen:
        raise no_ball(fig.desk.mech, fig.link)
    letters, corners = zip(*(_corner(fig, ray) for ray in seen), strict=True)
    q = _joined(fig, letters, *corners) if len(corners) == 2 else _along(fig, letters[0], corners[0])
    if sine(q.along, fig.tangent) < PARALLEL:
        _opposite(fig, symbol)
    else:
        _found(fig, q, symbol)


def _axis(fig: CurvatureFigure, ray: Ray) -> Points | None:
    """The pole tangent or the pole normal, where the pin lies on it: its Z is at infinity along the other."""
    normal = unit(fig.opposite - fig.pole)
    return next((axis for axis in (fig.tangent, normal) if sine(ray.line.along, axis) < PARALLEL), None)


def _corner(fig: CurvatureFigure, ray: Ray) -> tuple[str, Points]:
    """Z of a pin: its letter, and where it is."""
    assert ray.x is not None
    name = fig.shown(ray.moving)
    normal = unit(fig.opposite - fig.pole)
    z = fig.free("Z", ray.moving)
    fig.board.step(
        Words(
            f"过 ${name}$ 作 ${fig.p}{name}$ 的垂线，与极切线 $t$、极法线 $n$ 相交；过两交点分别作 $n$、$t$ 的平行线，"
            f"交于 ${z}$。",
            f"The perpendicular to ${fig.p}{name}$ at ${name}$ cuts the pole tangent $t$ and the pole normal $n$; the "
            f"parallels to $n$ and $t$ through these points meet at ${z}$.",
        ),
        fig.pane,
    )
    across = fig.normal(ray.line, ray.x)
    on_t = fig.meet(across, Line(fig.pole, fig.tangent), "极切线上的截点", "the section on the pole tangent")
    on_n = fig.meet(across, Line(fig.pole, normal), "极法线上的截点", "the section on the pole normal")
    up, along = fig.board.parallel(on_t, normal), fig.board.parallel(on_n, fig.tangent)
    found = fig.letter(z, fig.meet(up, along, "矩形的第四个顶点", "the fourth corner of the rectangle"))
    for line, ends in ((across, (ray.x, on_t, on_n)), (up, (on_t, found)), (along, (on_n, found))):
        fig.thin(line, *ends)
    return z, found


def _joined(fig: CurvatureFigure, letters: tuple[str, ...], one: Points, two: Points) -> Line:
    """q through both corners."""
    if abs(complex(nominal(two - one))) < PARALLEL * abs(complex(nominal(fig.opposite - fig.pole))):
        raise no_ball(fig.desk.mech, fig.link)
    fig.board.step(
        Words(
            f"连 ${letters[0]}$、${letters[1]}$ 得直线 $q$：曲率驻点曲线上各点按同法所得之点都在 $q$ 上。",
            f"Draw the line $q$ through ${letters[0]}$ and ${letters[1]}$. The same construction, applied to any point "
            "of the curve of stationary curvature (the cubic of stationary curvature), gives a point of $q$.",
        ),
        fig.pane,
    )
    q = fig.through(one, two)
    fig.thin(q, one, two, role=Role.GIVEN)
    _lettered(fig, two, q.along)
    return q


def _along(fig: CurvatureFigure, letter: str, corner: Points) -> Line:
    """q through the one corner, where the other pin lies on t or on n."""
    ray, axis = next((ray, axis) for ray in fig.rays if (axis := _axis(fig, ray)) is not None)
    name, tangent = fig.shown(ray.moving), axis is fig.tangent
    on, to = ("t", "n") if tangent else ("n", "t")
    fig.board.step(
        Words(
            f"${name}$ 在 ${on}$ 上，相应的点在无穷远处：过 ${letter}$ 作 ${to}$ 的平行线 $q$。",
            f"Point ${name}$ lies on ${on}$; its counterpart is at infinity: draw $q$ through ${letter}$ parallel to "
            f"${to}$.",
        ),
        fig.pane,
    )
    q = fig.board.parallel(corner, 1j * axis)
    fig.thin(q, corner, role=Role.GIVEN)
    _lettered(fig, corner, q.along)
    return q


def _lettered(fig: CurvatureFigure, last: Points, along: Points) -> None:
    """The letter of q, at the end of what is drawn of it."""
    fig.name("q", last, along * BEYOND)


def _opposite(fig: CurvatureFigure, symbol: str) -> None:
    """Ball's point where q is parallel to t: W itself."""
    fig.board.step(
        Words(
            f"$q$ ∥ $t$，鲍尔点 ${symbol}$ 与 ${fig.w}$ 重合。",
            f"The line $q$ is parallel to $t$: Ball's point ${symbol}$ is ${fig.w}$ itself.",
        ),
        fig.pane,
    )
    fig.undulating = fig.letter(symbol, fig.opposite)


def _found(fig: CurvatureFigure, q: Line, symbol: str) -> None:
    """The point of q as high as W, and from it U, by Thales on the inflection circle."""
    board = fig.board
    z = fig.free("Z", "U")
    board.step(
        Words(
            f"鲍尔点在拐点圆上，过它作其与 ${fig.p}$ 连线的垂线必过 ${fig.w}$。过 ${fig.w}$ 作 $t$ 的平行线，交 $q$ 于 "
            f"${z}$；由 ${z}$ 向 $t$ 作垂线得垂足，与 ${fig.w}$ 相连；由 ${fig.p}$ 向该连线作垂线，垂足即鲍尔点 "
            f"${symbol}$。",
            f"Ball's point ${symbol}$ lies on the inflection circle, so the perpendicular to ${fig.p}{symbol}$ at "
            f"${symbol}$ passes through ${fig.w}$. The parallel to $t$ through ${fig.w}$ meets $q$ at ${z}$; drop a "
            f"perpendicular from ${z}$ to $t$ and join its foot with ${fig.w}$; the foot of the "
            f"perpendicular from ${fig.p}$ to this line is Ball's point ${symbol}$.",
        ),
        fig.pane,
    )
    level = board.parallel(fig.opposite, fig.tangent)
    corner = fig.letter(z, fig.meet(level, q, "$q$ 上的点", "the point on $q$"))
    tangent = Line(fig.pole, fig.tangent)
    foot = fig.meet(board.parallel(corner, unit(fig.opposite - fig.pole)), tangent, "垂足", "the foot")
    joined = fig.through(fig.opposite, foot)
    drop = fig.normal(joined, fig.pole)
    fig.undulating = fig.letter(symbol, fig.meet(joined, drop, "鲍尔点", "Ball's point"), beside=fig.w)
    for a, b in ((fig.opposite, corner), (corner, foot), (fig.opposite, foot), (fig.pole, fig.undulating)):
        fig.thin(fig.through(a, b), a, b)


def _pins(number: str) -> Words:
    return Words(
        f"求构件 {number} 的鲍尔点，须已知其上两个铰链点的轨迹为圆或直线；此处不是。请从 find 中去掉",
        f"Ball's point of link {number} is constructed from two pins of it that run on circles or straight lines; here "
        "they do not: leave it out of `find`",
    )
