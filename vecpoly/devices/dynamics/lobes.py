"""How often two curves cross over a period, and about how much work lies between: how large a figure will be, and how
many quantities it has to name. What these are is found on paper, and by the oracle, each in its own way."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from .curve import Curve

NOTHING = 1e-9  # of the largest difference


@dataclass(frozen=True, slots=True, kw_only=True)
class Strip:
    """A part of the period in which both curves are straight: where it begins and ends, and their difference there."""

    start: float
    end: float
    first: float
    last: float

    @property
    def work(self) -> float:
        """The area between."""
        return (self.end - self.start) * (self.first + self.last) / 2


def at(curve: Curve, phi: float, period: float, *, before: bool) -> float:
    """The value at an angle; at a jump the one before it or behind it."""
    corners = curve.over(period)
    pairs = [pair for pair in pairwise(corners) if pair[0][0] < pair[1][0]]
    inside = [pair for pair in pairs if (pair[0][0] < phi <= pair[1][0] if before else pair[0][0] <= phi < pair[1][0])]
    (a, u), (b, v) = inside[0] if inside else (pairs[0] if phi <= pairs[0][0][0] else pairs[-1])
    return u + (v - u) * (phi - a) / (b - a)


def strips(upper: Curve, lower: Curve, period: float) -> tuple[Strip, ...]:
    """The parts of the period between the corners of either curve, with the difference upper − lower."""
    places = sorted({phi for curve in (upper, lower) for phi, _ in curve.over(period)})
    return tuple(
        Strip(
            start=a,
            end=b,
            first=at(upper, a, period, before=False) - at(lower, a, period, before=False),
            last=at(upper, b, period, before=True) - at(lower, b, period, before=True),
        )
        for a, b in pairwise(places)
    )


def works(upper: Curve, lower: Curve, period: float) -> tuple[float, ...]:
    """The works between one meeting of the curves and the next, from the beginning of the period (J); those on both
    sides of a place where they only touch have one sign."""
    found, sign, touched = [0.0], 0.0, False
    parts = strips(upper, lower, period)
    eye = NOTHING * max(abs(value) for part in parts for value in (part.first, part.last))
    for phi, value, work in _samples(parts):
        if abs(value) <= eye:
            touched = touched or (sign != 0.0 and 0.0 < phi < period)
        else:
            now = 1.0 if value > 0 else -1.0
            if sign and (now != sign or touched):
                found.append(0.0)
            sign, touched = now, False
        found[-1] += work
    return tuple(found)


def _samples(parts: Sequence[Strip]) -> list[tuple[float, float, float]]:
    """Place, difference there, and the work of the half strip of that sign that belongs to it."""
    rows = []
    for one in parts:
        if one.first * one.last < 0:
            cut = one.start + (one.end - one.start) * one.first / (one.first - one.last)
            first, last = (cut - one.start) * one.first / 2, (one.end - cut) * one.last / 2
        else:
            first, last = 0.0, one.work
            if abs(one.last) < abs(one.first):
                first, last = last, first
        rows += [(one.start, one.first, first), (one.end, one.last, last)]
    return rows


def levels(found: Sequence[float]) -> tuple[float, ...]:
    """The energy at the beginning, and after each work."""
    at_each = [0.0]
    for work in found:
        at_each.append(at_each[-1] + work)
    return tuple(at_each)
