"""The collineation axis PQ of two normals, and what it gives: points of the inflection circle."""

from __future__ import annotations

from ....board.paper.extent import box_of
from ....board.paper.marks import Role
from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..state import Axis, CurvatureFigure, Ray, sine

FAR = 1e-7  # sine below which Q is at infinity
INACCESSIBLE = 4.0  # times the size of what the axis rests on: from there on Q is done without


def draw_axis(fig: CurvatureFigure) -> Axis:
    """Q, in which the line of the moving points meets that of their centres; an axis that is drawn stays."""
    if fig.axis is not None:
        return fig.axis
    fig.axis = _drawn(fig)
    return fig.axis


def _drawn(fig: CurvatureFigure) -> Axis:
    one, two = fig.rays
    q = fig.free("Q")
    moving, fixed = _joined(one.x, two.x, fig), _joined(one.o, two.o, fig)
    if moving is None or fixed is None or sine(moving.along, fixed.along) < FAR:
        known = fixed if moving is None else moving
        assert known is not None, "a link that passes two fixed points does not move"
        fig.board.step(_told_endless(fig, q), fig.pane)
        line = Line(fig.pole, fig.board.turn(known.along))
        fig.thin(line, fig.pole - 20 * line.along, fig.pole + 20 * line.along, role=Role.DIRECTION)
        return Axis(line=line, letter=q, at=None)
    if one.whole and two.whole and _is_far(fig, moving, fixed):
        return _beside(fig, moving, fixed, q)
    fig.board.step(_told(fig, q), fig.pane)
    at = fig.letter(q, fig.meet(moving, fixed, "Q 点", "Q"))
    for g, ends in ((moving, (one.x, two.x)), (fixed, (one.o, two.o))):
        fig.thin(g, at, *(end for end in ends if end is not None))
    line = Line(fig.pole, unit(at - fig.pole))
    fig.thin(line, fig.pole, at, role=Role.DIRECTION)
    return Axis(line=line, letter=q, at=at)


def _is_far(fig: CurvatureFigure, moving: Line, fixed: Line) -> bool:
    """Whether Q lies many times as far off as the pole and the points of the normals are apart."""
    spots = [complex(nominal(at)) for ray in fig.rays for at in (*ray.spots(), fig.pole)]
    low, high = box_of(spots)
    g, h = ((complex(nominal(line.at)), complex(nominal(line.along))) for line in (moving, fixed))
    at = g[0] + g[1] * ((h[0] - g[0]).conjugate() * h[1]).imag / (g[1].conjugate() * h[1]).imag
    return abs(at - (low + high) / 2) > INACCESSIBLE * abs(high - low)


def _beside(fig: CurvatureFigure, moving: Line, fixed: Line, q: str) -> Axis:
    """PS in place of PQ: the triangle of one normal's centre, the other's moving point and P once more, about the other
    centre, in the figure that is similar to it and similarly placed about Q."""
    one, two = fig.rays
    assert one.o is not None and two.o is not None and two.x is not None
    a, s = fig.free("K"), fig.free("S")
    o, x, p = fig.shown(two.fixed), fig.shown(two.moving), fig.shown(one.fixed)
    fig.board.step(
        Words(
            f"${fig.shown(one.moving)}{x}$ 与 ${p}{o}$ 的交点 ${q}$ 太远：过 ${o}$ 作 ${p}{x}$ 的平行线，交 "
            f"${fig.shown(one.moving)}{x}$ 于 ${a}$；过 ${o}$、${a}$ 分别作 ${fig.shown(one.moving)}$、${x}$ 处法线的"
            f"平行线，交于 ${s}$。两三角形对 ${q}$ 位似，故 ${fig.p}{s}$ 过 ${q}$，为两法线的共线轴。",
            f"The lines ${fig.shown(one.moving)}{x}$ and ${p}{o}$ meet too far off at ${q}$: the parallel to ${p}{x}$ "
            f"through ${o}$ cuts ${fig.shown(one.moving)}{x}$ in ${a}$; the parallels to the normals at "
            f"${fig.shown(one.moving)}$ and ${x}$ through ${o}$ and ${a}$ meet in ${s}$. The two triangles are "
            f"similarly placed about ${q}$: ${fig.p}{s}$ leads to ${q}$ and is the collineation axis of the normals.",
        ),
        fig.pane,
    )
    across = fig.board.parallel(two.o, unit(two.x - one.o))
    at_a = fig.letter(a, fig.meet(across, moving, f"{a} 点", a))
    first, second = fig.board.parallel(two.o, one.line.along), fig.board.parallel(at_a, two.line.along)
    at_s = fig.letter(s, fig.meet(first, second, f"{s} 点", s))
    line = fig.through(fig.pole, at_s)
    for g, ends in (
        (fig.through(one.o, two.x), (one.o, two.x)),
        (across, (two.o, at_a)),
        (moving, (two.x, at_a)),
        (first, (two.o, at_s)),
        (second, (at_a, at_s)),
    ):
        fig.thin(g, *ends)
    fig.thin(line, fig.pole, at_s, role=Role.DIRECTION)
    return Axis(line=line, letter=s, at=at_s)


def _joined(a: Points | None, b: Points | None, fig: CurvatureFigure) -> Line | None:
    """The line of two points, one of which may be at infinity along its normal; None: the line at infinity."""
    one, two = fig.rays
    if a is not None and b is not None:
        return fig.through(a, b)
    if a is not None:
        return Line(a, fig.board.turn(two.line.along))
    if b is not None:
        return Line(b, fig.board.turn(one.line.along))
    return None


