"""Which value of one length makes a column right? Every length is tried over a range, then refined by Gauss and Newton.

The misfit of a column is the median of its deviations, each divided by the sensitivity of its row: rows typed over do
not count, rows near a dead point count less.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...mechanism.model import Mechanism
from ...oracle import Motion
from ...oracle.run import wrapped
from ..table.target import Reals
from ..table.truth import Truth
from ..table.weigh import Column, Weighing, deviations, scale_of, weigh
from .lengths import Length

ROWS = 48  # rows of a long table that are enough to find a length
GRID = np.geomspace(0.5, 2.0, 41)  # times the length that is given
MIRRORED = -np.geomspace(0.5, 2.0, 9)
STARTS = 4  # from how many grid points a column is refined, beside the best of every length
SPARSE = 5  # of how many grid points one is tried where each costs much
FLAT = 1e-3  # relative change of the misfit below which a length has no say in a column
ROUNDS = 8
PATIENCE = 3  # rounds after which a refinement that gets nowhere is given up
KEPT = 0.6  # share of the rows, the least deviating ones, that a refinement trusts

Model = Callable[[Mechanism], Motion | None]


@dataclass(frozen=True, slots=True, kw_only=True)
class Fit:
    """A value (m) of one length that makes a column fit best."""

    length: Length
    value: float


def fits(columns: Sequence[Column], truth: Truth, model: Model, coarse: bool = False) -> list[list[Fit]]:
    """For each column the lengths that fit it best, each at its best value, not yet rounded; `coarse` tries fewer
    starts.

    A mechanism that is solved by iteration costs a hundred times as much: the grid is sparse, and of all dips only the
    deepest are refined.
    """
    slow = truth.is_iterated
    starts: list[list[tuple[float, Length, float]]] = [[] for _ in columns]
    for length in truth.lengths:
        grid = [
            *(GRID[::SPARSE] if coarse or slow else GRID),
            *(MIRRORED[:: 2 if slow else 1] if length.signed else ()),
        ]
        table = np.array([_misfits(columns, truth, model(length.instead(length.value * times))) for times in grid])
        for i, column in enumerate(table.T):
            known = column[np.isfinite(column)]
            if len(known) and np.ptp(known) > FLAT * known.min():
                starts[i] += [(float(column[k]), length, length.value * float(grid[k])) for k in _lowest(column)]
    found = []
    for column, begun in zip(columns, starts, strict=True):
        ranked = sorted(begun, key=lambda start: start[0])
        first = {length.words.en: start for start in reversed(ranked) for length in [start[1]]}
        others = [start for start in ranked[:STARTS] if first[start[1].words.en] is not start]
        best = ranked[:STARTS] if slow else [*first.values(), *others]
        refined = [_refined(column, truth, model, length, value) for _, length, value in best]
        found.append([fit for fit in refined if fit is not None])
    return found


def _misfits(columns: Sequence[Column], truth: Truth, motion: Motion | None) -> list[float]:
    if motion is None:
        return [float("inf")] * len(columns)
    return [misfit(column, truth, column.target.of(motion)) for column in columns]


def misfit(column: Column, truth: Truth, expected: Reals) -> float:
    """Median deviation over sensitivity: the relative error of the lengths that it looks like."""
    off = np.abs(deviations(column, expected))[column.there] / _size(column, truth)[column.there]
    return float(np.median(np.where(np.isfinite(off), off, np.inf)))


def _size(column: Column, truth: Truth) -> Reals:
    return (
        np.maximum(truth.sensitivity[column.target.key], 0.1 * scale_of(column.target, truth.of(column.target)))
        + 1e-300
    )


def _lowest(column: Reals) -> list[int]:
    """The two lowest dips of a row of misfits."""
    padded = np.concatenate([[np.inf], column, [np.inf]])
    dips = [k for k in range(len(column)) if np.isfinite(column[k]) and padded[k] >= column[k] <= padded[k + 2]]
    return sorted(dips, key=lambda k: float(column[k]))[:2]


def _refined(column: Column, truth: Truth, model: Model, length: Length, value: float) -> Fit | None:
    """Gauss and Newton on the rows that deviate least."""
    size, begun = _size(column, truth), float("inf")
    for turn in range(ROUNDS):
        here, there = (model(length.instead(v)) for v in (value, value * (1 + 1e-7)))
        if here is None or there is None:
            return None
        expected = column.target.of(here)
        off, slope = (
            deviations(column, expected) / size,
            _slope(column, expected, column.target.of(there)) / (1e-7 * value) / size,
        )
        good = np.isfinite(off) & np.isfinite(slope)
        if good.sum() < 3:
            return None
        level = float(np.quantile(np.abs(off[good]), KEPT))
        begun = level if not turn else begun
        if turn >= PATIENCE and level > 0.5 * begun and level > 1e-9:
            return None
        good &= np.abs(off) <= level
        if not (steep := float((slope[good] ** 2).sum())):
            return None
        step = float((off[good] * slope[good]).sum()) / steep
        value += float(np.clip(step, -0.1 * abs(value), 0.1 * abs(value)))
        if abs(step) < 1e-9 * abs(value):
            break
    return Fit(length=length, value=value)


def _slope(column: Column, here: Reals, there: Reals) -> Reals:
    return wrapped(there - here) if column.target.is_angle else there - here


def thinned(count: int) -> slice:
    """Enough rows of a long table."""
    return slice(None, None, max(1, count // ROWS))


def polished(columns: Sequence[Column], truth: Truth, fit: Fit, model: Model) -> Fit:
    """The value that fits all these columns best, and then the roundest value in mm that fits as well."""
    value, best = fit.value, _units(columns, model(fit.length.instead(fit.value)))
    for _ in range(ROUNDS):
        here, there = (_units(columns, model(fit.length.instead(v))) for v in (value, value * (1 + 1e-7)))
        if here is None or there is None or not value:
            return fit
        kept = _kept(here) & np.isfinite(there)
        slope = (there - here)[kept] / (1e-7 * value)
        if not kept.any() or not (steep := float((slope**2).sum())):
            return fit
        step = -float((here[kept] * slope).sum()) / steep
        value += float(np.clip(step, -0.05 * abs(value), 0.05 * abs(value)))
        if abs(step) < 1e-10 * abs(value):
            break
    best = _units(columns, model(fit.length.instead(value)))
    if best is None:
        return fit
    kept = _kept(best)
    for decimals in range(5):
        round_ = round(value * 1e3, decimals) / 1e3
        found = _units(columns, model(fit.length.instead(round_))) if round_ else None
        if found is not None and as_good(found[kept], best[kept]):
            return Fit(length=fit.length, value=round_)
    return Fit(length=fit.length, value=value)


def as_good(units: Reals, best: Reals) -> bool:
    """Whether deviations (in half units) are no larger than the best ones, but for chance:
    χ² rises by no more than three sigma, or a tenth."""
    least = float((best**2).sum())
    return bool(np.isfinite(units).all()) and float((units**2).sum()) <= least * (
        1 + max(9 / max(len(best) - 1, 1), 0.1)
    ) + 1e-6 * len(best)


def _units(columns: Sequence[Column], motion: Motion | None) -> Reals | None:
    """The deviations of all these columns, one after the other, in half units of the last digit."""
    if motion is None:
        return None
    return np.concatenate(
        [(deviations(one, one.target.of(motion)) / np.maximum(one.half, 1e-300))[one.there] for one in columns]
    )


def _kept(units: Reals) -> NDArray[np.bool_]:
    """The rows that do not stand apart."""
    known = np.abs(np.where(np.isfinite(units), units, np.inf))
    return np.asarray(known <= max(5 * float(np.median(known)), 3.0))


def weighed(column: Column, truth: Truth, fit: Fit, model: Model) -> Weighing | None:
    """The column against the mechanism with this value of the length."""
    motion = model(fit.length.instead(fit.value))
    return None if motion is None else weigh(column, column.target.of(motion), truth.sensitivity[column.target.key])
