"""Every crank-rocker with given limit lines of its coupler: two lines meet in A, a bisector and a line in D."""

from __future__ import annotations

from cmath import exp

from ...designs.limit_lines import LimitLines
from ...errors import AssemblyError
from ...words import Words
from .four_bar import found
from .registry import Linkage, synthesizes

PARALLEL = 1e-9


@synthesizes(LimitLines)
def limit_lines(design: LimitLines) -> list[Linkage]:
    """D at C₁ + t u, u at 90° − α₁ to C₁A on either side, as far from C₂: t = |C₁C₂|² / (2 u · C₁C₂)."""
    c1, c2 = design.C1.at, design.C2.at
    u1, u2 = exp(1j * design.line_1.si), exp(1j * design.line_2.si)
    sine = _cross(u1, u2)
    if abs(sine) < PARALLEL:
        raise _parallel(Words("两极限位置的连杆线平行，没有交点 A", "the two lines of the coupler are parallel: no A"))
    a = c1 + u1 * _cross(c2 - c1, u2) / sine
    if a == c1:
        raise _parallel(Words("直线 line_2 过 C₁，A 与 C₁ 重合", "line_2 passes through C₁: A is C₁"))
    made = []
    for way in (1j, -1j):
        along = (a - c1) / abs(a - c1) * way * exp(-way * design.alpha_1.si)
        lean = 2 * (along.conjugate() * (c2 - c1)).real
        if abs(lean) > PARALLEL * abs(c2 - c1):
            made.append(found(a, c1 + along * abs(c2 - c1) ** 2 / lean, c1, c2))
    if not made:
        raise _parallel(Words("C₁D 线与 C₁C₂ 的中垂线平行，没有交点 D", "C₁D is parallel to the bisector: no D"))
    return made


def _cross(u: complex, v: complex) -> float:
    return (u.conjugate() * v).imag


def _parallel(words: Words) -> AssemblyError:
    return AssemblyError(
        words + Words("；请改动 line_1、line_2 或 alpha_1", "; change line_1, line_2 or alpha_1"), code="no-solution"
    )
