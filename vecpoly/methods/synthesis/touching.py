"""A pin where two arcs meet, or an arc and a guide, of a linkage that all but stands at its change point: where they
miss each other by less than can be drawn, they touch."""

from __future__ import annotations

import numpy as np

from ...board.board import Board
from ...errors import AssemblyError
from ...plane import Line, Points, Reals, nominal, unit
from ...words import Words

MISSED = 1.5  # mm: what three lengths that were read may be off together


def third(board: Board, b: Points, coupler: Reals, d: Points, rocker: Reals, name: str) -> Points:
    """C on the left of BD; of a hand whose arcs miss, in line with B and D."""
    try:
        return board.arcs(b, coupler, d, rocker, _finding(name))[0]
    except AssemblyError:
        span, one, other = (float(nominal(length)) for length in (np.abs(d - b), coupler, rocker))
        if max(span - one - other, abs(one - other) - span) > MISSED:
            raise
        board.remark(
            Words(
                f" 两弧相差甚微，图上只能看作相切：${name}$ 在直线 $BD$ 上。",
                f" The arcs miss by less than can be drawn: they touch, and ${name}$ lies on the line $BD$.",
            )
        )
        base = np.abs(d - b)
        cosine = (np.square(base) + np.square(coupler) - np.square(rocker)) / (2 * base * coupler)
        at_b = np.arccos(np.minimum(1.0, np.maximum(-1.0, cosine)))
        return board.lay_off(b, unit(d - b) * np.exp(1j * at_b), coupler)


def on_guide(board: Board, guide: Line, b: Points, height: Reals, coupler: Reals, name: str) -> Points:
    """C on the guide ahead of B, which stands above the guide's point by this height; of a hand whose arc does not
    reach the guide, below B."""
    try:
        return board.arc_on_line(guide, b, coupler, _finding(name))[0]
    except AssemblyError:
        if float(nominal(height)) - float(nominal(coupler)) > MISSED:
            raise
        board.remark(
            Words(
                f" 弧与导路相差甚微，图上只能看作相切：${name}$ 在 $B$ 的正下方。",
                f" The arc misses the guide by less than can be drawn: it touches it, and ${name}$ lies below $B$.",
            )
        )
        ahead = np.sqrt(np.maximum(0.0, np.square(coupler) - np.square(height)))
        return board.lay_off(guide.at, guide.along, ahead)


def _finding(name: str) -> Words:
    return Words(f"求 ${name}$", f"finding ${name}$")
