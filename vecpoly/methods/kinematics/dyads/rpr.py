"""Velocity and acceleration of an RPR group: a guide that swings about Q and a block on the pin P;
coincident points at P.

The guide's own point under P (on the link, or on the expanded link 扩大构件 where the guide passes P at an offset) is
called P_g, the block's P_b:  v_Pg = v_Q + v_PgQ = v_Pb + v_PgPb,
 a_Q + a^n + a^t = a_Pb + a^k + a^r,  a^k = 2 ω_g v_PgPb.
"""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....names import At, Kind, Rel
from ....vector.equation import Equation, Term
from ....words import Words
from ...desk import QUANTITY, Desk
from ...registry import Stage, method
from ..chains import solve, turning_chain
from ..image import images_of_link, letter_at_pole
from ..terms import coriolis, known, sliding
from ..turning import same_turn
from .rrr import total, turn_of_link

_SOURCE = "机械原理, coincident points of two links, Coriolis acceleration"


@method(
    stage=Stage.VELOCITY,
    group="RPR",
    source=_SOURCE,
    example="3-9",
    title=Words("RPR 杆组的速度", "Velocity of an RPR group"),
)
def velocity_rpr(desk: Desk, d: Dyad) -> None:
    """v_Q + v_PgQ (⊥ QP) = v_Pb + v_PgPb (∥ guide)."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="RPR",
    source=_SOURCE,
    example="3-9",
    title=Words("RPR 杆组的加速度", "Acceleration of an RPR group"),
)
def acceleration_rpr(desk: Desk, d: Dyad) -> None:
    """a_Q + a^n_PgQ + a^t_PgQ = a_Pb + a^k_PgPb + a^r_PgPb."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    joint = d.inner
    assert isinstance(joint, Prismatic) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    pins = {d.link_j: d.outer_j.point, d.link_k: d.outer_k.point}
    g, b = joint.guide, joint.block
    q, p = pins[g], pins[b]
    to, ref = At(p, g), At(p, b)
    desk.board.step(_opening(desk, view, to, ref, joint), view)
    swung = turning_chain(desk, view, to, q, g)
    eq = Equation(left=swung, right=_slid(desk, view, to, ref, joint), total=total(desk, view, to, len(swung)))
    closed = solve(desk, view, eq, to)
    turn_of_link(desk, view, closed.ends, to, q, g)
    same_turn(desk, b, g, view, said=not joint.pin_in_slot)
    for link in (g, b):
        images_of_link(desk, view, link)


def _slid(desk: Desk, view: View, to: At, ref: At, joint: Prismatic) -> tuple[Term, ...]:
    """v_Pb + v_PgPb, or a_Pb + a^k + a^r."""
    front, tail = known(desk, view, ref), desk.canonical(ref)
    letter_at_pole(desk, view, ref)
    if view is View.VELOCITY:
        return (front, sliding(desk, Rel(Kind.V, to, tail), joint))
    return (front, coriolis(desk, to, tail, joint.guide), sliding(desk, Rel(Kind.AR, to, tail), joint))


def _opening(desk: Desk, view: View, to: At, ref: At, joint: Prismatic) -> Words:
    kind, kind_en = QUANTITY[view].zh, QUANTITY[view].en
    a, b = desk.name(to), desk.name(ref)
    block = desk.coincident.get(to.point, joint.block)
    words = Words(
        f"取构件 {joint.guide} 与构件 {block} 在 ${to.point}$ 处的重合点 ${a}$、${b}$，列{kind}矢量方程并作图。",
        f"Links {joint.guide} and {block} have the coincident points ${a}$ and ${b}$ at "
        f"${to.point}$: write the vector equation of the {kind_en} and draw it.",
    )
    if view is View.VELOCITY and abs(desk.offset(joint, joint.block, to.point)) > 1e-12:
        words = (
            Words(
                f"导路不通过 ${to.point}$，将构件 {joint.guide} 扩大至包含 ${to.point}$ 点（扩大构件法）。",
                f"The guide does not pass through ${to.point}$: extend link {joint.guide} so that it "
                f"contains ${to.point}$. ",
            )
            + words
        )
    return words
