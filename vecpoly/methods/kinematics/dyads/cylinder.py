"""Velocity and acceleration of a driven cylinder and the link that it moves.

C is on the rod; the point of the cylinder's other link that lies under C (the link expanded, 扩大构件) is called C_n.
The relative motion along the cylinder is the input:
    v_C = v_D + v_CnD + v_CCn,    a_C = a_D + a^n_CnD + a^t_CnD + a^k_CCn + a^r_CCn,
with v_CCn and a^r_CCn known, along the guide (DC, where both hinges are on it), v_CnD and a^t_CnD perpendicular to DC,
and C led by the link that is moved.
"""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Role
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....mechanism.rams import Ram
from ....names import At, Kind, Rel
from ....plane import nominal
from ....vector.close import Closed, Ends
from ....vector.equation import Equation, Term
from ....words import Words
from ...desk import QUANTITY, Desk
from ...registry import Stage, method
from ..chains import coincident_tip, never_turns, sliding_chain, solve, turning_chain
from ..image import images_of_link
from ..terms import coriolis, guide_name
from ..turning import same_turn
from .rrr import total, turn_of_link

_SOURCE = "机械原理, coincident points of two links; the relative velocity along the cylinder is given"
ON_LINE = 1e-9  # m: so far beside each other two hinges are on one line of the guide
CORNER = {View.VELOCITY: "r", View.ACCELERATION: "r′"}  # where the given vectors end that are laid off first


@method(
    stage=Stage.VELOCITY,
    group="cylinder RR",
    source=_SOURCE,
    example="excavator-boom",
    title=Words("油缸（RR）的速度", "Velocity of a cylinder with a pinned link"),
)
def velocity_cylinder_rr(desk: Desk, ram: Ram) -> None:
    """v_A + v_CA (⊥ CA) = v_D + v_CnD (⊥ CD) + v_CCn (along the cylinder, given)."""
    _polygon(desk, View.VELOCITY, ram)


@method(
    stage=Stage.ACCELERATION,
    group="cylinder RR",
    source=_SOURCE,
    example="excavator-boom",
    title=Words("油缸（RR）的加速度", "Acceleration of a cylinder with a pinned link"),
)
def acceleration_cylinder_rr(desk: Desk, ram: Ram) -> None:
    """a_A + a^n_CA + a^t_CA = a_D + a^n_CnD + a^t_CnD + a^k + a^r."""
    _polygon(desk, View.ACCELERATION, ram)


@method(
    stage=Stage.VELOCITY,
    group="cylinder RP",
    source=_SOURCE,
    example="lift-gate",
    title=Words("油缸（RP）的速度", "Velocity of a cylinder with a sliding link"),
)
def velocity_cylinder_rp(desk: Desk, ram: Ram) -> None:
    """v_C (∥ guide) = v_D + v_CnD (⊥ CD) + v_CCn (along the cylinder, given)."""
    _polygon(desk, View.VELOCITY, ram)


@method(
    stage=Stage.ACCELERATION,
    group="cylinder RP",
    source=_SOURCE,
    example="lift-gate",
    title=Words("油缸（RP）的加速度", "Acceleration of a cylinder with a sliding link"),
)
def acceleration_cylinder_rp(desk: Desk, ram: Ram) -> None:
    """a_C (∥ guide) = a_D + a^n_CnD + a^t_CnD + a^k + a^r."""
    _polygon(desk, View.ACCELERATION, ram)


def _polygon(desk: Desk, view: View, ram: Ram) -> None:
    c, d = ram.inner.point, ram.outer.point
    to, under = At(c), At(c, ram.near)
    base = coincident_tip(desk, view, c, ram.link_parent) if isinstance(ram.link_joint, Prismatic) else None
    desk.board.step(_opening(desk, view, ram), view)
    swung = turning_chain(desk, view, under, d, ram.near)
    led, driven = _led(desk, view, ram, base), (*swung, *_along(desk, view, ram))
    closed = solve(
        desk, view, Equation(left=led, right=driven, total="" if len(led) == 1 else total(desk, view, to, 2)), to
    )
    ends = closed.ends | _parallelogram(desk, view, ram, swung[-1], driven[len(swung) :], closed)
    turn_of_link(desk, view, ends, under, d, ram.near)
    same_turn(desk, ram.far, ram.near, view)
    _turn_of_moved(desk, view, ram, ends)
    for link in (ram.link, ram.far, ram.near):
        images_of_link(desk, view, link)


def _opening(desk: Desk, view: View, ram: Ram) -> Words:
    c = ram.inner.point
    name, under, way = desk.name(At(c)), desk.name(At(c, ram.near)), _guide(desk, ram)
    kind, kind_en = QUANTITY[view].zh, QUANTITY[view].en
    return Words(
        f"${name}$ 与扩大的构件 {ram.near} 上的 ${under}$ 为重合点，其相对{kind}沿{way.zh}，由油缸给定；"
        f"列{kind}矢量方程并作图。",
        f"Point ${name}$ and the point ${under}$ of the extended link {ram.near} coincide; their relative "
        f"{kind_en} along {way.en} is given by the cylinder. Write the {kind_en} equation and draw "
        "it.",
    )


def _led(desk: Desk, view: View, ram: Ram, base: At | None) -> tuple[Term, ...]:
    """C as the link leads it that is moved."""
    match ram.link_joint:
        case Revolute(point=a):
            return turning_chain(desk, view, At(ram.inner.point), a, ram.link)
        case Prismatic() as guide:
            assert base is not None
            return sliding_chain(desk, view, At(ram.inner.point), base, guide, ram.link_parent)


