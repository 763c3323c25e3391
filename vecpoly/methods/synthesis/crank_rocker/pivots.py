"""A on its locus, by whatever is given beside K and the rocker; of two mirror images the left one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ....designs.crank_rocker import CrankRocker
from ....designs.place import OnLine
from ....plane import Points, nominal
from ....words import Words
from ..arc_middle import MIRROR, by_arc, called, primes_of
from ..draft import SHEET, Draft
from ..eta import Locus, Straight
from ..linkage import point
from .rocker import Rocker
from .trial import by_trial


def pivots(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> Iterator[Points]:
    """Every A on this circle, or on the line C₁C₂."""
    other = bool(primes_of(locus))
    on = Words(f"{called(locus).zh}上的", f" on {called(locus).en}") if other else Words.same("")
    draft.board.section(Words(f"求{on.zh} $A$ 点和各构件长度", f"The point $A${on.en} and the lengths"))
    if design.AD is not None:
        yield from _at_distance(draft, rocker, locus, draft.mm(design.AD.si))
    elif design.A is not None:
        yield from _on_line(draft, design.A, locus)
    elif isinstance(locus, Straight):
        if design.BC is not None:
            yield _middle_and_coupler(draft, rocker, locus, draft.mm(design.BC.si))
        else:
            yield from by_trial(draft, design, rocker, locus)
    elif design.AB is not None:
        yield from by_arc(draft, (rocker.c1, rocker.c2), locus, 2 * draft.mm(design.AB.si), "AB")
    elif design.BC is not None:
        yield from by_arc(draft, (rocker.c1, rocker.c2), locus, 2 * draft.mm(design.BC.si), "BC")
    else:
        yield from by_trial(draft, design, rocker, locus)


def _at_distance(draft: Draft, rocker: Rocker, locus: Locus, frame: float) -> Iterator[Points]:
    """On an arc about D with the radius AD."""
    board, what = draft.board, Words("求 $A$", "finding $A$")
    arc = Words("以 $D$ 为圆心、$l_AD/μ_l$ 为半径作弧", "Draw an arc about $D$ with the radius $l_AD/μ_l$")
    if isinstance(locus, Straight):
        meets = abs(float(nominal((locus.line.at - rocker.d).imag))) <= frame
        board.step(_met(draft, arc, locus, meets), SHEET)
        if meets:
            yield _left(draft, *board.arc_on_line(locus.line, rocker.d, frame, what))
        return
    span, radius = float(nominal(np.abs(locus.centre - rocker.d))), float(nominal(locus.radius))
    meets = abs(radius - frame) <= span <= radius + frame and span >= 1e-9
    board.step(_met(draft, arc, locus, meets), SHEET)
    if not meets:
        board.remark(
            Words(
                f" 两圆半径为 {radius:.1f} mm 与 {frame:.1f} mm，圆心距 {span:.1f} mm。",
                f" The radii are {radius:.1f} mm and {frame:.1f} mm, the centres {span:.1f} mm apart.",
            )
        )
        return
    a = _left(draft, *board.arcs(rocker.d, frame, locus.centre, locus.radius, what))
    board.swing(SHEET, rocker.d, frame, a)
    yield a


def _met(draft: Draft, drawn: Words, locus: Locus, meets: bool, times: int = 1) -> Words:
    """What is drawn, and whether it meets the locus: in the point, or points, found next."""
    on, letters = called(locus), [f"${draft.letter('A', n)}$" for n in range(times)]
    if meets:
        return Words(
            f"{drawn.zh}，与{on.zh}相交于 {'、'.join(letters)}。",
            f"{drawn.en}; it meets {on.en} at {' and '.join(letters)}.",
        )
    return Words(f"{drawn.zh}，与{on.zh}不相交。", f"{drawn.en}; it does not meet {on.en}.")


def _left(draft: Draft, *meetings: Points) -> Points:
    """Of two mirror images the left one."""
    draft.board.remark(MIRROR)
    return draft.board.either(min(meetings, key=lambda at: float(nominal(at).real)))


def _on_line(draft: Draft, given: OnLine, locus: Locus) -> Iterator[Points]:
    """Where the given line meets the locus."""
    board, at = draft.board, complex(draft.mm(1.0)) * given.at
    drawn, what = Words("画给定的直线", "Draw the given line"), Words("求 $A$", "finding $A$")
    if isinstance(locus, Straight):
        board.step(_met(draft, drawn, locus, given.along == 1j), SHEET)
        line = board.parallel(at, given.along, key="A")
        if given.along == 1j:
            yield board.meet(line, locus.line, what)
        return
    gap, radius = (
        float(nominal(size)) for size in (np.abs((np.conj(given.along) * (locus.centre - at)).imag), locus.radius)
    )
    both = 2 if given.along == 1j and gap < radius else 1
    board.step(_met(draft, drawn, locus, gap <= radius, both), SHEET)
    line = board.parallel(at, given.along, key="A")
    if gap > radius:
        board.remark(
            Words(
                f" 直线距圆心 {gap:.1f} mm，圆的半径为 {radius:.1f} mm。",
                f" It passes the centre at {gap:.1f} mm, and the radius is {radius:.1f} mm.",
            )
        )
        return
    meetings = board.arc_on_line(line, locus.centre, locus.radius, what)
    for end in meetings:
        board.rule(SHEET, line, end)
    yield from meetings if given.along == 1j else (_left(draft, *meetings),)


def _middle_and_coupler(draft: Draft, rocker: Rocker, locus: Straight, coupler: float) -> Points:
    """AC₁ + AC₂ = 2 BC on a straight line: A lies at the distance BC from the middle of C₁C₂."""
    board = draft.board
    board.step(
        Words(
            "$AC_1 + AC_2 = 2l_BC/μ_l$，故自 $C_{1}C_{2}$ 的中点 $M$ 沿直线截取 $l_BC/μ_l$ 得 $A$。",
            "Since $AC_1 + AC_2 = 2l_BC/μ_l$, $A$ lies on the line at $l_BC/μ_l$ from the middle $M$ of $C_{1}C_{2}$.",
        ),
        SHEET,
    )
    bisector = board.bisector(SHEET, rocker.c1, rocker.c2)
    m = point(draft, "M", board.meet(bisector, locus.line, Words("求中点", "the middle")))
    return board.lay_off(m, -locus.line.along, coupler, key="BC")
