"""Class II groups located with compass and ruler: RRR, RRP, RPR, PRP and RPP."""

from __future__ import annotations

import numpy as np

from ...board.construction import View
from ...board.marks import Arc, Role
from ...errors import AssemblyError
from ...mechanism.assur import Dyad
from ...mechanism.model import Prismatic, Revolute
from ...plane import Line, Points, distance, lines_meet, nominal, unit
from ...words import Words
from ..desk import Desk
from ..registry import Stage, method
from .assembly import choose, said
from .cam import tangent_words

_SOURCE = "机械原理, kinematic diagrams by Assur groups"


@method(stage=Stage.POSITION, group="RRR", source=_SOURCE, example="3-5",
        title=Words("RRR 杆组的位置", "Position of an RRR group"))
def position_rrr(desk: Desk, d: Dyad) -> None:
    """Two arcs: C is where the arc of l_j about P meets the arc of l_k about Q."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    c, p, q, board = d.inner.point, d.outer_j.point, d.outer_k.point, desk.board
    lengths = [abs(desk.body(li).points[c] - desk.body(li).points[o]) for li, o in ((d.link_j, p), (d.link_k, q))]
    bars = desk.bar(d.link_j, p, c), desk.bar(d.link_k, q, c)
    board.step(
        Words(f"分别以 ${p}$、${q}$ 为圆心，以 $l_{bars[0]}/μ_l$、$l_{bars[1]}/μ_l$ 为半径画弧，交点为 ${c}$",
              f"Arcs about ${p}$ and ${q}$ with radii $l_{bars[0]}/μ_l$ and $l_{bars[1]}/μ_l$ meet at ${c}$"),
        View.MECHANISM,
    )
    radii = [desk.mm(length) for length in lengths]
    pair = board.arcs(desk.at[p], radii[0], desk.at[q], radii[1], Words(f"构件 {d.link_j} 与 {d.link_k} 在 {c} 处", f"links {d.link_j} and {d.link_k} at {c}"))
    desk.at[c], why = choose(desk, c, (d.link_j, d.link_k), pair)
    board.remark(said(why) + Words("。", "."))
    board.swing(View.MECHANISM, desk.at[p], radii[0], desk.at[c])
    board.swing(View.MECHANISM, desk.at[q], radii[1], desk.at[c])
    desk.settle(d.link_j, (p, c))
    desk.settle(d.link_k, (q, c))


@method(stage=Stage.POSITION, group="RRP", source=_SOURCE, example="3-5",
        title=Words("RRP 杆组的位置", "Position of an RRP group"))
def position_rrp(desk: Desk, d: Dyad) -> None:
    """One arc and the guide: C is where the arc of l_j about P cuts the line on which C is led."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Prismatic)
    c, p, board = d.inner.point, d.outer_j.point, desk.board
    radius = desk.mm(abs(desk.body(d.link_j).points[c] - desk.body(d.link_j).points[p]))
    board.step(
        Words(f"以 ${p}$ 为圆心、$l_{desk.bar(d.link_j, p, c)}/μ_l$ 为半径画弧，与 ${c}$ 的导路线交于 ${c}$",
              f"The arc about ${p}$ with radius $l_{desk.bar(d.link_j, p, c)}/μ_l$ cuts the guide line of ${c}$ at ${c}$"),
        View.MECHANISM,
    )
    line = desk.locus(d.outer_k, d.link_k, c)
    pair = board.arc_on_line(line, desk.at[p], radius, Words(f"构件 {d.link_j} 在 {c} 处", f"link {d.link_j} at {c}"))
    desk.at[c], why = choose(desk, c, (d.link_j, d.link_k), pair)
    board.remark(said(why) + Words("。", "."))
    board.swing(View.MECHANISM, desk.at[p], radius, desk.at[c])
    desk.settle(d.link_j, (p, c))
    desk.settle_turned(d.link_k, c, slider_axis(desk, d.outer_k, d.link_k, line))


@method(stage=Stage.POSITION, group="RPR", source=_SOURCE, example="3-9",
        title=Words("RPR 杆组的位置", "Position of an RPR group"))
def position_rpr(desk: Desk, d: Dyad) -> None:
    """The guide passes its pivot Q and leaves the block's pin P at the offset e: join QP, or draw the tangent from Q."""
    joint = d.inner
    assert isinstance(joint, Prismatic) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    pins = {d.link_j: d.outer_j.point, d.link_k: d.outer_k.point}
    q, p = pins[joint.guide], pins[joint.block]
    offset = desk.mm(desk.offset(joint, joint.block, p) - desk.offset(joint, joint.guide, q))
    span = distance(desk.at[q], desk.at[p])
    if float(nominal(span)) <= abs(offset) + 1e-9:
        raise AssemblyError(Words(
            f"构件 {joint.guide} 与 {joint.block}：图上 {q}{p} 长 {nominal(span):.3f} mm，不大于导路的偏距 {abs(offset):.3f} mm，导路方向不定",
            f"links {joint.guide} and {joint.block}: {q}{p} is {nominal(span):.3f} mm on paper, not longer than the guide's offset of {abs(offset):.3f} mm, so the guide has no direction here"))
    if (cam := tangent_words(desk, joint)) is not None:
        words = cam + _tangent(q, p, offset)
    elif abs(offset) < 1e-9:
        words = Words(f"连接 ${q}$、${p}$，得构件 {joint.guide} 的导路方向。", f"Join ${q}$ and ${p}$: the guide of link {joint.guide}.")
    else:
        words = Words(f"以 ${p}$ 为圆心、偏距 $e/μ_l$ 为半径作圆，过 ${q}$ 作其切线，得构件 {joint.guide} 的导路方向。",
                      f"The tangent from ${q}$ to the circle about ${p}$ with the offset $e/μ_l$ as radius is the guide of link {joint.guide}.")
    desk.board.step(words, View.MECHANISM)
    direct = unit(desk.at[p] - desk.at[q]) * np.exp(-1j * np.arcsin(offset / span))
    along = desk.board.hand.tilt(direct)
    if abs(offset) > 1e-9:
        _offset_circle(desk, q, p, abs(offset), along)
    desk.settle_turned(joint.guide, q, along * np.exp(-1j * joint.direction))
    desk.settle_turned(joint.block, p, along * np.exp(1j * joint.turn))


