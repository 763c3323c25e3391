"""Claims about formulas in texts: all of each is read."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from vecpoly.algebra.formula import Txt, row, split_words, sym

CODE = Path(__file__).parents[2] / "vecpoly"
PROBLEMS = CODE.parent / "problems"
UNREAD = frozenset("_^")


def said(tree: ast.AST) -> Iterator[str]:
    """The texts of a module in two languages, each hole of one filled with a letter."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and isinstance(call.func, ast.Name) and call.func.id == "Words":
            for text in call.args:
                if isinstance(text, ast.JoinedStr):
                    yield "".join(str(one.value) if isinstance(one, ast.Constant) else "x" for one in text.values)
                elif isinstance(text, ast.Constant):
                    yield str(text.value)


def unread(text: str) -> Iterator[str]:
    """The formulas of a text of which marks of an index are left over: C_1DC_2 reads as C, of index 1DC, and _2."""
    for is_formula, piece in split_words(text):
        rest = [item.text for item in row(piece).items if isinstance(item, Txt)] if is_formula else []
        if any(UNREAD & set(one) for one in rest):
            yield piece


def test_no_text_has_a_formula_whose_index_is_printed_as_a_mark() -> None:
    assert [*unread("$C_1DC_2$")] == ["C_1DC_2"]
    assert not [*unread("$∠C_1DC_2$ $∠C_{1}DC_{2}$")]
    texts = [one for path in CODE.rglob("*.py") for one in said(ast.parse(path.read_text("utf-8")))]
    assert len(texts) > 1000
    assert not [formula for text in texts for formula in unread(text)]


def test_letters_of_points_side_by_side_have_each_its_own_index() -> None:
    """As statements write them: C_1C_2 is no C of the index 1C, ∠C_1OA none of the index 1OA."""
    assert row("C_1C_2") == row("C_{1}C_{2}")
    assert row("∠C_1OA") == row("∠C_{1}OA")
    assert row("△A_2′B_1C") == row("△A_{2}′B_{1}C")
    assert row("P_12P_13") == row("P_{12}P_{13}")
    for one in ("W_1I", "P_24C", "i_1H", "R_12B"):
        assert row(one).items == (sym(one),)


def test_no_problem_of_the_library_has_a_formula_that_is_not_read_in_whole() -> None:
    texts = [path.read_text("utf-8") for path in PROBLEMS.rglob("*.yaml")]
    lines = [line for text in texts for line in text.splitlines() if line.count("$") > 1]
    assert len(lines) > 300
    assert not [formula for line in lines for formula in unread(line)]
