"""What a problem file leads to, found one thing after the other, each when it is first wanted."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import count
from typing import Generic, TypeVar

from vecpoly.check.printed.answers import check_problem
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.errors import VecpolyError
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem
from vecpoly.solution import solve

Found = TypeVar("Found")


class Remembered(Generic[Found]):
    """Gives what the source gives, as often as it is gone through; the source is asked only as far as anybody went."""

    def __init__(self, source: Iterator[Found]) -> None:
        self._source, self._seen = source, list[Found]()

    def __iter__(self) -> Iterator[Found]:
        for i in count():
            if i == len(self._seen):
                try:
                    self._seen.append(next(self._source))
                except StopIteration:
                    return
            yield self._seen[i]


def effects(text: str) -> Iterator[object]:
    """Everything that a file leads to, or its refusal. Who has seen a difference asks for no more."""
    found = led_to(text)
    while True:
        try:
            one = next(found)
        except StopIteration:
            return
        except VecpolyError as error:
            one = str(error)
        yield one


def led_to(text: str) -> Iterator[object]:
    """One thing after the other: what a report prints of it, answers and drawing, checks, sheets."""
    problem = loads(text)
    yield said(problem)
    solution = solve(problem, by="exact", repeats=0, precise=False)
    yield solution.as_json(), solution.construction.figures
    yield solve(problem, by="exact", repeats=0).warnings
    yield check_problem(problem).answers
    yield [sheet.size for sheet in sheets(solution.construction, on=problem.paper)]


def said(problem: Problem) -> tuple[object, ...]:
    """What a report prints of the problem itself."""
    return (
        problem.id,
        problem.title,
        problem.source,
        problem.statement,
        problem.explain,
        problem.errata,
        problem.tables,
        problem.ranges,
        problem.gate,
        problem.given,
    )


@cache
def effect(text: str) -> Remembered[object]:
    """The same, of a file that several others are compared with."""
    return Remembered(effects(text))
