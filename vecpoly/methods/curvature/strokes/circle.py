"""The inflection circle through the pole, once one or two of its points are known."""

from __future__ import annotations

import numpy as np

from ....board.paper.marks import Role
from ....mechanism.asked.curvature import cusp, inflected
from ....plane import Line, Points, nominal, unit
from ....words import Words
from ..state import CurvatureFigure, Ray

NEAR = 16.0  # mm of the pole tangent to both sides, where the circle is drawn on another figure
SAME = 0.02  # mm: two points of the paper are one
INFLECTED = 1e-7  # of the distance to the pole: nearer to the inflection circle a point lies on it


def through_two(fig: CurvatureFigure, one: tuple[Ray, Points, str], two: tuple[Ray, Points, str]) -> None:
    """W by Thales: the perpendiculars at two points of the circle to their lines from the pole meet opposite to it."""
    (ray, j, name), (other, k, second) = one, two
    fig.board.step(
        Words(
            f"拐点圆过 ${fig.p}$、${name}$、${second}$：在 ${name}$、${second}$ 处各作法线的垂线，交于拐点极 "
            f"${fig.w}$；"
            f"以 ${fig.p}{fig.w}$ 为直径作拐点圆。",
            f"The inflection circle passes through ${fig.p}$, ${name}$, ${second}$: the perpendiculars to the normals "
            f"at "
            f"${name}$ and ${second}$ meet at the inflection pole ${fig.w}$; draw the circle on the diameter "
            f"${fig.p}{fig.w}$.",
        ),
        fig.pane,
    )
    g, h = fig.normal(ray.line, j), fig.normal(other.line, k)
    w = fig.meet(g, h, "拐点极", "the inflection pole")
    settle(fig, w)
    for line, at in ((g, j), (h, k)):
        fig.thin(line, at, fig.opposite)
        _square(fig, at)


def on_normal(fig: CurvatureFigure, ray: Ray, j: Points, name: str) -> None:
    """W on the pole normal, by Thales from one point of the circle."""
    fig.board.step(
        Words(
            f"在 ${name}$ 处作法线的垂线，与极法线 $n$ 交于拐点极 ${fig.w}$；以 ${fig.p}{fig.w}$ 为直径作拐点圆。",
            f"The perpendicular to the normal at ${name}$ meets the pole normal $n$ at the inflection pole ${fig.w}$; "
            f"draw the inflection circle on the diameter ${fig.p}{fig.w}$.",
        ),
        fig.pane,
    )
    g = fig.normal(ray.line, j)
    across = Line(fig.pole, fig.board.turn(1j * fig.tangent))
    settle(fig, fig.meet(g, across, "拐点极", "the inflection pole"))
    fig.thin(g, j, fig.opposite)
    _square(fig, j)


def on_the_normal(fig: CurvatureFigure, j: Points, name: str) -> None:
    """W itself: the point of the circle on the pole normal."""
    fig.board.step(
        Words(
            f"${name}$ 在极法线上，即拐点极 ${fig.w}$；以 ${fig.p}{fig.w}$ 为直径作拐点圆。",
            f"Point ${name}$ lies on the pole normal: it is the inflection pole ${fig.w}$ itself; draw the inflection "
            f"circle on "
            f"the diameter ${fig.p}{fig.w}$.",
        ),
        fig.pane,
    )
    settle(fig, j)


def settle(fig: CurvatureFigure, w: Points) -> None:
    """W has its letter, and the circle is drawn."""
    fig.opposite = fig.letter(fig.w, w)
    fig.tangent = 1j * unit(fig.opposite - fig.pole)
    fig.thin(fig.through(fig.pole, fig.opposite), fig.pole, fig.opposite, role=Role.CENTRE)
    fig.ring((fig.pole, fig.opposite), Role.GIVEN)


def draw_return_circle(fig: CurvatureFigure, symbol: str) -> None:
    """The mirror image of the inflection circle in the pole: on it lie the centres of the paths of points at infinity,
    and every point that a line of the link envelops."""
    fig.board.step(
        Words(
            f"在 ${fig.w}{fig.p}$ 的延长线上截取与 ${fig.p}{fig.w}$ 等长的线段，得回归极 ${symbol}$；以它与 ${fig.p}$ "
            "的连线为直径作回归圆（虚线），与拐点圆等大、相切。",
            f"On ${fig.w}{fig.p}$ produced step off the length ${fig.p}{fig.w}$ to the return pole ${symbol}$; on it "
            "as diameter draw the return circle (dashed), equal to the inflection circle and tangent to it.",
        ),
        fig.pane,
    )
    across = fig.pole - fig.opposite
    fig.returned = fig.letter(symbol, fig.board.lay_off(fig.pole, unit(across), np.abs(across)))
    fig.thin(fig.through(fig.pole, fig.returned), fig.pole, fig.returned, role=Role.CENTRE)
    fig.ring((fig.pole, fig.returned), Role.HIDDEN)


def letter_tangent(fig: CurvatureFigure) -> None:
    """The pole tangent t, with its letter at its end."""
    reach = float(nominal(np.abs(fig.opposite - fig.pole))) * 0.3
    along, (_, ratio) = unit(fig.opposite - fig.pole), fig.sheet(fig.opposite)
    for far in (reach, NEAR) if ratio < 1 else (reach,):
        fig.thin(Line(fig.pole, fig.tangent), fig.pole - fig.tangent * far, fig.pole + fig.tangent * far)
        fig.name("t", fig.pole + fig.tangent * far, fig.tangent * 5.0)
    fig.thin(Line(fig.opposite, along), fig.opposite, fig.opposite + along * 4.0 / ratio, role=Role.CENTRE)
    fig.name("n", fig.opposite, along * 9.0)


def refuse_inflected(fig: CurvatureFigure, letter: str) -> None:
    """Raise NotAskedError where the point is the pole, or lies on the inflection circle."""
    p, e, w = (complex(nominal(at)) for at in (fig.pole, fig.at(letter), fig.opposite))
    size = abs(w - p)
    if abs(e - p) <= max(INFLECTED * size, SAME):
        raise cusp(fig.shown(letter))
    along = (e - p) / abs(e - p)
    if abs(abs(e - p) - (along.conjugate() * (w - p)).real) <= INFLECTED * size:
        raise inflected(fig.shown(letter))


def _square(fig: CurvatureFigure, at: Points) -> None:
    """The right angle over the diameter; none where it is too small to be seen."""
    u, v, (pane, ratio) = fig.pole - at, fig.opposite - at, fig.sheet(at, fig.opposite)
    if min(float(nominal(np.abs(u))), float(nominal(np.abs(v)))) * ratio > 6.0:
        fig.board.right_angle(pane, at * ratio, unit(u), unit(v))
