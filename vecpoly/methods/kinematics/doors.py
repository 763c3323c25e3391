"""The doors of the methods of motion: for a driver, a dyad, a cylinder with its link, a group taken as a whole."""

from __future__ import annotations

from typing import assert_never

from ...mechanism.groups.assur import Dyad, Group
from ...mechanism.model import Drive
from ...mechanism.rams import Ram
from ..desk import Desk
from ..registry import Door, Stage


def _drive(desk: Desk, drive: Drive) -> None: ...


def _dyad(desk: Desk, dyad: Dyad) -> None: ...


def _ram(desk: Desk, ram: Ram) -> None: ...


def _group(desk: Desk, group: Group) -> None: ...


DRIVES, DYADS, RAMS, GROUPS = Door(_drive), Door(_dyad), Door(_ram), Door(_group)


def draw_drive(desk: Desk, stage: Stage, drive: Drive) -> None:
    """Draw a stage of the driver, by the method for a crank or a slide."""
    DRIVES.find(stage, "slide" if drive.slide else "crank").draw(desk, drive)


def draw_drives(desk: Desk, stage: Stage) -> None:
    """Draw a stage of every driver on the frame; a drive between two moving links is drawn with its group."""
    for drive in desk.mech.drives:
        if not drive.between:
            draw_drive(desk, stage, drive)


def draw_group(desk: Desk, stage: Stage, group: Group) -> None:
    """Draw a stage of a group, by the method for its kind."""
    match group.subject:
        case Dyad() as dyad:
            DYADS.find(stage, group.kind).draw(desk, dyad)
        case Ram() as ram:
            RAMS.find(stage, group.kind).draw(desk, ram)
        case Group() as whole:
            GROUPS.find(stage, group.kind).draw(desk, whole)
        case other:
            assert_never(other)
