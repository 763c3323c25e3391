"""The tolerance of a graded quantity: what a student's hand scatters by, within bounds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from math import floor, inf, isfinite, log10, radians
from typing import Any

import numpy as np

from ...board.acts import Act
from ...board.acts import Answer as Wrote
from ...board.hand import scatter
from ...foundation.slotted import replace
from ...methods.drawn import Drawn
from ..allowance import Allowance
from ..key import Graded, Kind, beside, come_round

LOST = 0.1  # share of hands that cannot close a figure, beyond which nothing can be promised
COMPUTED = 1e-9  # of the largest of its unit: less is zero
BETWEEN = 0.25  # of the way to another value of its kind: as far off is a value still itself
LONG, FAR = 3.0, 3.0  # times as far as across a place scatters along a direction to lean; σ across it in T
DEGREE = 1.0  # what an angle is read to at best


@dataclass(frozen=True, slots=True)
class Scatter:
    """One construction by many students' hands."""

    drawn: Drawn
    allowance: Allowance
    scales: Mapping[str, float]

    def sigma(self, one: Graded, act: Act) -> float:
        """σ of what an act gave (SI, readings in mm), of a place of its distance from the nominal one; infinite where
        too many hands find nothing."""
        own: Any = self.drawn.hands.get(act.number)
        place = one.kind is Kind.PLACE
        repeats = self.drawn.repeats.get(act.key) if isinstance(act, Wrote) and not place else own
        if repeats is None or np.ndim(repeats) == 0:
            return 0.0
        nominal, *others = np.asarray(repeats, dtype=complex if place else float)
        found = np.asarray(_near(one, np.array(others), nominal))
        closed = found[np.isfinite(found)]
        if closed.size < (1 - LOST) * found.size:
            return inf
        about = float(scatter(closed))
        if abs(nominal) <= COMPUTED * about:  # sizes of what is nothing lie all to one side of it
            return float(np.hypot(about, np.abs(np.mean(closed))))
        return about

    def turned(self, act: Act) -> float:
        """σ of the direction of a vector (deg); 0 where its direction by every hand is not known."""
        repeats: Any = self.drawn.hands.get(act.number)
        if not isinstance(act, Wrote) or repeats is None or not np.iscomplexobj(repeats) or not repeats[0]:
            return 0.0
        off = np.angle(repeats[1:] / repeats[0])
        return float(np.degrees(np.std(off[np.isfinite(off)])))

    def leaning(self, one: Graded, act: Act) -> tuple[float | None, float]:
        """The direction (deg) in which a place scatters far more than across it, and σ across."""
        repeats: Any = self.drawn.hands.get(act.number)
        if one.kind is not Kind.PLACE or repeats is None or np.ndim(repeats) == 0:
            return None, 0.0
        nominal, *others = np.asarray(repeats, dtype=complex)
        off = np.array([other - nominal for other in others if np.isfinite(other)])
        moments = np.cov(off.real, off.imag, ddof=0) + np.outer(mean := [off.real.mean(), off.imag.mean()], mean)
        sizes, axes = np.linalg.eigh(moments)
        across, along = np.sqrt(np.maximum(sizes, 0.0))
        if not along > LONG * across:
            return None, 0.0
        return float(np.degrees(np.arctan2(axes[1, 1], axes[0, 1]))) % 180.0, float(across)

    def bounded(self, graded: Sequence[Graded]) -> list[Graded]:
        """The quantities with T,
        which for a value without a length of its own is bounded by the lengths that it was computed from.
        """
        lengths = {one.key: one.mm for one in graded if one.kind is Kind.READING and one.mm}
        largest: dict[str, float] = {}
        for one in graded:  # also where all are nothing but rounding: by what they scatter
            size = max(abs(one.exact), one.sigma if isfinite(one.sigma) else 0.0)
            largest[one.unit] = max(size, largest.get(one.unit, 0.0))
        bounded = [
            self._bounded(
                _rid_of_rounding(one, largest[one.unit]), self._shortest(one, lengths), largest[one.unit] or 1.0
            )
            for one in graded
        ]
        return [self._told_from(one, bounded) for one in bounded]

    def _told_from(self, one: Graded, all_of_them: Sequence[Graded]) -> Graded:
        """The quantity, of which T is no larger than lets it be told from others of its kind where it is found by
        formula alone: n_max is not n_min. Three digits are enough always."""
        spread, size = self.allowance.k * one.sigma, abs(one.exact)
        if one.kind is not Kind.SCALAR or one.mm or not one.asked or not size or not spread < one.allowed:
            return one
        gaps = (abs(abs(other.exact) - size) for other in all_of_them if _like(one, other))
        least = min((gap for gap in gaps if gap > COMPUTED * size), default=inf) * BETWEEN
        return replace(one, allowed=max(spread, min(one.allowed, max(least, 0.5 * third_digit(size)))))

    def _shortest(self, one: Graded, lengths: dict[str, float]) -> float | None:
        below = [lengths[key] for key in one.needs if key in lengths]
        return one.mm or (min(below) if below else None)

    def _bounded(self, one: Graded, mm: float | None, largest: float) -> Graded:
        rule, size = self.allowance, abs(one.exact)
        spread, floor = rule.k * one.sigma, self._floor(one, mm, largest)
        if one.kind is Kind.YES_NO:
            return one
        if size <= COMPUTED * largest or one.kind is Kind.PLACE or (one.unit == "deg" and spread):
            wide = _share(one, spread, largest) > rule.share
            allowed = max(spread, floor) if isfinite(spread) else size or largest
            across = max(FAR * one.across, floor)
            leans = one.leans if across < allowed else None
            return replace(one, allowed=allowed, demoted=wide, leans=leans, across=across if leans is not None else 0.0)
        if spread > rule.share * size:
            return replace(one, allowed=max(min(spread, size), floor), demoted=True)
        cap = min(rule.cap / mm if mm else inf, rule.share) * size
        if spread > rule.wrong * cap:  # a right drawing would be called wrong
            return replace(one, allowed=spread)
        return replace(one, allowed=max(min(spread, cap), floor))

    def _floor(self, one: Graded, mm: float | None, largest: float) -> float:
        """What nobody reads or reckons more finely than."""
        rule, size = self.allowance, abs(one.exact)
        if one.unit == "deg" and one.sigma:
            return DEGREE
        if one.kind is Kind.PLACE:
            return rule.floor * self._paper(one)
        if one.mu in self.scales and size <= COMPUTED * largest:
            return rule.floor * self.scales[one.mu]
        if size <= COMPUTED * largest:
            return rule.arithmetic * largest
        return max(size * rule.floor / mm if mm else 0.0, rule.arithmetic * size)

    def _paper(self, one: Graded) -> float:
        """What 1 mm stands for where a place is read off: at μ_l′ of a second diagram, where it is not of the first."""
        figures = self.drawn.construction.figures
        return self.scales.get(one.mu) or max(
            (each.scale.value for each in figures if each.scale.unit == "m"), default=0.0
        )


