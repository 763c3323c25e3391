"""Crank and guide bar: whether the bar turns right round or rocks,
from the crank's length and the distance of the pivots."""

from __future__ import annotations

from cmath import rect

from ..algebra.quantity import number
from ..mechanism.groups.assur import Dyad, decompose, hinges
from ..mechanism.model import FRAME, Mechanism, Prismatic, Revolute
from ..words import Words
from .study.study import Study

_EQUAL = 1e-9


def guide_bar(study: Study, d: Dyad) -> Words | None:
    """A pivoted crank, a block, a straight guide through its pivot;
    driven by the crank (RPR), or by the guide (RRP). Elsewhere None."""
    found = _by_crank(study.mech, d) or _by_guide(study.mech, d)
    if found is None:
        return None
    crank, guide, a, b, c, radius, frame = found
    ab, ac = "".join(sorted(a + b)), "".join(sorted(a + c))
    told = Words(
        f"导杆回路 ${a}{b}{c}$：$l_{{{ab}}}$ = {_mm(radius)} mm，机架 $l_{{{ac}}}$ = {_mm(frame)} mm",
        f"The guide-bar loop ${a}{b}{c}$ has $l_{{{ab}}}$ = {_mm(radius)} mm and the frame $l_{{{ac}}}$ = "
        f"{_mm(frame)} mm",
    )
    if abs(radius - frame) < _EQUAL * frame:
        return told + Words(
            "，二者相等，$" + b + "$ 与 $" + c + "$ 会重合，为变点。",
            f": equal, so that ${b}$ comes upon ${c}$, a change point.",
        )
    if radius > frame:
        return told + Words(
            f"，$l_{{{ab}}}$ > $l_{{{ac}}}$，构件 {crank} 与 {guide} 都能整周转动，为转动导杆机构。",
            f". $l_{{{ab}}}$ > $l_{{{ac}}}$: links {crank} and {guide} both can make full revolutions.",
        )
    swinging = isinstance(d.inner, Prismatic) and d.inner.guide == guide
    return told + Words(
        f"，$l_{{{ab}}}$ < $l_{{{ac}}}$，构件 {crank} 可整周转动，构件 {guide} 只能摆动，"
        f"为{'摆动导杆' if swinging else '曲柄摇块'}机构。",
        f". $l_{{{ab}}}$ < $l_{{{ac}}}$: link {crank} can make full revolutions; "
        f"{'the guide bar' if swinging else 'the block'}, link {guide}, only swings.",
    )


def winding(study: Study, link: str, count: float) -> Words:
    """Why a guide bar turns round: the pin of its block goes so often round the bar's pivot. Empty of other links."""
    for d in (group.dyad for group in decompose(study.mech) if group.dyad is not None and group.kind == "RPR"):
        if (
            FRAME not in (d.parent_j, d.parent_k)
            or not isinstance(d.inner, Prismatic)
            or link not in (d.link_j, d.link_k)
        ):
            continue
        joint, fixed = (d.outer_j, d.outer_k) if d.parent_k == FRAME else (d.outer_k, d.outer_j)
        if isinstance(joint, Revolute) and isinstance(fixed, Revolute) and _straight(study.mech, d.inner, joint, fixed):
            p, g, turns = joint.point, fixed.point, f"{abs(count)}"
            return Words(
                f"（${p}$ 的轨迹每循环绕 ${g}$ 转 {turns} 周）",
                f" (the path of ${p}$ goes {'once' if abs(count) == 1 else f'{turns} times'} round ${g}$ in a cycle)",
            )
    return Words.same("")


_Loop = tuple[str, str, str, str, str, float, float]


def _by_crank(mech: Mechanism, d: Dyad) -> _Loop | None:
    """crank, guide, A, B, C, AB,
    AC of a pivoted crank AB whose pin B lies on a straight line through the fixed pivot C."""
    if d.kind != "RPR" or FRAME not in (d.parent_j, d.parent_k) or not isinstance(d.inner, Prismatic):
        return None
    (joint, parent), (fixed, _) = sorted(
        ((d.outer_j, d.parent_j), (d.outer_k, d.parent_k)), key=lambda pair: pair[1] == FRAME
    )
    a = next((p for p, names in hinges(mech).items() if FRAME in names and parent in names), "")
    if (
        not a
        or not isinstance(joint, Revolute)
        or not isinstance(fixed, Revolute)
        or not _straight(mech, d.inner, joint, fixed)
    ):
        return None
    b, c, turning = joint.point, fixed.point, d.link_k if d.parent_k == FRAME else d.link_j
    turning = d.inner.guide if turning in mech.slot_pins else turning
    radius = abs(mech.link(parent).points[a] - mech.link(parent).points[b])
    return (parent, turning, a, b, c, radius, abs(mech.frame[a] - mech.frame[c])) if radius and a != c else None


def _by_guide(mech: Mechanism, d: Dyad) -> _Loop | None:
    """The same loop driven by its guide: a block on a straight line through the driving guide's own fixed pivot."""
    guide, inner, pin = d.outer_k, d.inner, d.outer_j
    if (
        d.kind != "RRP"
        or d.parent_j != FRAME
        or not isinstance(guide, Prismatic)
        or not isinstance(inner, Revolute)
        or not isinstance(pin, Revolute)
        or guide.guide != d.parent_k
    ):
        return None
    c = next((p for p, names in hinges(mech).items() if FRAME in names and guide.guide in names), "")
    if not c or not _straight(mech, guide, inner, Revolute(point=c, a=guide.guide, b=FRAME)):
        return None
    a, b = pin.point, inner.point
    radius = abs(mech.link(d.link_j).points[a] - mech.link(d.link_j).points[b])
    frame = abs(mech.frame[a] - mech.frame[c])
    return (d.link_j, guide.guide, a, b, c, radius, frame) if radius > frame else None


def _straight(mech: Mechanism, slide: Prismatic, one: Revolute, two: Revolute) -> bool:
    """Whether the guide's line passes through both pins."""
    guide, block = mech.link(slide.guide), mech.link(slide.block)
    if len(block.points) > 1:
        return False
    pivot = next((j.point for j in (one, two) if j.point in guide.points), "")
    if not pivot:
        return False
    return (
        abs(((guide.points[pivot] - slide.origin) * rect(1.0, slide.direction).conjugate()).imag - slide.offset)
        < 1e-12 * mech.scale
    )


def _mm(value: float) -> str:
    return number(round(1e3 * value, 2), 6)
