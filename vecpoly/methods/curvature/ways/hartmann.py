"""Hartmann: the velocity with which the pole changes its place, from the tips of two velocities."""

from __future__ import annotations

import numpy as np

from ....board.paper.marks import Role
from ....plane import Line, Points, unit
from ....words import Words
from ...registry import Stage, method
from ..state import CurvatureFigure, Ray
from ..strokes.circle import letter_tangent, refuse_inflected, settle

_SOURCE = "Hartmann 1893; 机械原理, 连杆曲线的曲率"


@method(
    stage=Stage.CURVATURE,
    group="hartmann",
    source=_SOURCE,
    example="curv-3",
    title=Words("哈特曼作图法", "Hartmann's construction"),
)
def hartmann(fig: CurvatureFigure, points: tuple[str, ...]) -> None:
    """The normal turns about O: its line from O to the tip of v_X cuts off the component of u across it; u = ω δ."""
    fig.board.step(
        Words(
            f"取速度的比例使 $v$ 的图长等于该点到 ${fig.p}$ 的距离（即图上 $ω$ = 1），则瞬心换位速度 $u$ 的图长等于 "
            f"$δ$。",
            f"Draw velocities to such a scale that $v$ is as long as the distance of its point from ${fig.p}$ (on "
            f"paper "
            "$ω$ = 1); then $u$, the velocity of the change of the pole, is as long as $δ$.",
        ),
        fig.pane,
    )
    one, two = (_component(fig, ray) for ray in fig.rays)
    tip = _whole(fig, one, two)
    _turn_back(fig, tip)
    letter_tangent(fig)
    for letter in points:
        _centre(fig, letter, tip)


def _velocity(fig: CurvatureFigure, letter: str, at: Points) -> Points:
    """The tip of v: a quarter turn ahead of the ray from the pole, and as long."""
    along = at - fig.pole
    tip = fig.board.lay_off(at, 1j * unit(along), np.abs(along), key=f"v_{letter}")
    fig.arrow(at, tip, Role.GIVEN, f"v_{{{letter}}}")
    return tip


def _component(fig: CurvatureFigure, ray: Ray) -> tuple[Points, Line]:
    """The component of u across a normal, and the line on which the tip of u lies."""
    board, across = fig.board, fig.normal(ray.line, fig.pole)
    if ray.x is None:
        assert ray.o is not None
        board.step(
            Words(
                f"法线过定点 ${ray.fixed}$ 而转动中心在杆上无穷远处：$u$ 沿杆的分量为 ${ray.fixed}$ 处杆上点速度的反向"
                f"。",
                f"The normal passes the fixed point ${ray.fixed}$: along the rod $u$ has the velocity of the rod's "
                f"point "
                f"at ${ray.fixed}$, reversed.",
            ),
            fig.pane,
        )
        _velocity(fig, ray.fixed, ray.o)
        away = fig.pole - ray.o
        part = board.lay_off(fig.pole, 1j * unit(away), np.abs(away))
    else:
        board.step(_told(fig, ray), fig.pane)
        tip = _velocity(fig, ray.moving, ray.x)
        turned = Line(ray.o, unit(tip - ray.o)) if ray.o is not None else board.parallel(tip, ray.line.along)
        part = fig.meet(turned, across, "u 的分量", "the component of u")
        fig.thin(turned, tip, part, *([ray.o] if ray.o is not None else []))
    fig.arrow(fig.pole, part, Role.GIVEN, f"u_{{{ray.name}}}")
    return part, board.parallel(part, ray.line.along)


def _told(fig: CurvatureFigure, ray: Ray) -> Words:
    x, o = fig.shown(ray.moving), fig.shown(ray.fixed)
    if ray.o is None:
        return Words(
            f"作 $v_{x}$ ⊥ ${fig.p}{x}$；${x}$ 的曲率中心在无穷远处，法线平移，$u$ 垂直于法线的分量等于 $v_{x}$。",
            f"Draw $v_{x}$ across ${fig.p}{x}$; the centre of ${x}$ is at infinity and the normal only shifts: across "
            f"it "
            f"$u$ has the component $v_{x}$.",
        )
    return Words(
        f"作 $v_{x}$ ⊥ ${fig.p}{x}$；连 ${o}$ 与 $v_{x}$ 的末端，在 ${fig.p}$ 处法线的垂线上截得 $u$ 的分量。",
        f"Draw $v_{x}$ across ${fig.p}{x}$; the line from ${o}$ through its tip cuts off, on the perpendicular to the "
        f"normal at ${fig.p}$, the component of $u$.",
    )


def _whole(fig: CurvatureFigure, one: tuple[Points, Line], two: tuple[Points, Line]) -> Points:
    """u from its two components."""
    fig.board.step(
        Words(
            "过两分量的末端各作法线的平行线，交点为 $u$ 的末端；极切线 $t$ 沿 $u$。",
            "The parallels to the normals through the tips of both components meet at the tip of $u$; the pole tangent "
            "$t$ lies along $u$.",
        ),
        fig.pane,
    )
    tip = fig.meet(one[1], two[1], "u 的末端", "the tip of u")
    for part, line in (one, two):
        fig.thin(line, part, tip)
    fig.arrow(fig.pole, tip, Role.RESULT, "u")
    return tip


def _turn_back(fig: CurvatureFigure, tip: Points) -> None:
    """W: u turned back by a right angle, PW = u/ω."""
    fig.board.step(
        Words(
            f"将 $u$ 反 $ω$ 方向转 90°，得拐点极 ${fig.w}$（${fig.p}{fig.w} = u/ω = δ$）；以 ${fig.p}{fig.w}$ 为直径作"
            f"拐点圆。",
            f"Turn $u$ back by 90° against $ω$: this is the inflection pole ${fig.w}$ (${fig.p}{fig.w} = u/ω = δ$); "
            f"draw "
            f"the inflection circle on the diameter ${fig.p}{fig.w}$.",
        ),
        fig.pane,
    )
    u = tip - fig.pole
    settle(fig, fig.board.lay_off(fig.pole, -1j * unit(u), np.abs(u)))


def _centre(fig: CurvatureFigure, letter: str, tip: Points) -> None:
    """O_E on the line through the tips of v_E and of u's component across PE."""
    refuse_inflected(fig, letter)
    e, shown, o, mine = fig.at(letter), fig.shown(letter), fig.free("O", letter), fig.ray_of(letter)
    fig.board.step(
        Words(
            f"作 $v_{shown}$ 及 $u$ 垂直于 ${fig.p}{shown}$ 的分量；两末端的连线交 ${fig.p}{shown}$ 于曲率中心 ${o}$。",
            f"Draw $v_{shown}$ and the component of $u$ across ${fig.p}{shown}$; the line through both tips cuts "
            f"${fig.p}{shown}$ in the centre of curvature ${o}$.",
        ),
        fig.pane,
    )
    velocity = _velocity(fig, letter, e)
    across, down = fig.normal(mine, fig.pole), fig.board.parallel(tip, mine.along)
    part = fig.meet(down, across, "u 的分量", "the component of u")
    fig.arrow(fig.pole, part, Role.GIVEN, f"u_{{{letter}}}")
    turned = fig.through(velocity, part)
    centre = fig.centre(letter, o, fig.meet(turned, mine, o, o))
    fig.thin(down, tip, part)
    fig.thin(turned, velocity, part, centre)
    fig.thin(mine, fig.pole, e, centre)
