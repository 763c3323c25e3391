"""Small geometry for symbols: circles, arcs, rectangles, hatching and arrowheads as points in mm."""

from __future__ import annotations

import cmath
import math

from ...foundation.slotted import replace
from ..scene import Stroke
from ..style import HEAD_LENGTH, HEAD_WIDTH, THIN, Dash, Hue

HATCH = 1.7  # mm: how deep ground is hatched
NEAR = 1e-4  # mm: places closer than this are one
WIDER = 2.4  # times as wide as its line a head is at least
HOLLOW, WIDENED = 0.72, 1.45  # mm: width of a hollow shaft at least; times as wide as a full one
SAGITTA = 0.004  # mm: how far a curve may be from its chords


def arc(centre: complex, radius: float, start: float, sweep: float) -> tuple[complex, ...]:
    """Points of an arc, close enough to be called round."""
    if radius < 1e-9:
        return (centre, centre)
    chord = 2 * math.acos(max(0.0, 1 - SAGITTA / radius))
    n = max(2, math.ceil(abs(sweep) / chord))
    return tuple(centre + cmath.rect(radius, start + sweep * i / n) for i in range(n + 1))


def circle(centre: complex, radius: float) -> tuple[complex, ...]:
    """Points of a full circle, without the first one again."""
    return arc(centre, radius, 0.0, 2 * math.pi)[:-1]


def rectangle(centre: complex, along: complex, length: float, height: float) -> tuple[complex, ...]:
    """The corners of a rectangle with its long side along a unit vector."""
    u, v = along * length / 2, along * 1j * height / 2
    return (centre - u - v, centre + u - v, centre + u + v, centre - u + v)


def hatching(a: complex, b: complex, depth: float = HATCH, pitch: float = 1.3) -> tuple[tuple[complex, complex], ...]:
    """Short strokes at 45° to the right of a -> b, none beyond its ends."""
    length = abs(b - a)
    if length < 1e-9:
        return ()
    u = (b - a) / length
    n = max(1, int((length - depth) / pitch + 1e-9) + 1)
    first = (length - depth - (n - 1) * pitch) / 2 + depth
    back = depth * u * (-1 - 1j)
    return tuple((a + u * (first + i * pitch), a + u * (first + i * pitch) + back) for i in range(n))


def head_length(length: float) -> float:
    """3 mm on a vector of 9 mm and more, a third of a shorter one."""
    return min(HEAD_LENGTH, length / 3)


def head_width(length: float, line: float) -> float:
    """Two fifths of the head's length, but always much wider than its line."""
    return max(head_length(length) * HEAD_WIDTH / HEAD_LENGTH, WIDER * line)


def shaft_width(length: float, line: float) -> float:
    """The line of a very short vector is thinned so that its head still shows."""
    return min(line, max(THIN, head_length(length) / 4))


def hollow_width(line: float) -> float:
    """How wide a shaft is that has white in its middle: that of a vector found is wider than that of a known one."""
    return max(WIDENED * line, HOLLOW)


def hollow(shaft: Stroke) -> tuple[Stroke, Stroke]:
    """A shaft as two thin lines with white between them."""
    wide = hollow_width(shaft.width)
    return replace(shaft, width=wide), replace(shaft, width=wide / 2, dash=Dash.FULL, hue=Hue.WHITE)


def head(tip: complex, direction: complex, length: float, width: float) -> tuple[complex, complex, complex]:
    """A slim filled arrowhead with its point at `tip`."""
    foot = tip - direction * length
    return (tip, foot + direction * 1j * width / 2, foot - direction * 1j * width / 2)


def inside(head: tuple[complex, complex, complex], wall: float) -> tuple[complex, ...]:
    """The white of an open arrowhead, so far (mm) inside its three sides; none in one that is all wall."""
    a, b, c = head
    sides = abs(b - c), abs(c - a), abs(a - b)
    around = sum(sides)
    middle = sum(side * corner for side, corner in zip(sides, head, strict=True)) / around  # of the circle in it
    within = abs(((b - a) * (c - a).conjugate()).imag) / around
    share = 1.0 - wall / within if within else 0.0
    return tuple(middle + share * (corner - middle) for corner in head) if share > 0 else ()
