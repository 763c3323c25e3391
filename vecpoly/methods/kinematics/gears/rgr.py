"""Two links hinged to known ones that roll on each other: a rack on a crank pin that turns a pinion."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Revolute, Rolling
from ....names import At, Kind, Rel
from ....vector.equation import Equation
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import solve, turning_chain
from ..dyads.rrr import hinge_polygon, opening, total, turn_of_link
from ..image import images_of_link
from ..turning import angular_acceleration
from .pitch import rolling_term
from .rrg import imaged_wheel

_SOURCE = "机械原理, pure rolling: the pitch point is the relative instant centre"


@method(
    stage=Stage.VELOCITY,
    group="RGR",
    source=_SOURCE,
    example="crank-rack-pinion",
    title=Words("齿条—齿轮杆组的速度", "Velocity of a group of a pinned rack and a pinion"),
)
def velocity_rgr(desk: Desk, d: Dyad) -> None:
    """v_P + v_HP (⊥ PH) = v_Q + v_HQ (⊥ QH), H the pitch point."""
    assert isinstance(d.inner, Rolling) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    h = d.inner.point
    desk.board.step(opening(View.VELOCITY, h, d.link_j, d.link_k), View.VELOCITY)
    hinge_polygon(desk, View.VELOCITY, h, (d.outer_j.point, d.link_j), (d.outer_k.point, d.link_k))
    for link in (d.link_j, d.link_k):
        imaged_wheel(desk, d.inner, link)


@method(
    stage=Stage.ACCELERATION,
    group="RGR",
    source=_SOURCE,
    example="crank-rack-pinion",
    title=Words("齿条—齿轮杆组的加速度", "Acceleration of a group of a pinned rack and a pinion"),
)
def acceleration_rgr(desk: Desk, d: Dyad) -> None:
    """a_P + a^n_HP + a^t_HP + a_HkHj = a_Q + a^n_HQ + a^t_HQ."""
    assert isinstance(d.inner, Rolling) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    h, p, q, view = d.inner.point, d.outer_j.point, d.outer_k.point, View.ACCELERATION
    one, two = At(h, d.link_j), At(h, d.link_k)
    desk.board.step(opening(view, h, d.link_j, d.link_k), view)
    left = (*turning_chain(desk, view, one, p, d.link_j), rolling_term(desk, d.inner, d.link_k, tip="r′"))
    right = turning_chain(desk, view, two, q, d.link_k)
    closed = solve(desk, view, Equation(left=left, right=right, total=total(desk, view, two, 2)), two)
    rel = Rel(Kind.AT, one, None if desk.at_rest(view, At(p)) else At(p))
    angular_acceleration(
        desk, d.link_j, p, h, closed.ends[rel.key], f"r′ {desk.tip_label(view, two)}", desk.symbol(rel)
    )
    turn_of_link(desk, view, closed.ends, two, q, d.link_k)
    for link in (d.link_j, d.link_k):
        images_of_link(desk, view, link)
