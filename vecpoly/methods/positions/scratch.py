"""Paper that is thrown away, for the mechanism in one position."""

from __future__ import annotations

from collections.abc import Mapping

from ...board.board import Board, Scratch
from ...board.construction import Scale, View
from ...board.hand import Hand, hand
from ...board.place import views
from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism
from ...plane import Reals
from ..coincident import coincident_letters
from ..desk import Desk
from .sides import Sides

SIZE = 100.0  # mm: how large mechanism and first vector are drawn


def position_desk(
    mech: Mechanism,
    groups: tuple[Group, ...],
    by: Hand | None = None,
    sides: Sides | None = None,
    ahead: Mapping[str, Reals] | None = None,
) -> Desk:
    """With the fixed points on it; an exact hand's where nothing is said; sides: choices that are carried on; ahead: of
    the drive and of open links, how far on they are in places that are drawn at once, as if each were another hand's.
    """
    rate = abs(mech.drive.rate) * (1.0 if mech.drive.slide else mech.scale)
    sizes = dict.fromkeys(views(), 1.0) | {View.MECHANISM: mech.scale / SIZE, View.VELOCITY: rate / SIZE}
    board: Board = Scratch(by or hand("exact"), {view: Scale.of(view, size) for view, size in sizes.items()})
    board.beside = ahead or {}
    desk = Desk(board=board, mech=mech, coincident=coincident_letters(mech, groups), sides=sides or Sides())
    for name, at in mech.frame.items():
        desk.letter(name, at * desk.mm(1.0))
    return desk
