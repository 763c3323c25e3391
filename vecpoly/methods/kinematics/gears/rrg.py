"""A hinge between a link and a rolling gear, or between two gears:
the gear turns about its pitch point as about a hinge."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Circle, Joint, Revolute, Rolling
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..dyads.rrr import hinge_polygon, opening
from .pitch import pitch_acceleration, pitch_velocity, wheel
from .rolled import image_circle

_SOURCE = "机械原理, pure rolling: the pitch point is the relative instant centre"


@method(
    stage=Stage.VELOCITY,
    group="RRG",
    source=_SOURCE,
    example="3-13",
    title=Words("纯滚动齿轮杆组的速度", "Velocity of a group with a rolling gear"),
)
def velocity_rrg(desk: Desk, d: Dyad) -> None:
    """v_H + v_CH (⊥ CH) = v_P + v_CP (⊥ CP), H the pitch point."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="RRG",
    source=_SOURCE,
    example="rack-on-a-rocker",
    title=Words("纯滚动齿轮杆组的加速度", "Acceleration of a group with a rolling gear"),
)
def acceleration_rrg(desk: Desk, d: Dyad) -> None:
    """a_H + a^n_CH + a^t_CH = a_P + a^n_CP + a^t_CP, H of the gear."""
    _polygon(desk, View.ACCELERATION, d)


@method(
    stage=Stage.VELOCITY,
    group="GRG",
    source=_SOURCE,
    example="",
    title=Words("双滚动齿轮杆组的速度", "Velocity of a group of two rolling gears"),
)
def velocity_grg(desk: Desk, d: Dyad) -> None:
    """v_H + v_CH = v_K + v_CK, H and K the pitch points."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="GRG",
    source=_SOURCE,
    example="",
    title=Words("双滚动齿轮杆组的加速度", "Acceleration of a group of two rolling gears"),
)
def acceleration_grg(desk: Desk, d: Dyad) -> None:
    """a_H + a^n_CH + a^t_CH = a_K + a^n_CK + a^t_CK."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute)
    c = d.inner.point
    arms = [(_seat(desk, view, joint, link), link) for joint, link in ((d.outer_k, d.link_k), (d.outer_j, d.link_j))]
    desk.board.step(opening(view, c, d.link_j, d.link_k), view)
    hinge_polygon(desk, view, c, *arms)
    if view is View.VELOCITY:
        imaged_wheel(desk, d.outer_k, d.link_k)
        imaged_wheel(desk, d.outer_j, d.link_j)


def _seat(desk: Desk, view: View, joint: Joint, link: str) -> str:
    """The point about which the link turns: its hinge, or its pitch point, whose vector is found first."""
    if isinstance(joint, Rolling):
        seat(desk, view, joint, link)
    assert isinstance(joint, Revolute | Rolling)
    return joint.point


def seat(desk: Desk, view: View, joint: Rolling, link: str) -> None:
    """Find the vector of the link's pitch point from what it rolls on."""
    if view is View.VELOCITY:
        pitch_velocity(desk, joint, link)
    else:
        pitch_acceleration(desk, joint, link)


def imaged_wheel(desk: Desk, joint: Joint, link: str) -> None:
    """The circle that is the velocity image of a rolling gear."""
    if isinstance(joint, Rolling) and isinstance(mine := wheel(joint, link), Circle):
        image_circle(desk, link, mine.centre, joint.point)
