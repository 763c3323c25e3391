"""The driving link in its given position: φ_1 laid off with the protractor, or the travel along the guide."""

from __future__ import annotations

import math

import numpy as np

from ...board.construction import View
from ...board.marks import AngleMark, Role, Segment
from ...mechanism.model import FRAME, Drive, Prismatic
from ...plane import nominal
from ...quantity import number
from ...words import Words
from ..desk import Desk, Pose
from ..registry import Stage, method


@method(
    stage=Stage.POSITION, group="crank", source="机械原理, kinematic diagrams", example="3-9",
    title=Words("原动件的位置", "Position of the driving link"),
)
def position_crank(desk: Desk, drive: Drive) -> None:
    """Lay off φ from the x axis at the fixed pivot, then l_AB / μ_l along it."""
    link, board = desk.mech.link(drive.link), desk.board
    pivot, others = desk.crank(drive.link)
    phi = number(math.degrees(drive.position), 6)
    fixed, fixed_en = "$、$".join(desk.mech.frame), "$, $".join(desk.mech.frame)
    length = f"，量取 ${pivot}{others[0]} = l_{pivot}{others[0]}/μ_l$" if others else ""
    length_en = f" and step off ${pivot}{others[0]} = l_{pivot}{others[0]}/μ_l$ on it" if others else ""
    board.step(
        Words(f"取 $μ_l$，按坐标定出固定点 ${fixed}$；过固定铰链 ${pivot}$ 作与 $x$ 轴成 $φ_{drive.link}$ = {phi}° 的直线，为构件 {drive.link}{length}。",
              f"Place the fixed point{'s' if len(desk.mech.frame) > 1 else ''} ${fixed_en}$ to the scale $μ_l$; through the fixed pivot ${pivot}$ draw link {drive.link} at $φ_{drive.link}$ = {phi}° to the $x$ axis{length_en}."),
        View.MECHANISM,
    )
    along = board.turn(complex(np.exp(1j * drive.position)))
    local = link.points[pivot]
    desk.pose[drive.link] = Pose(desk.at[pivot] - along * desk.mm(1.0) * local, along)
    for name in others:
        base = desk.place(drive.link, link.points[name])
        desk.letter(name, base + along * board.hand.carry(0.0))
    desk.settle_rest(drive.link)
    _angle(desk, pivot, drive, max((abs(desk.mm(abs(link.points[p] - local))) for p in others), default=40.0))


@method(
    stage=Stage.POSITION, group="slide", source="机械原理, kinematic diagrams", example="",
    title=Words("移动原动件的位置", "Position of the driving slider"),
)
def position_slide(desk: Desk, drive: Drive) -> None:
    """Step off the travel along the fixed guide."""
    joint = next(j for j in desk.mech.joints
                 if isinstance(j, Prismatic) and j.block == drive.link and j.guide == FRAME)
    board = desk.board
    board.step(
        Words(f"沿固定导路量取构件 {drive.link} 的位移 $s/μ_l$，得 ${joint.pin}$。",
              f"Step off the travel $s/μ_l$ of link {drive.link} along its fixed guide: ${joint.pin}$."),
        View.MECHANISM,
    )
    line = desk.locus(joint, drive.link, joint.pin)
    desk.letter(joint.pin, board.lay_off(line.at, line.along, desk.mm(drive.position)))
    desk.settle_turned(drive.link, joint.pin, line.along * np.exp(1j * joint.turn))


def say_fixed_points(desk: Desk) -> None:
    """The first step where no link is driven against the frame."""
    fixed, fixed_en = "$、$".join(desk.mech.frame), "$, $".join(desk.mech.frame)
    desk.board.step(Words(f"取 $μ_l$，按坐标定出固定点 ${fixed}$。",
                          f"Place the fixed point{'s' if len(desk.mech.frame) > 1 else ''} ${fixed_en}$ to the scale $μ_l$."), View.MECHANISM)


def say_welded(desk: Desk) -> None:
    """Rollers are drawn as parts of the links that carry them."""
    for roller, host in desk.mech.welded:
        desk.board.step(Words(f"滚子 {roller} 绕其销轴的转动为局部自由度，将滚子与构件 {host} 视为焊成一体。",
                              f"Roller {roller} turns idly about its pin, a local freedom: it is taken as welded to link {host}."), View.MECHANISM)


def swept(position: float) -> float:
    """How far the arc of an angle runs round: as far as is stated, less full turns."""
    return math.fmod(position, 2 * math.pi)


def _angle(desk: Desk, pivot: str, drive: Drive, reach: float) -> None:
    """Mark the angle φ at the pivot: the arc runs in the sense of the stated value."""
    at = complex(nominal(desk.at[pivot]))
    radius = min(11.0, 0.45 * reach)
    desk.board.mark(
        View.MECHANISM,
        Segment(a=at, b=at + radius + 3.5, role=Role.CENTRE),
        AngleMark(at=at, radius=radius, start=0.0, sweep=swept(drive.position), label=f"φ_{drive.link}"),
    )
