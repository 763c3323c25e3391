"""The kinematic geometry of one link, by the construction that the problem names."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import View
from ...board.paper.extent import bounds
from ...board.paper.titled import CURVATURES, SMALLER_CURVATURES
from ...errors import DeadPointError, NoMethodError, NotAskedError
from ...mechanism.asked.curvature import (
    Way,
    asked_points,
    ball_point,
    collineation,
    diameter,
    inflection_pole,
    of_link,
    return_pole,
)
from ...mechanism.groups.assur import Group
from ...problem.asked.asks import AskNamed
from ...problem.problem import Problem
from ...words import Words
from ..centres.copy import mechanism_copied
from ..centres.onto import is_once, opened, sharing
from ..centres.size import Paper
from ..desk import Desk
from ..registry import Stage
from .centrodes import draw_centrodes
from .doors import WAYS
from .off import carry_over
from .pairs import rolling_of
from .path import draw_paths
from .readings import read_collineation, read_curvatures
from .refused import off_the_sheet
from .room import FAR, LEAST, NAME, Draw, Room, Wanted, room_for
from .state import CurvatureFigure
from .strokes.ball import draw_ball_point
from .strokes.circle import draw_return_circle
from .strokes.pole import draw_pole


def curvature_pass(desk: Desk, problem: Problem, groups: tuple[Group, ...]) -> None:
    """Pole, inflection circle, centres of curvature; centrodes on a figure of their own."""
    asked = problem.curvature
    assert asked is not None
    keys = frozenset(ask.rel.key for ask in problem.asks if isinstance(ask, AskNamed))
    curved = bool(keys & of_link(desk.mech, asked.link).keys())
    if curved:
        _curvatures(desk, problem, groups, keys)
    if asked.centrodes is not None:
        alone = is_once(problem) and not curved
        draw_centrodes(desk, groups, asked.centrodes, sharing(problem, LEAST), alone=alone)


def _curvatures(desk: Desk, problem: Problem, groups: Sequence[Group], keys: frozenset[str]) -> None:
    """By the construction that is asked, on paper that holds it all."""
    asked = problem.curvature
    assert asked is not None
    points = asked_points(desk.mech, asked.link, keys)
    back = return_pole(desk.mech, asked.link)
    ball = ball_point(desk.mech, asked.link)
    circle = (inflection_pole(desk.mech, asked.link), diameter(desk.mech, asked.link), back, ball)
    curved = bool(keys & {named.key for named in circle}) or bool(points)
    if rolling_of(desk.mech, asked.link) is not None and asked.way is not Way.EULER_SAVARY and curved:
        raise NoMethodError(_rolls(desk.mech.number(asked.link)), code="rolls")
    way = WAYS.find(Stage.CURVATURE, asked.way.value).draw
    axis = collineation(desk.mech, asked.link).key in keys

    def construct(fig: CurvatureFigure, second: Paper | None = None) -> None:
        draw_pole(fig)
        carry_over(fig, second)
        if curved:
            try:
                way(fig, points)
            except (DeadPointError, ZeroDivisionError):
                raise NotAskedError(_collapsed(asked.way), code="collapsed") from None
        if back.key in keys:
            draw_return_circle(fig, back.symbol)
        if ball.key in keys:
            draw_ball_point(fig, ball.symbol)
        if axis:
            read_collineation(fig)

    fig, room = _opened(desk, problem, groups, construct)
    construct(fig, room.second)
    draw_paths(fig, room.paper)
    read_curvatures(fig, keys)


def _opened(desk: Desk, problem: Problem, groups: Sequence[Group], draw: Draw) -> tuple[CurvatureFigure, Room]:
    """The figure, or the two, on which all that is to be drawn finds room."""
    asked, board = problem.curvature, desk.board
    assert asked is not None
    box = bounds(board.marks(View.MECHANISM))
    want = Wanted(desk=desk, link=asked.link, draw=draw, box=box, sharing=sharing(problem, LEAST))
    room = room_for(want)
    if room is None:
        raise off_the_sheet(want)
    pane = opened(board, NAME, CURVATURES, room.paper, once=is_once(problem))
    fig = CurvatureFigure(desk=desk, link=asked.link, pane=pane, factor=room.paper.factor)
    if (second := room.second) is not None:
        far = board.open_pane(View.MECHANISM, FAR, SMALLER_CURVATURES, second.scale, aside=True, composed=True)
        fig.off = room.off(far)
    if pane is not View.MECHANISM:
        _copy(fig, room.paper, groups)
    return fig, room


def _rolls(number: str) -> Words:
    return Words(
        f"构件 {number} 在机架上纯滚动，只有一条已知的法线；请用 construction: euler-savary",
        f"link {number} rolls on the frame and has only one known normal: use construction: euler-savary",
    )


def _collapsed(way: Way) -> Words:
    """That lines of the construction fall together, or have no length."""
    if way is Way.EULER_SAVARY:
        return Words(
            "在此位置作图线重合或没有长度，不能作图；请另取原动件位置",
            "in this position lines of the construction fall together or have no length; choose another input position",
        )
    return Words(
        f"在此位置 {way.value} 作图的线重合或没有长度；请改用 construction: euler-savary，或另取原动件位置",
        f"in this position lines of the construction '{way.value}' fall together or have no length; use construction: "
        "euler-savary, or choose another input position",
    )


def _copy(fig: CurvatureFigure, paper: Paper, groups: Sequence[Group]) -> None:
    """The mechanism once more, reduced where the circle needs more room."""
    words = Words("重画机构图，作为曲率作图之用。", "Draw the mechanism once more for the curvatures.")
    if paper.factor < 1:
        words = Words(
            f"为使拐点圆等落在图纸内，另取较大的 {paper.told} 重画机构图。",
            "So that the inflection circle falls on the paper, draw the mechanism once more to the scale "
            f"{paper.told}.",
        )
    fig.board.step(words, fig.pane)
    fig.board.depict(fig.pane, *mechanism_copied(fig.desk, paper, tuple(groups)))
