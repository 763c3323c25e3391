"""Class II groups located with compass and ruler: RRR, RRP, RPR, PRP and RPP."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import FRAME, Prismatic, Revolute
from ....plane import Line, Points
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..diagram.cam import tangent_words
from ..dyads.parallelogram import step_off
from .assembly import choose, said

_SOURCE = "机械原理, kinematic diagrams by Assur groups"


@method(
    stage=Stage.POSITION,
    group="RRR",
    source=_SOURCE,
    example="3-5",
    title=Words("RRR 杆组的位置", "Position of an RRR group"),
)
def position_rrr(desk: Desk, d: Dyad) -> None:
    """Two arcs: C is where the arc of l_j about P meets the arc of l_k about Q."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    if step_off(desk, d):
        return
    c, p, q, board = d.inner.point, d.outer_j.point, d.outer_k.point, desk.board
    lengths = [
        abs(desk.mech.link(li).points[c] - desk.mech.link(li).points[o]) for li, o in ((d.link_j, p), (d.link_k, q))
    ]
    bars = desk.bar(d.link_j, p, c), desk.bar(d.link_k, q, c)
    board.step(
        Words(
            f"分别以 ${p}$、${q}$ 为圆心，以 $l_{bars[0]}/μ_l$、$l_{bars[1]}/μ_l$ 为半径画弧，交点为 ${c}$",
            f"Arcs about ${p}$ and ${q}$ with radii $l_{bars[0]}/μ_l$ and $l_{bars[1]}/μ_l$ meet at ${c}$",
        ),
        View.MECHANISM,
        again=Words(
            f"同样，由 ${p}$、${q}$ 以 $l_{bars[0]}/μ_l$、$l_{bars[1]}/μ_l$ 为半径得 ${c}$",
            f"Likewise, arcs about ${p}$ and ${q}$ with radii $l_{bars[0]}/μ_l$ and $l_{bars[1]}/μ_l$ give ${c}$",
        ),
    )
    radii = [desk.mm(length) for length in lengths]
    pair = board.arcs(
        desk.at[p],
        radii[0],
        desk.at[q],
        radii[1],
        Words(f"构件 {d.link_j} 与 {d.link_k} 在 {c} 处", f"links {d.link_j} and {d.link_k} at {c}"),
    )
    found, why = choose(desk, c, (d.link_j, d.link_k), pair)
    desk.letter(c, found)
    board.remark(said(why) + Words("。", "."))
    board.swing(View.MECHANISM, desk.at[p], radii[0], desk.at[c])
    board.swing(View.MECHANISM, desk.at[q], radii[1], desk.at[c])
    desk.settle(d.link_j, (p, c))
    desk.settle(d.link_k, (q, c))


@method(
    stage=Stage.POSITION,
    group="RRP",
    source=_SOURCE,
    example="3-5",
    title=Words("RRP 杆组的位置", "Position of an RRP group"),
)
def position_rrp(desk: Desk, d: Dyad) -> None:
    """One arc and the guide: C is where the arc of l_j about P cuts the line on which C is led."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Prismatic)
    c, p, board = d.inner.point, d.outer_j.point, desk.board
    radius = desk.mm(abs(desk.mech.link(d.link_j).points[c] - desk.mech.link(d.link_j).points[p]))
    board.step(
        Words(
            f"以 ${p}$ 为圆心、$l_{desk.bar(d.link_j, p, c)}/μ_l$ 为半径画弧，与 ${c}$ 的导路线交于 ${c}$",
            f"The arc about ${p}$ with radius $l_{desk.bar(d.link_j, p, c)}/μ_l$ cuts the guide line of ${c}$ at ${c}$",
        ),
        View.MECHANISM,
    )
    line = desk.locus(d.outer_k, d.link_k, c)
    pair = board.arc_on_line(line, desk.at[p], radius, Words(f"构件 {d.link_j} 在 {c} 处", f"link {d.link_j} at {c}"))
    found, why = choose(desk, c, (d.link_j, d.link_k), pair)
    desk.letter(c, found)
    board.remark(said(why) + Words("。", "."))
    board.swing(View.MECHANISM, desk.at[p], radius, desk.at[c])
    desk.settle(d.link_j, (p, c))
    desk.settle_turned(d.link_k, c, slider_axis(desk, d.outer_k, d.link_k, line))


@method(
    stage=Stage.POSITION,
    group="PRP",
    source=_SOURCE,
    example="3-11",
    title=Words("PRP 杆组的位置", "Position of a PRP group"),
)
def position_prp(desk: Desk, d: Dyad) -> None:
    """Two guides: B is where they cross."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Prismatic) and isinstance(d.outer_k, Prismatic)
    b, board = d.inner.point, desk.board
    board.step(Words(f"两导路线的交点为 ${b}$。", f"The two guide lines cross at ${b}$."), View.MECHANISM)
    lines = [desk.locus(joint, link, b) for joint, link in ((d.outer_j, d.link_j), (d.outer_k, d.link_k))]
    desk.letter(
        b,
        board.meet(
            lines[0],
            lines[1],
            Words(f"构件 {d.link_j} 与 {d.link_k} 的导路", f"guides of links {d.link_j} and {d.link_k}"),
        ),
    )
    for joint, link, line in zip((d.outer_j, d.outer_k), (d.link_j, d.link_k), lines, strict=True):
        desk.settle_turned(link, b, slider_axis(desk, joint, link, line))