def _share(one: Graded, spread: float, largest: float) -> float:
    """What part of it a value without a size of its own scatters by: an angle of a radian, a place of how far off the
    farthest lies; nothing of nothing."""
    if one.unit == "deg":
        return radians(spread)
    return spread / largest if one.kind is Kind.PLACE else 0.0


def _near(one: Graded, found: Any, nominal: float) -> Any:
    """What hands found, of a line with 179° and 1° 2° apart, of another angle 359° and 1°."""
    if one.kind is Kind.LINE:
        return beside(found, nominal)
    return come_round(found, nominal) if one.unit == "deg" else found


def _like(one: Graded, other: Graded) -> bool:
    """Whether one could be taken for the other."""
    return other.asked and other.key != one.key and other.unit == one.unit and other.kind is one.kind


def third_digit(size: float) -> float:
    """One in the third digit of a number."""
    return float(10.0 ** (floor(log10(size)) - 2))


def _rid_of_rounding(one: Graded, largest: float) -> Graded:
    """The quantity, nothing where it is not more than the rounding of the largest of its unit."""
    nothing = one.kind is not Kind.PLACE and abs(one.exact) <= COMPUTED * largest
    return replace(one, exact=0.0) if nothing else one


def with_tolerance(one: Graded, act: Act, scatter: Scatter) -> Graded:
    """The quantity with the scatter of the act that gave it."""
    leans, across = scatter.leaning(one, act)
    return replace(one, sigma=scatter.sigma(one, act), turned=scatter.turned(act), leans=leans, across=across)
