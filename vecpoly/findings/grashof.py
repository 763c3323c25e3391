"""Whether the links of a four-bar loop or of a slider-crank can make full revolutions: the condition of full rotation
with this mechanism's lengths."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from dataclasses import dataclass

from ..algebra.quantity import number
from ..mechanism.groups.assur import Dyad, decompose, pivot_of
from ..mechanism.model import FRAME, Mechanism, Prismatic, Revolute
from ..words import Words
from .guide_bars import guide_bar
from .study.study import Study

_EQUAL = 1e-9


@dataclass(frozen=True, slots=True)
class Bar:
    """One side of the loop: its letters, its length (m), whether it is crank, coupler, rocker or frame."""

    letters: str
    length: float
    part: str
    link: str = ""

    @property
    def told(self) -> str:
        return f"$l_{{{''.join(sorted(self.letters))}}}$ = {number(round(1e3 * self.length, 2), 6)} mm"


def full_rotation(study: Study) -> Iterator[Words]:
    """The condition for every loop of two pivoted links with a coupler,
    of a crank and a slider, of a crank and a guide bar."""
    mech = study.mech
    for dyad in (group.dyad for group in decompose(mech) if group.dyad is not None):
        if bars := _four_bar(mech, dyad):
            yield _grashof(study, bars)
        elif told := _slider_crank(study, dyad) or guide_bar(study, dyad):
            yield told


def _four_bar(mech: Mechanism, d: Dyad) -> tuple[Bar, ...]:
    """Crank, coupler, rocker and frame where an RRR group joins a pivoted link to a fixed pivot."""
    parent = d.parent_k if d.parent_j == FRAME else d.parent_j
    near = pivot_of(mech, parent)
    if d.kind != "RRR" or FRAME not in (d.parent_j, d.parent_k) or not near:
        return ()
    assert isinstance(d.outer_j, Revolute) and isinstance(d.outer_k, Revolute) and isinstance(d.inner, Revolute)
    ends = ((d.outer_j.point, d.link_j), (d.outer_k.point, d.link_k))
    (b, coupler), (far, rocker) = ends if d.parent_k == FRAME else ends[::-1]
    if b == near or near == far:
        return ()
    c = d.inner.point
    sides = ((near, b, parent, "crank"), (b, c, coupler, "coupler"), (c, far, rocker, "rocker"))
    bars = tuple(
        Bar(p + q, abs(mech.link(link).points[p] - mech.link(link).points[q]), part, link) for p, q, link, part in sides
    )
    return (*bars, Bar(near + far, abs(mech.frame[near] - mech.frame[far]), "frame", ""))


def _grashof(study: Study, bars: tuple[Bar, ...]) -> Words:
    short, *middle, long = sorted(bars, key=lambda bar: bar.length)
    extreme, rest = short.length + long.length, sum(bar.length for bar in middle)
    sums = (
        number(round(1e3 * value, 2), 6)
        for value in (short.length, long.length, extreme, *(bar.length for bar in middle), rest)
    )
    a, b, ab, c, d, cd = sums
    loop = f"{bars[0].letters}{bars[2].letters}"
    told = Words(
        f"四杆回路 ${loop}$ 的杆长为 " + "、".join(bar.told for bar in bars) + f"。最短杆与最长杆之和 {a} + {b} = "
        f"{ab} mm",
        f"The four-bar loop ${loop}$ has {', '.join(bar.told for bar in bars)}. Shortest and longest, {a} + {b} = "
        f"{ab} mm, ",
    )
    if abs(extreme - rest) <= _EQUAL * rest:
        return told + Words(
            f" 等于其余两杆之和 {c} + {d} = {cd} mm，有各杆共线的变点位置，该处运动不确定。",
            f"equal the other two, {c} + {d} = {cd} mm: there are change points at which all links are in one line, "
            "and the motion is not determined there.",
        )
    if extreme > rest:
        return told + Words(
            f" > 其余两杆之和 {c} + {d} = {cd} mm，不满足杆长条件，"
            "无论以哪一杆为机架都没有整周转动的杆，为双摇杆机构。",
            f"exceed the sum of the other two, {c} + {d} = {cd} mm: Grashof's condition fails, no link can make full "
            "revolutions, and the loop is a double rocker.",
        )
    kind = _kind(short.part, bars[0].link, bars[2].link)
    return told + Words(
        f" < 其余两杆之和 {c} + {d} = {cd} mm，满足杆长条件；{kind.zh}。",
        f"are less than the sum of the other two, {c} + {d} = {cd} mm: Grashof's condition holds; {kind.en}.",
    )


def _kind(shortest: str, one: str, two: str) -> Words:
    """The kind of a loop that fulfils Grashof's condition, by the part that its shortest bar plays."""
    return {
        "crank": Words(
            f"最短杆为连架杆 {one}，故为曲柄摇杆机构，构件 {one} 为曲柄，能整周转动，构件 {two} 为摇杆",
            f"the shortest bar, link {one}, is beside the frame: a crank-rocker. Link {one}, the crank, can make "
            f"full revolutions; link {two} rocks",
        ),
        "rocker": Words(
            f"最短杆为连架杆 {two}，故为曲柄摇杆机构，而构件 {one} 为摇杆，不能整周转动",
            f"the shortest bar, link {two}, is beside the frame: a crank-rocker, of which link {one} is the "
            "rocker and cannot make full revolutions",
        ),
        "frame": Words(
            f"最短杆为机架，故为双曲柄机构，连架杆 {one}、{two} 都能整周转动",
            f"the frame is the shortest: a double crank, links {one} and {two} can both make full revolutions",
        ),
        "coupler": Words(
            f"最短杆为连杆，故为双摇杆机构，连架杆 {one}、{two} 都不能整周转动",
            f"the coupler is the shortest: a double rocker, neither link {one} nor link {two} can make full "
            "revolutions",
        ),
    }[shortest]


