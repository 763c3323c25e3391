"""The mechanism in other positions of its drive, as an exact hand draws it on scratch paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..mechanism.groups.assur import Group
from .desk import Desk
from .kinematics.diagram.cam import letter_contacts
from .kinematics.doors import draw_drives, draw_group
from .registry import Stage


def placed(desk: Desk, groups: Sequence[Group], position: float) -> Desk:
    """The position diagram for this position of the drive (rad, or m), at the same scale.

    Raises AssemblyError where it cannot be assembled, DeadPointError likewise.
    """
    drive = replace(desk.mech.drive, position=position)
    scratch = Desk(
        board=desk.board.scratch(),
        mech=replace(desk.mech, drives=(drive, *desk.mech.drives[1:])),
        coincident=desk.coincident,
        shapes=desk.shapes,
    )
    for name, at in scratch.mech.frame.items():
        scratch.letter(name, at * scratch.mm(1.0))
    draw_drives(scratch, Stage.POSITION)
    for group in groups:
        draw_group(scratch, Stage.POSITION, group)
        letter_contacts(scratch, group.links)
    return scratch
