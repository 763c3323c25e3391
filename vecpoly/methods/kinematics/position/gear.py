"""A gear whose centre other links hold, or a rack that a gear drives:
it touches what it rolls on at the pitch point."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....mechanism.groups.assur import Group
from ....mechanism.model import FRAME, Circle, Prismatic, Rack, Rolling
from ....mechanism.travel import counted_from
from ....plane import Reals
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..gears.pitch import fixed_gear, letter_pitch_points, partner, rolling_of, wheel
from .standing import said_standing, standing, told_in

_SOURCE = "机械原理, pure rolling: the pitch point lies on the line of centres"


@method(
    stage=Stage.POSITION,
    group="gear",
    source=_SOURCE,
    example="3-1f",
    title=Words("齿轮（行星轮）的位置", "Position of a gear on a held centre"),
)
def position_gear(desk: Desk, group: Group) -> None:
    """The centre C is drawn already; the pitch point H lies on the line of centres, or is the foot of C on the rack."""
    joint, gear = rolling_of(group), group.links[0]
    mine = wheel(joint, gear)
    assert isinstance(mine, Circle)
    desk.board.step(_words(gear, mine.centre, joint.point, _partner(joint, gear)), View.MECHANISM)
    desk.settle_turned(gear, mine.centre, standing(desk, gear))
    desk.board.remark(said_standing(desk, gear))
    letter_pitch_points(desk, (joint,))


@method(
    stage=Stage.POSITION,
    group="rack",
    source=_SOURCE,
    example="pinion-drives-rack",
    title=Words("齿条的位置", "Position of a driven rack"),
)
def position_rack(desk: Desk, group: Group) -> None:
    """The rack's travel along its guide is given;
    the pitch point is the foot of the gear's centre on its pitch line."""
    joint, rack = rolling_of(group), group.links[0]
    slide = next(outer.joint for outer in group.outer if isinstance(outer.joint, Prismatic))
    travel: Reals = next((told_in(desk, one) for one in desk.mech.starts if one.link == rack and one.slide), 0.0)
    pin, c, h = slide.pin, joint.gear.centre, joint.point
    desk.board.step(
        Words(
            f"齿条 {rack} 沿其导路移动：{counted_from(slide).zh}按给定的 $s_{rack}/μ_l$ 定出 ${pin}$；"
            f"自 ${c}$ 向齿条节线作垂线，垂足为啮合点 ${h}$。",
            f"Rack {rack} slides along its guide: step off the given $s_{rack}/μ_l$ "
            f"{counted_from(slide).en} to ${pin}$; the foot of the perpendicular from ${c}$ to its "
            f"pitch line is the pitch point ${h}$.",
        ),
        View.MECHANISM,
    )
    line = desk.guide_line(slide)
    if slide.block == rack:
        foot = desk.board.lay_off(line.at, line.along, desk.mm(1.0) * travel)
        desk.letter(pin, foot + 1j * line.along * desk.mm(slide.offset))
        desk.settle_turned(rack, pin, line.along * np.exp(1j * slide.turn))
    else:
        origin = desk.at[pin] - 1j * line.along * desk.mm(slide.offset) - line.along * desk.mm(1.0) * travel
        first, local = next(iter(desk.mech.link(rack).points.items()))
        axis = line.along * np.exp(-1j * slide.direction)
        desk.letter(first, origin + axis * desk.mm(1.0) * (local - slide.origin))
        desk.settle_turned(rack, first, axis)
    letter_pitch_points(desk, (joint,))


def _partner(joint: Rolling, link: str) -> Words:
    other = partner(joint, link)
    if isinstance(joint.on, Rack):
        return Words("齿条", "the rack")
    if other == FRAME:
        return Words("", "the ") + fixed_gear(joint, link)
    return Words(f"齿轮 {other} ", f"gear {other}")


def _words(gear: str, c: str, h: str, on: Words) -> Words:
    return Words(
        f"以 ${c}$ 为圆心作齿轮 {gear} 的节圆，与{on.zh}相切于 ${h}$。",
        f"About ${c}$ draw the pitch circle of gear {gear}; it touches {on.en} at ${h}$.",
    )
