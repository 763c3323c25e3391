"""A on its locus, by whatever is given beside K and the rocker; of two mirror images the left one."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ....designs.crank_rocker import CrankRocker
from ....designs.place import OnLine
from ....plane import Line, Points, line_circle_meet, nominal, unit
from ....words import Words
from ..draft import SHEET, Draft
from ..linkage import point
from .locus import Eta, Locus, Rocker, Straight
from .trial import by_trial

MIRROR = Words(
    "（另一交点是它的镜像，所得机构相同。）", " (The other meeting is its mirror image and gives the same linkage.)"
)


def pivots(draft: Draft, design: CrankRocker, rocker: Rocker, locus: Locus) -> Iterator[Points]:
    """Every A on this circle, or on the line C₁C₂."""
    section = Words(f"求 $A{_primes(locus)}$ 点和各构件长度", f"The point $A{_primes(locus)}$ and the lengths")
    draft.board.section(section)
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
        yield from _by_arc(draft, rocker, locus, 2 * draft.mm(design.AB.si), "AB")
    elif design.BC is not None:
        yield from _by_arc(draft, rocker, locus, 2 * draft.mm(design.BC.si), "BC")
    else:
        yield from by_trial(draft, design, rocker, locus)


def _primes(locus: Locus) -> str:
    return "′" if isinstance(locus, Eta) and locus.side > 0 else ""


def _eta(locus: Locus) -> str:
    return "直线 $C_{1}C_{2}$" if isinstance(locus, Straight) else f"圆 $η{_primes(locus)}$"


def _eta_en(locus: Locus) -> str:
    return "the line $C_{1}C_{2}$" if isinstance(locus, Straight) else f"the circle $η{_primes(locus)}$"


def _at_distance(draft: Draft, rocker: Rocker, locus: Locus, frame: float) -> Iterator[Points]:
    """On an arc about D with the radius AD."""
    board = draft.board
    board.step(
        Words(
            f"以 $D$ 为圆心、$l_AD/μ_l$ 为半径作弧，与{_eta(locus)}相交于 $A$。",
            f"An arc about $D$ with the radius $l_AD/μ_l$ meets {_eta_en(locus)} in $A$.",
        ),
        SHEET,
    )
    what = Words("求 $A$", "finding $A$")
    if isinstance(locus, Straight):
        if abs(float(nominal((locus.line.at - rocker.d).imag))) <= frame:
            yield _left(draft, *board.arc_on_line(locus.line, rocker.d, frame, what))
        return
    span, radius = float(nominal(np.abs(locus.centre - rocker.d))), float(nominal(locus.radius))
    if not abs(radius - frame) <= span <= radius + frame or span < 1e-9:
        _no_meeting(draft, radius, frame, span)
        return
    a = _left(draft, *board.arcs(rocker.d, frame, locus.centre, locus.radius, what))
    board.swing(SHEET, rocker.d, frame, a)
    yield a


def _no_meeting(draft: Draft, radius: float, frame: float, span: float) -> None:
    draft.board.remark(
        Words(
            f" 两圆不相交：半径 {radius:.1f} mm 与 {frame:.1f} mm，圆心距 {span:.1f} mm。",
            f" The circles do not meet: radii {radius:.1f} mm and {frame:.1f} mm, centres {span:.1f} mm apart.",
        )
    )


def _left(draft: Draft, *meetings: Points) -> Points:
    """Of two mirror images the left one."""
    draft.board.remark(MIRROR)
    return min(meetings, key=lambda at: float(nominal(at).real))


def _on_line(draft: Draft, given: OnLine, locus: Locus) -> Iterator[Points]:
    """Where the given line meets the locus."""
    board, at = draft.board, complex(draft.mm(1.0)) * given.at
    board.step(
        Words(f"画给定的直线，与{_eta(locus)}相交于 $A$。", f"Draw the given line; it meets {_eta_en(locus)} in $A$."),
        SHEET,
    )
    what, line = Words("求 $A$", "finding $A$"), board.parallel(at, given.along, key="A")
    if isinstance(locus, Straight):
        if given.along == 1j:
            yield board.meet(line, locus.line, what)
        return
    gap = float(nominal(np.abs((np.conj(given.along) * (locus.centre - at)).imag)))
    if gap > float(nominal(locus.radius)):
        _no_meeting(draft, float(nominal(locus.radius)), 0.0, gap)
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
            "$AC_1 + AC_2 = 2l_BC/μ_l$，故自 $C_{1}C_{2}$ 的中点 $M$ 沿直线量取 $l_BC/μ_l$ 得 $A$。",
            "$AC_1 + AC_2 = 2l_BC/μ_l$, so $A$ lies on the line at $l_BC/μ_l$ from the middle $M$ of $C_{1}C_{2}$.",
        ),
        SHEET,
    )
    bisector = board.bisector(SHEET, rocker.c1, rocker.c2)
    m = point(draft, "M", board.meet(bisector, locus.line, Words("求中点", "the middle")))
    return board.lay_off(m, -locus.line.along, coupler, key="BC")


def _by_arc(draft: Draft, rocker: Rocker, eta: Eta, twice: float, given: str) -> Iterator[Points]:
    """The construction by the middle of an arc: S on C₂A with C₂S = AC₂ − AC₁ = 2 AB, or AC₂ + AC₁ = 2 BC.

    The triangle A C₁ S is isosceles, so that C₁C₂ is seen from S under 90° + θ/2, or θ/2: S lies on a circle about the
    middle M of the arc C₁C₂ on which A does not lie, or does.
    """
    board, crank, primes = draft.board, given == "AB", _primes(eta)
    lies = ("不含", "on which $A$ does not lie") if crank else ("含", "on which $A$ lies")
    board.step(
        Words(
            f"取圆 $η{primes}$ 上{lies[0]} $A$ 的弧 $C_{{1}}C_2$ 的中点 $M{primes}$，以 $M{primes}$ 为圆心、"
            f"$M{primes}C_1$ 为半径作圆；"
            f"以 $C_2$ 为圆心、$2l_{given}/μ_l$ 为半径作弧，交于 $S{primes}$；$C_{{2}}S{primes}$ 的延长线与 "
            f"$η{primes}$ 交于 $A$。",
            f"From the middle $M{primes}$ of the arc $C_{{1}}C_2$ of $η{primes}$ {lies[1]} draw the circle through "
            f"$C_1$; the arc about "
            f"$C_2$ with the radius $2l_{given}/μ_l$ meets it in $S{primes}$. The line $C_{{2}}S{primes}$ meets "
            f"$η{primes}$ in $A$.",
        ),
        SHEET,
    )
    ends = board.arc_on_line(eta.bisector, eta.centre, eta.radius, Words("求弧的中点", "the middle of the arc"))
    up = max(ends, key=lambda at: float(nominal(at).imag)), min(ends, key=lambda at: float(nominal(at).imag))
    m = point(draft, f"M{primes}", up[0 if (eta.side < 0) == crank else 1])
    radius, what = np.abs(rocker.c1 - m), Words(f"求 $S{primes}$", f"finding $S{primes}$")
    spots = board.arcs(rocker.c2, twice, m, radius, what)
    board.circle(SHEET, m, radius)
    s = point(draft, f"S{primes}", min(spots, key=lambda at: _across(rocker.c2, at, eta)))
    board.swing(SHEET, rocker.c2, twice, s)
    board.remark(MIRROR)
    line = Line(rocker.c2, unit(s - rocker.c2))
    a, _ = board.arc_on_line(line, eta.centre, eta.radius, Words("求 $A$", "finding $A$"))
    board.rule(SHEET, line, a)
    yield a


def _across(c2: Points, s: Points, eta: Eta) -> float:
    """How far to the right A comes to lie by this S."""
    start, way = complex(nominal(c2)), complex(nominal(unit(s - c2)))
    a, _ = line_circle_meet(Line(start, way), complex(nominal(eta.centre)), float(nominal(eta.radius)))
    return complex(a).real
