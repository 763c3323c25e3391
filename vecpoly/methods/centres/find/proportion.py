"""What goes as a ratio of two lengths of the figure, which somebody may turn upside down."""

from __future__ import annotations

from ....algebra.quantity import Expr
from ....board.board import Board
from ....board.otherwise.formulas import upside_down
from ....board.otherwise.slip import Mistake
from ....plane import Reals


def proportioned(board: Board, key: str, value: Reals, ratio: Expr, unit: str) -> Reals:
    """The value with which the construction goes on; a mistaken hand divides by the ratio it ought to multiply by."""
    chance = upside_down(ratio)
    hands = [hand for hand, slip in board.amended.wrong(board.here, key) if slip.mistake is Mistake.INVERTED]
    over = board.amended.altered(value, [(hand, value / ratio.value**2) for hand in hands])
    return board.conclude(key, over, unit, chances=() if chance is None else (chance,))
