"""Paper that nobody looks at: passes of an approximation of which only what they measured counts."""

from __future__ import annotations

from . import acts as done
from .board import Board, Scratch
from .hand import hand as hand_of


class Unseen(Scratch):
    """Scratch paper on which no ink stays, so that nobody seeks free places on its figures."""

    seen = False

    def ink(self, act: done.Act) -> None:
        """Left out."""


def unseen(board: Board) -> Board:
    """Such paper for an exact hand, with the scales and the readings of a sheet."""
    under = Unseen(hand_of("exact"), board.scales)
    under.ledger = board.ledger.below()
    return under
