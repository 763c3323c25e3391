"""The code of the house, read and parsed once for all claims about it."""

from __future__ import annotations

import ast
import gc
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
HOUSE = ROOT / "vecpoly"


@cache
def sources() -> tuple[Path, ...]:
    """Every file of the program."""
    return tuple(sorted(HOUSE.rglob("*.py")))


@cache
def text(path: Path) -> str:
    """What stands in a file."""
    return path.read_text(encoding="utf-8")


@cache
def tree(source: str) -> ast.Module:
    """A source as Python parses it; who walks it changes nothing."""
    gc.disable()  # for all that is parsed is kept, and would be looked through again and again
    try:
        return ast.parse(source)
    finally:
        gc.enable()


@cache
def nodes(source: str) -> tuple[ast.AST, ...]:
    """Everything in a source, in no particular order."""
    return tuple(ast.walk(tree(source)))
