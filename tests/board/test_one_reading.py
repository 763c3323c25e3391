"""One segment is read once, and a vector that was computed is not read at all:
steps, table and answers show one number."""

from __future__ import annotations

import re

import numpy as np
import pytest

from tests.drawn_library import DRAFTED, drafted, ids
from vecpoly.algebra.formula import plain, sym
from vecpoly.board.board import Board
from vecpoly.board.construction import Scale, View
from vecpoly.board.hand import hand
from vecpoly.errors import NotAskedError
from vecpoly.names import Rel
from vecpoly.printed.digits import drawn_number
from vecpoly.printed.units import printed_unit
from vecpoly.problem.load import load
from vecpoly.solution import Answer, Solution, solve

RESULT = re.compile(r"(−?[\d.]+)(?:×10\^?(−?\d+))? (?:m/s|m/s\^2|rad/s|rad/s\^2|N|N·m)$")


def written(solution: Solution, answer: Answer) -> list[float]:
    """The results that the steps print for this quantity: symbol = ... = number unit."""
    head = plain(sym(answer.reading.symbol)) + " = "
    lines = [plain(node) for step in solution.construction.steps for node in step.formulas]
    found = [RESULT.search(line) for line in lines if line.startswith(head)]
    return [float(m[1].replace("−", "-")) * 10.0 ** int((m[2] or "0").replace("−", "-")) for m in found if m]


def test_what_the_steps_print_of_a_motion_is_what_the_table_prints() -> None:
    compared, other = 0, []
    for solution in filter(None, map(drafted, sorted({*DRAFTED} & {*ids()}))):
        for answer in solution.answers.values():
            if not isinstance(answer.rel, Rel):
                continue
            text, (factor, _) = drawn_number(answer), printed_unit(answer.reading.unit)
            shown = abs(float(text.replace("−", "-").replace("×10^{", "e").rstrip("}"))) / factor
            for value in written(solution, answer):
                compared += 1
                if abs(abs(value) - shown) > 1e-9 * max(1.0, shown):
                    other.append((solution.problem.id, answer.key, value, shown))
    assert compared > len(DRAFTED) / 2
    assert other == []


@pytest.mark.parametrize("by", ["drafting", "pencil"])
def test_a_segment_is_read_once_by_every_hand(by: str) -> None:
    board = Board(hand(by, seed=3, repeats=400), {View.FORCE: Scale(symbol="μ_F", value=1.0, unit="N")})
    tip = board.lay_off(0j, 1 + 0j, 41.37)
    there, back = board.measure(0j, tip, "a b"), board.measure(tip, 0j, "b a")
    assert np.shape(there.value) == (401,)
    assert np.array_equal(there.value, back.value)
    other = board.measure(0j, board.lay_off(0j, 1 + 0j, 41.37), "a c")
    assert not np.array_equal(there.value, other.value)


@pytest.mark.parametrize(("problem", "read"), [("3-9", "BC"), ("3-12", "ED")])
def test_a_length_read_as_nothing_by_which_something_is_divided_is_refused(problem: str, read: str) -> None:
    with pytest.raises(NotAskedError, match="no length"):
        solve(load(problem), by="exact", repeats=0, readings={read: 0.0})