@method(stage=Stage.POSITION, group="PRP", source=_SOURCE, example="3-11",
        title=Words("PRP 杆组的位置", "Position of a PRP group"))
def position_prp(desk: Desk, d: Dyad) -> None:
    """Two guides: B is where they cross."""
    assert isinstance(d.inner, Revolute) and isinstance(d.outer_j, Prismatic) and isinstance(d.outer_k, Prismatic)
    b, board = d.inner.point, desk.board
    board.step(Words(f"两导路线的交点为 ${b}$。", f"The two guide lines cross at ${b}$."), View.MECHANISM)
    lines = [desk.locus(joint, link, b) for joint, link in ((d.outer_j, d.link_j), (d.outer_k, d.link_k))]
    desk.at[b] = board.meet(lines[0], lines[1], Words(f"构件 {d.link_j} 与 {d.link_k} 的导路", f"guides of links {d.link_j} and {d.link_k}"))
    for joint, link, line in zip((d.outer_j, d.outer_k), (d.link_j, d.link_k), lines, strict=True):
        desk.settle_turned(link, b, slider_axis(desk, joint, link, line))


@method(stage=Stage.POSITION, group="RPP", source=_SOURCE, example="3-14",
        title=Words("RPP 杆组的位置", "Position of an RPP group"))
def position_rpp(desk: Desk, d: Dyad) -> None:
    """Link k keeps its direction: shift it along its guide until its slot passes through the pin B of link j."""
    inner, outer = d.inner, d.outer_k
    assert isinstance(d.outer_j, Revolute) and isinstance(inner, Prismatic) and isinstance(outer, Prismatic)
    b = d.outer_j.point
    cam = tangent_words(desk, inner)
    desk.board.step(
        Words(f"构件 {d.link_k} 只能沿其导路移动：沿导路推移，使其导槽通过 ${b}$。",
              f"Link {d.link_k} can only move along its guide: shift it until its slot passes through ${b}$.") if cam is None else cam + Words("。", "."),
        View.MECHANISM,
    )
    guide = desk.guide_line(outer)
    axis = slider_axis(desk, outer, d.link_k, guide)
    own = inner.direction if inner.guide == d.link_k else -inner.turn
    slot = axis * np.exp(1j * own)
    r = next(iter(desk.body(d.link_k).points))
    path = desk.locus(outer, d.link_k, r)
    side = desk.mm(desk.offset(inner, d.link_j, b) - desk.offset(inner, d.link_k, r))
    desk.at[r] = lines_meet(path, Line(desk.at[b] - 1j * slot * side, slot))
    desk.settle_turned(d.link_k, r, axis)
    desk.settle_turned(d.link_j, b, slider_axis(desk, inner, d.link_j, Line(desk.at[b], slot)))


def _tangent(q: str, p: str, offset: float) -> Words:
    """How the guide's direction is found for a flat face: the tangent from its pivot, or the line through it."""
    if abs(offset) < 1e-9:
        return Words(f"，即连线 ${q}{p}$。", f": the line ${q}{p}$.")
    return Words(f"：以 ${p}$ 为圆心、虚拟导路到 ${q}$ 的距离为半径作圆，过 ${q}$ 作其切线，得平底的方向。",
                 f": the tangent from ${q}$ to the circle about ${p}$ whose radius is the distance of that guide from ${q}$ gives the direction of the face.")


def _offset_circle(desk: Desk, q: str, p: str, radius: float, along: Points) -> None:
    """The circle of the offset about the pin, and the tangent to it from the guide's pivot."""
    centre, pivot, way = (complex(nominal(z)) for z in (desk.at[p], desk.at[q], along))
    foot = pivot + way * float((np.conj(way) * (centre - pivot)).real)
    desk.board.mark(View.MECHANISM, Arc(centre=centre, radius=radius, start=0.0, sweep=2 * np.pi, role=Role.CONSTRUCTION))
    desk.board.join(View.MECHANISM, pivot, foot, Role.CONSTRUCTION)


def slider_axis(desk: Desk, joint: Prismatic, link: str, line: Line) -> Points:
    """Direction of the x axis of the link that slides, from the line of the guide."""
    turn = joint.turn if link == joint.block else -joint.direction
    axis: Points = line.along * np.exp(1j * turn)
    return axis


