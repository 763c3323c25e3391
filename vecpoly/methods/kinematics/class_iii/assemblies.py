"""All assemblies of a class III group: the orientations of the central link in which its three loci meet in one point.

For a trial orientation two loci fix the link; what the third misses by, the gap, is a function of the orientation whose
zeros are the assemblies. Each pair of loci serves once: where one stands at the end of its range another does not.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....foundation.slotted import dataclass
from ....plane import Points, Reals, nominal
from ...desk import Desk
from ...diagram import Pose
from .loci import gap, locus_of, meet, normal_at, orientation, put
from .star import Axial, Parallel, Star

SCAN, HALVINGS = 7200, 60  # trials a turn; halvings of an interval in which the gap changes sign
OPEN = 1e-7  # of the mechanism's size: what may be open before the last digits are settled
SAME = 1e-5  # of the size, and rad: assemblies nearer than this are one
DIGITS = 6  # of Assembly.sharp that tell one way from another
ROUNDS = 12  # of the secant that settles the last digits

Three = tuple[Axial, Axial, Axial]
Grid = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Assembly:
    """Orientation (rad) and origin (mm) of the central link;
    the legs that placed it (the third checks), on which side."""

    theta: float
    at: complex
    legs: tuple[Axial, ...]
    first: bool
    sharp: float  # sine of the loci × change of the gap over the size: the best way to draw it; near 0 at a dead point

    @property
    def quality(self) -> float:
        """By what ways to draw it are compared: not by the rounding of what is as good."""
        return round(self.sharp, DIGITS)


def assemblies(desk: Desk, star: Star) -> list[Assembly]:
    """Every assembly once, each in the way that draws it best."""
    plain = bare(desk)
    size = desk.mm(desk.mech.scale)
    found = sorted(
        _turned(plain, star, star.parallel) if star.parallel else _scanned(plain, star), key=lambda one: -one.quality
    )
    kept: list[Assembly] = []
    for one in found:
        if all(
            abs(np.exp(1j * one.theta) - np.exp(1j * other.theta)) > SAME or abs(one.at - other.at) > SAME * size
            for other in kept
        ):
            kept.append(one)
    return kept


def bare(desk: Desk) -> Desk:
    """A copy of what is drawn, by the nominal hand alone."""
    return Desk(
        board=desk.board.scratch(),
        mech=desk.mech,
        at={name: complex(nominal(at)) for name, at in desk.at.items()},
        pose={
            name: Pose(complex(nominal(pose.origin)), complex(nominal(pose.along))) for name, pose in desk.pose.items()
        },
    )


def places(desk: Desk, star: Star, found: Assembly) -> dict[str, complex]:
    """Where all letters lie in this assembly (mm)."""
    copy = bare(desk)
    put(copy, star, found.at, complex(np.exp(1j * found.theta)))
    return {name: complex(at) for name, at in copy.at.items()}


def trial(desk: Desk, star: Star, legs: tuple[Axial, ...], first: bool, theta: Reals) -> Points:
    """The origin of the central link where two legs hold it in this orientation."""
    u = np.exp(1j * np.asarray(theta))
    return meet(locus_of(desk, star, legs[0], u), locus_of(desk, star, legs[1], u))[0 if first else 1]


def missed(desk: Desk, star: Star, legs: tuple[Axial, ...], first: bool, theta: Reals) -> Reals:
    """By how much the third leg is missed (mm)."""
    return gap(locus_of(desk, star, legs[2], np.exp(1j * np.asarray(theta))), trial(desk, star, legs, first, theta))


def settled(desk: Desk, star: Star, found: Assembly) -> Reals:
    """The orientation at which nothing is open, for every repeated hand (secant)."""
    now: Reals = np.asarray(found.theta) + 0.0 * np.real(sum(np.asarray(desk.at[p]) for p in desk.at))
    before, open_before = now - 1e-5, missed(desk, star, found.legs, found.first, now - 1e-5)
    for _ in range(ROUNDS):
        open_now = missed(desk, star, found.legs, found.first, now)
        change = open_now - open_before
        with np.errstate(divide="ignore", invalid="ignore"):
            step = np.where((now == before) | (change == 0), 0.0, open_now * (now - before) / change)
        before, open_before, now = now, open_now, now - np.clip(step, -0.05, 0.05)
    return now


def _turned(desk: Desk, star: Star, leg: Parallel) -> Iterator[Assembly]:
    """The orientation is given: two loci meet in one or two points."""
    u = complex(orientation(desk, star, leg))
    one, two = (locus_of(desk, star, other, u) for other in star.axial)
    for first, at in zip((True, False), meet(one, two), strict=True):
        if np.isfinite(complex(at)):
            yield Assembly(
                float(np.angle(u)), complex(at), star.axial, first, _sine(normal_at(one, at), normal_at(two, at))
            )


def _scanned(desk: Desk, star: Star) -> Iterator[Assembly]:
    a, b, c = star.axial
    grid = np.linspace(-np.pi, np.pi, SCAN + 1)
    for legs in ((a, b, c), (b, c, a), (c, a, b)):
        for first in (True, False):
            misses = np.asarray(missed(desk, star, legs, first, grid))
            k = np.flatnonzero(misses[1:] * misses[:-1] <= 0)
            before, lowest, behind = _dips(desk, star, legs, first, grid, misses)
            inside, last = _range_ends(desk, star, legs, first, grid, misses)
            low = np.concatenate([grid[k], before, lowest, inside])
            high = np.concatenate([grid[k + 1], lowest, behind, last])
            yield from _closed(desk, star, legs, first, low, high)


def _halvings(intervals: NDArray[Any]) -> range:
    """So many rounds, where there is anything to halve."""
    return range(HALVINGS if intervals.size else 0)


def _range_ends(desk: Desk, star: Star, legs: Three, first: bool, grid: Grid, misses: Grid) -> tuple[Grid, Grid]:
    """Intervals at the ends of the range in which the two loci meet, where the gap comes down to zero there."""
    sound = np.isfinite(misses)
    k = np.flatnonzero(sound[1:] != sound[:-1])
    inside, last, beyond = (np.where(sound[k], grid[a], grid[b]) for a, b in ((k, k + 1), (k, k + 1), (k + 1, k)))
    for _ in _halvings(k):
        middle = (last + beyond) / 2
        meets = np.isfinite(missed(desk, star, legs, first, middle))
        last, beyond = np.where(meets, middle, last), np.where(meets, beyond, middle)
    here, end = (np.asarray(missed(desk, star, legs, first, theta)) for theta in (inside, last))
    touches = np.abs(end) < OPEN * desk.mm(desk.mech.scale)
    crosses = (here * end <= 0) & ~touches
    return np.concatenate([inside[crosses], last[touches]]), np.concatenate([last[crosses], last[touches]])


def _dips(desk: Desk, star: Star, legs: Three, first: bool, grid: Grid, misses: Grid) -> tuple[Grid, Grid, Grid]:
    """Where the gap comes down to zero and back between two trials, near a dead point:
    before, at the lowest, behind."""
    near = np.abs(misses)
    lowest = (
        (near[1:-1] <= near[:-2])
        & (near[1:-1] <= near[2:])
        & (misses[1:-1] * misses[:-2] > 0)
        & (misses[1:-1] * misses[2:] > 0)
    )
    k = 1 + np.flatnonzero(lowest & (near[1:-1] < near[:-2] + near[2:] - 2 * near[1:-1]))
    low, high, sign = grid[k - 1], grid[k + 1], np.sign(misses[k])
    for _ in _halvings(k):
        one, two = low + (high - low) / 3, high - (high - low) / 3
        down = sign * missed(desk, star, legs, first, one) < sign * missed(desk, star, legs, first, two)
        low, high = np.where(down, low, one), np.where(down, two, high)
    crossed = sign * np.asarray(missed(desk, star, legs, first, low)) <= 0
    return grid[k - 1][crossed], low[crossed], grid[k + 1][crossed]


def _closed(desk: Desk, star: Star, legs: Three, first: bool, low: Grid, high: Grid) -> Iterator[Assembly]:
    """The zeros between these orientations, by halving; a jump of the gap is none."""
    at_low = np.asarray(missed(desk, star, legs, first, low))
    for _ in _halvings(low):
        middle = (low + high) / 2
        open_ = np.asarray(missed(desk, star, legs, first, middle))
        left = at_low * open_ <= 0
        low, high = np.where(left, low, middle), np.where(left, middle, high)
        at_low = np.where(left, at_low, open_)
    for theta in np.atleast_1d(high):
        if abs(float(missed(desk, star, legs, first, float(theta)))) < OPEN * desk.mm(desk.mech.scale):
            yield told(desk, star, legs, first, float(theta))


def told(desk: Desk, star: Star, legs: tuple[Axial, ...], first: bool, theta: float) -> Assembly:
    """The assembly in this orientation, placed by two legs on one side."""
    at, u = complex(trial(desk, star, legs, first, theta)), complex(np.exp(1j * theta))
    one, two = (locus_of(desk, star, leg, u) for leg in legs[:2])
    gaps = [float(missed(desk, star, legs, first, theta + step)) for step in (1e-6, -1e-6)]
    slope = abs(gaps[0] - gaps[1]) / 2e-6 / desk.mm(desk.mech.scale)
    sine = _sine(normal_at(one, at), normal_at(two, at))
    return Assembly(theta, at, legs, first, sine * min(slope, 1.0) if np.isfinite(slope) else 0.0)


def _sine(u: Points, v: Points) -> float:
    return abs(float(np.imag(np.conj(u) * v)))
