"""Velocity and acceleration of an RPP group:
a pinned block in the slot of a link that itself slides (sine mechanism)."""

from __future__ import annotations

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....names import At, Kind, Rel, omega
from ....vector.equation import Equation, Term
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..chains import coincident_tip, never_turns, sliding_chain, solve
from ..image import images_of_link
from ..terms import coriolis, known, sliding
from ..turning import same_turn
from .rrr import opening, total

_SOURCE = "机械原理, coincident points of two links"


@method(
    stage=Stage.VELOCITY,
    group="RPP",
    source=_SOURCE,
    example="3-14",
    title=Words("RPP 杆组的速度", "Velocity of an RPP group"),
)
def velocity_rpp(desk: Desk, d: Dyad) -> None:
    """v_Bk (∥ guide of k) = v_Bj + v_BkBj (∥ slot)."""
    _polygon(desk, View.VELOCITY, d)


@method(
    stage=Stage.ACCELERATION,
    group="RPP",
    source=_SOURCE,
    example="3-14",
    title=Words("RPP 杆组的加速度", "Acceleration of an RPP group"),
)
def acceleration_rpp(desk: Desk, d: Dyad) -> None:
    """a_Bk (∥ guide of k) = a_Bj + a^k + a^r; no Coriolis term where link k only translates."""
    _polygon(desk, View.ACCELERATION, d)


def _polygon(desk: Desk, view: View, d: Dyad) -> None:
    assert isinstance(d.inner, Prismatic) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Prismatic)
    b, k = d.outer_j.point, d.link_k
    to = At(b, k)
    base = coincident_tip(desk, view, b, d.parent_k)
    desk.board.step(opening(view, desk.name(to), k), view)
    if d.parent_k == FRAME:
        never_turns(desk, k)
    else:
        same_turn(desk, k, d.parent_k, view)
    led = sliding_chain(desk, view, to, base, d.outer_k, d.parent_k)
    front = "" if len(led) == 1 else total(desk, view, to, 2)
    solve(desk, view, Equation(left=led, right=_from_block(desk, view, d, to), total=front), to)
    if view is View.ACCELERATION and desk.turns[omega(k)].never:
        desk.board.remark(
            Words(
                f"构件 {k} 只作平动（$ω_{k}$ ≡ 0），不存在哥氏加速度。",
                f" Link {k} only translates ($ω_{k}$ ≡ 0): there is no Coriolis term.",
            )
        )
    same_turn(desk, d.link_j, k, view, said=not d.inner.pin_in_slot)
    for link in (k, d.link_j):
        images_of_link(desk, view, link)


def _from_block(desk: Desk, view: View, d: Dyad, to: At) -> tuple[Term, ...]:
    """v_Bj + v_BkBj, or a_Bj + a^k + a^r."""
    assert isinstance(d.inner, Prismatic)
    tail = desk.canonical(At(to.point, d.link_j))
    front = known(desk, view, tail)
    if view is View.VELOCITY:
        return (front, sliding(desk, Rel(Kind.V, to, tail), d.inner))
    if desk.turns[omega(d.link_k)].never:
        return (front, sliding(desk, Rel(Kind.AR, to, tail), d.inner))
    return (front, coriolis(desk, to, tail, d.link_k), sliding(desk, Rel(Kind.AR, to, tail), d.inner))
