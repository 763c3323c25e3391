"""How far a number may be varied by itself: as far as the problem can still be set with it."""

from __future__ import annotations

from collections.abc import Iterable

from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...problem.ranges import Range
from ...problem.values.vary import vary
from .numbers import Span

LEAST = 3  # values that a range has


def fitted(problem: Problem, span: Span) -> Span | None:
    """The values of a range, on either side of the one that stands there, as far as the problem can be set with them; a
    time ratio begins at 1. None where hardly any are left: a gear is as large as the distance of the axes has it.

    problem: with this range alone.
    """
    one = problem.ranges[0]
    middle, last = one.count // 2, one.count - 1
    down = _reached(problem, one, 0, range(middle - 1, 0, -1), middle)
    up = _reached(problem, one, last, range(middle + 1, last), middle)
    if up - down + 1 < LEAST:
        return None
    if (down, up) == (0, last):
        return span
    step = span.text.rpartition(" by ")[2]
    return replace(span, text=f"{one.at(down)} .. {one.at(up)} by {step}")


def _reached(problem: Problem, one: Range, end: int, inner: Iterable[int], middle: int) -> int:
    """The last number on the way from the middle with which the problem can be set: the end where it can be there."""
    if _is_set(problem, one, end):
        return end
    reached = middle
    for number in inner:
        if not _is_set(problem, one, number):
            break
        reached = number
    return reached


def _is_set(problem: Problem, one: Range, number: int) -> bool:
    try:
        vary(problem, {one.name: one.at(number)})
    except VecpolyError:
        return False
    return True
