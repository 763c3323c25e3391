"""Claims about who makes marks: acts do, and the symbols in diagram/; a method asks for both and makes none."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from types import UnionType
from typing import get_args

import vecpoly
from vecpoly.board.board import Board
from vecpoly.board.paper import marks
from vecpoly.board.paper.symbols import Symbol

METHODS = Path(vecpoly.__file__).parent / "methods"
MADE = {kind.__name__ for kind in get_args(marks.Mark)} | {Symbol.__name__}


def imported(tree: ast.Module) -> dict[str, str]:
    """The names under which a file knows marks and symbols → what they are."""
    return {
        alias.asname or alias.name: alias.name
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[-1] in ("marks", "symbols")
        for alias in node.names
        if alias.name in MADE
    }


def made(text: str) -> Iterator[str]:
    """The marks and symbols that a file makes by their constructors, and calls of a board's inner ones."""
    tree = ast.parse(text)
    known = imported(tree)
    for node in ast.walk(tree):
        if isinstance(node, ast.Call):
            called = node.func.value if isinstance(node.func, ast.Attribute) else node.func
            if isinstance(called, ast.Name) and called.id in known:
                yield f"{node.lineno}: {known[called.id]}"
            if isinstance(node.func, ast.Attribute) and node.func.attr in ("mark", "ink"):
                yield f"{node.lineno}: .{node.func.attr}"


def test_no_method_makes_a_mark() -> None:
    found = [
        f"{path.relative_to(METHODS)}:{one}"
        for path in sorted(METHODS.rglob("*.py"))
        for one in made(path.read_text(encoding="utf-8"))
    ]
    assert not found


def test_one_that_did_would_be_found() -> None:
    raw = "from ..board.paper.marks import Segment as Line\ndesk.board.mark(view, Line(a=0j, b=1j))\n"
    whole = "from ..board.paper.symbols import Symbol\nboard.depict(view, Symbol.of('link 2', copied))\n"
    assert list(made(raw)) == ["2: .mark", "2: Segment"]
    assert list(made(whole)) == ["2: Symbol"]


def test_a_board_has_no_door_for_raw_marks() -> None:
    assert isinstance(marks.Mark, UnionType)
    assert not hasattr(Board, "mark")
