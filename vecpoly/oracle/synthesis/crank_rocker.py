"""Every crank-rocker with a given K and rocker, from the law of chords.

(2 a cos(θ/2))² + (2 b sin(θ/2))² = C₁C₂², for AC₁ = b − a, AC₂ = b + a and the angle θ between them.
"""

from __future__ import annotations

from collections.abc import Iterator
from math import cos, isclose, sin, sqrt, tan
from typing import Any

from ...designs.crank_rocker import CrankRocker
from ...designs.verdict import Verdict
from ...foundation.bounds import below
from .chord import SIDES, Chord
from .four_bar import NEAR, found, useful_angles
from .reach import out_of_reach
from .registry import Linkage, synthesizes
from .sweep import crossings, summits


@synthesizes(CrankRocker, out_of_reach)
def crank_rockers(design: CrankRocker) -> list[Linkage]:
    """Every candidate, by whatever is given beside K and the rocker."""
    return list(_by_limit(design) if design.swing is None else _by_swing(design, Chord(design)))


def _by_swing(design: CrankRocker, chord: Chord) -> Iterator[Linkage]:
    if design.AB is not None:
        a = design.AB.si
        if chord.theta > 0 and below(a, chord.s / 2):
            yield from (chord.of_crank(a, side) for side in SIDES)
    elif design.BC is not None:
        yield from _by_coupler(chord, design.BC.si)
    elif design.AD is not None or design.A is not None:
        yield from (chord.at(a, verdict) for a, verdict in _carried(design, chord))
    else:
        yield from _by_angle(design, chord)


def _by_coupler(chord: Chord, b: float) -> Iterator[Linkage]:
    square = (chord.s**2 - (2 * b * sin(chord.theta / 2)) ** 2) / (2 * cos(chord.theta / 2)) ** 2
    if square > 0 and below(chord.s / 2, b):
        sides = SIDES if chord.theta > 0 else SIDES[:1]
        yield from (chord.at(complex(chord.pivot(sqrt(square), b, side))) for side in sides)


def _carried(design: CrankRocker, chord: Chord) -> Iterator[tuple[complex, Verdict | None]]:
    """A on a locus of the chord, and at the distance AD from D or on the given line."""
    if chord.theta == 0:
        for a in _on_chord_line(design, chord):
            yield a, None if abs(a.real) > chord.s / 2 + NEAR * chord.c else Verdict.FAR_ARC
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

        def both(t: Any, side: int = side) -> tuple[Any, Any]:
            return useful_angles(chord.near(t, side), 0j, *chord.ends)

        at = crossings(both, design.gamma_min.si) if design.gamma_min is not None else summits(both)
        yield from (chord.at(complex(chord.near(t, side))) for t in at)


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
                yield found(0j, complex(d), c1, ray * far, None if far > NEAR * c else Verdict.FAR_ARC)
