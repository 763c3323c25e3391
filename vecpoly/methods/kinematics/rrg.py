"""Velocity of a group with a rolling gear: at the pitch point both bodies have one velocity, so it acts as a hinge there."""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...board.marks import Arc, Role
from ...mechanism.assur import Dyad
from ...mechanism.model import FRAME, Revolute, Rolling
from ...names import At
from ...plane import nominal
from ...quantity import magnitude
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method
from .image import imaged
from .rrr import hinge_polygon, opening


@method(stage=Stage.VELOCITY, group="RRG", source="机械原理, pure rolling: the pitch point is the instant centre", example="3-13",
        title=Words("纯滚动齿轮杆组的速度", "Velocity of a group with a rolling gear"))
def velocity_rrg(desk: Desk, d: Dyad) -> None:
    """v_H + v_CH (⊥ CH) = v_P + v_CP (⊥ CP), H the pitch point."""
    joint = d.outer_k
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(joint, Rolling)
    view, c, p, h = View.VELOCITY, d.inner.point, d.outer_j.point, joint.point
    _pitch_point(desk, joint, d)
    desk.lengths[frozenset((h, c))] = magnitude(f"r_{d.link_k}", joint.gear.radius, "m")
    desk.board.step(opening(view, c, d.link_j, d.link_k), view)
    hinge_polygon(desk, view, c, (h, d.link_k), (p, d.link_j))
    _image_circle(desk, d.link_k, c, h)


def _pitch_point(desk: Desk, joint: Rolling, d: Dyad) -> None:
    """The velocity of the pitch point, from the body on which the gear rolls."""
    h = joint.point
    if d.parent_k == FRAME:
        desk.centres.add(h)
        desk.board.step(Words(f"齿轮 {d.link_k} 在固定齿条上纯滚动，接触点 ${h}$ 的速度为零（绝对瞬心），${h.lower()}$ 与极点 $p$ 重合。",
                              f"Gear {d.link_k} rolls on a fixed rack: its contact ${h}$ has no velocity (instant centre), ${h.lower()}$ lies at the pole $p$."), View.VELOCITY)
    elif not desk.has_tip(View.VELOCITY, At(h)):
        imaged(desk, View.VELOCITY, d.parent_k, At(h))


def _image_circle(desk: Desk, link: str, c: str, h: str) -> None:
    """The image of a gear's pitch circle is a circle about the tip of its centre."""
    centre, rim = (complex(nominal(desk.tip(View.VELOCITY, At(x)))) for x in (c, h))
    desk.board.mark(View.VELOCITY, Arc(centre=centre, radius=abs(rim - centre), start=0.0, sweep=2 * np.pi, role=Role.CENTRE))
    desk.board.remark(Words(f"以 ${c.lower()}$ 为圆心、过 ${h.lower()}$ 的圆即齿轮 {link} 的速度影像。",
                            f" The circle about ${c.lower()}$ through ${h.lower()}$ is the velocity image of gear {link}."))
