"""How accurately the emulated person works; repeated hands give every answer its honest tolerance.

exact: nothing is rounded or disturbed. drafting: readings to 0.1 mm. pencil: readings to 0.5 mm, every length carried
with a scatter of 0.2 mm, every parallel or perpendicular with 0.3°. One board can carry many hands: element 0 of every
array is the nominal sheet, the others are repetitions.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ..errors import UnknownNameError
from ..foundation.arguments import whole_number
from ..foundation.slotted import dataclass, replace
from ..limits import REPEATS, SEED
from ..plane import Points, Reals
from ..plane.traced import acts_of, bare, traced
from ..words import Words

HandName = Literal["exact", "drafting", "pencil"]


@dataclass(frozen=True, slots=True, kw_only=True)
class Skill:
    """reading: graduation read to (mm, 0 = exact); protractor: angles read to (rad); dividers: σ of a length carried
    (mm);
    square: σ of a parallel or perpendicular (rad). squares: σ of an area counted on millimetre paper (mm²) over the
    root of its perimeter (mm), for that many squares are cut; whole: to which a count is rounded (mm²); planimeter:
    graduation to which one is read (mm²)."""

    reading: float
    protractor: float
    dividers: float
    square: float
    squares: float
    whole: float
    planimeter: float


ON_LINE, BY_LINE = 1e-6, 0.035  # of a division: rounding of numbers; of 200 hands none reads another line, in 1 of 1000
EXACT = Skill(reading=0, protractor=0, dividers=0, square=0, squares=0, whole=0, planimeter=0)
_DRAFTING = Skill(
    reading=0.1,
    protractor=0.1 * pi / 180,
    dividers=0.05,
    square=0.05 * pi / 180,
    squares=0.3,
    whole=1.0,
    planimeter=10.0,
)
_PENCIL = replace(_DRAFTING, reading=0.5, protractor=0.5 * pi / 180, dividers=0.2, square=0.3 * pi / 180)
_SKILLS: dict[str, tuple[Skill, Skill]] = {  # (the nominal sheet, its repetitions)
    "exact": (EXACT, _DRAFTING),
    "drafting": (replace(_DRAFTING, dividers=0, square=0, squares=0), _DRAFTING),
    "pencil": (_PENCIL, _PENCIL),
}


@dataclass(frozen=True, slots=True)
class Hand:
    """A person at the board, with `repeats` repetitions beside the nominal sheet."""

    name: str
    nominal: Skill
    repeated: Skill
    repeats: int
    rng: np.random.Generator

    @property
    def is_ideal(self) -> bool:
        """Whether it neither rounds nor scatters, with no repetitions beside it."""
        return self.nominal == EXACT and not self.repeats

    @property
    def slack(self) -> float:
        """How far (mm) a point of the nominal sheet may lie beside its place: ten times what the dividers scatter."""
        return 10.0 * self.nominal.dividers

    @property
    def slacks(self) -> Reals:
        """The same of every hand."""
        return np.array([self.slack, *[10.0 * self.repeated.dividers] * self.repeats]) if self.repeats else self.slack

    def carry(self, length: Reals) -> Reals:
        """A length set in the dividers (mm)."""
        return length + self._scatter(lambda skill: skill.dividers)

    def carry_vector(self, vector: Points) -> Points:
        """A vector carried to another place (mm): length and direction both scatter."""
        size = np.abs(vector)
        with np.errstate(invalid="ignore", divide="ignore"):
            stretched = np.where(size > 0, vector * (1 + self._scatter(lambda skill: skill.dividers) / size), vector)
        return self.tilt(stretched[()])

    def tilt(self, along: Points) -> Points:
        """A direction transferred with the set square."""
        return along * np.exp(1j * self._scatter(lambda skill: skill.square))

    def read(self, mm: Reals) -> Reals:
        """A length read off the rule."""
        return self._graduated(mm, lambda skill: skill.reading)

    def gauge(self, angle: Reals) -> Reals:
        """An angle read off the protractor (rad)."""
        return self._graduated(angle, lambda skill: skill.protractor)

    def count(self, mm2: Reals, perimeter: Reals) -> Reals:
        """An area counted in squares of millimetre paper: those that its outline cuts are judged by the eye."""
        return self._graduated(mm2 + np.sqrt(perimeter) * self._scatter(lambda skill: skill.squares), lambda s: s.whole)

    def roll(self, mm2: Reals) -> Reals:
        """An area read off a planimeter."""
        return self._graduated(mm2, lambda skill: skill.planimeter)

    def _scatter(self, of: Callable[[Skill], float]) -> Reals:
        first, others = of(self.nominal), of(self.repeated)
        if not self.repeats:
            return float(self.rng.normal(0.0, first)) if first else 0.0
        noise = self.rng.normal(0.0, 1.0, self.repeats + 1) * others
        noise[0] *= first / others if others else 0.0
        return noise

    def _graduated(self, value: Reals, of: Callable[[Skill], float]) -> Reals:
        value, acts = bare(value), acts_of(value)
        if not self.repeats:
            return traced(_round_to(value, of(self.nominal)), acts) if acts else _round_to(value, of(self.nominal))
        full = np.broadcast_to(np.asarray(value, dtype=float), (self.repeats + 1,)).copy()
        step = of(self.repeated)
        jitter = self.rng.uniform(-0.5, 0.5, self.repeats) * step
        full[1:] = _round_to(full[1:] + jitter, step)
        full[0] = _round_to(full[0], of(self.nominal))
        return traced(full, acts) if acts else full


def _round_to(value: Reals, step: float) -> Reals:
    return np.round(np.asarray(value) / step) * step if step else value


def steady(repeats: int) -> Hand:
    """An exact hand whose repetitions are as exact: each can be amended in its own way."""
    return Hand("exact", EXACT, EXACT, repeats, np.random.Generator(np.random.PCG64(0)))


def hand(name: str, *, seed: int = 0, repeats: int = 0) -> Hand:
    """The hand of this name: exact, drafting or pencil.

    Raises UnknownNameError for any other name.
    """
    if name not in _SKILLS:
        raise UnknownNameError(
            Words(
                f"没有名为“{name}”的作图手法；可用 exact、drafting、pencil",
                f"no hand is called '{name}'; there are exact, drafting and pencil",
            )
        )
    whole_number("repeats", repeats, 0, REPEATS)
    whole_number("seed", seed, 0, SEED)
    first, others = _SKILLS[name]
    return Hand(name, first, others, repeats, np.random.Generator(np.random.PCG64(seed)))


def seldom(name: HandName | str, mm: float) -> float:
    """σ (mm) of the rounding of a length that lies so near a line of the rule that of some hundred hands perhaps none
    reads another: p of a division beside it one of 1/p does, and σ is √(p (1 − p)) divisions. 0 of any other length."""
    step = _SKILLS[name][1].reading
    beside = abs(mm / step - round(mm / step))
    return step * (beside * (1 - beside)) ** 0.5 if ON_LINE < beside < BY_LINE else 0.0


def scatter(found: NDArray[Any]) -> float:
    """The standard deviation of what hands found, all of it finite, but near a singular figure beyond all bounds
    (10^200), where a square overflows: that of the values by a power of two, which changes no digit."""
    size = np.ldexp(0.5, np.frexp(np.abs(found).max(initial=0.0))[1])
    return float(np.std(found / size) * size)
