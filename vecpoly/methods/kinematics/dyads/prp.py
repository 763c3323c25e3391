"""Velocity and acceleration of a PRP group: two sliders pinned together, each on its own guide."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....names import At
from ....vector.equation import Equation
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import coincident_tip, never_turns, sliding_chain, solve
from ..image import images_of_link
from ..turning import same_turn
from .rrr import opening, total

_SOURCE = "机械原理, coincident points of two links"


@method(
    stage=Stage.VELOCITY,
    group="PRP",
    source=_SOURCE,
    example="3-11",
    title=Words("PRP 杆组的速度", "Velocity of a PRP group"),
)
def velocity_prp(desk: Desk, d: Dyad) -> None:
    """v_Bp + v^r (∥ first guide) = v_Bq + v^r (∥ second guide); a fixed guide gives v_B itself."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="PRP",
    source=_SOURCE,
    example="3-11",
    title=Words("PRP 杆组的加速度", "Acceleration of a PRP group"),
)
def acceleration_prp(desk: Desk, d: Dyad) -> None:
    """a_Bp + a^k + a^r = a_Bq + a^k + a^r."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Prismatic) and isinstance(d.outer_k, Prismatic)
    b = d.inner.point
    slides = ((d.outer_j, d.parent_j, d.link_j), (d.outer_k, d.parent_k, d.link_k))
    bases = [coincident_tip(desk, view, b, parent) for _, parent, _ in slides]
    desk.board.step(opening(view, b, d.link_j, d.link_k), view)
    sides = sorted(
        (sliding_chain(desk, view, At(b), base, *slide[:2]) for base, slide in zip(bases, slides, strict=True)), key=len
    )
    front = "" if len(sides[0]) == 1 else total(desk, view, At(b), 2)
    solve(desk, view, Equation(left=sides[0], right=sides[1], total=front), At(b))
    for joint, parent, link in slides:
        if parent == FRAME:
            never_turns(desk, link)
        else:
            same_turn(desk, link, parent, view, said=not joint.pin_in_slot)
        images_of_link(desk, view, link)
