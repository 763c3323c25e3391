"""能量指示图: works one after the other as arrows, up and down from a base line to which they must return."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce

import numpy as np

from ...algebra.quantity import Quantity
from ...board.board import Board
from ...board.construction import Place
from ...board.paper.marks import Dot, Role
from ...plane import Points, Reals, nominal

PACE, MARGIN = 9.0, 6.0  # mm from arrow to arrow, and beside the first and the last
SMALL = 1e-9  # of the whole: what is no misreading


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """The tips of the arrows with their letters; the highest and the lowest; the energy between them, read there."""

    tips: tuple[Points, ...]
    letters: tuple[str, ...]
    top: int
    bottom: int
    swing: Quantity

    def energy(self, board: Board, place: Place, number: int) -> Reals:
        """Of a tip over the base line (J)."""
        mu = board.scale_of(place).value
        return (self.tips[number] - self.tips[0]).imag * mu


def shared_out(works: Sequence[Reals]) -> tuple[Reals, tuple[Reals, ...]]:
    """What they miss zero by, and the works without it: each gives its share, as large as itself."""
    left: Reals = 0.0
    whole: Reals = 0.0
    for work in works:
        left, whole = left + work, whole + np.abs(work)
    return left, tuple(work - left * np.abs(work) / whole for work in works)


def indicator(board: Board, place: Place, works: Sequence[Reals], letters: Sequence[str], symbol: str) -> Bar:
    """Draw the bar and read the energy between its ends."""
    wide = PACE * len(works) + MARGIN
    board.join(place, -MARGIN + 0j, wide + 0j, Role.CENTRE)
    tips = _arrows(board, place, works, letters)
    heights = [round(complex(nominal(tip)).imag, 9) for tip in tips]
    top, bottom = heights.index(max(heights)), heights.index(min(heights))
    every = [tip.imag for tip in tips]
    ends = [
        _level(board, place, complex(nominal(tips[n])).real + 1j * reduce(far, every), wide)
        for n, far in ((top, np.maximum), (bottom, np.minimum))
    ]
    for end, speed in zip(ends, ("ω_{max}", "ω_{min}"), strict=True):
        board.plot(place, end, speed, Dot.NONE)
    board.arrow(place, ends[1], ends[0], Role.RESULT, key="dW_max", label=symbol)
    read = board.measure(ends[1], ends[0], f"{letters[bottom]} {letters[top]}")
    return Bar(tips=tips, letters=tuple(letters), top=top, bottom=bottom, swing=read)


def _arrows(board: Board, place: Place, works: Sequence[Reals], letters: Sequence[str]) -> tuple[Points, ...]:
    tip: Points = 0j
    tips = [tip]
    board.plot(place, tip, letters[0], Dot.POINT)
    for n, (work, name) in enumerate(zip(works, letters[1:], strict=True), 1):
        tail = tip + PACE if n > 1 else tip
        if n > 1:
            board.join(place, tip, tail, Role.CONSTRUCTION)
        board.given_size(f"W_{n}", work, "J")
        rises = 1 if float(nominal(work)) >= 0 else -1
        tip = board.lay_off(tail, 1j * rises, rises * board.to_paper(place, work), key=f"W_{n}")
        board.arrow(place, tail, tip, Role.RESULT, label=f"W_{n}")
        board.plot(place, tip, name, Dot.POINT)
        tips.append(tip)
    return tuple(tips)


def _level(board: Board, place: Place, tip: Points, wide: float) -> Points:
    """The height of a tip carried to the right."""
    end = board.parallel(tip, 1 + 0j)
    at = end.at + end.along * (wide - complex(nominal(tip)).real)
    board.join(place, tip, at, Role.CONSTRUCTION)
    return at
