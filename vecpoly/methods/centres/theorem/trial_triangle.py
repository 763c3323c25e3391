"""The trial triangle drawn:
the three known lines, a triangle with its sides through three known centres, the line of its third corner."""

from __future__ import annotations

from ....board.paper.marks import Dot
from ....words import Words
from ...registry import Stage, method
from ..geometry import Centre, meeting, through
from ..state import CentreFigure
from .kennedy import sides_of
from .polygon import join
from .search import Known, Search, Way
from .trial import Trial, trial_at


@method(
    stage=Stage.CENTRES,
    group="trial",
    source="机械原理, class III groups",
    example="class-iii",
    title=Words("试作法求Ⅲ级杆组的瞬心", "A centre of a class III group by a trial triangle"),
)
def find_by_trial(fig: CentreFigure, search: Search) -> None:
    """Draw the trial triangle, the line of its third corner, and the centre."""
    assert search.trial is not None
    link, others, offset = search.trial
    ways = tuple(
        _laid(fig, fig.known.way(fig.known.pair(link, other), _via(fig.known, link, other))) for other in others
    )
    trial = trial_at(fig.known, link, others, (ways[0], ways[1], ways[2]), offset * fig.paper.factor)
    assert trial is not None and trial.locus is not None
    fig.board.step(_words(fig, trial), fig.pane)
    locus = fig.board.parallel(trial.locus.at, trial.locus.along)
    join(fig.desk, fig.polygon, search.pair, sought=True)
    here = fig.settle(search.pair, meeting(trial.ways[2].line, locus, False))
    _draw(fig, trial, here)
    fig.letter(search.pair, Dot.POINT, 0j)


def _via(known: Known, link: str, other: str) -> str:
    return next(way.via for way in known.ways(known.pair(link, other)) if way.line is not None)


def _laid(fig: CentreFigure, way: Way) -> Way:
    return (
        way
        if way.line is None or not way.via
        else Way(via=way.via, line=fig.board.parallel(way.line.at, way.line.along))
    )


def _draw(fig: CentreFigure, trial: Trial, here: Centre) -> None:
    """The three lines, the triangle with its sides through the known centres, the line of its third corner."""
    a, b, c = trial.others
    for other, way, end in zip(trial.others, trial.ways, (*trial.corners[:2], here), strict=True):
        assert way.line is not None
        pair = fig.known.pair(trial.link, other)
        fig.rule(
            way.line,
            end,
            *((trial.start,) if other != c else ()),
            *(fig.known.of(*side) for side in sides_of(pair, way)),
        )
    x, y, z = trial.corners
    for (p, q), centre in zip(
        ((x, y), (x, z), (y, z)), (fig.known.of(a, b), fig.known.of(a, c), fig.known.of(b, c)), strict=True
    ):
        side = through(p, q)
        if side is not None:
            fig.rule(side, p, q, *(() if centre.endless else (centre,)), whole=True)
    if trial.locus is not None:
        fig.rule(trial.locus, z, here, *(() if trial.start.endless else (trial.start,)), whole=True)
    for spot, letter in zip((x, y, z), "xyz", strict=True):
        if fig.paper.holds(spot.spot()):
            fig.board.plot(fig.pane, spot.spot(), letter, Dot.POINT)


def _words(fig: CentreFigure, trial: Trial) -> Words:
    k, (a, b, c) = trial.link, trial.others
    ka, kb, kc = (f"${fig.symbol(k, other)}$" for other in trial.others)
    ab, ac, bc = (f"${fig.letters(*two)}$" for two in ((a, b), (a, c), (b, c)))
    number = fig.mech.number(k)
    return Words(
        f"求 {kc}：构件 {number} 的瞬心 {ka}、{kb}、{kc} 各只有一条已知连线，用试作法。在 {ka} 的连线上任取一点 "
        f"$x$，连 $x${ab} 交 {kb} 的连线于 $y$，$x${ac} 与 $y${bc} 交于 $z$。因 {ab}、{ac}、{bc} 共线，"
        f"$x$ 移动时 $z$ 的轨迹为一直线，且过 {ka}、{kb} 两连线的交点；此直线与 {kc} 的连线的交点即为 {kc}。",
        f"Find {kc}: of the centres {ka}, {kb}, {kc} of link {number} one line each is known. Try any "
        f"point $x$ on the line of {ka}; the line from $x$ to {ab} meets the line of {kb} at $y$; "
        f"the lines from $x$ to {ac} and from $y$ to {bc} meet at $z$. Since {ab}, {ac} and {bc} "
        "lie on one line, $z$ runs on a straight line as $x$ moves, and it passes where the lines "
        f"of {ka} and {kb} meet; it cuts the line of {kc} in {kc}.",
    )