def _told_endless(fig: CurvatureFigure, q: str) -> Words:
    one, two = fig.rays
    moved, fixed = (one.moving and two.moving), (one.fixed and two.fixed)
    line = f"{one.moving}{two.moving}" if moved else f"{one.fixed}{two.fixed}"
    other = (
        Words("两曲率中心的连线在无穷远处", "the centres lie at infinity")
        if not fixed
        else Words(
            f"${one.moving}{two.moving}$ 与 ${one.fixed}{two.fixed}$ 平行",
            f"${one.moving}{two.moving}$ and ${one.fixed}{two.fixed}$ meet at infinity",
        )
    )
    return Words(
        f"{other.zh}，交点 ${q}$ 在无穷远处：过 ${fig.p}$ 作 ${line}$ 的平行线，即为两法线的共线轴 ${fig.p}{q}$。",
        f"Here {other.en}: ${q}$ is at infinity, and the parallel to ${line}$ through ${fig.p}$ is the collineation "
        f"axis "
        f"${fig.p}{q}$ of the two normals.",
    )


def _told(fig: CurvatureFigure, q: str) -> Words:
    one, two = fig.rays

    def line(a: str, b: str, first: Ray, second: Ray) -> Words:
        a, b = fig.shown(a), fig.shown(b)
        if a and b:
            return Words(f"${a}{b}$", f"${a}{b}$")
        if a or b:
            through, along = (a, second) if a else (b, first)
            return Words(
                f"过 ${through}$ 且平行于 ${along.name}$ 处法线的直线",
                f"the parallel through ${through}$ to the normal at ${along.name}$",
            )
        return Words("无穷远直线", "the line at infinity")

    moving, fixed = line(one.moving, two.moving, one, two), line(one.fixed, two.fixed, one, two)
    return Words(
        f"{moving.zh}与{fixed.zh}交于 ${q}$，${fig.p}{q}$ 为两法线的共线轴。",
        f"Let {moving.en} and {fixed.en} meet at ${q}$; ${fig.p}{q}$ is the collineation axis of the two normals.",
    )


def inflection_by_axis(fig: CurvatureFigure, axis: Axis, ray: Ray, other: Ray) -> tuple[Points, str]:
    """The point of the inflection circle on a normal: its centre of curvature is at infinity on the same axis."""
    if ray.o is None:
        assert ray.x is not None
        fig.board.step(
            Words(
                f"${fig.shown(ray.moving)}$ 作直线运动，曲率中心在无穷远处，故 ${fig.shown(ray.moving)}$ 在拐点圆上。",
                f"Point ${fig.shown(ray.moving)}$ runs on a straight line; its centre is at infinity, so "
                f"${fig.shown(ray.moving)}$ itself lies on the inflection circle.",
            ),
            fig.pane,
        )
        return ray.x, fig.shown(ray.moving)
    name = fig.free("J", ray.name)
    if other.o is None:
        return _by_parallel(fig, axis, ray, other, name)
    r = fig.free("R")
    cut = f"连 ${other.moving}{r}$" if other.moving else f"过 ${r}$ 作 ${other.name}$ 处法线的平行线"
    cut_en = f"${other.moving}{r}$" if other.moving else f"the parallel through ${r}$ to the normal at ${other.name}$"
    fig.board.step(
        Words(
            f"拐点圆与 ${ray.name}$ 处法线的交点 ${name}$，其曲率中心在该法线的无穷远处：过 ${other.fixed}$ "
            f"作该法线的平行线，交共线轴于 ${r}$；{cut}，交该法线于 ${name}$。",
            f"The point ${name}$ of the inflection circle on the normal of ${ray.name}$ has its centre at infinity: "
            f"the "
            f"parallel to this normal through ${other.fixed}$ cuts the axis in ${r}$, and {cut_en} cuts the normal in "
            f"${name}$.",
        ),
        fig.pane,
    )
    far = fig.board.parallel(other.o, ray.line.along)
    at_r = fig.letter(r, fig.meet(far, axis.line, "R 点", "R"))
    back = fig.through(other.x, at_r) if other.x is not None else Line(at_r, fig.board.turn(other.line.along))
    j = fig.letter(name, fig.meet(back, ray.line, "拐点圆上一点", "a point of the inflection circle"))
    fig.thin(far, other.o, at_r)
    fig.thin(back, at_r, j, *([other.x] if other.x is not None else []))
    fig.thin(axis.line, fig.pole, at_r, role=Role.DIRECTION)
    fig.thin(ray.line, fig.pole, j, role=Role.CENTRE)
    return j, name


def _by_parallel(fig: CurvatureFigure, axis: Axis, ray: Ray, other: Ray, name: str) -> tuple[Points, str]:
    """Both centres at infinity: the line of the moving points is parallel to the axis."""
    assert other.x is not None
    fig.board.step(
        Words(
            f"过 ${other.moving}$ 作共线轴的平行线，交 ${ray.name}$ 处法线于拐点圆上的 ${name}$。",
            f"The parallel to the axis through ${other.moving}$ cuts the normal of ${ray.name}$ in ${name}$, a point "
            f"of "
            "the inflection circle.",
        ),
        fig.pane,
    )
    back = fig.board.parallel(other.x, axis.line.along)
    j = fig.letter(name, fig.meet(back, ray.line, "拐点圆上一点", "a point of the inflection circle"))
    fig.thin(back, other.x, j)
    fig.thin(ray.line, fig.pole, j)
    return j, name
