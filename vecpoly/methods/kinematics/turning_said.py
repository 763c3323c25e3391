"""Which way the vectors of a point lie that follow from the known rotation of its link."""

from __future__ import annotations

from ...board.construction import View
from ...names import At, Kind, Rel, alpha, omega
from ...plane import nominal
from ...words import Words
from ..desk import QUANTITY, Desk
from .terms import ref_at


def turning_said(desk: Desk, view: View, link: str, at: At, held: At) -> Words:
    """What is found, and the senses of what is perpendicular to the line from the known point."""
    name, kind = desk.name(at), QUANTITY[view]
    found = Words(
        f"由构件 {link} 的转动求 ${name}$ 点的{kind.zh}", f"The rotation of link {link} gives the {kind.en} of ${name}$"
    )
    return found + _ways(desk, view, link, at, held) + Words("。", ".")


def _ways(desk: Desk, view: View, link: str, at: At, held: At) -> Words:
    """v ⊥ PX in the sense of ω; a^t ⊥ PX in that of α, or the normal component alone."""
    turn, letter = (omega(link), "ω") if view is View.VELOCITY else (alpha(link), "α")
    rate, ref = float(nominal(desk.turns[turn].value)), ref_at(desk, view, held, link)
    p, x = held.point, at.point
    if rate:
        kind = Kind.V if view is View.VELOCITY else Kind.AT
        symbol = desk.symbol(Rel(kind, desk.canonical(at), ref))
        way, way_en = ("逆时针", "counter-clockwise") if rate > 0 else ("顺时针", "clockwise")
        return Words(
            f"：${symbol}$ ⊥ ${p}{x}$，指向与 ${letter}_{link}$（{way}）一致",
            f": ${symbol}$ is perpendicular to ${p}{x}$ in the sense of ${letter}_{link}$ ({way_en})",
        )
    if not nominal(desk.turns[omega(link)].value):
        none = f"$ω_{link}$ = 0" if view is View.VELOCITY else f"$ω_{link}$ = 0，$α_{link}$ = 0"
        return Words(
            f"：{none}，故 ${x}$ 与 ${p}$ 的{QUANTITY[view].zh}相同",
            f": since {none.replace('，', ' and ')}, ${x}$ has the same {QUANTITY[view].en} as ${p}$",
        )
    if view is View.ACCELERATION and ref is None:
        return Words(
            f"：$α_{link}$ = 0，只有法向分量，由 ${x}$ 指向 ${p}$",
            f": since $α_{link}$ = 0, it is purely normal and points from ${x}$ to ${p}$",
        )
    return Words("", "")
