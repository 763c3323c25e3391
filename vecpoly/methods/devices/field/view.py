"""The figures of field balancing: vibrations as vectors, and the rotor from its end with its weights."""

from __future__ import annotations

from cmath import rect
from math import radians

from ....board.construction import View
from ....board.paper.marks import AngleMark, Dot, Lump, Role
from ....board.place import view_named
from ....devices.balancing.field import FieldBalancing
from ....devices.balancing.vibration import MICRON
from ....diagram.single import disc
from ....words import Words
from ..bench import Bench
from ..rotor.scales import AXIS, END_VIEW, LUMP

ANGLE_AT = 10.0  # mm: radius at which the angle of the correction is marked


def vibrations(device: FieldBalancing) -> View:
    """Displacements, or velocities."""
    return view_named("vibration" if device.unit == MICRON[0] else "vibration-speed")


def rotor_seen(bench: Bench, device: FieldBalancing) -> None:
    """The rotor with its trial weights."""
    board, mm = bench.board, bench.board.scale_of(END_VIEW).value
    board.section(Words("转子", "The rotor"))
    board.step(
        Words(
            "画出转子端视图，标出试重的方位（逆时针为正）。",
            "Draw the rotor from its end, with the trial weights (counter-clockwise).",
        ),
        END_VIEW,
    )
    reach = max(device.correct.r.si, *(trial.r.si for trial in device.trials)) / mm
    board.circle(END_VIEW, 0j, reach, Role.CENTRE)
    for way in (1, 1j):
        board.join(END_VIEW, -way * (reach + AXIS), way * (reach + AXIS), Role.CENTRE)
    board.plot(END_VIEW, 0j, "O", Dot.JOINT)
    for i, trial in enumerate(device.trials, 1):
        at = rect(trial.r.si / mm, trial.at.si)
        board.depict(END_VIEW, disc(f"trial {i}", at, LUMP, Lump.TRIAL))
        board.plot(END_VIEW, at, f"{i}" if len(device.trials) > 1 else "m_t", Dot.NONE)


def weight_seen(bench: Bench, device: FieldBalancing, degrees: float, label: str, angle: str) -> None:
    """The correction, drawn into the end view, and its angle; a second one outside that of the first."""
    board = bench.board
    marked = sum(isinstance(mark, AngleMark) for mark in board.marks(END_VIEW))
    board.angle(END_VIEW, 0j, 1 + 0j, radians(degrees), ANGLE_AT * (1 + marked), angle)
    at = rect(device.correct.r.si / board.scale_of(END_VIEW).value, radians(degrees))
    board.join(END_VIEW, 0j, at, Role.HIDDEN)
    board.circle(END_VIEW, at, LUMP, Role.RESULT)
    board.plot(END_VIEW, at, label, Dot.NONE)
