"""How a wrong column came about: every usual slip is tried, and those that fit are kept, the best and its equals."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from ...errors import VecpolyError
from ...mechanism.model import FRAME, Mechanism
from ...names import Kind
from ...oracle import Motion
from ...words import Words
from ..table.target import Reals
from ..table.truth import Truth, solved, truth_of
from ..table.weigh import Column, Level, Weighing, weigh
from .constants import constants
from .divisors import undivided
from .fit import Fit, Model, fits, polished, thinned, weighed
from .guess import Guess, Slip, Told
from .motions import at_other_motions, differences, divisors, loops_without, other_motions, swapped, terms
from .rates import mixed

SURE = 2e-4  # the largest doubt at which a guess still counts as found
MOST = 6  # explanations of one column that are told
LOOSE = (
    6.0  # half units of the last digit in which a column may scatter where no other column tells how exact the table is
)
CLEARLY = 0.15  # share of the deviation that an explanation may leave unexplained
DIGITS = 10.0  # half units of the last digit that a column must reach for anything to be told by it
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
)  # told in this order, where several fit equally


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Explanation:
    """A slip with which the column becomes right, and how right; `parameter`: the length (m), factor or angle (rad)
    that was found."""

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
    rows = (
        before.level is Level.ROWS and int(before.outliers.sum()) > 1
    )  # wrong rows that one slip makes right, all of them
    return after.level <= Level.LAST_DIGIT and (rows or after.typical < before.typical / 3)


def noise_of(weighed: Sequence[Weighing]) -> float:
    """Half units of the last digit in which an explained column of this table may scatter: somewhat more than those
    that are right do."""
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


def lengths_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """For each column the lengths, one at a time, with which it becomes right when all is computed with them."""
    return _found(columns, by, lambda q: partial(_solved, q), Slip.LENGTH)


def rates_found(columns: Sequence[Column], by: Suspect) -> list[list[tuple[Fit, Explanation]]]:
    """The same for rates alone: the angles as they are, velocities and accelerations with another length."""
    return _found(
        columns,
        by,
        lambda q: partial(mixed_or_none, (by.truth if q is by.truth.positions else by.thin).motion),
        Slip.RATES,
    )


def _solved(positions: Reals, mech: Mechanism) -> Motion | None:
    return solved(mech, positions)


def mixed_or_none(poses: Motion, mech: Mechanism) -> Motion | None:
    """Rates with the lengths of this mechanism at the angles of that motion; None where there are none."""
    try:
        return mixed(mech, poses)
    except (VecpolyError, ValueError, ArithmeticError):
        return None


def _found(
    columns: Sequence[Column], by: Suspect, model_at: Callable[[Reals], Model], slip: Slip
) -> list[list[tuple[Fit, Explanation]]]:
    """Fit every column, then all columns together that one length makes right, and try that value on every column."""
    part = thinned(len(by.truth.positions))
    thin = [replace(column, values=column.values[part], half=column.half[part]) for column in columns]
    narrow, wide = model_at(by.thin.positions), model_at(by.truth.positions)
    found: list[dict[tuple[str, float], tuple[Fit, Explanation]]] = []
    for column, best in zip(columns, fits(thin, by.thin, narrow, coarse=slip is Slip.RATES), strict=True):
        mine = [
            (fit, after)
            for one in best
            if _other(fit := polished([column], by.truth, one, wide))
            and (after := weighed(column, by.truth, fit, wide))
        ]
        found.append({_name(fit): (fit, explained_by(fit, after, slip)) for fit, after in mine})
    pool = {
        _name(fit): fit
        for fit in (
            *_together(columns, found, by, wide),
            *(fit for told in found for fit, one in told.values() if _fits(one.after)),
        )
    }
    for column, told in zip(columns, found, strict=True):
        for name, fit in pool.items():
            if name not in told and (after := weighed(column, by.truth, fit, wide)) is not None:
                told[name] = fit, explained_by(fit, after, slip)
    return [list(told.values()) for told in found]


def _together(
    columns: Sequence[Column],
    found: Sequence[Mapping[tuple[str, float], tuple[Fit, Explanation]]],
    by: Suspect,
    wide: Model,
) -> Iterator[Fit]:
    """For every length that makes several columns right, the one value with which they are right together."""
    names = dict.fromkeys(name for told in found for (name, _), (_, one) in told.items() if _fits(one.after))
    for name in names:
        right = [
            (column, fit)
            for column, told in zip(columns, found, strict=True)
            for fit, one in told.values()
            if fit.length.words.en == name and _fits(one.after)
        ]
        middle = float(np.median([fit.value for _, fit in right]))  # two signs may leave it at 0
        near = [one for one in right if abs(one[1].value - middle) < 0.05 * abs(middle)]
        if len(near) > 1 and _other(fit := polished([column for column, _ in near], by.truth, near[0][1], wide)):
            yield fit


def _fits(after: Weighing) -> bool:
    return after.level < Level.WRONG and (after.doubt <= SURE or after.spread <= 2 * LOOSE)


def _other(fit: Fit) -> bool:
    """Whether it is another value, and not on the other side of a link (that is another assembly)."""
    times = fit.value / fit.length.value
    return abs(times - 1) > 1e-6 and (times > 0 or fit.length.link == FRAME)


def _odd(fit: Fit) -> int:
    """Decimals of mm beyond those of the length that is given, and 0.1 mm."""
    usual, found = (len(f"{1e3 * value:.4f}".rstrip("0").partition(".")[2]) for value in (fit.length.value, fit.value))
    return max(found - max(min(usual, 2), 1), 0) + (2 if found > usual + 1 else 0)


def _name(fit: Fit) -> tuple[str, float]:
    return fit.length.words.en, round(fit.value, 9)


def explained_by(fit: Fit, after: Weighing, slip: Slip) -> Explanation:
    """A length that was found by fit, in words."""
    name, value, given = fit.length.words, f"{1e3 * fit.value:.6g}", f"{1e3 * fit.length.value:.6g}"
    if slip is Slip.LENGTH:
        words = Words(
            f"按 {name.zh} = {value} mm 计算（而不是 {given} mm）",
            f"computed with {name.en} = {value} mm (not {given} mm)",
        )
    else:
        words = Words(
            f"位置按 {name.zh} = {given} mm，速度和加速度却按 {name.zh} = {value} mm 计算",
            f"angles with {name.en} = {given} mm, but rates computed with {name.en} = {value} mm",
        )
    return Explanation(slip=slip, words=words, after=after, parameter=fit.value, length=name.en, odd=_odd(fit))
