"""What data no crank-rocker fits, and the range in which there is one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import groupby
from math import asin, cos, degrees, sin
from operator import itemgetter
from typing import Any

import numpy as np

from ...designs.crank_rocker import LEAST, CrankRocker
from ...designs.ranged.admitted import between
from ...errors import AssemblyError
from ...words import Words
from .chord import SIDES, Chord
from .four_bar import useful
from .registry import Linkage

NEAR_END = 1e-7  # of a range that is open


def out_of_reach(design: CrankRocker) -> AssemblyError:
    """No meeting: the range in which there is a linkage, on either side of the chord."""
    if design.swing is None:
        return _no_limit(design)
    if design.best is not None:
        return _no_best(design)
    if design.AB is not None and not design.theta:
        return _half_the_chord(design.AB.text, Chord(design).s / 2)
    if design.A is not None and design.A.along == 1 and not design.theta:
        return _level_with_the_chord(design.A.text, Chord(design))
    name, given, unit, of = _datum(design)
    if not (ranges := _all_ranges(design, of)):
        return _none_at_all(design)
    told = between(ranges, unit)
    return AssemblyError(
        Words(
            f"{name} = {given}：与 K、摇杆长和摆角所定的圆没有可用的交点（无交点，或 A 在禁用弧上）；{name} 的允许范围"
            f"是{told.zh.rstrip()}",
            f"{name} = {given} has no use on the circles that K, the rocker and its swing determine (no meeting, or A "
            f"on "
            f"the forbidden arc); admissible is {name} from {told.en}",
        ),
        code="no-solution",
        numbers={"low": min(low for low, _ in ranges), "high": max(high for _, high in ranges)},
    )


def _none_at_all(design: CrankRocker) -> AssemblyError:
    return AssemblyError(
        Words(
            f"按此 K 和摆角没有曲柄摇杆机构：θ = {degrees(design.theta):.4g}° 过大；请减小 K",
            f"there is no crank-rocker with this K and swing: θ = {degrees(design.theta):.4g} deg is too large; "
            "lower K",
        ),
        code="no-solution",
    )


def _no_best(design: CrankRocker) -> AssemblyError:
    """No greatest γ_min: because there is no linkage, or because γ_min grows up to an end that none reaches."""
    if not _all_ranges(design, lambda one: one.values["gamma_min"]):
        return _none_at_all(design)
    if not design.theta:
        return AssemblyError(
            Words(
                "K = 1 时 γ_min 随连杆加长而一直增大，没有最大值（AB = C₁C₂/2 不变）；请给定 BC、AD 或 gamma_min",
                "with K = 1, γ_min grows as the coupler gets longer and has no maximum value (AB = C₁C₂/2 with any of "
                "them); give BC, AD or gamma_min",
            ),
            code="no-solution",
        )
    return AssemblyError(
        Words(
            "γ_min 随 l_AB 减小而一直增大，没有最大值；请给定 AB 或 gamma_min",
            "γ_min grows as the crank gets shorter and has no maximum value; give AB, or gamma_min",
        ),
        code="no-solution",
    )


def _all_ranges(design: CrankRocker, of: Callable[[Linkage], float]) -> list[tuple[float, float]]:
    """Of the datum, on both circles."""
    sides = SIDES if design.theta else SIDES[:1]
    ranges = [row for side in sides for row in _ranges(Chord(design), side, of)]
    if design.A is not None and design.A.along == 1j:  # a given x may be that of a mirror image
        return ranges + [(-high, -low) for low, high in ranges]
    if design.gamma_min is not None:
        return [(max(low, degrees(LEAST)), high) for low, high in ranges if high > degrees(LEAST)]
    return ranges


def _half_the_chord(given: str, half: float) -> AssemblyError:
    """K = 1: A lies on C₁C₂, whose half the crank is with any coupler."""
    return AssemblyError(
        Words(
            f"AB = {given}：K = 1 时 A 在 C₁C₂ 线上，无论连杆多长都有 AB = C₁C₂/2 = {1e3 * half:.4g} mm；请改为给定 "
            "BC、AD 或 gamma_min",
            f"AB = {given}: with K = 1 the pivot A lies on C₁C₂, and AB = C₁C₂/2 = {1e3 * half:.4g} mm with any "
            "coupler; give BC, AD or gamma_min instead",
        ),
        code="no-solution",
        numbers={"AB": half},
    )


def _level_with_the_chord(given: str, chord: Chord) -> AssemblyError:
    """K = 1: A lies on C₁C₂, which a level line does not meet, or meets everywhere."""
    height, half = 1e3 * chord.m, 1e3 * chord.s / 2
    return AssemblyError(
        Words(
            f"A：{given}；K = 1 时 A 在 C₁C₂ 线（y = {height:.4g} mm）上，水平线与它平行或重合，"
            f"不能确定 A；请改为给定竖直线，如 on x = {-2 * half:.4g} mm，|x| 须大于 C₁C₂/2 = {half:.4g} mm",
            f"A {given}: with K = 1 the pivot A lies on C₁C₂, the line y = {height:.4g} mm, which a level line is "
            f"parallel to, or is itself: A does not follow; give an upright one, e.g. on x = {-2 * half:.4g} mm, where "
            f"|x| must be more than C₁C₂/2 = {half:.4g} mm",
        ),
        code="no-solution",
        numbers={"half": half / 1e3},
    )


def _datum(design: CrankRocker) -> tuple[str, str, str, Callable[[Linkage], float]]:
    """What is given beside K and the rocker: name, as written, unit, and what it is of a linkage."""
    if design.A is not None:
        of_x = design.A.along == 1j
        return "A", design.A.text, "mm", lambda one: 1e3 * (one.pins["A"].real if of_x else one.pins["A"].imag)
    for name in ("AB", "BC", "AD"):
        if (length := getattr(design, name)) is not None:
            return name, length.text, "mm", lambda one, key=name: one.values[key]
    text = design.gamma_min.text if design.gamma_min is not None else ""
    return "gamma_min", text, "deg", lambda one: one.values["gamma_min"]


def _ranges(chord: Chord, side: int, of: Callable[[Linkage], float]) -> Iterator[tuple[float, float]]:
    """The least and the greatest of a number over each row of linkages with A on one side of the chord."""

    def valid(t: Any) -> Any:
        return useful(chord.tried(t, side), 0j, *chord.ends)

    places = np.array([NEAR_END, *np.linspace(0, 1, 402)[1:-1], 1 - NEAR_END])
    changes = np.flatnonzero(np.diff(valid(places)))
    edges = [_edge(valid, float(places[i]), float(places[i + 1])) for i in changes]
    tried = np.sort([*places, *edges])
    for good, row in groupby(zip(valid(tried).tolist(), tried.tolist(), strict=True), key=itemgetter(0)):
        if good:
            values = [of(chord.at(complex(chord.tried(t, side)))) for _, t in row]
            yield min(values), max(values)


def _edge(valid: Callable[[float], Any], one: float, other: float) -> float:
    """The last place that is valid, between one that is and one that is not."""
    good, bad = (one, other) if valid(one) else (other, one)
    for _ in range(50):
        middle = (good + bad) / 2
        good, bad = (middle, bad) if valid(middle) else (good, middle)
    return good


def _no_limit(design: CrankRocker) -> AssemblyError:
    assert design.AD is not None and design.ADC is not None
    d, c = design.AD.si, design.CD.si
    c1 = d - c * complex(cos(design.ADC.si), -sin(design.ADC.si))
    gap = min(d * abs((c1 / abs(c1) * complex(cos(turn), sin(turn))).imag) for turn in (-design.theta, design.theta))
    least = abs(c1.imag) / abs(c1)
    most = degrees(asin(min(1.0, least)) + asin(min(1.0, c / d)))
    return AssemblyError(
        Words(
            f"过 A 与 AC₁ 成 θ = {degrees(design.theta):.4g}° 的射线距 D {1e3 * gap:.4g} mm，大于摇杆长 "
            f"{design.CD.text}，"
            f"没有另一极限位置；θ 不得大于 {most:.4g}°，即 K ≤ {(180 + most) / (180 - most):.4g}",
            f"the ray from A at θ = {degrees(design.theta):.4g} deg to AC₁ passes D at {1e3 * gap:.4g} mm, more than "
            f"the "
            f"rocker of {design.CD.text}: there is no other limit; admissible is θ up to {most:.4g} deg, "
            f"K ≤ {(180 + most) / (180 - most):.4g}",
        ),
        code="no-solution",
        numbers={"gap": gap, "theta": design.theta},
    )
