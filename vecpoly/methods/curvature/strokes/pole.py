"""The normals of two known paths, and the pole in which they meet."""

from __future__ import annotations

from ....board.paper.marks import Role
from ....mechanism.model import Rolling
from ....plane import Line, unit
from ....words import Words
from ..pairs import pairs_of, rolled, rolling_of
from ..state import CurvatureFigure, Ray
from .normals import normal_of, refuse_parallel


def draw_pole(fig: CurvatureFigure) -> None:
    """P: each normal of a path passes through it. Raises NotAskedError where the normals are parallel."""
    board, mech = fig.board, fig.desk.mech
    if (joint := rolling_of(mech, fig.link)) is not None:
        _rolling_pole(fig, joint)
        return
    pairs = pairs_of(mech, fig.link)
    fig.rays = tuple(normal_of(fig.desk, pair, fig.factor, board) for pair in pairs)
    one, two = fig.rays
    refuse_parallel(one, two, mech.number(fig.link))
    told = _told(fig, one) + _told(fig, two)
    board.step(
        told
        + Words(
            f"两法线交于构件 {mech.number(fig.link)} 的绝对瞬心 ${fig.p}$。",
            f" The two normals meet at the pole ${fig.p}$ of link {mech.number(fig.link)}.",
        ),
        fig.pane,
    )
    found = fig.meet(one.line, two.line, "两法线的交点", "the meeting point of the two normals")
    fig.pole = fig.letter(fig.p, found)
    for ray in fig.rays:
        fig.thin(ray.line, fig.pole, *ray.spots(), role=Role.CENTRE)
    for ray in fig.rays:
        _name_ends(fig, ray)


def _rolling_pole(fig: CurvatureFigure, joint: Rolling) -> None:
    """The pitch point, where the gear has no velocity; the normal of its centre's path passes through it."""
    pair, number = rolled(joint), fig.desk.mech.number(fig.link)
    x, o = fig.shown(pair.moving), fig.shown(pair.fixed)
    about = (
        Words(f"绕 ${o}$ 作圆周运动", f"runs on a circle about ${o}$") if o else Words("作直线运动", "runs straight")
    )
    fig.board.step(
        Words(
            f"构件 {number} 在机架上纯滚动，绝对瞬心 ${fig.p}$ 即节点 ${joint.point}$；其中心 ${x}$ {about.zh}，法线过 "
            f"${fig.p}$，且垂直于节圆的公切线，故为极法线 $n$。",
            f"Link {number} rolls on the frame: its pole ${fig.p}$ is the pitch point ${joint.point}$. Its centre "
            f"${x}$ {about.en}; the normal ${x}{fig.p}$ is perpendicular to the common tangent: it is the pole "
            "normal $n$.",
        ),
        fig.pane,
    )
    fig.pole = fig.letter(fig.p, fig.desk.contact(joint) * fig.factor)
    at, fixed = fig.at(pair.moving), fig.at(pair.fixed) if pair.fixed else None
    ray = Ray(moving=pair.moving, fixed=pair.fixed, x=at, o=fixed, line=Line(fig.pole, unit(at - fig.pole)))
    fig.rays = (ray,)
    fig.thin(ray.line, fig.pole, *ray.spots(), role=Role.CENTRE)
    _name_ends(fig, ray)


def _name_ends(fig: CurvatureFigure, ray: Ray) -> None:
    """The letters of its points."""
    for letter in filter(None, (ray.moving, ray.fixed)):
        fig.name_once(letter)


def _told(fig: CurvatureFigure, ray: Ray) -> Words:
    x, o = fig.shown(ray.moving), fig.shown(ray.fixed)
    if ray.whole:
        return Words(
            f"${x}$ 绕 ${o}$ 作圆周运动，其轨迹的法线为 ${x}{o}$。",
            f" Point ${x}$ runs on a circle about ${o}$: the normal of its path is ${x}{o}$.",
        )
    if ray.moving:
        return Words(
            f"${x}$ 沿导路作直线运动，曲率中心在导路垂线方向的无穷远处，法线过 ${x}$ 垂直于导路。",
            f" Point ${x}$ runs on a straight line: its centre of curvature is at infinity across the guide, and the "
            f"normal is perpendicular to the guide at ${x}$.",
        )
    return Words(
        f"构件 {fig.desk.mech.number(fig.link)} 的导路线始终与 ${o}$ 保持定距，其包络的法线过 ${o}$ 垂直于该线。",
        f" A line of link {fig.desk.mech.number(fig.link)} always passes ${o}$ at one distance: the normal of what it "
        f"envelops is perpendicular to it and passes through ${o}$.",
    )
