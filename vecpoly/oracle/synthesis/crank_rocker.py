"""Every crank-rocker with a given K and rocker, from the law of chords.

2 a² (1 + cos θ) + 2 b² (1 − cos θ) = C₁C₂², for AC₁ = b − a, AC₂ = b + a and the angle θ between them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import asin, cos, degrees, isclose, nan, radians, sin, sqrt, tan

import numpy as np

from ...designs.crank_rocker import CrankRocker
from ...designs.verdict import Verdict
from ...errors import AssemblyError
from ...words import Words
from .four_bar import found
from .registry import Linkage, synthesizes
from .sweep import crossings, summits

NEAR_END = 1e-7  # of a range that is open
SIDES = (-1, 1)  # A below the chord C₁C₂, where D is, or above it


@synthesizes(CrankRocker)
def crank_rockers(design: CrankRocker) -> list[Linkage]:
    """Every candidate, by whatever is given beside K and the rocker."""
    made = list(_by_limit(design) if design.swing is None else _by_swing(design, Chord(design)))
    if not made:
        raise _out_of_reach(design)
    return made


class Chord:
    """The limit positions, evenly beside the y axis with D in the origin: C₁, C₂ = (∓s/2, m)."""

    def __init__(self, design: CrankRocker) -> None:
        assert design.swing is not None
        self.c, self.theta = design.CD.si, design.theta
        self.s, self.m = 2 * self.c * sin(design.swing.si / 2), self.c * cos(design.swing.si / 2)
        self.ends = complex(-self.s / 2, self.m), complex(self.s / 2, self.m)

    def at(self, a_pin: complex, verdict: Verdict | None = None) -> Linkage:
        """The candidate with this A."""
        return found(a_pin, 0j, *self.ends, verdict)

    def pivot(self, a: float, b: float, side: int) -> complex:
        """A of the crank a and coupler b, on the left: 2 s x = AC₁² − AC₂² = −4 a b."""
        x = -2 * a * b / self.s
        return complex(x, self.m + side * sqrt(max((b - a) ** 2 - (x + self.s / 2) ** 2, 0.0)))

    def coupler(self, a: float) -> float:
        """b of a crank by the law of chords; NaN where there is none."""
        square = (self.s**2 - 2 * a * a * (1 + cos(self.theta))) / (2 * (1 - cos(self.theta)))
        return sqrt(square) if square > 0 else nan

    def of_crank(self, a: float, side: int) -> Linkage:
        """The candidate with this crank."""
        return self.at(self.pivot(a, self.coupler(a), side))

    def tried(self, t: float, side: int) -> Linkage:
        """A candidate of all, t from 0 to 1: by its crank, or at K = 1 by its coupler."""
        if self.theta:
            return self.of_crank(t * self.s / 2, side)
        return self.at(self.pivot(self.s / 2, self.s / 2 / t, -1))

    def sees(self, a_pin: complex, side: int) -> Verdict | None:
        """That from A the chord is seen under π − θ, where it is."""
        return None if side * (a_pin.imag - self.m) > 0 else Verdict.FAR_ARC


def _by_swing(design: CrankRocker, chord: Chord) -> Iterator[Linkage]:
    if design.AB is not None:
        a = design.AB.si
        if chord.theta > 0 and a < chord.s / 2:
            yield from (chord.of_crank(a, side) for side in SIDES)
    elif design.BC is not None:
        yield from _by_coupler(chord, design.BC.si)
    elif design.AD is not None or design.A is not None:
        yield from (chord.at(a, verdict) for a, verdict in _carried(design, chord))
    else:
        yield from _by_angle(design, chord)


def _by_coupler(chord: Chord, b: float) -> Iterator[Linkage]:
    square = (chord.s**2 - 2 * b * b * (1 - cos(chord.theta))) / (2 * (1 + cos(chord.theta)))
    if square > 0 and b > chord.s / 2:
        sides = SIDES if chord.theta > 0 else SIDES[:1]
        yield from (chord.at(chord.pivot(sqrt(square), b, side)) for side in sides)


def _carried(design: CrankRocker, chord: Chord) -> Iterator[tuple[complex, Verdict | None]]:
    """A on a locus of the chord, and at the distance AD from D or on the given line."""
    if chord.theta == 0:
        for a in _on_chord_line(design, chord):
            yield a, None if abs(a.real) > chord.s / 2 else Verdict.FAR_ARC
        return
    for side in SIDES:
        y0, radius = chord.m + side * chord.s / 2 / tan(chord.theta), chord.s / 2 / sin(chord.theta)
        for a in _on_circle(design, y0, radius):
            yield a, chord.sees(a, side)


def _on_chord_line(design: CrankRocker, chord: Chord) -> Iterator[complex]:
    if design.AD is not None and design.AD.si > chord.m:
        yield complex(-sqrt(design.AD.si**2 - chord.m**2), chord.m)
    elif design.A is not None and design.A.along == 1j:
        yield complex(design.A.at.real, chord.m)


def _on_circle(design: CrankRocker, y0: float, radius: float) -> Iterator[complex]:
    if design.AD is not None:
        d = design.AD.si
        if abs(y0) > 1e-12 * radius:
            y = (d * d + y0 * y0 - radius * radius) / (2 * y0)
            if abs(y) <= d:
                yield complex(-sqrt(d * d - y * y), y)
    elif design.A is not None and design.A.along == 1j:
        x = design.A.at.real
        if abs(x) <= radius:
            yield from (complex(x, y0 + way * sqrt(radius**2 - x * x)) for way in (1, -1))
    elif design.A is not None:
        y = design.A.at.imag
        if abs(y - y0) <= radius:
            yield complex(-sqrt(radius**2 - (y - y0) ** 2), y)


def _by_angle(design: CrankRocker, chord: Chord) -> Iterator[Linkage]:
    """A with a given least transmission angle, or with the greatest."""
    for side in SIDES if chord.theta else SIDES[:1]:

        def gamma(t: float, side: int = side) -> float:
            one = chord.tried(t, side)
            return radians(one.values["gamma_min"]) if one.verdict is Verdict.VALID else nan

        at = crossings(gamma, design.gamma_min.si, 0, 1) if design.gamma_min is not None else summits(gamma, 0, 1)
        yield from (chord.tried(t, side) for t in at)


def _by_limit(design: CrankRocker) -> Iterator[Linkage]:
    """AD on the x axis and ∠ADC in one limit: C₂ lies on a ray from A at θ to AC₁, at the distance CD from D."""
    assert design.AD is not None and design.ADC is not None
    d, c = design.AD.si, design.CD.si
    c1 = d - c * complex(cos(design.ADC.si), -sin(design.ADC.si))
    for turn in (-design.theta, design.theta) if design.theta else (0.0,):
        ray = c1 / abs(c1) * complex(cos(turn), sin(turn))
        middle, power = ray.real * d, d * d - c * c
        if middle * middle < power:
            continue
        for way in (1, -1):
            far = middle + way * sqrt(middle * middle - power)
            if design.theta or not isclose(far, abs(c1), rel_tol=1e-9):
                yield found(0j, complex(d), c1, ray * far, None if far > 0 else Verdict.FAR_ARC)


def _out_of_reach(design: CrankRocker) -> AssemblyError:
    """No meeting: the range in which there is a linkage, on either side of the chord."""
    if design.swing is None:
        return _no_limit(design)
    name, given, unit, of = _datum(design)
    ranges = [(low, high) for side in SIDES for low, high in _range(Chord(design), side, of)]
    if not ranges:
        return AssemblyError(Words("K = 1 时 l_AB 只能是 C₁C₂/2", "at K = 1 the crank is half of C₁C₂"))
    zh = " 或 ".join(f"{low:.4g} 至 {high:.4g} {unit}" for low, high in ranges)
    en = " or ".join(f"{low:.4g} to {high:.4g} {unit}" for low, high in ranges)
    return AssemblyError(
        Words(
            f"{name} = {given}：与 K、摇杆长和摆角所定的圆没有可用的交点；{name} 的允许范围是 {zh}",
            f"{name} = {given} meets neither of the circles that K, the rocker and its swing determine; "
            f"admissible is {name} from {en}",
        ),
        code="no-solution",
        numbers={"low": ranges[0][0], "high": ranges[-1][1]},
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


def _range(chord: Chord, side: int, of: Callable[[Linkage], float]) -> Iterator[tuple[float, float]]:
    """The least and the greatest of a number over the linkages with A on one side of the chord."""
    tried = (chord.tried(t, side) for t in (NEAR_END, *np.linspace(0, 1, 2002)[1:-1], 1 - NEAR_END))
    if values := [of(one) for one in tried if one.verdict is Verdict.VALID]:
        yield min(values), max(values)


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
