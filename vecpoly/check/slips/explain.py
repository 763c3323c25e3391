"""How a wrong column came about: every usual slip is tried, and those that fit are kept, the best and its equals."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...mechanism.model import Mechanism
from ...names import Kind
from ...oracle import Motion
from ...words import Words
from ..table.target import Reals
from ..table.truth import Truth, truth_of
from ..table.weigh import Column, Level, Weighing, weigh
from .constants import constants
from .divisors import undivided
from .fit import thinned
from .guess import Guess, Slip, Told
from .motions import at_other_motions, differences, divisors, loops_without, other_motions, swapped, terms

SURE = 2e-4  # the largest doubt at which a guess still counts as found
MOST = 6  # explanations of one column that are told
# half units of the last digit in which a column may scatter where no other column tells how exact the table is
LOOSE = 6.0
CLEARLY = 0.15  # share of the deviation that an explanation may leave unexplained
DIGITS = 10.0  # half units of the last digit that a column must reach for anything to be told by it
# told in this order, where several fit equally
SIMPLE = (
    Slip.SIGN,
    Slip.OMEGA,
    Slip.UNIT,
    Slip.FACTOR,
    Slip.SWAPPED,
    Slip.ZERO,
    Slip.QUADRANT,
    Slip.BRANCH,
    Slip.LENGTH,
    Slip.RATES,
    Slip.RADIANS,
    Slip.DRIVE,
    Slip.DIVISOR,
    Slip.TERM,
    Slip.DIFFERENCE,
    Slip.FORMULA,
)


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Explanation:
    """A slip with which the column becomes right, and how right; `parameter`:
    the length (m), factor or angle (rad) that was found."""

    slip: Slip
    words: Words
    after: Weighing
    parameter: float | None = None
    length: str = ""  # symbol of the length that was found
    odd: int = 0  # how many digits more than usual its number needs: the less plausible
    alone: Words | None = None  # the same without the slip that the table's other columns share
    slips: int = 1  # how many there are at once


@dataclass(frozen=True, slots=True, eq=False)
class Suspect:
    """A mechanism by which the columns may have been computed, with all that a slip may do to it."""

    truth: Truth
    thin: Truth  # over rows enough to find a length
    motions: Sequence[Told]
    left_out: Sequence[tuple[Words, Motion]]
    undivided: Sequence[tuple[Kind, Words, Motion]]


def suspect(mech: Mechanism, positions: Reals, columns: Sequence[Column]) -> Suspect | None:
    """Solve everything once; None where the mechanism cannot be assembled."""
    targets = [column.target for column in columns]
    truth, thin = (truth_of(mech, q, targets) for q in (positions, positions[thinned(len(positions))]))
    if truth is None or thin is None:
        return None
    return Suspect(truth, thin, other_motions(truth), loops_without(truth), list(undivided(mech, truth.motion)))


def explain(
    column: Column, columns: Sequence[Column], by: Suspect, before: Weighing, found: Iterable[Explanation], noise: float
) -> tuple[Explanation, ...]:
    """The slips that make the column right, best first and with all that fit equally; `found` are lengths found by fit.

    `noise`: half units of the last digit in which the columns of this table that are right scatter.
    """
    if not float(np.nanmax(np.abs(column.values))) >= DIGITS * float(np.median(column.half[column.there])):
        return ()
    known = [one for one in found if accepted(one.after, before, noise)]
    for guess in _guesses(column, columns, by):
        after = weigh(column, guess.expected, _sensitivity(column, by.truth, guess), guess.whole_turns)
        if accepted(after, before, noise):
            known.append(
                Explanation(
                    slip=guess.slip,
                    words=guess.words,
                    after=after,
                    parameter=guess.parameter,
                    length=guess.length,
                    odd=guess.odd,
                )
            )
    return equals(known)


def equals(known: Sequence[Explanation]) -> tuple[Explanation, ...]:
    """Of explanations that fit, the best and those that fit as well, the most plausible first."""
    if not known:
        return ()
    best = min(known, key=lambda one: (max(one.after.level, Level.LOW), one.after.spread))
    equal = sorted((one for one in known if _equal(one.after, best.after)), key=plausible)
    told = {one.words.en: one for one in reversed(equal)}
    return tuple(sorted((one for one in told.values() if one.odd <= equal[0].odd + 1), key=plausible))[:MOST]


def plausible(one: Explanation) -> tuple[int, int]:
    """The smaller, the sooner it is told: round numbers before crooked ones, simple slips before far-fetched ones."""
    return (one.odd if one.odd > 1 else 0), SIMPLE.index(one.slip)


def accepted(after: Weighing, before: Weighing, noise: float) -> bool:
    """Whether a guess fits as well as columns of this table do, and clearly better than none."""
    if after.level is Level.WRONG or (after.doubt > SURE and after.spread > noise):
        return False
    if before.level is Level.WRONG:
        return after.spread <= max(CLEARLY * before.spread, min(1.2, before.spread / 3))
    # wrong rows that one slip makes right, all of them
    rows = before.level is Level.ROWS and int(before.outliers.sum()) > 1
    return after.level <= Level.LAST_DIGIT and (rows or after.typical < before.typical / 3)


def noise_of(weighed: Sequence[Weighing]) -> float:
    """Half units of the last digit in which an explained column of this table may scatter:
    somewhat more than those that are right do."""
    right = [one.spread for one in weighed if one.level <= Level.LAST_DIGIT]
    return max(2.0 * max(right), 1.5) if right else LOOSE


def _equal(one: Weighing, best: Weighing) -> bool:
    alike = max(one.level, Level.LOW) == max(best.level, Level.LOW)
    return alike and one.spread <= 1.25 * best.spread + 0.05 and int(one.outliers.sum()) <= int(best.outliers.sum()) + 1


def _guesses(column: Column, columns: Sequence[Column], by: Suspect) -> Iterator[Guess]:
    yield from constants(column, by.truth)
    yield from swapped(column, by.truth)
    yield from at_other_motions(column, by.motions)
    yield from terms(column, by.truth, by.left_out)
    yield from divisors(column, by.undivided)
    yield from differences(column, columns, by.truth)


def _sensitivity(column: Column, truth: Truth, guess: Guess) -> Reals:
    """That of the quantity, in the measure in which the guess is larger or smaller."""
    sensitivity = truth.sensitivity[column.target.key]
    if column.target.is_angle and guess.whole_turns is not False:
        return sensitivity
    here, there = (float(np.nanmedian(np.abs(values))) for values in (truth.of(column.target), guess.expected))
    return sensitivity * (there / here) if here > 0 and np.isfinite(there) else sensitivity
