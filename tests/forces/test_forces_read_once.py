"""One segment of a force polygon is read once: whatever names it has, by every hand."""

from __future__ import annotations

import numpy as np
import pytest

from tests.laws import few
from vecpoly.algebra.formula import plain, sym
from vecpoly.board.board import Board
from vecpoly.board.hand import hand
from vecpoly.mechanism.asked.forces import pairs
from vecpoly.methods.draw import draw
from vecpoly.methods.scaling import scaled
from vecpoly.names import Named, reaction
from vecpoly.printed.digits import drawn_number
from vecpoly.problem.load import load
from vecpoly.solution import Answer, Solution, solve

LOADED = [
    "4-3a",
    "4-3b",
    "4-3c",
    "4-3d",
    "4-4",
    "4-5",
    "4-5-circles",
    "4-6",
    "4-7",
    "C-inertia",
    "six-bar-dynamic",
    "slider-crank-dynamic",
    "compound-hinge-six-bar",
    "hand-lever",
    "guided-couple",
]
HANDS = 400


def by_every_hand(name: str) -> tuple[dict[str, np.ndarray], list[tuple[str, str]]]:
    """Every force by 400 pencil hands, and the keys of actions and reactions."""
    problem = load(name)
    with np.errstate(all="ignore"):
        desk = draw(problem, Board(hand("pencil", repeats=HANDS), scaled(problem).scales))
    mech = problem.mechanism
    keys = [
        (reaction(mech.number(a), mech.number(b)).key, reaction(mech.number(b), mech.number(a)).key)
        for a, b in pairs(mech)
    ]
    return {key: np.asarray(value) for key, value in desk.board.found.items()}, keys


@pytest.mark.parametrize("name", few(LOADED, 4))
def test_action_and_reaction_are_equal_for_every_one_of_400_hands(name: str) -> None:
    found, keys = by_every_hand(name)
    compared = 0
    for one, two in keys:
        for ending in ("", "_0"):
            if one + ending in found:
                np.testing.assert_array_equal(found[one + ending], found[two + ending])
                compared += 1
    assert compared >= len(keys)


def test_both_ends_of_a_two_force_link_have_one_size_for_every_hand() -> None:
    found, _ = by_every_hand("4-3a")
    assert np.std(found["R_32"]) > 1
    np.testing.assert_array_equal(found["R_32"], found["R_12"])


@pytest.mark.parametrize("name", few(LOADED, 4))
def test_what_the_steps_print_of_a_force_is_what_the_table_prints(name: str) -> None:
    solution = solve(load(name))
    compared, named = 0, [answer for answer in solution.answers.values() if isinstance(answer.rel, Named)]
    for answer in named:
        shown = {
            drawn_number(one).lstrip("−-") for one in named if one.reading.symbol == answer.reading.symbol
        }  # by lever and by power alike
        for line in _written(solution, answer):
            ends = f"{line.replace('≈', '=').replace('= −', '= ')} "
            assert any(f"= {text} " in ends for text in shown), (answer.key, line, shown)
            compared += 1
    assert compared >= (0 if name == "guided-couple" else 2)


def _written(solution: Solution, answer: Answer) -> list[str]:
    """The formulas of the steps that end in this quantity."""
    head = plain(sym(answer.reading.symbol)) + " = "
    lines = [plain(node) for step in solution.construction.steps for node in step.formulas]
    return [line for line in lines if line.startswith(head)]
