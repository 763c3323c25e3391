"""A hinge between a slider and a rolling gear:
the gear turns about its pitch point as about a hinge, the slider is led."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute, Rolling
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..dyads.rrp import slider_polygon
from .rrg import imaged_wheel, seat

_SOURCE = "机械原理, pure rolling; relative motion of coincident points"


@method(
    stage=Stage.VELOCITY,
    group="PRG",
    source=_SOURCE,
    example="",
    title=Words("滑块—齿轮杆组的速度", "Velocity of a group of a slider and a rolling gear"),
)
def velocity_prg(desk: Desk, d: Dyad) -> None:
    """v_C (∥ guide) = v_H + v_CH (⊥ CH), H the pitch point."""
    _polygon(desk, View.VELOCITY, d)
    imaged_wheel(desk, d.outer_k, d.link_k)


@method(
    stage=Stage.ACCELERATION,
    group="PRG",
    source=_SOURCE,
    example="",
    title=Words("滑块—齿轮杆组的加速度", "Acceleration of a group of a slider and a rolling gear"),
)
def acceleration_prg(desk: Desk, d: Dyad) -> None:
    """a_C (∥ guide) = a_H + a^n_CH + a^t_CH, H of the gear."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Prismatic) and isinstance(d.outer_k, Rolling)
    seat(desk, view, d.outer_k, d.link_k)
    slider_polygon(desk, view, d.inner.point, (d.outer_j, d.link_j, d.parent_j), (d.outer_k.point, d.link_k))
