"""Velocity and acceleration of an RRP group: the pin of a slider is led by a guide, fixed or moving."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....names import At
from ....vector.equation import Equation
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import coincident_tip, never_turns, sliding_chain, solve, turning_chain
from ..image import images_of_link
from ..turning import same_turn
from .rrr import opening, total, turn_of_link

_SOURCE = "机械原理, relative motion of two points of one link and of coincident points"


@method(
    stage=Stage.VELOCITY,
    group="RRP",
    source=_SOURCE,
    example="3-5",
    title=Words("RRP 杆组的速度", "Velocity of an RRP group"),
)
def velocity_rrp(desk: Desk, d: Dyad) -> None:
    """v_C (∥ guide) = v_P + v_CP (⊥ CP); on a moving guide v_Cg + v^r stands on the left."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="RRP",
    source=_SOURCE,
    example="3-5",
    title=Words("RRP 杆组的加速度", "Acceleration of an RRP group"),
)
def acceleration_rrp(desk: Desk, d: Dyad) -> None:
    """a_C (∥ guide) = a_P + a^n_CP + a^t_CP; on a moving guide a_Cg + a^k + a^r stands on the left."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Prismatic)
    slider_polygon(desk, view, d.inner.point, (d.outer_k, d.link_k, d.parent_k), (d.outer_j.point, d.link_j))


def slider_polygon(desk: Desk, view: View, c: str, slide: tuple[Prismatic, str, str], arm: tuple[str, str]) -> None:
    """The vector of C of a slider (joint, link,
    what it slides along) and of a link that turns about a known point (point, link)."""
    (joint, slider, parent), (p, link) = slide, arm
    base = coincident_tip(desk, view, c, parent)
    desk.board.step(opening(view, c, link, slider), view)
    led = sliding_chain(desk, view, At(c), base, joint, parent)
    swung = turning_chain(desk, view, At(c), p, link)
    own = len(led) == 1 or (view is View.VELOCITY and len(swung) == 1)
    left, right = (led, swung) if len(led) <= len(swung) else (swung, led)
    eq = Equation(left=left, right=right, total="" if own else total(desk, view, At(c), 2))
    closed = solve(desk, view, eq, At(c))
    turn_of_link(desk, view, closed.ends, At(c), p, link)
    if parent == FRAME:
        never_turns(desk, slider)
    else:
        same_turn(desk, slider, parent, view, said=not joint.pin_in_slot)
    for name in (link, slider):
        images_of_link(desk, view, name)