@method(
    stage=Stage.POSITION,
    group="RPP",
    source=_SOURCE,
    example="3-14",
    title=Words("RPP 杆组的位置", "Position of an RPP group"),
)
def position_rpp(desk: Desk, d: Dyad) -> None:
    """Link k keeps its direction: shift it along its guide until its slot passes through the pin B of link j."""
    inner, outer = d.inner, d.outer_k
    assert isinstance(d.outer_j, Revolute) and isinstance(inner, Prismatic) and isinstance(outer, Prismatic)
    b = d.outer_j.point
    r = next(iter(desk.mech.link(d.link_k).points))
    cam = tangent_words(desk, inner)
    desk.board.step(_slid_words(d, inner, b, r) if cam is None else cam + Words("。", "."), View.MECHANISM)
    guide = desk.guide_line(outer)
    axis = slider_axis(desk, outer, d.link_k, guide)
    own = inner.direction if inner.guide == d.link_k else -inner.turn
    slot = axis * np.exp(1j * own)
    path = desk.locus(outer, d.link_k, r)
    side = desk.mm(desk.offset(inner, d.link_j, b) - desk.offset(inner, d.link_k, r))
    desk.letter(
        r,
        desk.board.meet(path, Line(desk.at[b] - 1j * slot * side, slot), f"guides of links {d.link_j} and {d.link_k}"),
    )
    desk.settle_turned(d.link_k, r, axis)
    desk.settle_turned(d.link_j, b, slider_axis(desk, inner, d.link_j, Line(desk.at[b], slot)))


def _slid_words(d: Dyad, inner: Prismatic, b: str, r: str) -> Words:
    """How the sliding link is found: its own slot brought over the pin,
    or the guide that is pinned there drawn in its direction."""
    if inner.guide == d.link_k:
        on = Words.same("") if d.parent_k == FRAME else Words(f"相对构件 {d.parent_k} ", f" on link {d.parent_k}")
        return Words(
            f"构件 {d.link_k} {on.zh}只能沿其导路移动，方位已定：沿该导路推移，使其滑道通过 ${b}$。",
            f"Link {d.link_k} can only move along its guide{on.en}, which fixes its orientation: "
            f"shift it until its slideway passes through ${b}$.",
        )
    return Words(
        f"构件 {d.link_j} 与 {d.link_k} 之间不能相对转动，其导路方向已定：过 ${b}$ 按此方向作构件 {d.link_j} "
        f"的导路，与构件 {d.link_k} 的另一导路相交，定出 ${r}$。",
        f"Links {d.link_j} and {d.link_k} cannot turn against each other, so the direction of the "
        f"guide on link {d.link_j} is known: drawn through ${b}$, it meets the other guide of link "
        f"{d.link_k} and so gives ${r}$.",
    )


def slider_axis(desk: Desk, joint: Prismatic, link: str, line: Line) -> Points:
    """Direction of the x axis of the link that slides, from the line of the guide."""
    turn = joint.turn if link == joint.block else -joint.direction
    axis: Points = line.along * np.exp(1j * turn)
    return axis
