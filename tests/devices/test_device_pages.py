"""What the solution sheets of devices must say:
errata without printed answers, formulas that agree with the drawing, verdicts on self-locking."""

from __future__ import annotations

import re
from itertools import pairwise, product

import pytest

from tests.laws import few
from vecpoly.algebra.formula import plain
from vecpoly.board.paper.marks import Vector
from vecpoly.problem.load import load, loads
from vecpoly.report.document import markup
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

LANGS: tuple[Lang, ...] = ("zh", "en")
DEVICES = ("4-1", "4-2", "5-1", "5-2", "5-3", "5-4", "5-5", "5-6", "5-7")


def page(solution: Solution, lang: Lang) -> str:
    return markup([solution], lang, "solution", {}, None, None)[0]


@pytest.mark.parametrize(("name", "lang"), few(list(product(DEVICES, LANGS)), 9))
def test_errata_stand_on_the_page_whether_or_not_an_answer_is_printed(name: str, lang: Lang) -> None:
    solution = solve(load(name), by="exact", repeats=0, precise=False)
    text = page(solution, lang)
    assert ('kind="note"' in text) == bool(solution.problem.errata)


def test_a_block_diagram_stands_in_the_text_and_a_drawing_on_a_sheet() -> None:
    train, wedge = page(solve(load("5-6"), by="exact"), "en"), page(solve(load("5-2"), by="exact"), "en")
    assert "<sheet" not in train and train.count("<figure") == 2
    assert "<sheet" in wedge and wedge.count("<figure") == 1


@pytest.mark.parametrize("name", DEVICES)
def test_a_quantity_found_twice_in_one_step_is_the_same_by_drawing_and_by_formula(name: str) -> None:
    for step in solve(load(name), by="exact").construction.steps:
        found: dict[str, list[str]] = {}
        for formula in (plain(node) for node in step.formulas):
            symbol, value = formula.split(" = ")[0], formula.rsplit(" = ", 1)[1]
            found.setdefault(symbol, []).append(value)
        assert all(_alike(one, two) for values in found.values() for one, two in pairwise(values)), found


def _alike(one: str, two: str) -> bool:
    """Whether two texts are one, or one number with more and with fewer digits: 992 N as read, 992.4 N as worked."""
    if one == two:
        return True
    (a, unit), (b, same) = ((text.split(" ")[0], text.split(" ")[1:]) for text in sorted((one, two), key=len))
    digits = len(a.partition(".")[2])
    return unit == same and f"{round(float(b), digits):.{digits}f}" == a


@pytest.mark.parametrize(
    ("slope", "said"), [("6 deg", "self-locking, the block must be pulled down"), ("24 deg", "not self-locking")]
)
def test_a_given_slope_is_judged_by_the_sign_of_the_force_that_holds(slope: str, said: str) -> None:
    text = load("5-1").text
    solution = solve(
        loads(text.replace("beta: 45 deg,", f"beta: 45 deg, alpha: {slope},").split("printed:")[0]), by="exact"
    )
    assert said in " ".join(step.words.en for step in solution.construction.steps)
    assert (solution.answers["F_r"].exact <= 0) == ("must be pulled" in said)


@pytest.mark.parametrize("name", DEVICES[1:])
def test_every_force_arrow_carries_its_symbol(name: str) -> None:
    for figure in solve(load(name), by="exact").construction.figures:
        if not figure.name.startswith(("limits", "collar", "thread", "train")):
            assert all(mark.label for mark in figure.marks if isinstance(mark, Vector)), figure.name


def test_no_symbol_of_a_polygon_without_friction_is_that_of_one_with_friction() -> None:
    for name in ("4-2", "5-1", "5-2", "5-3", "5-4"):
        smooth = [
            s.equation
            for s in solve(load(name), by="exact").construction.steps
            if s.equation and any(re.search(r"F'?_\{?0", t) for t in s.equation.symbols)
        ]
        assert smooth
        for table in smooth:
            assert all(",0}" in symbol for symbol in table.symbols if symbol.startswith("R") and symbol != "R_{23}")
