"""The first step of every synthesis by K: the angle between the limit positions."""

from __future__ import annotations

from ...algebra.quantity import Quantity, magnitude
from ...designs.quantities import THETA
from ...designs.quantities import K as ADVANCE
from ...words import Words
from .draft import HALF_TURN, ONE, SHEET, Draft


def theta_of(draft: Draft, advance: float) -> Quantity:
    """θ = 180° (K − 1) / (K + 1)."""
    board = draft.board
    board.section(Words("极位夹角", "Angle between the limit positions"))
    board.step(
        Words("由行程速比系数 $K$ 求极位夹角：", "The time ratio $K$ gives the angle between the limit positions:"),
        SHEET,
    )
    draft.shared(ADVANCE, advance)
    k = magnitude("K", board.given(advance, "K"), "")
    return draft.worked(THETA, HALF_TURN * (k - ONE) / (k + ONE))
