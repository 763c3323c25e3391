"""Claims about formulas in texts: all of each is read."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from vecpoly.algebra.formula import Txt, row, split_words

CODE = Path(__file__).parents[2] / "vecpoly"
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
    """The formulas of a text of which marks of an index are left over: ∠C_1DC_2 reads as C, of index 1DC, and _2."""
    for is_formula, piece in split_words(text):
        rest = [item.text for item in row(piece).items if isinstance(item, Txt)] if is_formula else []
        if any(UNREAD & set(one) for one in rest):
            yield piece


def test_no_text_has_a_formula_whose_index_is_printed_as_a_mark() -> None:
    assert [*unread("$∠C_1DC_2$")] == ["∠C_1DC_2"]
    assert not [*unread("$∠C_{1}DC_{2}$")]
    texts = [one for path in CODE.rglob("*.py") for one in said(ast.parse(path.read_text("utf-8")))]
    assert len(texts) > 1000
    assert not [formula for text in texts for formula in unread(text)]
