"""The slowest point of a line of a link: the foot of the perpendicular from the link's absolute centre."""

from __future__ import annotations

from ....board.paper.marks import Dot, Role
from ....errors import NoMethodError
from ....mechanism.model import FRAME
from ....names import subscripted
from ....plane import Line, Points, foot, nominal, unit
from ....problem.asked.asks import AskPoint
from ....words import Words
from ...registry import Stage, method
from .motions import Motions
from .spots import spot_of


@method(
    stage=Stage.CENTRES,
    group="slowest point",
    source="机械原理, 瞬心法",
    example="3-2",
    title=Words("构件上速度最小的点", "The slowest point of a link"),
)
def find_slowest(motions: Motions, ask: AskPoint) -> None:
    """v_E = ω P E is least where P E is perpendicular to the line."""
    fig, (p, q) = motions.fig, ask.slowest or ("", "")
    if fig.known.of(ask.link, FRAME).endless:
        raise NoMethodError(
            Words(
                f"{ask.name}：构件 {ask.link} 此时作平动，各点速度相等",
                f"{ask.name}: link {ask.link} only translates here: all its points are equally fast",
            )
        )
    centre, name = spot_of(fig, ask.link, FRAME), subscripted(ask.name)
    ends = [fig.desk.at[letter] * fig.paper.factor for letter in (p, q)]
    fig.board.step(
        Words(
            f"构件 {ask.link} 上各点速度与到 ${centre.letter}$ 的距离成正比：过 ${centre.letter}$ 作 ${p}{q}$ "
            f"的垂线，垂足 ${name}$ 为直线 ${p}{q}$ 上速度最小的点。",
            f"The velocities of link {ask.link} grow with the distance from ${centre.letter}$: "
            f"the foot ${name}$ of the perpendicular from ${centre.letter}$ to ${p}{q}$ is the "
            "slowest point of this line.",
        ),
        fig.pane,
    )
    along = fig.board.turn(unit(ends[1] - ends[0]))
    at = foot(Line(ends[0], along), centre.at)
    motions.places[ask.name] = at
    _draw(motions, at, ends, centre.at, name)
    fig.keep_place(ask.rel.key, name, fig.board.coordinates(at, ask.name))


def _draw(motions: Motions, at: Points, ends: list[Points], centre: Points, name: str) -> None:
    """The perpendicular with its right angle, and the line carried on to its foot where that lies beyond."""
    fig = motions.fig
    spot, a, b = (complex(nominal(z)) for z in (at, *ends))
    near, other = sorted((a, b), key=lambda end: abs(end - spot))
    if abs(other - spot) > abs(b - a):
        fig.board.join(fig.pane, near, spot, Role.HIDDEN)
    fig.board.join(fig.pane, centre, at, Role.DIRECTION)
    if fig.paper.holds(complex(nominal(centre))) and abs(complex(nominal(centre)) - spot) > 1.0:
        fig.board.right_angle(fig.pane, at, unit(centre - at), unit(other - spot))
    fig.board.plot(fig.pane, at, name, Dot.POINT)
