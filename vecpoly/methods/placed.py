"""The mechanism in other positions of its drive, as an exact hand draws it on scratch paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ..errors import NoMethodError
from ..mechanism.groups.assur import Group
from ..mechanism.model import Mechanism
from ..words import Words
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


def refuse_told(mech: Mechanism) -> None:
    """NoMethodError where a gear, or an arm that gears move, is told in the mechanism's own position only, so that no
    drawing knows how it stands in others."""
    if mech.starts:
        raise NoMethodError(
            Words(
                "齿轮（或其系杆）的位置只在图示位置给定，不能由图得出其在原动件其他位置时的位置；请用 vecpoly exact",
                "gears, or arms that gears move, are told in the given position only, and no drawing on file follows "
                "them to other positions of the drive; use 'vecpoly exact'",
            ),
            code="no-method",
        )
