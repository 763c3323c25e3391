"""The answers read off the figure of the centres: where they are, and what the problem asks of the motion."""

from __future__ import annotations

import numpy as np

from ...algebra.formula import Row, Txt, sym
from ...algebra.worked import worked
from ...board.construction import Reading
from ...errors import NoMethodError
from ...mechanism.asked.centres import ENDLESS, Pair, centre, centre_speed, link_pairs, ratio
from ...mechanism.model import FRAME
from ...names import Kind, Rel
from ...plane import Points, Reals, cross, nominal, unit
from ...plane.traced import acts_of, traced
from ...problem.asked.asks import AskNamed, AskPoint, AskRel
from ...problem.problem import Problem
from ...words import Words
from ..registry import Stage
from .doors import RATIOS, VELOCITIES
from .find.motions import Motions
from .find.speeds import draw_speeds, read_centre_speed
from .find.spots import Spot, another_line, measured, spot_of
from .state import LEVEL, CentreFigure


def read_centres(motions: Motions, problem: Problem) -> None:
    """Every answer that centres give, in the order of the questions."""
    fig, found = motions.fig, []
    wanted = {ask.rel.key for ask in problem.asks if isinstance(ask, AskNamed)}
    for pair in link_pairs(fig.mech):
        if centre(fig.mech, *pair).key in wanted:
            _read_place(fig, pair)
    slow = {ask.at for ask in problem.asks if isinstance(ask, AskPoint) and ask.slowest is not None}
    for ask in problem.asks:
        if isinstance(ask, AskRel) and ask.rel.kind is Kind.OMEGA and problem.by_centres:
            _read_turn(motions, ask.rel)
        elif isinstance(ask, AskRel) and ask.rel.kind is Kind.V and (problem.by_centres or ask.rel.to in slow):
            found.append(VELOCITIES.find(Stage.CENTRES, "velocity").draw(motions, ask.rel))
        elif isinstance(ask, AskNamed):
            found += _read_named(motions, ask.rel.key)
    draw_speeds(fig, [speed for speed in found if speed is not None])


def _read_turn(motions: Motions, rel: Rel) -> None:
    """ω of a link; that of the driver is given."""
    link, desk = rel.to.link, motions.fig.desk
    if link == FRAME:
        raise NoMethodError(Words("机架不转动", "the frame does not turn"))
    motions.find(link)
    if rel.key not in desk.board.readings:
        value = motions.turns[link]
        desk.board.keep(
            Reading(
                key=rel.key,
                symbol=rel.symbol,
                unit=rel.unit,
                scalar=float(nominal(value)),
                formula=worked(sym(rel.symbol), motions.sizes[link], rel.unit),
            ),
            value,
        )


def _read_named(motions: Motions, key: str) -> list[tuple[str, Points, Points] | None]:
    """A ratio ω_i/ω_j, or the velocity of a centre."""
    mech = motions.fig.mech
    for a, b in link_pairs(mech):
        if key == centre_speed(mech, a, b).key:
            return [read_centre_speed(motions, (a, b))]
        for pair in ((a, b), (b, a)):
            if FRAME not in pair and key == ratio(mech, *pair).key:
                RATIOS.find(Stage.CENTRES, "ratio").draw(motions, pair)
    return []


def _read_place(fig: CentreFigure, pair: Pair) -> None:
    """Place in m on the diagram's axes; at infinity the direction in deg."""
    named, found = centre(fig.mech, *pair), fig.known.of(*pair)
    if found.along is not None:
        angle = _upright(fig.board.gauge(0j, found.along))
        turn, symbol = float(nominal(angle)), f"{named.symbol}^{{∞}}"
        text = Row((sym(symbol), Txt(f" (∠{turn:.1f}°)")))
        fig.board.keep(Reading(key=named.key, symbol=symbol, unit=ENDLESS, scalar=turn, formula=text), angle)
        return
    mm = _far_place(fig, pair) if pair in fig.paper.far else _near_place(fig, pair)
    fig.keep_place(named.key, named.symbol, mm)


def _near_place(fig: CentreFigure, pair: Pair) -> Points:
    """Both coordinates read off the rule (mm)."""
    spot = spot_of(fig, *pair)
    return fig.board.coordinates(spot.at, spot.letter)


def _far_place(fig: CentreFigure, pair: Pair) -> Points:
    """Off the paper: from a centre on the paper along the line towards it, by direction and distance (mm)."""
    far = spot_of(fig, *pair)
    ways = [way for way in fig.known.ways(pair) if way.via]
    near = [
        spot_of(fig, link, way.via)
        for way in ways
        for link in pair
        if not fig.known.of(link, way.via).endless and not fig.far(link, way.via)
    ]
    if not near:
        raise NoMethodError(
            Words(
                f"{far.letter} 在图纸之外，图上没有通向它的直线；请加大 μ_l",
                f"no line on the paper leads to {far.letter}, which is off it; choose a larger μ_l",
            )
        )

    def parted(spot: Spot) -> float:
        """The sine between the line from there and another one."""
        return abs(float(nominal(cross(unit(far.at - spot.at), another_line(fig, spot, far).along))))

    start = max(near, key=parted)
    fig.board.step(
        Words(
            f"${far.letter}$ 落在图外：量 ${start.letter}{far.letter}$ 的方向，其长度由比例线段求得：",
            f"The centre ${far.letter}$ is off the paper: measure the direction of "
            f"${start.letter}{far.letter}$; its length follows from proportional segments:",
        ),
        fig.pane,
    )
    way = np.exp(1j * fig.board.gauge(start.at, far.at))
    return fig.board.coordinates(start.at, start.letter) + way * measured(fig, start, far).value


def _upright(angle: Reals) -> Reals:
    """A direction without sense, 0 to 180°; its repetitions without a jump."""
    degrees = np.degrees(angle)
    first = float(nominal(degrees)) % 180.0
    first = 0.0 if 180.0 - first < LEVEL else first
    near: Reals = first + (degrees - first + 90.0) % 180.0 - 90.0
    return near if np.ndim(near) else traced(first, acts_of(angle))
