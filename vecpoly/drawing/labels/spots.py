"""All the places where a letter could stand: round a point, along both sides of a line, or farther off on a leader."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ...foundation.slotted import dataclass
from .about.bounds import Complexes, Floats, Indices
from .want import Thing, Want

DIRECTIONS = np.exp(2j * np.pi * np.arange(24) / 24)
GAPS = (0.55, 0.95, 1.9, 3.0, 4.4)
OFF, NEAR = 7.0, 2.5  # what a letter of a point costs that stands farther from it than this (mm)
TIGHT = 2.0  # what the closest of them costs beyond its distance: a digit all but touches a thick bar there
FAR = (5.5, 6.5, 8.0, 9.5, 11.0, 13.0)
CROWD = (12.0, 14.2, 15.5, 16.8, 18.0), (20.0, 22.0, 24.5, 27.0, 30.0)
# In a crowd; the usual ones come first, so that each place keeps its number.
FARTHER = (*FAR, *CROWD[0], *CROWD[1])
LED = 5  # from so many of the places along a line, the first, a leader may start
LEADER = 22.0  # what resorting to a leader line costs
LETTERED = 12.0  # what it costs beyond that for the letter of a point: first of all that stands beside its own
SOONER = 0.4  # of that in a crowd: a leader tells better than a place beside something else
PER_DISTANCE, PER_FRACTION = 1.2, 6.0
SHORT = 0.8  # mm that a leader ends before the lettering
BENT, STRAIGHT = 14.0, 0.6  # what a leader costs whose cosine to the line that it names is less
BEHIND, ASLANT = 60.0, 0.2  # what a leader of the frame's number costs that runs over its guide; cosine
LEVEL, OFF_LEVEL = GAPS[1], 24.0  # where the numbers of an axis stand, and what a mm off that line costs
SHIFTED = 2.0  # times what other letters pay for the next place along a line pays a number for one beside its tick


@dataclass(frozen=True, slots=True)
class Spots:
    """Places for the middle of a label: what each costs, and the foot of its leader line (nan: none)."""

    centre: Complexes
    cost: Floats
    foot: Complexes
    root: Complexes  # of the thing that is named, where the place is nearest to it

    def some(self, which: Indices) -> Spots:
        """Some of them."""
        return Spots(self.centre[which], self.cost[which], self.foot[which], self.root[which])

    @property
    def parts(self) -> tuple[Complexes, Floats, Complexes, Complexes]:
        """All that is known of them."""
        return self.centre, self.cost, self.foot, self.root


def spots(want: Want, middle: complex) -> Spots:
    """All the places to be tried for a label; `middle`: of the figure, from which letters tend away."""
    near, led = beside(want, middle), on_leaders(want)
    joined = (np.concatenate(pair) for pair in zip(near.parts, led.parts, strict=True))
    return Spots(*joined)


def beside(want: Want, middle: complex) -> Spots:
    """The places beside what the label names."""
    half, all_round = _half(want), _all_round(want)
    feet, number = np.array(want.feet)[:, None], np.arange(len(want.feet))[:, None] / len(want.feet)
    normals = np.array(want.normals)[:, None]
    sides = DIRECTIONS[None] if all_round else normals if want.one_sided else np.hstack([normals, -normals])
    away, reach = feet - middle, np.abs(feet - middle)
    away = np.where(reach > 1, away / np.maximum(reach, 1.0), 0j)
    base = PER_FRACTION * (SHIFTED if want.level else 1.0) * number + 1.0 * (1 - (sides * away.conjugate()).real)
    gap = np.array(GAPS)[:, None]
    near = feet[..., None] + _offset(sides[:, None], want.radius + want.clear + gap, half, all_round)
    by_gap = PER_DISTANCE * gap + TIGHT * (gap == GAPS[0]) + OFF_LEVEL * want.level * np.abs(gap - LEVEL)
    by_gap += OFF * (want.thing is Thing.POINT) * (gap > NEAR)
    return Spots(
        near.ravel(),
        (base[:, None] + by_gap).ravel(),
        np.full(near.size, complex(math.nan, math.nan)),
        np.broadcast_to(feet[..., None], near.shape).ravel(),
    )


def rings(want: Want) -> tuple[tuple[float, ...], ...]:
    """How far off its leaders may be, the shortest first; those of a crowd are seldom asked for."""
    return (FAR, *CROWD) if want.farther else (FAR,)


def on_leaders(want: Want, ring: tuple[float, ...] | None = None) -> Spots:
    """The places farther off; of one ring of them alone where it is said."""
    feet, number = np.array(want.feet[:LED])[:, None], np.arange(len(want.feet))[:LED, None] / len(want.feet)
    far = np.array(ring or (FARTHER if want.farther else FAR))[:, None, None]
    led = feet + _offset(DIRECTIONS, want.radius + far, _half(want), True)
    at = np.broadcast_to(feet + DIRECTIONS * (want.radius if _all_round(want) else 0.0), led.shape).ravel()
    if want.one_sided and want.thing is Thing.LINK:
        at = np.broadcast_to(feet + want.radius * np.array(want.normals[:LED])[:, None], led.shape).ravel()
    dear = np.broadcast_to(price_of_leader(want) + PER_DISTANCE * far + PER_FRACTION * number + bent(want), led.shape)
    return Spots(led.ravel(), dear.ravel(), at, at)


def bent(want: Want) -> Floats:
    """What leaders in all directions cost that leave the line of a direction sideways: with its end they would be taken
    for the sign of a right angle; and those of the frame's number that do not come from the side of its hatching."""
    a, b = want.own
    if want.one_sided and want.thing is Thing.LINK:
        behind: Floats = BEHIND * ((DIRECTIONS * np.conj(want.normals[0])).real < ASLANT)
        return behind
    if want.thing is not Thing.DIRECTION or a == b:
        return np.zeros(len(DIRECTIONS))
    along = np.abs((DIRECTIONS * ((b - a) / abs(b - a)).conjugate()).real)
    result: Floats = BENT * (along < STRAIGHT)
    return result


