"""A column weighed against what it ought to hold: reproduced, of low accuracy, wrong in certain rows, or wrong.

A row is right where it lies within half a unit of its last printed digit. A row that is not may still come from a
loosely
converged or coarsely rounded calculation: its deviation is divided by the sensitivity of the quantity to the lengths of
the
mechanism, so that a deviation near a dead point counts less than the same deviation elsewhere. The quotient is the
`doubt`:
the relative error of the lengths that would move the quantity so far. Rows whose doubt stands apart from that of all
others
are outliers (typed over).
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum

import numpy as np
from numpy.typing import NDArray

from ...oracle.run import wrapped
from ...words import Words
from .target import Reals, Target

LAST_DIGIT = 10.0  # units of the last digit within which only this digit is in doubt
LOW = 1e-3  # the largest doubt of a column that is of low accuracy, not wrong
OUTLIER = 1e-4  # the smallest doubt of a row that stands apart
APART = 5.0  # how many times more doubtful than the next row an outlier is
FEW = 0.4  # share of the rows that may be outliers

Mask = NDArray[np.bool_]


class Level(IntEnum):
    """How well a column is reproduced; smaller is better."""

    REPRODUCED = 0
    LAST_DIGIT = 1
    LOW = 2
    ROWS = 3
    WRONG = 4

    @property
    def label(self) -> str:
        """As it stands in JSON."""
        return self.name.lower().replace("_", " ")

    @property
    def words(self) -> Words:
        """The verdict in words."""
        return {
            Level.REPRODUCED: Words("正确", "agrees"),
            Level.LAST_DIGIT: Words("正确，末位欠准", "agrees but for the last digit"),
            Level.LOW: Words("正确，但精度低", "agrees, with low accuracy"),
            Level.ROWS: Words("个别行错误", "wrong in certain rows"),
            Level.WRONG: Words("错误", "wrong"),
        }[self]


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Column:
    """A printed column in SI: its quantity, values (NaN where blank),
    half a unit of each last digit, texts, and unit."""

    header: str
    target: Target
    values: Reals
    half: Reals
    texts: tuple[str, ...]
    unit: str
    factor: float
    renumbered: str = ""  # symbol in the table, where it gives the link another number
    floor: float = 0.0  # SI: what is rounding noise of a zero
    turned: float = (
        0.0  # rad that the table counts more than the problem does: 180° where a link is looked at from its other end
    )

    @property
    def label(self) -> Words:
        """How the column is called: its symbol;
        that of the table beside it where the table numbers the links otherwise."""
        symbol = f"${self.target.symbol}$"
        return (
            Words(f"表中 ${self.renumbered}$（即 {symbol}）", f"${self.renumbered}$ (here {symbol})")
            if self.renumbered
            else Words.same(symbol)
        )

    @property
    def there(self) -> Mask:
        """Which rows have a number."""
        return np.isfinite(self.values)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Weighing:
    """The outcome: level, which rows are right to the last digit, which are outliers, how far off the others are."""

    level: Level
    off: Reals  # printed − expected (SI)
    right: Mask
    outliers: Mask
    doubt: float  # largest of the rows that are no outliers
    typical: float  # median deviation in half units of the last digit
    spread: float  # root mean square of the same, without the rows that stand apart

    @property
    def rows_right(self) -> int:
        """How many rows are right to the last digit."""
        return int(self.right.sum())

    @property
    def largest(self) -> float:
        """Largest deviation (SI) of the rows that are no outliers."""
        kept = np.abs(self.off[~self.outliers & np.isfinite(self.off)])
        return float(kept.max()) if len(kept) else float("nan")

    @property
    def worst(self) -> float:
        """Largest deviation (SI) of all rows."""
        known = np.abs(self.off[np.isfinite(self.off)])
        return float(known.max()) if len(known) else float("nan")


def weigh(column: Column, expected: Reals, sensitivity: Reals, whole_turns: bool | None = None) -> Weighing:
    """Compare a column with what it ought to hold (SI);
    `sensitivity` is the change of the quantity per relative change of the lengths.

    Angles are compared but for whole turns, unless said otherwise. Rows without a number are left out.
    """
    off = column.values - expected
    if column.target.is_angle if whole_turns is None else whole_turns:
        off = wrapped(off)
    there = column.there
    gap = np.where(there, np.where(np.isfinite(off), np.abs(off), np.inf), 0.0)
    slack = max(1e-12 * scale_of(column.target, expected), column.floor, 1e-42)
    right = there & (gap <= column.half * (1 + 1e-6) + slack)
    size = np.maximum(sensitivity, 0.1 * scale_of(column.target, expected)) + 1e-300
    doubt = np.where(right, 0.0, np.maximum(gap - column.half, 0.0) / size)
    with np.errstate(divide="ignore", invalid="ignore"):
        units = gap / np.maximum(column.half, slack)
    outliers = _outliers(doubt, units, there)
    kept = there & ~outliers
    worst = float(doubt[kept].max(initial=0.0))
    near = bool((units[kept] <= 2 * LAST_DIGIT).all())
    if not kept.any() or (worst > LOW and not near):
        level, outliers = Level.WRONG, np.zeros_like(outliers)
    elif outliers.any():
        level = Level.ROWS
    else:
        level = Level.REPRODUCED if right[kept].all() else Level.LAST_DIGIT if near else Level.LOW
    return Weighing(
        level=level,
        off=off,
        right=right,
        outliers=outliers,
        doubt=worst,
        typical=float(np.median(units[there])),
        spread=spread_of(units[there]),
    )


def spread_of(units: Reals) -> float:
    """Root mean square of what does not stand apart from the median."""
    median = float(np.median(units))
    return (
        float(np.sqrt(np.mean(units[units <= max(APART * median, 3.0)] ** 2))) if np.isfinite(median) else float("inf")
    )


def deviations(column: Column, expected: Reals) -> Reals:
    """Printed − expected (SI), of angles but for whole turns."""
    off = column.values - expected
    return wrapped(off) if column.target.is_angle else off


def scale_of(target: Target, values: Reals) -> float:
    """The size of a quantity: half its swing where it is a place, else its largest magnitude."""
    known = values[np.isfinite(values)]
    if not len(known):
        return 0.0
    if target.is_angle:
        known = np.unwrap(known)
    return float(np.ptp(known)) / 2 if target.is_place else float(np.abs(known).max())


def _outliers(doubt: Reals, units: Reals, there: Mask) -> Mask:
    """The rows above the lowest gap in the doubts,
    where few enough lie above it and all these are off by more than their last digit."""
    order = np.argsort(-np.where(there, doubt, -1.0))
    ranked, far, count = doubt[order], units[order], int(there.sum())
    found = np.zeros(len(doubt), np.bool_)
    for k in range(min(int(FEW * count), count - 1), 0, -1):
        fine = ranked[k] <= LOW or float(far[k:count].max()) <= 2 * LAST_DIGIT
        apart = ranked[k - 1] >= max(OUTLIER, APART * ranked[k]) and float(far[:k].min()) > 2 * LAST_DIGIT
        if fine and apart:
            found[order[:k]] = True
            break
    return found
