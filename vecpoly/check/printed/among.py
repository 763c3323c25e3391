"""Printed lengths of a crank-rocker whose figure is lost, held against each other by what the text alone still says.

In a limit position crank and coupler are in line: the triangle with AC = BC ∓ AB, CD and AD has the transmission angle
at C, and the pressure angle is what it lacks of 90°.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import acos, degrees, isfinite, nan, pi

import numpy as np

from ...designs.limit_lines import LimitLines
from ...problem.problem import Printed, Problem
from ...words import Words
from .verdict import MOST_DEGREES

BARS = ("AB", "BC", "CD", "AD")
FAR, STEPS = 1.5, 4001  # so much longer or shorter a length is tried, at so many places
LIMITS = (-1, 1)  # folded, extended


def among(problem: Problem, printed: Sequence[Printed]) -> Words | None:
    """That lengths printed to data that are lost contradict the pressure angle that is given, with the one length that
    alone may be to blame; None where they do not, or where nothing can be said."""
    design = problem.subject
    lengths = {one.symbol: one.value for one in printed if one.lost}
    if not isinstance(design, LimitLines) or not lengths.keys() >= set(BARS):
        return None
    given = design.alpha_1.si
    found = [pressure(lengths, way) for way in LIMITS]
    off = [degrees(abs(angle - given)) for angle in found if isfinite(angle)]
    if off and min(off) <= MOST_DEGREES:
        return None
    told = [f"{degrees(angle):.1f}°" if isfinite(angle) else "—" for angle in found]
    listed = [f"$l_{{{bar}}}$ = {lengths[bar]:.4g}" for bar in BARS]
    asked, blamed = f"$α_1$ = {degrees(given):g}°", _blamed(lengths, given)
    return Words(
        f"原书答案 {'、'.join(listed)} mm 属于原书的图，不属于本题的尺寸，却与两者共有的压力角矛盾："
        f"按此四个长度，两极限位置的压力角为 {told[0]} 和 {told[1]}，都不是 {asked}；{blamed.zh}。",
        f"The printed lengths {', '.join(listed)} mm belong to the book's own figure, not to the dimensions here, yet "
        f"contradict the pressure angle that both have: with them those in the limit positions are {told[0]} and "
        f"{told[1]}, neither of them {asked}; {blamed.en}.",
    )


def pressure(lengths: Mapping[str, float], way: int) -> float:
    """The pressure angle (rad) in a limit position; not a number where the three sides make no triangle."""
    ac, c, d = lengths["BC"] + way * lengths["AB"], lengths["CD"], lengths["AD"]
    cosine = (ac * ac + c * c - d * d) / (2 * ac * c) if ac > 0 else nan
    return abs(pi / 2 - acos(cosine)) if abs(cosine) <= 1 else nan


def _blamed(lengths: Mapping[str, float], given: float) -> Words:
    """Which length alone, if another one were meant, would put all right; of several none is told."""
    cures = [(bar, size) for bar in BARS for size in sorted(set(_cures(lengths, bar, given)))]
    if len(cures) != 1:
        return Words("不能断定是哪一个错", "which of them is wrong does not follow")
    ((bar, size),) = cures
    return Words(
        f"若只有一个错，只能是 $l_{{{bar}}}$，应为 {size:.3g} mm",
        f"if one alone is wrong it is $l_{{{bar}}}$: {size:.3g} mm would do",
    )


def _cures(lengths: Mapping[str, float], bar: str, given: float) -> Iterator[float]:
    """The values of one length, the others as printed, with which a limit position of a crank-rocker has the angle."""
    tried = lengths[bar] * np.geomspace(1 / FAR, FAR, STEPS)
    for way in LIMITS:
        gaps = np.array([pressure({**lengths, bar: float(size)}, way) - given for size in tried])
        with np.errstate(invalid="ignore"):
            for n in np.flatnonzero(gaps[:-1] * gaps[1:] <= 0):
                share = gaps[n] / (gaps[n] - gaps[n + 1])
                size = float(tried[n] + share * (tried[n + 1] - tried[n]))
                if _rocks({**lengths, bar: size}):
                    yield round(size, 6)


def _rocks(lengths: Mapping[str, float]) -> bool:
    """Whether AB is a crank and CD a rocker."""
    least, *middle, most = sorted(lengths[bar] for bar in BARS)
    return least == lengths["AB"] and least + most <= sum(middle)
