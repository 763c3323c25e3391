"""Velocity and acceleration of an RRP group: the pin of a slider is led by a guide, fixed or moving."""

from __future__ import annotations

from ...board.construction import View
from ...mechanism.assur import Dyad
from ...mechanism.model import FRAME, Prismatic, Revolute
from ...names import At
from ...vector.equation import Equation
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method
from .chains import coincident_tip, never_turns, sliding_chain, solve, turning_chain
from .image import images_of_link
from .rrr import opening, total, turn_of_link
from .turning import same_turn

_SOURCE = "机械原理, relative motion of two points of one link and of coincident points"


@method(stage=Stage.VELOCITY, group="RRP", source=_SOURCE, example="3-5",
        title=Words("RRP 杆组的速度", "Velocity of an RRP group"))
def velocity_rrp(desk: Desk, d: Dyad) -> None:
    """v_C (∥ guide) = v_P + v_CP (⊥ CP); on a moving guide v_Cg + v^r stands on the left."""
    _polygon(desk, View.VELOCITY, d)


@method(stage=Stage.ACCELERATION, group="RRP", source=_SOURCE, example="3-5",
        title=Words("RRP 杆组的加速度", "Acceleration of an RRP group"))
def acceleration_rrp(desk: Desk, d: Dyad) -> None:
    """a_C (∥ guide) = a_P + a^n_CP + a^t_CP; on a moving guide a_Cg + a^k + a^r stands on the left."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Prismatic)
    c, p = d.inner.point, d.outer_j.point
    base = coincident_tip(desk, view, c, d.parent_k)
    desk.board.step(opening(view, c, d.link_j, d.link_k), view)
    led = sliding_chain(desk, view, At(c), base, d.outer_k, d.parent_k)
    swung = turning_chain(desk, view, At(c), p, d.link_j)
    own = len(led) == 1 or (view is View.VELOCITY and len(swung) == 1)
    left, right = (led, swung) if len(led) <= len(swung) else (swung, led)
    eq = Equation(left=left, right=right, total="" if own else total(desk, view, At(c), 2))
    closed = solve(desk, view, eq, At(c))
    turn_of_link(desk, view, closed.ends, At(c), p, d.link_j)
    if d.parent_k == FRAME:
        never_turns(desk, d.link_k)
    else:
        same_turn(desk, d.link_k, d.parent_k, view, said=not d.outer_k.pin_in_slot)
    for link in (d.link_j, d.link_k):
        images_of_link(desk, view, link)
