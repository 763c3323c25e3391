"""Velocities of points: v_X = ω_j · P_jk X, perpendicular to the line from the absolute centre, k being the frame."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ....algebra.formula import plain, sym
from ....algebra.quantity import Expr
from ....algebra.worked import worked
from ....board.construction import Reading
from ....board.paper.marks import Dot, Point, Role, Segment
from ....errors import NoMethodError
from ....foundation.slotted import replace
from ....mechanism.asked.centres import Pair, centre_speed, real_links
from ....mechanism.model import FRAME
from ....names import At, Rel, ascii_key
from ....plane import Points, nominal, unit
from ....plane.traced import bare
from ....words import Words, joined
from ...registry import Stage, method
from ..state import CentreFigure
from .motions import CLOSE, Motions
from .spots import Spot, apart, given, measured, point_spot, spot_of

NEAR, ASIDE = 0.5, 5.0  # mm: a link's end is here; an arrow beside a link
LONGEST = 24.0  # mm, the arrow of the largest velocity
Drawn = tuple[str, Points, Points]  # symbol, place on the figure, velocity


@method(
    stage=Stage.CENTRES,
    group="velocity",
    source="机械原理, 瞬心法求速度",
    example="3-2",
    title=Words("用绝对瞬心求点的速度", "A velocity by the absolute centre"),
)
def read_speed(motions: Motions, rel: Rel) -> Drawn | None:
    """The velocity of a lettered point of a link."""
    if rel.ref is not None:
        raise NoMethodError(
            Words(
                f"{rel.key}：瞬心法只给出相对于机架的速度；求此量请去掉 method: centres",
                f"{rel.key}: instant centres give velocities relative to the frame only; leave out 'method: "
                "centres' for it",
            )
        )
    at = rel.to if rel.to.link in motions.fig.mech.links_at(rel.to.point) else motions.fig.desk.canonical(rel.to)
    link, place = _where(motions, at)
    return _speed(
        motions,
        link,
        point_spot(motions.fig, str(rel.to) if str(rel.to) in motions.places else at.point, place),
        rel.key,
        rel.symbol,
    )


def read_centre_speed(motions: Motions, pair: Pair) -> Drawn | None:
    """v_P13: as of the link whose motion is known first."""
    fig, named = motions.fig, centre_speed(motions.fig.mech, *pair)
    moving = [name for name in pair if name != FRAME]
    link = next((name for name in moving if name in motions.turns), moving[0])
    if fig.known.of(*pair).endless:
        raise NoMethodError(
            Words(
                f"{named.key}：此瞬心在无穷远处，没有速度",
                f"{named.key}: this centre is at infinity and has no velocity",
            )
        )
    return _speed(motions, link, spot_of(fig, *pair), named.key, named.symbol)


def _speed(motions: Motions, link: str, spot: Spot, key: str, symbol: str) -> Drawn:
    """Read the velocity of a place of a link whose motion is, or now becomes, known."""
    motions.find(link)
    reading, vector = (_gliding if link in motions.glides else _turning)(
        motions, link, spot, Reading(key=key, symbol=symbol, unit="m/s", scalar=0.0)
    )
    motions.fig.board.write(reading.formula or sym(symbol))
    motions.fig.board.keep(
        replace(reading, scalar=float(nominal(np.abs(vector))), vector=complex(nominal(vector))), np.abs(vector), vector
    )
    return symbol, spot.at, vector


def _gliding(motions: Motions, link: str, spot: Spot, blank: Reading) -> tuple[Reading, Points]:
    """All points of a translating link have one velocity."""
    motions.fig.board.step(
        Words(
            f"${spot.letter}$ 在平动构件 {link} 上：",
            f"Point ${spot.letter}$ belongs to link {link}, which translates:",
        ),
        motions.fig.pane,
    )
    return replace(blank, formula=worked(sym(blank.symbol), motions.sizes[link], "m/s")), motions.glides[link]


def _turning(motions: Motions, link: str, spot: Spot, blank: Reading) -> tuple[Reading, Points]:
    """v_X = ω μ_l P X, perpendicular to P X."""
    fig, board = motions.fig, motions.fig.board
    own = spot_of(fig, link, FRAME)
    board.step(
        Words(
            f"${spot.letter}$ 绕构件 {link} 的绝对瞬心 ${own.letter}$ 转动，速度垂直于 ${own.letter}{spot.letter}$：",
            f"Point ${spot.letter}$ of link {link} turns about the absolute centre ${own.letter}$; its "
            f"velocity is perpendicular to ${own.letter}{spot.letter}$:",
        ),
        fig.pane,
    )
    known = given(fig, own, spot)
    paper = measured(fig, own, spot) if known is None else None
    if paper is not None and fig.paper.holds(complex(nominal(spot.at))):
        _letter(fig, spot)
    length: Expr = (
        known if known is not None else board.mu(fig.pane) * paper if paper is not None else board.mu(fig.pane)
    )
    expr = motions.sizes[link] * length
    reading = replace(blank, formula=worked(sym(blank.symbol), expr, "m/s"))
    if paper is not None:
        reading = replace(
            reading,
            mm=float(nominal(paper.value)),
            line=f"{own.letter} {spot.letter}",
            scale=fig.paper.scale.symbol,
            factor=plain(motions.sizes[link].symbol()),
        )
    if apart(own, spot) < CLOSE:
        return reading, 0j
    from_centre = spot.at - own.at
    at_rest = np.abs(bare(from_centre)) == 0.0  # whoever errs may be led to the centre itself
    way = 1j * unit(from_centre + at_rest if np.any(at_rest) else from_centre) * np.sign(nominal(motions.turns[link]))
    return reading, expr.value * np.exp(1j * board.gauge(0j, way))


def _letter(fig: CentreFigure, spot: Spot) -> None:
    """What is measured to a point stands on the figure with the letter of that point."""
    at = complex(nominal(spot.at))
    named = (mark for mark in fig.board.marks(fig.pane) if isinstance(mark, Point) and mark.label == spot.letter)
    if not any(abs(mark.at - at) < CLOSE for mark in named):
        fig.board.plot(fig.pane, spot.at, spot.letter, Dot.POINT)


def _where(motions: Motions, at: At) -> tuple[str, Points]:
    """The link on which a point is thought, and its place on the figure;
    the driver first, then links whose centre is at hand."""
    fig = motions.fig
    if str(at) in motions.places:
        return at.link, motions.places[str(at)]
    place = fig.desk.at[at.point] * fig.paper.factor
    if at.link:
        return at.link, place
    carriers = [name for name in fig.mech.links_at(at.point) if name in real_links(fig.mech) and name != FRAME]
    if not carriers:
        raise NoMethodError(
            Words(f"v_{at}：请指明是哪个构件上的点，如 v_{at.point}1", f"v_{at}: say of which link, e.g. v_{at.point}1")
        )
    return min(
        carriers, key=lambda name: (name != fig.mech.drive.link, fig.far(name, FRAME), name not in motions.turns)
    ), place


def draw_speeds(fig: CentreFigure, found: Iterable[Drawn]) -> None:
    """The velocities as arrows on the figure, in proportion to each other."""
    drawn = [(symbol, complex(nominal(at)), complex(nominal(v))) for symbol, at, v in found]
    largest = max((abs(v) for _, _, v in drawn), default=0.0)
    if not largest:
        return
    fig.board.step(
        Words(
            "在瞬心图上标出各速度的方向（箭头长度只表示相互比例）。",
            "Mark the velocities on the figure of the centres (their lengths are in proportion).",
        ),
        fig.pane,
    )
    moved = []
    for symbol, at, v in drawn:
        if abs(v) > 0.02 * largest and fig.paper.holds(at):
            start = at + (aside := _aside(fig, at, v / abs(v)))
            moved += [Words.same(f"${symbol}$")] if aside else []
            fig.board.arrow(
                fig.pane, start, start + v / largest * LONGEST, Role.RESULT, key=ascii_key(symbol), label=symbol
            )
    if moved:
        fig.board.remark(_said_aside(moved))


def _said_aside(symbols: Sequence[Words]) -> Words:
    """That arrows do not start at their points."""
    names = joined(symbols)
    lies, starts = ("lies", "starts beside its point") if len(symbols) == 1 else ("lie", "start beside their points")
    return Words(
        f"{names.zh} 几乎沿构件方向，为免重合，箭头自该点旁画起。",
        f" So as to be seen, {names.en}, which {lies} nearly along a link, {starts}.",
    )


def _aside(fig: CentreFigure, at: complex, way: complex) -> complex:
    """A step to the side where the arrow would lie on a link."""
    links = [
        m
        for m in fig.board.marks(fig.pane)
        if isinstance(m, Segment) and m.role is Role.LINK and min(abs(m.a - at), abs(m.b - at)) < NEAR
    ]
    hidden = any(
        abs((way.conjugate() * (m.b - m.a)).imag) < 0.1 * abs(m.b - m.a)
        and (way.conjugate() * (m.a + m.b - 2 * at)).real > 0
        for m in links
    )
    return -1j * way * ASIDE if hidden else 0j
