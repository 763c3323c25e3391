"""Bobillier: the collineation axis makes with one normal the angle that the pole tangent makes with the other."""

from __future__ import annotations

from math import pi, sin

import numpy as np

from ....plane import Line, Points, nominal, unit
from ....words import Words
from ...registry import Stage, method
from ..state import Axis, CurvatureFigure, Ray, sine
from ..strokes.angles import carry_angle
from ..strokes.circle import letter_tangent, on_normal, refuse_inflected
from ..strokes.collinear import draw_axis, inflection_by_axis
from ..strokes.triangles import inflection_by_triangles

GRAZED = 0.1  # sine to the axis below which a point of the circle is badly found on a normal
_SOURCE = "Bobillier 1870; 机械原理, 连杆曲线的曲率"


@method(
    stage=Stage.CURVATURE,
    group="bobillier",
    source=_SOURCE,
    example="curv-1",
    title=Words("博比利尔作图法", "Bobillier's construction"),
)
def bobillier(fig: CurvatureFigure, points: tuple[str, ...]) -> None:
    """∠(p_1, PQ) = ∠(t, p_2), and the same of the normal of E."""
    axis = draw_axis(fig)
    _draw_tangent(fig, axis)
    ray, j, name = _inflected(fig, axis)
    on_normal(fig, ray, j, name)
    letter_tangent(fig)
    for letter in points:
        _centre(fig, letter)


def _draw_tangent(fig: CurvatureFigure, axis: Axis) -> None:
    one, two = fig.rays
    board, q = fig.board, axis.letter
    first, second = map(_normal, fig.rays)
    words = Words(
        f"博比利尔定理：由{first.zh}到共线轴 ${fig.p}{q}$ 的角，等于由极切线 $t$ 到{second.zh}的角，转向相同。以 "
        f"${fig.p}$ 为圆心作弧，用分规移取弦长，得极切线 $t$；极法线 $n$ 垂直于 $t$。",
        f"Bobillier: the angle from {first.en} to the collineation axis ${fig.p}{q}$ equals that from the pole tangent "
        f"$t$ to {second.en}, in the same sense. Carry the chord of the arc about ${fig.p}$ with the dividers: this "
        "gives the pole tangent $t$; the pole normal $n$ is perpendicular to it.",
    )
    board.step(words, fig.pane)
    fig.tangent = carry_angle(fig, (axis.line.along, one.line.along), two.line.along, "ψ")


def _normal(ray: Ray) -> Words:
    """The normal of a known path, by its letters."""
    if ray.whole:
        return Words(f"法线 ${ray.moving}{ray.fixed}$ ", f"the normal ${ray.moving}{ray.fixed}$")
    return Words(f" ${ray.name}$ 处的法线", f"the normal at ${ray.name}$")


def _inflected(fig: CurvatureFigure, axis: Axis) -> tuple[Ray, Points, str]:
    """A point of the inflection circle, on the normal that cuts the pole tangent the more steeply, on which W is found
    the better; by similar triangles where the axis grazes it: by as much as the tangent grazes the other."""
    one, two = fig.rays
    at_once = [ray for ray in fig.rays if ray.o is None and sine(ray.line.along, fig.tangent) > 0.3]
    first = at_once[0] if at_once else max(fig.rays, key=lambda ray: sine(ray.line.along, fig.tangent))
    if not at_once and first.whole and sine(first.line.along, axis.line.along) < GRAZED:
        return (first, *inflection_by_triangles(fig, first))
    return (first, *inflection_by_axis(fig, axis, first, two if first is one else one))


def _centre(fig: CurvatureFigure, letter: str) -> None:
    """Q_E on a line that makes with the normal of a known path the angle of t with PE; then O_E."""
    refuse_inflected(fig, letter)
    board, e, shown = fig.board, fig.at(letter), fig.shown(letter)
    mine = fig.ray_of(letter)
    ray = max(fig.rays, key=lambda one: _fitness(fig, one, letter))
    q, o = fig.free("Q", letter), fig.free("O", letter)
    at_ray = Words(f"${ray.name}$ 处的法线", f"the normal at ${ray.name}$")
    known = Words.same(f"${ray.moving}{ray.fixed}$") if ray.whole else at_ray
    board.step(
        Words(
            f"求 ${shown}$ 轨迹的曲率中心：过 ${fig.p}$ 作射线，使{known.zh}到它的角等于 $t$ 到 ${fig.p}{shown}$ "
            f"的角" + _cut(ray, shown, q, o, fig.p)[0],
            f"To find the centre of curvature of the path of ${shown}$, draw through ${fig.p}$ the line to "
            f"which {known.en} makes the angle of $t$ to ${fig.p}{shown}$" + _cut(ray, shown, q, o, fig.p)[1],
        ),
        fig.pane,
    )
    along = carry_angle(fig, (fig.tangent, mine.along), ray.line.along, f"ψ_{{{letter}}}")
    axis = Line(fig.pole, along)
    side = Line(e, unit(ray.x - e)) if ray.x is not None else Line(e, ray.line.along)
    at_q = fig.letter(q, fig.meet(axis, side, q, q))
    back = Line(at_q, unit(at_q - ray.o)) if ray.o is not None else Line(at_q, ray.line.along)
    centre = fig.centre(letter, o, fig.meet(back, mine, o, o))
    fig.thin(axis, fig.pole, at_q)
    fig.thin(side, e, at_q, *([ray.x] if ray.x is not None else []))
    fig.thin(back, at_q, centre, *([ray.o] if ray.o is not None else []))
    fig.thin(mine, fig.pole, e, centre)


def _cut(ray: Ray, e: str, q: str, o: str, p: str) -> tuple[str, str]:
    """How Q_E and O_E are found; with a point at infinity a parallel is drawn."""
    side = (
        (f"直线 ${ray.moving}{e}$", f"${ray.moving}{e}$")
        if ray.x is not None
        else (f"过 ${e}$ 所作该法线的平行线", f"the parallel to that normal through ${e}$")
    )
    back = (
        (f"连 ${ray.fixed}{q}$", f"${ray.fixed}{q}$")
        if ray.o is not None
        else (f"过 ${q}$ 作该法线的平行线", f"the parallel to that normal through ${q}$")
    )
    zh = f"，交{side[0]}于 ${q}$；{back[0]}，交 ${p}{e}$ 于 ${o}$。"
    return zh, f"; it cuts {side[1]} in ${q}$, and {back[1]} cuts ${p}{e}$ in ${o}$."


def _fitness(fig: CurvatureFigure, ray: Ray, letter: str) -> float:
    """How well the lines of the construction would meet: the smallest sine; 0 where the point lies on this normal."""
    p, e, t, u = (complex(nominal(z)) for z in (fig.pole, fig.at(letter), fig.tangent, ray.line.along))
    mine = (e - p) / abs(e - p)
    axis = u * mine / t
    x = None if ray.x is None else complex(nominal(ray.x))
    side = u if x is None else (x - e) / abs(x - e) if abs(x - e) > 1e-6 else mine
    if min(sine(mine, u), sine(axis, side)) < sin(pi / 180):
        return 0.0
    s = ((side.conjugate() * (p - e)).imag) / (side.conjugate() * axis).imag
    q = p - axis * s
    back = u if ray.o is None else complex(nominal(ray.o)) - q
    if abs(back) < 1e-6:
        return 0.0
    return float(np.min([sine(mine, u), sine(axis, side), sine(back, mine)]))
