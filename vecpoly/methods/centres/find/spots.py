"""Lengths between centres and points: given by the problem, measured on the figure,
or found by proportion where a centre is off the paper."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....algebra.formula import letters_node
from ....algebra.quantity import Quantity, magnitude, paper
from ....errors import NoMethodError
from ....mechanism.asked.centres import Pair, pair_of, real_links
from ....names import subscripted
from ....plane import Line, Points, cross, nominal, unit
from ....words import Words
from ..state import CentreFigure

STRIP, SHORTEST = (
    60.0,
    20.0,
)  # mm, at most and at least, between the two offsets from which a distance off the paper follows


@dataclass(frozen=True, slots=True, kw_only=True)
class Spot:
    """A place on the figure with its letter; `pin`: the letter of the mechanism that stands there;
    `off`: the centre, where off the paper."""

    letter: str
    at: Points
    pin: str = ""
    off: Pair | None = None


def spot_of(fig: CentreFigure, a: str, b: str) -> Spot:
    """The centre of two links, which is not at infinity."""
    found, pair = fig.known.of(a, b), pair_of(fig.mech, a, b)
    assert found.at is not None
    return Spot(
        letter=fig.symbol(a, b),
        at=found.at,
        pin=_pin(fig, found.spot(), pair),
        off=pair if pair in fig.paper.far else None,
    )


def point_spot(fig: CentreFigure, letter: str, at: Points) -> Spot:
    """A lettered point."""
    return Spot(letter=subscripted(letter), at=at, pin=letter)


def _pin(fig: CentreFigure, here: complex, pair: Pair) -> str:
    """The letter of the hinge that is this centre."""
    real = set(real_links(fig.mech))
    for letter, at in fig.desk.at.items():
        if (
            abs(complex(nominal(at)) * fig.paper.factor - here) < 1e-9
            and set(pair) <= set(fig.mech.links_at(letter)) & real
        ):
            return letter
    return ""


def apart(p: Spot, q: Spot) -> float:
    """Nominal distance on the figure, mm."""
    return float(abs(complex(nominal(q.at)) - complex(nominal(p.at))))


def given(fig: CentreFigure, p: Spot, q: Spot) -> Quantity | None:
    """l_AB where the problem gives it: both places are points of one link."""
    if (
        p.pin
        and q.pin
        and any({p.pin, q.pin} <= set(points) for points in (fig.mech.frame, *(link.points for link in fig.mech.links)))
    ):
        return fig.desk.length(p.pin, q.pin)
    return None


def measured(fig: CentreFigure, p: Spot, q: Spot) -> Quantity:
    """The length on the figure (mm), read off the rule; by proportion where one end is off the paper."""
    if p.off is not None and q.off is not None:
        raise NoMethodError(
            Words(
                f"{p.letter} 与 {q.letter} 都在图纸之外，其间距离无法量取",
                f"the distance of {p.letter} and {q.letter}, both off the paper, cannot be measured",
            )
        )
    if p.off is not None:
        p, q = q, p
    if q.off is None:
        return fig.board.measure(p.at, q.at, f"{p.letter} {q.letter}")
    return _by_proportion(fig, p, q)


def _by_proportion(fig: CentreFigure, p: Spot, q: Spot) -> Quantity:
    """PQ = s d_1 / (d_1 − d_2): d_1 and d_2 are the offsets, s mm apart on the line PQ,
    from another line that leads to Q.

    The second offset lies between P and the edge of the paper;
    where that is too near, s mm behind P: PQ = s d_1 / (d_2 − d_1).
    """
    other = another_line(fig, p, q)
    way = unit(q.at - p.at)
    step, behind = _strip(fig, complex(nominal(p.at)), complex(nominal(way)), apart(p, q))
    offsets = [np.abs(cross(other.along, at - other.at)) for at in (p.at, p.at + (-way if behind else way) * step)]
    d1, d2 = (magnitude(f"d_{n}", fig.board.hand.read(d), "mm") for n, d in zip((1, 2), offsets, strict=True))
    s = magnitude("s", step, "mm")
    back = Words("的反方向上", " backwards") if behind else Words("方向上", "")
    fig.board.remark(
        Words(
            f"（在 ${p.letter}{q.letter}$ {back.zh}相距 $s$ 的两处量取到另一连线的距离 $d_1$、$d_2$。）",
            f" (The offsets $d_1$ and $d_2$ from another line to ${q.letter}$ are measured "
            f"$s$ apart on ${p.letter}{q.letter}${back.en}.)",
        )
    )
    node = letters_node(f"{p.letter} {q.letter}")
    gap = d2 - d1 if behind else d1 - d2
    return Quantity(paper(node, 0.0).node, fig.board.compute(f"{p.letter}{q.letter}", s * d1 / gap, "mm").value, "mm")


def _strip(fig: CentreFigure, at: complex, way: complex, distance: float) -> tuple[float, bool]:
    """How far apart the offsets are taken (mm), and whether behind P: on the paper, and never beyond Q."""
    rooms = [STRIP if (edge := fig.edge(at, w)) is None else abs(edge - at) for w in (way, -way)]
    ahead = 5.0 * (min(STRIP, rooms[0], 0.9 * distance) // 5.0)
    if ahead >= SHORTEST:
        return ahead, False
    return max(5.0 * (min(STRIP, rooms[1]) // 5.0), SHORTEST), True


def another_line(fig: CentreFigure, p: Spot, q: Spot) -> Line:
    """A line that leads to a centre off the paper and leaves out the place p: the one that meets PQ best."""
    assert q.off is not None
    way = complex(nominal(unit(q.at - p.at)))
    best = max(fig.known.on_paper(q.off), key=lambda line: abs(float(nominal(cross(line.along, way)))), default=None)
    if best is None or abs(float(nominal(cross(best.along, way)))) < 1e-9:
        raise NoMethodError(
            Words(
                f"{q.letter} 在图纸之外，图上没有第二条通向它的直线；请加大 μ_l",
                f"no second line on the paper leads to {q.letter}, which is off it; choose a larger μ_l",
            )
        )
    return best
