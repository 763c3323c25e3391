"""A gear whose centre other links hold: it touches the gear or rack on which it rolls at the pitch point."""

from __future__ import annotations

from ...board.construction import View
from ...mechanism.assur import Group
from ...mechanism.model import FRAME, Rack, Rolling
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method


@method(stage=Stage.POSITION, group="gear", source="机械原理, pure rolling: the pitch point lies on the line of centres", example="3-1f",
        title=Words("齿轮（行星轮）的位置", "Position of a gear on a held centre"))
def position_gear(desk: Desk, group: Group) -> None:
    """The centre C is drawn already; the pitch point H lies on the line of centres, or is the foot of C on the rack."""
    joint = next(outer.joint for outer in group.outer if isinstance(outer.joint, Rolling))
    gear, h = group.links[0], joint.point
    mine = joint.gear.link == gear
    c = joint.gear.centre if mine or isinstance(joint.on, Rack) else joint.on.centre
    desk.board.step(_words(gear, c, h, _partner(joint, joint.on.link if mine else joint.gear.link)), View.MECHANISM)
    desk.settle_turned(gear, c, 1 + 0j)
    desk.at[h] = desk.contact(joint)


def _partner(joint: Rolling, other: str) -> Words:
    if isinstance(joint.on, Rack):
        return Words("齿条", "the rack")
    return Words("固定的齿轮", "the fixed gear") if other == FRAME else Words(f"齿轮 {other} ", f"gear {other}")


def _words(gear: str, c: str, h: str, on: Words) -> Words:
    return Words(f"以 ${c}$ 为圆心作齿轮 {gear} 的节圆，与{on.zh}相切于 ${h}$。", f"About ${c}$ draw the pitch circle of gear {gear}; it touches {on.en} at ${h}$.")