def _slider_crank(study: Study, d: Dyad) -> Words | None:
    """l_AB + e ≤ l_BC for the crank of a slider-crank."""
    mech = study.mech
    near = pivot_of(mech, d.parent_j)
    if d.kind != "RRP" or d.parent_j == FRAME or d.parent_k != FRAME or not near:
        return None
    assert isinstance(d.outer_j, Revolute) and isinstance(d.inner, Revolute) and isinstance(d.outer_k, Prismatic)
    b, c = d.outer_j.point, d.inner.point
    if d.outer_k.guide != FRAME or b == near:
        return None
    crank = Bar(near + b, abs(mech.link(d.parent_j).points[near] - mech.link(d.parent_j).points[b]), "crank")
    rod = Bar(b + c, abs(mech.link(d.link_j).points[b] - mech.link(d.link_j).points[c]), "coupler")
    along = cmath.rect(1.0, d.outer_k.direction)
    gap = abs((along.conjugate() * (study.at[c] - mech.frame[near])).imag)
    e, total, bc = (number(round(1e3 * value, 2), 6) for value in (gap, crank.length + gap, rod.length))
    holds = crank.length + gap <= rod.length
    sign, ab = "≤" if holds else ">", "".join(sorted(near + b))
    verdict = _crank_exists(d.parent_j, gap > 1e-9) if holds else _no_crank(d.parent_j)
    rod_letters = "".join(sorted(b + c))
    return Words(
        f"曲柄滑块回路 ${near}{b}{c}$：{crank.told}，{rod.told}，偏距 $e$ = {e} mm。$l_{{{ab}}} + e$ = "
        f"{total} mm {sign} $l_{{{rod_letters}}}$ = {bc} mm，{verdict.zh}。",
        f"The slider-crank ${near}{b}{c}$ has {crank.told}, {rod.told} and the offset $e$ = {e} mm. "
        f"$l_{{{ab}}} + e$ = {total} mm {sign} $l_{{{rod_letters}}}$ = {bc} mm: {verdict.en}.",
    )


def _crank_exists(link: str, offset: bool) -> Words:
    kind = Words("偏置曲柄滑块机构", "an offset slider-crank")
    if not offset:
        kind = Words("对心曲柄滑块机构", "an in-line slider-crank")
    return Words(
        f"满足曲柄存在条件，构件 {link} 可整周转动，为{kind.zh}", f"link {link} can make full revolutions, {kind.en}"
    )


def _no_crank(link: str) -> Words:
    return Words(f"不满足曲柄存在条件，构件 {link} 不能整周转动", f"link {link} cannot make full revolutions")
