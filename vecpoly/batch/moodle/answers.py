"""What an answer is worth: the right one, one that is close, one of the wrong sense, and those that a slip gives."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import isfinite

import numpy as np

from ...foundation.slotted import replace
from ...grading.allowance import STUDENT, Allowance
from ...grading.key import AnswerKey, Graded, Kind, is_count
from ...grading.marking.order import same_of_others
from ...grading.told.slip import told_of
from ...problem.problem import Problem
from ...report.values import class_told, is_class, is_worded, value
from ...variants.look import Look, sketch_of
from ...words import Lang, Words, bare

CLOSE, TURNED, SLIPPED = 50, 25, 20  # per cent, as Moodle allows them
DIGITS = 6
HALF_TURN = 180.0
_CLASSES = (2.0, 3.0, 4.0, 0.0)  # of a mechanism; 0: it cannot be taken apart
Slipped = tuple[tuple[float, Words], ...]  # values that slips give, each with what was done wrongly
_CLOSE = Words("接近：量取误差偏大", "close: read more carefully")
_TURNED = Words("数值对，转向或正负号相反", "the number is right, its sense or sign is not")


@dataclass(frozen=True, slots=True, kw_only=True)
class Worth:
    """A band of values: centre, half its width, per cent of the mark, and what is said."""

    value: float
    allowed: float
    percent: int
    said: Words


def asked_of(key: AnswerKey) -> tuple[Graded, ...]:
    """What Moodle can mark by itself: what is asked and has a tolerance, or is told in words; of a place each of its
    coordinates."""
    asked = (one for one in key.quantities if one.asked and not one.demoted and _comparable(one))
    return tuple(part for one in asked for part in (_coordinates(one) if one.kind is Kind.PLACE else (one,)))


def worths(problem: Problem, key: AnswerKey) -> dict[str, tuple[Worth, ...]]:
    """For each asked quantity its bands, in the order in which Moodle tries them: the narrow before the wide, the right
    before the wrong. Of several solutions each value is right in the blank of any: they have no order."""
    slipped, asked = _by_slips(problem), asked_of(key)
    return {
        one.key: tuple(
            bands(
                one, slipped.get(one.key, ()), tuple(map(key.__getitem__, same_of_others(key, one.key))), key.allowance
            )
        )
        for one in asked
    }


def bands(
    one: Graded, slipped: Slipped = (), others: tuple[Graded, ...] = (), rule: Allowance = STUDENT
) -> Iterator[Worth]:
    """The bands of a quantity, the right one first, close as a marker has it; none of what is told in words. others:
    the same of other solutions."""
    if is_worded(one.key, one.unit):
        return
    right, wide = _rounded(one.exact), _rounded(one.allowed)
    taken = [right, *_again(one, right), *([-right] if one.unsigned else [])]
    yield from (Worth(value=at, allowed=wide, percent=100, said=Words.same("")) for at in taken)
    for other in others:
        yield Worth(value=_rounded(other.exact), allowed=_rounded(other.allowed), percent=100, said=Words.same(""))
    counted = is_count(one)  # nothing is nearly as many, or as many below nothing
    if not counted:
        yield from (Worth(value=at, allowed=_rounded(rule.wrong * wide), percent=CLOSE, said=_CLOSE) for at in taken)
    if _has_sign(one) and abs(right) > 2.0 * wide and not counted:
        taken.append(-right)
        yield Worth(value=-right, allowed=wide, percent=TURNED, said=_TURNED)
    taken += [other.exact for other in others]
    for given, said in slipped:
        if abs(given) > wide and all(abs(given - other) > 2.0 * wide for other in taken):  # for 0 nobody gets marks
            taken.append(given)
            yield Worth(value=_rounded(given), allowed=wide, percent=SLIPPED, said=said)


def worded(one: Graded, lang: Lang) -> tuple[str, ...]:
    """What is told in words, and what might be told instead; nothing of a number."""
    if is_class(one.key):
        ranks = (one.exact, *(rank for rank in _CLASSES if rank != one.exact))
        return tuple(class_told(rank, lang) for rank in ranks)
    if one.kind is Kind.YES_NO:
        return tuple(value(truth, one.unit, lang, one.key) for truth in (one.exact, 1.0 - one.exact))
    return ()


def _comparable(one: Graded) -> bool:
    return is_worded(one.key, one.unit) or (isfinite(one.exact) and _rounded(one.allowed) > 0.0)


def _coordinates(one: Graded) -> Iterator[Graded]:
    """Both coordinates as numbers by themselves, in mm."""
    for axis, at in zip("xy", one.at or (), strict=False):
        yield replace(
            one,
            key=f"{one.key} {axis}",
            symbol=f"{axis}({one.symbol})",
            kind=Kind.SCALAR,
            unit=one.written_in,
            exact=at / one.one,
            allowed=one.allowed / one.one,
            at=None,
        )


def _again(one: Graded, right: float) -> tuple[float, ...]:
    """The same line, told from its other end: 178.3° and −1.7°."""
    return tuple(map(_rounded, (right - HALF_TURN, right + HALF_TURN))) if one.kind is Kind.LINE else ()


def _has_sign(one: Graded) -> bool:
    """Whether the opposite value is the same with another sense, and not another angle."""
    return one.kind is Kind.SIGNED or (one.kind is Kind.SCALAR and one.unit != "deg" and not one.unsigned)


def _by_slips(problem: Problem) -> dict[str, Slipped]:
    """Of each asked quantity the values that slips give, with what was done wrongly."""
    look = Look(problem, sketch_of(problem))
    found: dict[str, list[tuple[float, Words]]] = {}
    for column, one in enumerate(look.asked):
        with np.errstate(invalid="ignore"):
            values = look.places[1:, column] * one.allowed
        for slip, found_by in zip(look.slips, values, strict=True):
            size = abs(found_by) if one.kind is Kind.VECTOR else float(found_by.real)
            if np.isfinite(size):
                said = told_of(slip).words
                found.setdefault(one.key, []).append((float(size), Words(bare(said.zh), bare(said.en))))
    return {key: tuple(values) for key, values in found.items()}


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}") + 0.0
