"""Where a problem asks for the reactions of all its joints or bearings, each that is read in a step is an answer."""

from __future__ import annotations

import re
from collections.abc import Sequence

import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from vecpoly.algebra.formula import Row, Sym
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

ALL = re.compile("各(运动副|轴承|移动副|铰链和导路)[^，。]{0,3}反力")
SIZE = re.compile(r"([\d.]+)\D{1,3}N\b")
SAME = 0.01  # of its size: a two-force link passes on what it bears


def asking(names: Sequence[str]) -> list[str]:
    """Those whose statement asks for all."""
    return [
        name for name in names if isinstance(given(name).subject, Mechanism) and ALL.search(given(name).statement.zh)
    ]


def read_and_unanswered(solution: Solution) -> list[str]:
    """R_45 and others that steps read off, and that no answer has, nor any of the same size."""
    answers = {key: one.drawn for key, one in solution.answers.items() if key.startswith("R_")}
    known = {frozenset(key[2:4]) for key in answers}
    lost = []
    for formula in (formula for step in solution.construction.steps for formula in step.formulas):
        first, last = (formula.items[0], str(formula.items[-1])) if isinstance(formula, Row) else (None, "")
        if isinstance(first, Sym) and first.base == "R" and not first.sup and re.fullmatch(r"\d\d", first.sub):
            size = SIZE.search(last)
            assert size is not None, last
            alike = any(abs(abs(one) - float(size[1])) < SAME * abs(one) for one in answers.values())
            lost += [first.sub] if frozenset(first.sub) not in known and not alike else []
    return lost


@each(Later(lambda: asking(IDS)))
def test_all_reactions_that_are_asked_for_are_answered(name: str) -> None:
    assert read_and_unanswered(drawn(name).solution) == []


@pytest.mark.parametrize("name", ["two-trains-one-sun", "six-bar-dynamic"])
def test_the_reactions_of_all_bearings_are_answered(name: str) -> None:
    assert asking((name,)) and read_and_unanswered(drawn(name).solution) == []
