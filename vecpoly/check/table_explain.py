"""How a wrong column came about: every usual slip is tried, and those that fit are kept, the best and its equals."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ..errors import VecpolyError
from ..mechanism.model import Mechanism
from ..oracle import Motion
from ..words import Words
from .table_constants import constants
from .table_fit import Fit, Model, fits, rounded, thinned, weighed
from .table_guess import Guess, Slip
from .table_motions import Told, at_other_motions, differences, loops_without, other_motions, swapped, terms
from .table_rates import mixed
from .table_target import Reals
from .table_truth import Truth, solved, truth_of
from .table_weigh import Column, Level, Weighing, weigh

SURE = 2e-4  # the largest doubt at which a guess still counts as found
MOST = 6  # explanations of one column that are told
SIMPLE = (Slip.SIGN, Slip.UNIT, Slip.OMEGA, Slip.FACTOR, Slip.SWAPPED, Slip.ZERO, Slip.LENGTH, Slip.RATES)  # told first, where several fit equally


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Explanation:
    """A slip with which the column becomes right, and how right; `parameter`: the length (m), factor or angle (rad) that was found."""

    slip: Slip
    words: Words
    after: Weighing
    parameter: float | None = None
    length: str = ""  # symbol of the length that was found


@dataclass(frozen=True, slots=True, eq=False)
class Suspect:
    """A mechanism by which the columns may have been computed, with all that a slip may do to it."""

    truth: Truth
    thin: Truth  # over rows enough to find a length
    motions: Sequence[Told]
    left_out: Sequence[tuple[Words, Motion]]


def suspect(mech: Mechanism, positions: Reals, columns: Sequence[Column]) -> Suspect | None:
    """Solve everything once; None where the mechanism cannot be assembled."""
    targets = [column.target for column in columns]
    truth, thin = (truth_of(mech, q, targets) for q in (positions, positions[thinned(len(positions))]))
    if truth is None or thin is None:
        return None
    return Suspect(truth, thin, other_motions(truth), loops_without(truth))


def explain(column: Column, columns: Sequence[Column], by: Suspect, before: Weighing, found: Iterable[Explanation]) -> tuple[Explanation, ...]:
    """The slips that make the column right, best first and with all that fit equally; `found` are lengths found by fit."""
    known = [one for one in found if accepted(one.after, before)]
    for guess in _guesses(column, columns, by):
        after = weigh(column, guess.expected, _sensitivity(column, by.truth, guess), guess.whole_turns)
        if accepted(after, before):
            known.append(Explanation(slip=guess.slip, words=guess.words, after=after, parameter=guess.parameter, length=guess.length))
    if not known:
        return ()
    best = min(known, key=_rank)
    equal = [one for one in known if _equal(one.after, best.after)]
    told = {one.words.en: one for one in sorted(equal, key=_order)}
    return tuple(told.values())[:MOST]


def accepted(after: Weighing, before: Weighing) -> bool:
    """Whether a guess fits, and fits clearly better than none."""
    fits_ = after.level <= Level.LAST_DIGIT or (after.level < Level.WRONG and after.doubt <= SURE)
    if before.level is Level.WRONG:
        return fits_
    return after.level <= Level.LAST_DIGIT and after.typical < before.typical / 3


def _rank(one: Explanation) -> tuple[int, int, float]:
    return max(one.after.level, Level.LAST_DIGIT), -one.after.rows_right, one.after.doubt


def _equal(one: Weighing, best: Weighing) -> bool:
    alike = max(one.level, Level.LAST_DIGIT) == max(best.level, Level.LAST_DIGIT)
    return alike and one.rows_right >= 0.9 * best.rows_right and one.doubt <= 2 * best.doubt + 1e-6


def _order(one: Explanation) -> int:
    return SIMPLE.index(one.slip) if one.slip in SIMPLE else len(SIMPLE)


def _guesses(column: Column, columns: Sequence[Column], by: Suspect) -> Iterator[Guess]:
    yield from constants(column, by.truth)
    yield from swapped(column, by.truth)
    yield from at_other_motions(column, by.motions)
    yield from terms(column, by.truth, by.left_out)
    yield from differences(column, columns, by.truth)


def _sensitivity(column: Column, truth: Truth, guess: Guess) -> Reals:
    """That of the quantity, in the measure in which the guess is larger or smaller."""
    sensitivity = truth.sensitivity[column.target.key]
    if column.target.is_angle and guess.whole_turns is not False:
        return sensitivity
    here, there = (float(np.nanmedian(np.abs(values))) for values in (truth.of(column.target), guess.expected))
    return sensitivity * (there / here) if here > 0 and np.isfinite(there) else sensitivity


def lengths_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """For each column the lengths, one at a time, with which it becomes right when all is computed with them."""
    return _found(columns, by, lambda q: partial(_solved, q), Slip.LENGTH)


def rates_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """The same for rates alone: the angles as they are, velocities and accelerations with another length."""
    return _found(columns, by, lambda q: partial(_mixed, (by.truth if q is by.truth.positions else by.thin).motion), Slip.RATES)


def _solved(positions: Reals, mech: Mechanism) -> Motion | None:
    return solved(mech, positions)


def _mixed(poses: Motion, mech: Mechanism) -> Motion | None:
    try:
        return mixed(mech, poses)
    except (VecpolyError, ValueError, ArithmeticError):
        return None


def _found(columns: Sequence[Column], by: Suspect, model_at: Callable[[Reals], Model], slip: Slip) -> list[list[tuple[Fit, Explanation]]]:
    """Fit every column, then try what one column has found on all the others."""
    part = thinned(len(by.truth.positions))
    thin = [replace(column, values=column.values[part], half=column.half[part]) for column in columns]
    narrow, wide = model_at(by.thin.positions), model_at(by.truth.positions)
    found: list[dict[tuple[str, float], tuple[Fit, Explanation]]] = []
    for column, best in zip(columns, fits(thin, by.thin, narrow, coarse=slip is Slip.RATES), strict=True):
        mine = [one for fit in best if (one := rounded(column, by.truth, fit, wide)) is not None and abs(one[0].value / fit.length.value - 1) > 1e-6]
        found.append({_name(fit): (fit, explained_by(fit, after, slip)) for fit, after in mine})
    pool = {_name(fit): fit for told in found for fit, one in told.values() if one.after.level < Level.WRONG and one.after.doubt <= SURE}
    for column, told in zip(columns, found, strict=True):
        for name, fit in pool.items():
            if name not in told and (after := weighed(column, by.truth, fit, wide)) is not None:
                told[name] = fit, explained_by(fit, after, slip)
    return [list(told.values()) for told in found]


def _name(fit: Fit) -> tuple[str, float]:
    return fit.length.words.en, round(fit.value, 9)


def explained_by(fit: Fit, after: Weighing, slip: Slip) -> Explanation:
    """A length that was found by fit, in words."""
    name, value, given = fit.length.words, f"{1e3 * fit.value:.6g}", f"{1e3 * fit.length.value:.6g}"
    if slip is Slip.LENGTH:
        words = Words(f"按 {name.zh} = {value} mm 计算（而不是 {given} mm）", f"computed with {name.en} = {value} mm (not {given} mm)")
    else:
        words = Words(f"位置按 {name.zh} = {given} mm，速度和加速度却按 {name.zh} = {value} mm 计算",
                      f"angles with {name.en} = {given} mm, but rates computed with {name.en} = {value} mm")
    return Explanation(slip=slip, words=words, after=after, parameter=fit.value, length=name.en)
