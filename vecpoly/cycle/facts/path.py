"""The path of a point over the cycle: its length and its shape."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from itertools import pairwise
from math import isfinite, tau

import numpy as np
from numpy.typing import NDArray

from ...mechanism.profiles import refuse_centre
from ..cycle import Cycle
from ..extremes import Extremes, Spot, extremes
from ..root import ridders
from ..sample import sample
from .crossings import crossings

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
STEPS = 1440
_WHOLE = 1e-6
FAR = 1e3  # times the mechanism's size: a point beyond it runs off to infinity


class Shape(StrEnum):
    """What a path is."""

    STILL = "still"
    CIRCLE = "circle"
    ARC = "arc"  # swept to and fro
    LINE = "line"  # a straight piece, to and fro
    CURVE = "curve"


@dataclass(frozen=True, slots=True)
class Crossing:
    """A point (m) through which the path passes twice, at two positions of the drive (rad)."""

    at: complex
    first: float
    second: float


@dataclass(frozen=True, slots=True)
class Path:
    """The path of a point.

    length: m, the way travelled: there and back where it is swept to and fro, ∞ where it runs off to infinity; once: m,
    the length of the arc, circle or straight piece itself, None of another shape; closed: whether it ends where it
    began; crossings: self-intersections;
    cusps: where the point stands still for a moment and turns back, (place in m, position of the drive); turning: how
    often the tangent turns
    round (counter-clockwise positive, as the drive moves), None of a path with cusps or an open one; inflections:
    positions of the drive (rad) at
    which such a path bends the other way; low, high: corners of its box.
    """

    point: str
    shape: Shape
    length: float
    closed: bool
    crossings: tuple[Crossing, ...]
    cusps: tuple[tuple[complex, float], ...]
    turning: int | None
    low: complex
    high: complex
    inflections: tuple[float, ...] = ()
    once: float | None = None

    @property
    def passes(self) -> int | None:
        """How often an arc, a circle or a straight piece is run along; None where its parts are run unequally often."""
        if not self.once or not isfinite(self.length):
            return None
        times = self.length / self.once
        return round(times) if abs(times - round(times)) < _WHOLE * times else None


def path(cycle: Cycle, point: str) -> Path:
    """Length, self-intersections, cusps and turning number of the path of a point (a letter).

    Length: ∫ |dp/dφ| dφ over the cycle. Raises UnknownNameError; NoMethodError of a profile's centre of curvature.
    """
    even = cycle.once.steady
    cycle.info(f"p_{point}")
    refuse_centre(cycle.mech.cams, point)
    phi = np.linspace(even.low, even.high, STEPS + 1)
    here = sample(even.mech, None, phi)
    p = np.asarray(here.value(f"p_{point}"), np.complex128)
    v = np.asarray(here.value(f"v_{point}") / even.mech.drive.rate, np.complex128)
    size = even.mech.scale
    with np.errstate(invalid="ignore"):
        sound = np.isfinite(p)
        away = np.abs(p - np.median(p[sound])) > FAR * size
    if away.any():
        return _endless(point, p[sound & ~away])
    p, v, phi = p[sound], v[sound], phi[sound]
    low, high = complex(p.real.min(), p.imag.min()), complex(p.real.max(), p.imag.max())
    closed = bool(abs(p[-1] - p[0]) < 1e-9 * size)
    if abs(high - low) < 1e-9 * size:
        return Path(point, Shape.STILL, 0.0, True, (), (), None, low, high)
    shape = shape_of(p, v, size)
    shape = Shape.ARC if shape is Shape.CIRCLE and not closed else shape
    speeds = extremes(even, f"v_{point}")
    length = _length(even, point, phi, p, v, speeds.zeros)
    if shape is not Shape.CURVE:
        turns = round(_turned(even, point, phi, v)) if shape is Shape.CIRCLE and closed else None
        once = _once(even, point, shape, phi, speeds.zeros)
        return Path(point, shape, length, closed, (), (), turns, low, high, once=once)
    cusps = _cusps(even, point, v, speeds.minima)
    smooth = closed and not cusps and even.whole and bool(np.isfinite(v).all()) and not _kinks(even, point, speeds)
    turning = round(_turned(even, point, phi, v)) if smooth else None
    found = tuple(Crossing(at, first, second) for at, first, second in crossings(even, point, phi, p, closed))
    bends = _inflections(even, point, phi) if smooth else ()
    return Path(point, shape, length, closed, found, cusps, turning, low, high, bends)


def _endless(point: str, p: Points) -> Path:
    """A path that runs off to infinity: what is near has a shape and a box, nothing else can be told."""
    low, high = complex(p.real.min(), p.imag.min()), complex(p.real.max(), p.imag.max())
    shape = shape_of(p, np.gradient(p), float(np.abs(p).max()))
    return Path(point, shape, float("inf"), False, (), (), None, low, high)


def shape_of(p: Points, v: Points, size: float) -> Shape:
    """Straight, on a circle, or neither, to 1e-9 of the mechanism's size."""
    away = p - p.mean()
    if np.abs((away * _axis(away).conjugate()).imag).max() < 1e-9 * size:
        return Shape.LINE
    centre, radius = _round(away)
    if np.abs(np.abs(away - centre) - radius).max() > 1e-9 * max(size, radius):
        return Shape.CURVE
    sense = ((away - centre).conj() * v).imag
    known = sense[np.isfinite(sense)]
    return Shape.CIRCLE if (known > 0).all() or (known < 0).all() else Shape.ARC


