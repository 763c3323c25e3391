"""An RPR group located: a guide that swings about Q and passes the pin P of its block, through it or at an offset."""

from __future__ import annotations

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Dot, Role
from ....errors import AssemblyError
from ....mechanism.groups.assur import Dyad
from ....mechanism.model import Prismatic, Revolute
from ....mechanism.offsets import offset_symbol
from ....plane import Points, distance, nominal, unit
from ....words import Words
from ...desk import Desk
from ...registry import Stage, method
from ..diagram.cam import tangent_words
from .assembly import said
from .guide_way import choose_way

_SOURCE = "机械原理, kinematic diagrams by Assur groups"
LETTERED = 5.0  # mm: a shorter radius has no room for its letter


@method(
    stage=Stage.POSITION,
    group="RPR",
    source=_SOURCE,
    example="3-9",
    title=Words("RPR 杆组的位置", "Position of an RPR group"),
)
def position_rpr(desk: Desk, d: Dyad) -> None:
    """The guide passes its pivot Q and leaves the block's pin P at the offset e:
    join QP, or draw the tangent from Q."""
    joint = d.inner
    assert isinstance(joint, Prismatic) and isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute)
    pins = {d.link_j: d.outer_j.point, d.link_k: d.outer_k.point}
    q, p = pins[joint.guide], pins[joint.block]
    offset = desk.mm(desk.offset(joint, joint.block, p) - desk.offset(joint, joint.guide, q))
    span = distance(desk.at[q], desk.at[p])
    if float(nominal(span)) <= abs(offset) + 1e-9:
        raise AssemblyError(
            Words(
                f"构件 {joint.guide} 与 {joint.block}：图上 {q}{p} 长 {nominal(span):.3f} mm，不大于导路的偏距 "
                f"{abs(offset):.3f} mm，导路方向不定",
                f"links {joint.guide} and {joint.block}: {q}{p} is {nominal(span):.3f} mm on paper, not longer "
                f"than the guide's offset of {abs(offset):.3f} mm, so the guide has no direction here",
            )
        )
    if (cam := tangent_words(desk, joint)) is not None:
        words = cam + _tangent(q, p, offset)
    elif abs(offset) < 1e-9:
        words = Words(
            f"连接 ${q}$、${p}$，得构件 {joint.guide} 的导路方向",
            f"Join ${q}$ and ${p}$: the direction of link {joint.guide}",
        )
    else:
        words = _touching(desk, joint, q, p)
    desk.board.step(words, View.MECHANISM)
    direct, why = choose_way(desk, joint, q, p, _directions(desk.at[p] - desk.at[q], offset))
    which = _which_tangent(desk, q, p, direct, offset) if cam is None else Words.same("")
    desk.board.remark((which if why is None else said(why, "个方向")) + Words("。", "."))
    along = desk.board.turn(direct)
    if abs(offset) > 1e-9:
        _offset_circle(desk, q, p, abs(offset), along, _letter(desk, joint, q, p) if cam is None else "")
    desk.settle_turned(joint.guide, q, along * np.exp(-1j * joint.direction))
    desk.settle_turned(joint.block, p, along * np.exp(1j * joint.turn))


def _directions(ray: Points, offset: float) -> tuple[Points, Points]:
    """Both directions u of a line through Q that leaves P so far (mm) to its left, ray = QP:
    u (σ + ie) = QP with σ = ±√(QP² - e²)."""
    lean = np.exp(1j * np.arcsin(offset / np.abs(ray)))
    return unit(ray) * np.conj(lean), -unit(ray) * lean


def _which_tangent(desk: Desk, q: str, p: str, direct: Points, offset: float) -> Words:
    """Of the two tangents the one that is meant: on which side of it the circle lies."""
    if abs(offset) < 1e-9:
        return Words.same("")
    ray, way = complex(nominal(desk.at[p] - desk.at[q])), complex(nominal(direct))
    ahead = (way.conjugate() * ray).real
    left = (way.conjugate() * ray).imag * ahead > 0
    return Words(
        f"（两条切线中，自 ${q}$ 看 ${p}$ 在其{'左' if left else '右'}侧的一条）",
        f" (of the two, the one with ${p}$ on its {'left' if left else 'right'}, seen from ${q}$)",
    )


