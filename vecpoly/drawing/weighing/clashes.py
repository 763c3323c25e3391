"""What labels cost each other: lettering on lettering or too near to it, leaders that strike it or each other.

Most places of a label are far from most others: first the pairs are found that are near enough to cost anything.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ..labels.about.bounds import Bounds, Complexes, Floats, Indices
from ..labels.about.clipping import enters
from ..labels.about.obstacles import crossed
from ..labels.spots import ends
from ..labels.want import Thing
from .stood import (
    APART,
    AS_ONE,
    CLEAR,
    CORNER,
    CORNERED,
    FRACTION,
    LEADER_ON_LABEL,
    LEADERS_CROSS,
    LEVEL,
    LISTED,
    MISREAD,
    OVER,
    OVERLAP,
    PER_AREA,
    READ_SO,
    RUN,
    RUNS_ON,
    STACK,
    STACKED,
    TIGHT,
    Stood,
)

NEAR = complex(RUN, FRACTION)  # mm about a label beyond which others cost nothing


@dataclass(frozen=True)
class Trial:
    """Places of one label: their middles, half its size, the feet of their leaders where they have any."""

    centre: Complexes
    half: complex
    foot: Complexes | None
    thing: Thing = Thing.OTHER

    @cached_property
    def tip(self) -> Complexes | None:
        """Where the leaders end, just short of the label."""
        return None if self.foot is None else ends(self.foot, self.centre, self.half)

    @cached_property
    def about(self) -> Bounds:
        """About the label at each place, with its leader."""
        own = Bounds.between(self.centre - self.half, self.centre + self.half)
        return own if self.foot is None else own.with_points(self.foot)

    @property
    def span(self) -> tuple[complex, complex]:
        """The lower left and the upper right corner of all that."""
        about = self.about
        return complex(about.x0.min(), about.y0.min()), complex(about.x1.max(), about.y1.max())

    def one(self, place: int) -> Stood:
        """The label at one of the places."""
        if (found := self._ones[place]) is None:
            foot = None if self.foot is None else complex(self.foot[place])
            found = self._ones[place] = Stood.at(complex(self.centre[place]), self.half, foot, self.thing)
        return found

    @cached_property
    def _ones(self) -> list[Stood | None]:
        return [None] * len(self.centre)


@dataclass(frozen=True, slots=True)
class Others:
    """Labels that stand: their middles, half their sizes, feet and tips of their leaders, whether they have one, what
    they name; about all that is near to them."""

    centre: Complexes
    half: Complexes
    foot: Complexes
    tip: Complexes
    led: NDArray[np.bool_]
    things: NDArray[np.object_]
    about: Bounds

    @classmethod
    def of(cls, labels: Sequence[Stood]) -> Others:
        """Of labels at their places."""
        parts = [(one.centre, one.half, one.foot or 0j, one.tip or 0j, one.low, one.high) for one in labels]
        centre, half, foot, tip, low, high = np.array(parts, dtype=complex).T.copy()
        led = np.array([one.foot is not None for one in labels], dtype=bool)
        things = np.array([one.thing for one in labels], dtype=object)
        return cls(centre, half, foot, tip, led, things, Bounds.between(low - NEAR, high + NEAR))


def clashes(trial: Trial, others: Others) -> Floats:
    """What some places of a label cost for each of these others where they are now; shape (places, others)."""
    cost = np.zeros((len(trial.centre), len(others.centre)))
    place, other = np.nonzero(trial.about.meet(others.about))
    if len(place):
        price = _crowded(trial, others, place, other)
        led = others.led[other]
        if trial.foot is not None or led.any():
            price += _struck(trial, others, place, other, led)
        cost[place, other] = price
    return cost


def _crowded(trial: Trial, others: Others, place: Indices, other: Indices) -> Floats:
    """What lettering costs on, beside and over other lettering."""
    half, size, apart = trial.half, others.half[other], trial.centre[place] - others.centre[other]
    dx = size.real + half.real + APART - np.abs(apart.real)
    dy = size.imag + half.imag + APART - np.abs(apart.imag)
    level, over = dy > 0, (dy <= 0) & (dx > APART)
    price = np.where((dx > 0) & level, OVERLAP + PER_AREA * dx * dy, 0.0)
    price += np.where((dx <= 0) & (dx > APART - AS_ONE) & level, MISREAD, 0.0)
    in_line = (dx <= APART - AS_ONE) & (dx > APART - RUN) & (np.abs(apart.imag) < LEVEL)
    price += np.where(in_line & level, RUNS_ON, 0.0)
    corner = (dy <= 0) & ~over & (np.minimum(dx, dy) > APART - CORNER)
    price += np.where(corner, CORNERED, 0.0)
    if over.any():
        stack = np.where(others.things == Thing.OTHER, LISTED, STACK)[other] if trial.thing is Thing.OTHER else STACK
        price += np.where(over & (dy > APART - stack), np.where(dy > APART - TIGHT, MISREAD, STACKED), 0.0)
        if trial.thing in OVER:  # a letter over a number, or a number over a letter
            fraction = np.asarray(others.things == OVER[trial.thing], dtype=bool)[other]
            price += np.where(over & fraction & (dy > APART - FRACTION), READ_SO, 0.0)
    return price


def _struck(trial: Trial, others: Others, place: Indices, other: Indices, led: NDArray[np.bool_]) -> Floats:
    """What leaders cost that run through the label of the other, or cross; led: of which pairs the other has one."""
    price = np.zeros(len(place))
    size = complex(CLEAR, CLEAR)
    if led.any():
        at, by = place[led], other[led]
        half = trial.half + size
        price[led] += LEADER_ON_LABEL * enters(others.foot[by], others.tip[by], trial.centre[at], half.real, half.imag)
    if trial.foot is None or trial.tip is None:
        return price
    a, b, box = trial.foot[place], trial.tip[place], others.half[other] + size
    price += LEADER_ON_LABEL * enters(a, b, others.centre[other], box.real, box.imag)
    if led.any():
        met = Bounds.between(a[led], b[led]).touch(Bounds.between(others.foot[by], others.tip[by]))
        met &= crossed(a[led], b[led], others.foot[by], others.tip[by])
        price[led] += LEADERS_CROSS * met
    return price
