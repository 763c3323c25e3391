"""The instant centres of a mechanism: how many, those at sight, the others in order;
then what the problem asks of them."""

from __future__ import annotations

from ...algebra.formula import Row, Txt, row
from ...board.construction import View
from ...mechanism.asked.centres import count, real_links
from ...mechanism.groups.assur import Group
from ...names import Sort
from ...problem.asked.asks import AskNamed, AskPoint
from ...problem.problem import Problem
from ...words import Words
from ..desk import Desk
from ..registry import Stage
from .at_sight import draw_direct
from .copy import mechanism_copied
from .direct import direct_centres, normals, scaled
from .doors import LIMITS, SEARCHES, SLOWEST
from .find.motions import Motions
from .onto import is_once, opened, sharing
from .readings import read_centres
from .size import LEAST, NAME, Paper, paper_for
from .state import CentreFigure
from .theorem.polygon import open_polygon
from .theorem.search import Known

TITLE = Words("瞬心图", "Instant centres")


def centre_pass(desk: Desk, problem: Problem, groups: tuple[Group, ...]) -> None:
    """Draw the centres and read the answers off; raises NoMethodError where the theorem leads no further."""
    direct = direct_centres(desk)
    paper, seen = paper_for(desk, direct, sharing(problem, LEAST))
    here = scaled(direct, paper.factor)
    _count(desk)
    polygon = open_polygon(desk)
    pane = opened(desk.board, NAME, TITLE, paper, once=is_once(problem))
    fig = CentreFigure(
        desk=desk, pane=pane, polygon=polygon, paper=paper, known=Known(desk.mech, {}, normals(here), paper.far)
    )
    if pane is not View.MECHANISM:
        _copy(fig, paper, groups)
    draw_direct(fig, here)
    for search in seen.searches:
        SEARCHES.find(Stage.CENTRES, "Kennedy" if search.trial is None else "trial").draw(fig, search)
    motions = Motions(fig)
    for ask in problem.asks:
        if isinstance(ask, AskPoint) and ask.slowest is not None:
            SLOWEST.find(Stage.CENTRES, "slowest point").draw(motions, ask)
    read_centres(motions, problem)
    _limit_positions(desk, problem)


def _count(desk: Desk) -> None:
    """k links have N = k (k − 1) / 2 centres; K is the time ratio of the strokes, n counts the moving links."""
    k, n = len(real_links(desk.mech)), count(desk.mech)
    number = desk.mech.frame_number
    desk.board.step(
        Words(
            f"机构（含机架 {number}）共有 $k$ = {k} 个构件，瞬心数目为：",
            f"With the frame, {number}, the mechanism has $k$ = {k} links; the number of their centres is:",
        )
    )
    desk.board.write(Row((*row("N = k(k − 1)/2").items, Txt(f" = {k} × {k - 1}/2 = {n}"))))


def _copy(fig: CentreFigure, paper: Paper, groups: tuple[Group, ...]) -> None:
    """The mechanism once more, reduced where its centres need more room."""
    if paper.factor < 1:
        words = Words(
            f"为使瞬心落在图纸内，另取较大的 {paper.told} 重画机构图，作为瞬心图。",
            f"So that the centres fall on the paper, draw the mechanism once more to the scale {paper.told}.",
        )
    else:
        words = Words("重画机构图，作为瞬心图。", "Draw the mechanism once more for its centres.")
    fig.board.step(words + _sparing(fig), fig.pane)
    fig.board.depict(fig.pane, *mechanism_copied(fig.desk, paper, groups))


def _sparing(fig: CentreFigure) -> Words:
    """How the lines of many centres are drawn."""
    if not fig.crowded:
        return Words.same("")
    return Words(
        "瞬心较多，各连线只画出交点附近的一段。",
        " There are many centres: of every line only the piece where it cuts is drawn.",
    )


def _limit_positions(desk: Desk, problem: Problem) -> None:
    for ask in problem.asks:
        if isinstance(ask, AskNamed) and ask.rel.key not in desk.board.readings and ask.rel.sort is Sort.LIMIT:
            LIMITS.find(Stage.CENTRES, "limit positions").draw(desk, ask.rel)