def _touching(desk: Desk, joint: Prismatic, q: str, p: str) -> Words:
    """The tangent from the guide's pivot is the guide where that passes the pivot, else parallel to it: drawn through
    the block's pin where that lies on it."""
    i = joint.guide
    passes, holds = (abs(desk.offset(joint, *one)) < 1e-9 for one in ((i, q), (joint.block, p)))
    is_guide = Words(f"，即构件 {i} 的导路", f": it is the guide of link {i}")
    through = Words(
        f"，再过 ${p}$ 作其平行线，即构件 {i} 的导路", f"; the guide of link {i} is parallel to it, through ${p}$"
    )
    along = Words(f"，得构件 {i} 的导路方向", f": the guide of link {i} is parallel to it")
    end = is_guide if passes else through if holds else along
    radius = _away(desk, joint, p if passes else q) if passes or holds else _between(desk, joint, q, p)
    return Words(
        f"以 ${p}$ 为圆心、{radius.zh}为半径作弧，过 ${q}$ 作其切线{end.zh}",
        f"From ${q}$ draw the tangent to the arc about ${p}$ with {radius.en} as radius{end.en}",
    )


def _away(desk: Desk, joint: Prismatic, letter: str) -> Words:
    """How far from the guide the one of both is that does not lie on it: by its offset, where such is given of it."""
    if letter == joint.aside:
        symbol = offset_symbol(desk.mech, joint)
        return Words(f"偏距 ${symbol}/μ_l$", f"the offset ${symbol}/μ_l$")
    return Words(
        f"$r/μ_l$（$r$ 为 ${letter}$ 到导路的距离）", f"$r/μ_l$ ($r$: the distance of ${letter}$ from the guide)"
    )


def _between(desk: Desk, joint: Prismatic, q: str, p: str) -> Words:
    """How far the pin is from the line through the pivot along the guide, where neither of them lies on the guide."""
    alike = desk.offset(joint, joint.guide, q) * desk.offset(joint, joint.block, p) > 0
    return Words(
        f"$r/μ_l$（$r$ 为 ${p}$、${q}$ 到导路的距离之{'差' if alike else '和'}）",
        f"$r/μ_l$ ($r$: the {'difference' if alike else 'sum'} of the distances of ${p}$ and ${q}$ from the guide)",
    )


def _letter(desk: Desk, joint: Prismatic, q: str, p: str) -> str:
    """What the radius is called in the figure: the offset of the one that is off the guide, or r of both."""
    off = [one for link, one in ((joint.guide, q), (joint.block, p)) if abs(desk.offset(joint, link, one)) > 1e-9]
    return f"r = {offset_symbol(desk.mech, joint)}" if off == [joint.aside] else "r"


def _tangent(q: str, p: str, offset: float) -> Words:
    """How the guide's direction is found for a flat face: the tangent from its pivot, or the line through it."""
    if abs(offset) < 1e-9:
        return Words(f"，即连线 ${q}{p}$", f": the line ${q}{p}$")
    return Words(
        f"：以 ${p}$ 为圆心、虚拟导路到 ${q}$ 的距离为半径作弧，过 ${q}$ 作其切线，得平底的方向",
        f": the tangent from ${q}$ to the arc about ${p}$ whose radius is the distance of that "
        f"guide from ${q}$ gives the direction of the face",
    )


def _offset_circle(desk: Desk, q: str, p: str, radius: float, along: Points, letter: str) -> None:
    """An arc of the circle of the offset about the pin, and the tangent to it from the guide's pivot; the radius to
    where it touches, with its letter if the step names it so."""
    centre, pivot, way = (complex(nominal(z)) for z in (desk.at[p], desk.at[q], along))
    foot = pivot + way * float((np.conj(way) * (centre - pivot)).real)
    desk.board.arcs_past(View.MECHANISM, centre, radius, foot)
    desk.board.join(View.MECHANISM, pivot, foot, Role.CONSTRUCTION)
    if letter and radius > LETTERED:
        desk.board.join(View.MECHANISM, centre, foot, Role.CONSTRUCTION)
        desk.board.plot(View.MECHANISM, (centre + foot) / 2, letter, Dot.NONE)
        desk.board.right_angle(View.MECHANISM, foot, unit(centre - foot), unit(pivot - foot))