def _turn_of_moved(desk: Desk, view: View, ram: Ram, ends: Ends) -> None:
    match ram.link_joint:
        case Revolute(point=a):
            turn_of_link(desk, view, ends, At(ram.inner.point), a, ram.link)
        case Prismatic(pin_in_slot=unseen):
            if ram.link_parent == FRAME:
                never_turns(desk, ram.link)
            else:
                same_turn(desk, ram.link, ram.link_parent, view, said=not unseen)


def _along(desk: Desk, view: View, ram: Ram) -> tuple[Term, ...]:
    """v_CCn, or a^k + a^r: along the cylinder, as the input says."""
    to, under = desk.canonical(At(ram.inner.point)), At(ram.inner.point, ram.near)
    drive = next(drive for drive in desk.mech.drives if drive.pair == {ram.near, ram.far})
    if view is View.VELOCITY:
        return (_given(desk, ram, Rel(Kind.V, to, under), drive.rate),)
    bend = coriolis(desk, to, under, ram.near)
    return bend, _given(desk, ram, Rel(Kind.AR, to, under), drive.accel)


def _given(desk: Desk, ram: Ram, rel: Rel, value: float) -> Term:
    """A vector of known size along the drawn cylinder, which it lengthens where it is positive."""
    view, sign = (View.VELOCITY, desk.symbol(rel)) if rel.kind is Kind.V else (View.ACCELERATION, desk.symbol(rel))
    way = (1.0 if ram.near == ram.pair.guide else -1.0) * (np.sign(value) or 1.0)
    if value:
        desk.board.given_size(sign, abs(value), rel.kind.unit)
    direction = _parallel(desk, ram) if value else Words.same("—")
    return Term(
        rel=rel,
        symbol=sign,
        direction=direction,
        magnitude="✓" if value else "0",
        along=desk.guide_line(ram.pair).along * way,
        mm=desk.board.to_paper(view, np.asarray(abs(value))),
        tip=CORNER[view] if value else "",
    )


def _hinges_on_line(desk: Desk, ram: Ram) -> bool:
    """Whether the cylinder moves along the line of its hinges: not so where one of them lies farther from it."""
    ends = (ram.near, ram.outer.point), (ram.far, ram.inner.point)
    one, other = (desk.offset(ram.pair, link, point) for link, point in ends)
    return abs(one - other) < ON_LINE


def _guide(desk: Desk, ram: Ram) -> Words:
    """Along what the rod moves, as a sentence calls it."""
    if _hinges_on_line(desk, ram):
        return Words(f" ${ram.outer.point}{ram.inner.point}$", f"${ram.outer.point}{ram.inner.point}$")
    return Words("油缸导路", "the guide of the cylinder")


def _parallel(desk: Desk, ram: Ram) -> Words:
    """The same in the table of the equation."""
    if _hinges_on_line(desk, ram):
        return Words.same(f"∥$ {ram.outer.point}{ram.inner.point}$")
    return guide_name(desk, ram.pair)


def _shifted(corner: str, tip: str, *, laid: int, together: bool) -> Words:
    """What a parallelogram is drawn for. laid: so many given vectors; together: a line is ruled for their sum."""
    told = Words(
        f"将所给矢量平移，使其终点与 ${tip}$ 重合，其起点即 ${corner}$（平行四边形法则，两矢量的次序可交换）",
        f" The given vector{' is' if laid == 1 else 's are'} shifted so that {'it ends' if laid == 1 else 'they end'} "
        f"at ${tip}$; {'its' if laid == 1 else 'their'} start is then ${corner}$ (law of the parallelogram: the two "
        "vectors may be added in either order)",
    )
    whole = (
        Words(f"，即细线 ${corner}{tip}$", f"; it is then the thin line ${corner}{tip}$")
        if laid == 1
        else Words(f"，细线 ${corner}{tip}$ 为两者之和", f"; the thin line ${corner}{tip}$ is the sum of both")
    )
    return told + (whole if together else Words.same("")) + Words("。", ".")


def _parallelogram(desk: Desk, view: View, ram: Ram, turning: Term, along: tuple[Term, ...], closed: Closed) -> Ends:
    """C_n on the polygon: the given vectors, laid off first, are shifted to the end of the one that was sought."""
    board, under = desk.board, At(ram.inner.point, ram.near)
    start, end = closed.ends[along[0].rel.key][0], closed.ends[along[-1].rel.key][1]
    foot, corner = start, desk.put_tip(view, under, closed.meeting - (end - start))
    tips = desk.tip_label(view, under), desk.tip_label(view, At(ram.inner.point))
    laid = sum(one.mm is not None and bool(nominal(one.mm)) for one in along)
    board.remark(_shifted(*tips, laid=laid, together=len(along) > 1))
    board.plot(view, corner, desk.tip_label(view, under))
    board.arrow(view, foot, corner, Role.RESULT, key=turning.key)
    moved: Ends = {turning.rel.key: (foot, corner)}
    if len(along) == 1:
        moved[along[0].rel.key] = (corner, closed.meeting)
        board.arrow(view, corner, closed.meeting, Role.GIVEN, key=along[0].key)
    else:  # a^k + a^r, shifted as one
        board.join(view, corner, closed.meeting, Role.DIRECTION)
    return moved