def _axis(away: Points) -> complex:
    """The direction in which points about their mean are spread most."""
    return complex(np.exp(0.5j * np.angle((away**2).sum())))


def _round(away: Points) -> tuple[complex, float]:
    """Centre and radius of the circle through points about their mean, by least squares."""
    rows = np.stack([2 * away.real, 2 * away.imag, np.ones(len(away))], axis=1)
    x, y, c = np.linalg.lstsq(rows, np.abs(away) ** 2, rcond=None)[0]
    return complex(x, y), float(np.sqrt(max(c + x * x + y * y, 0.0)))


def _once(cycle: Cycle, point: str, shape: Shape, phi: Reals, still: tuple[Spot, ...]) -> float:
    """The length of the arc, circle or straight piece itself, however often it is run along: m."""
    phi = np.sort([*phi, *(spot.phi for spot in still)])
    p = np.asarray(sample(cycle.mech, None, phi).value(f"p_{point}"), np.complex128)
    away = p - p.mean()
    if shape is Shape.LINE:
        return float(np.ptp((away * _axis(away).conjugate()).real))
    centre, radius = _round(away)
    return float(radius * min(np.ptp(np.unwrap(np.angle(away - centre))), tau))


def _length(cycle: Cycle, point: str, phi: Reals, p: Points, v: Points, still: tuple[Spot, ...]) -> float:
    """Trapezoid of |dp/dφ| all round, which converges fast on a smooth closed path;
    between reversals by chords of Simpson's kind elsewhere."""
    speed = np.abs(v)
    if not np.isfinite(speed).all():
        return float(np.abs(np.diff(p)).sum())
    step = np.diff(phi)
    if cycle.whole and not still:
        return float((speed[1:] + speed[:-1]) @ step / 2)
    knots = np.array([cycle.low, *(spot.phi for spot in still), cycle.high])
    nodes, weights = np.polynomial.legendre.leggauss(24)
    parts = np.concatenate([np.linspace(a, b, 25) for a, b in pairwise(knots) if b - a > 1e-12])
    a, b = parts[:-1], parts[1:]
    places = ((a + b) / 2)[:, None] + ((b - a) / 2)[:, None] * nodes
    values = np.abs(sample(cycle.mech, None, places.ravel()).value(f"v_{point}") / cycle.mech.drive.rate).reshape(
        places.shape
    )
    return float(np.nansum((values @ weights) * (b - a) / 2))


def _cusps(cycle: Cycle, point: str, v: Points, minima: tuple[Spot, ...]) -> tuple[tuple[complex, float], ...]:
    """Where the velocity passes zero: |v| below 1e-7 of its largest."""
    fastest = float(np.nanmax(np.abs(v))) * abs(cycle.mech.drive.rate)
    still = [spot.phi for spot in minima if spot.value < 1e-7 * fastest]
    if not still:
        return ()
    places = np.asarray(cycle.at(f"p_{point}", np.array(still)))
    return tuple((complex(z), q) for z, q in zip(places, still, strict=True))


def _inflections(cycle: Cycle, point: str, phi: Reals) -> tuple[float, ...]:
    """Where the curvature v × a passes zero, to full accuracy."""

    def bend(at: Reals) -> Reals:
        here = sample(cycle.mech, None, at)
        return np.asarray((np.conj(here.value(f"v_{point}")) * here.value(f"a_{point}")).imag, np.float64)

    curvature = bend(phi)
    change = np.flatnonzero(curvature[:-1] * curvature[1:] < 0)
    found = ridders(bend, phi[change], phi[change + 1])
    return tuple(float(q) for q in found[np.isfinite(found)])


def _kinks(cycle: Cycle, point: str, speeds: Extremes) -> bool:
    """Whether the velocity jumps somewhere:
    at a change point the path has a corner, and its tangent no number of turns."""
    phi, v = cycle.on_grid(f"v_{point}")
    step = np.abs(np.diff(v))
    top = speeds.highest.value if speeds.highest is not None else 0.0
    where = int(np.argmax(step))
    fine = np.linspace(phi[where], phi[where + 1], 65)
    between = np.abs(np.diff(np.asarray(cycle.at(f"v_{point}", fine))))
    return not np.isfinite(top) or bool(between.max() > 0.5 * step[where] and step[where] > 1e-3 * top)


def _turned(cycle: Cycle, point: str, phi: Reals, v: Points) -> float:
    """Turns of the tangent; the grid is halved wherever the tangent turns more than 0.4 rad in a step."""
    for _ in range(24):
        turn = np.angle(v[1:] * v[:-1].conj())
        steep = np.flatnonzero(np.abs(turn) > 0.4)
        if not steep.size:
            break
        between = (phi[steep] + phi[steep + 1]) / 2
        speed = np.asarray(sample(cycle.mech, None, between).value(f"v_{point}")) / cycle.mech.drive.rate
        phi, v = np.insert(phi, steep + 1, between), np.insert(v, steep + 1, speed)
    turned = float(np.angle(v[1:] * v[:-1].conj()).sum()) / (2 * np.pi)
    return turned if cycle.mech.drive.rate > 0 else -turned
