"""What an answer is worth: the right one, one that is close, one of the wrong sense, and those that a slip gives."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...grading.key import Graded, Kind
from ...problem.problem import Problem
from ...variants.look import Look, sketch_of
from ...words import Words

CLOSE, TURNED, SLIPPED = 50, 25, 20  # per cent, as Moodle allows them
DIGITS = 6
_CLOSE = Words("接近：量取误差偏大", "close: read more carefully")
_TURNED = Words("数值对，方向相反", "the number is right, the sense is not")


@dataclass(frozen=True, slots=True, kw_only=True)
class Worth:
    """A band of values: centre, half its width, per cent of the mark, and what is said."""

    value: float
    allowed: float
    percent: int
    said: Words


def worths(problem: Problem, asked: tuple[Graded, ...]) -> dict[str, tuple[Worth, ...]]:
    """For each asked quantity its bands, in the order in which Moodle tries them: the narrow before the wide, the right
    before the wrong."""
    slipped = _by_slips(problem)
    return {one.key: tuple(_bands(one, slipped.get(one.key, ()))) for one in asked}


def _bands(one: Graded, slipped: tuple[tuple[float, Words], ...]) -> Iterator[Worth]:
    right, wide = _rounded(one.exact), _rounded(one.allowed)
    taken = [right]
    yield Worth(value=right, allowed=wide, percent=100, said=Words.same(""))
    yield Worth(value=right, allowed=_rounded(2.0 * one.allowed), percent=CLOSE, said=_CLOSE)
    if one.kind is Kind.SIGNED and abs(right) > 2.0 * wide:
        taken.append(-right)
        yield Worth(value=-right, allowed=wide, percent=TURNED, said=_TURNED)
    for value, said in slipped:
        if abs(value) > wide and all(abs(value - other) > 2.0 * wide for other in taken):  # for 0 nobody gets marks
            taken.append(value)
            yield Worth(value=_rounded(value), allowed=wide, percent=SLIPPED, said=said)


def _by_slips(problem: Problem) -> dict[str, tuple[tuple[float, Words], ...]]:
    """Of each asked quantity the values that slips give, with what was done wrongly."""
    look = Look(problem, sketch_of(problem))
    found: dict[str, list[tuple[float, Words]]] = {}
    for column, one in enumerate(look.asked):
        with np.errstate(invalid="ignore"):
            values = look.places[1:, column] * one.allowed
        for slip, value in zip(look.slips, values, strict=True):
            size = abs(value) if one.kind is Kind.VECTOR else float(value.real)
            if np.isfinite(size):
                said = Words(f"{slip.key} {slip.mistake.words.zh}？", f"{slip.key} {slip.mistake.words.en}?")
                found.setdefault(one.key, []).append((float(size), said))
    return {key: tuple(values) for key, values in found.items()}


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}") + 0.0
