"""Several solutions of a design: each has its number in the order in which it is found, or the reader is told why."""

from __future__ import annotations

import re

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import Step

NUMBER = re.compile(r"\^\((\d)\)")


def numbers(step: Step) -> list[int]:
    """The numbers of the solutions whose quantities a step works out."""
    return [int(found[1]) for node in step.formulas if (found := NUMBER.search(plain(node).split(" = ")[0]))]


@each(Later(lambda: ids(mechanisms=False)))
def test_solutions_are_numbered_in_the_order_in_which_they_are_found(name: str) -> None:
    steps = drawn(name).construction.steps
    found = list(dict.fromkeys(number for step in steps for number in numbers(step)))
    assert found == sorted(found) or any("are numbered by" in step.words.en for step in steps), found


def test_the_meetings_have_the_letters_that_are_measured() -> None:
    steps = drawn("8-4").construction.steps
    told = next(step for step in steps if step.formulas and 1 in numbers(step))
    assert "$C_2$ and $C′_2$" in told.words.en and "AC_2" in plain(told.formulas[0])