def price_of_leader(want: Want) -> float:
    """What resorting to a leader costs a label, however short it is."""
    return LEADER * (SOONER if want.farther else 1.0) + (LETTERED if want.thing is Thing.POINT else 0.0)


def ends(foot: Complexes, centre: Complexes, half: Complexes | complex) -> Complexes:
    """Where leaders end, just short of labels with these middles and halves of their sizes."""
    w, h, off = half.real + SHORT, half.imag + SHORT, foot - centre
    return centre + np.clip(off.real, -w, w) + 1j * np.clip(off.imag, -h, h)


def _half(want: Want) -> complex:
    return complex(want.width / 2, want.height / 2)


def _all_round(want: Want) -> bool:
    return want.normals[0] == 0


def spot(want: Want, index: int) -> tuple[complex, complex | None] | None:
    """One of these places alone, by its number: the middle of the label and the foot of its leader;
    None where there are not so many."""
    half, all_round = _half(want), _all_round(want)
    sides = len(DIRECTIONS) if all_round else 1 if want.one_sided else 2
    number, rest = divmod(index, len(GAPS) * sides)
    if number < len(want.feet):
        gap, side = divmod(rest, sides)
        u = complex(DIRECTIONS[side]) if all_round else want.normals[number] * (1 - 2 * side)
        return want.feet[number] + complex(_offset(u, want.radius + want.clear + GAPS[gap], half, all_round)), None
    rest, way = divmod(index - len(want.feet) * len(GAPS) * sides, len(DIRECTIONS))
    far, number = divmod(rest, len(want.feet[:LED]))
    if far >= len(FARTHER):
        return None
    foot, u = want.feet[number], complex(DIRECTIONS[way])
    rim = u if all_round else want.normals[number] if want.one_sided and want.thing is Thing.LINK else 0.0
    return foot + complex(_offset(u, want.radius + FARTHER[far], half, True)), foot + rim * want.radius


def _offset(u: Any, distance: Any, half: complex, round_point: bool) -> Any:
    """From a point to the middle of a box that stands clear of it by `distance` in direction u."""
    if round_point:  # the box slides round the point
        x, y = np.clip(u.real * 1.42, -1, 1), np.clip(u.imag * 1.42, -1, 1)
        return distance * u + half.real * x + 1j * half.imag * y
    return u * (distance + half.real * np.abs(u.real) + half.imag * np.abs(u.imag))
