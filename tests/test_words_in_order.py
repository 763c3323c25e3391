"""A claim about every sentence in the code, met by a test or not: Chinese stands first, English second."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

HOUSE = Path(__file__).parent.parent / "vecpoly"
_EXAMPLE = re.compile(r"'[^']*'")  # between quotes: what the reader may write, in either language
_HAN, _WORD = re.compile("[\u4e00-\u9fff]"), re.compile(r"\b[a-z]{4,}\b")


def literal(node: ast.expr) -> str:
    """What is written out of a text, with a blank for all that is filled in."""
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=parts):
            return " ".join(literal(part) for part in parts)
        case _:
            return " "


def misplaced(source: str) -> Iterator[tuple[int, str]]:
    """(line, text) of every sentence of which the English has a Chinese letter, or the Chinese has none and the English has words."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "Words" and len(node.args) == 2:
            zh, en = (_EXAMPLE.sub(" ", literal(arg)) for arg in node.args)
            if _HAN.search(en) or (_WORD.search(re.sub(r"\$[^$]*\$", " ", en)) and zh.strip() and not _HAN.search(zh)):
                yield node.lineno, f"{zh} | {en}"


@pytest.mark.parametrize("text", ["Words('the link', '构件')", "Words(f'no link {x}', f'没有构件 {x}')", "Words('link', 'the link')"])
def test_languages_swapped_are_seen(text: str) -> None:
    assert list(misplaced(text)) and not list(misplaced("Words(f'没有构件 {x}', f'no link {x}')")) and not list(misplaced("Words(zh, en)"))


def test_chinese_stands_first_in_every_sentence_of_the_code() -> None:
    found = {f"{file.relative_to(HOUSE)}:{line}": text for file in sorted(HOUSE.rglob("*.py")) for line, text in misplaced(file.read_text(encoding="utf-8"))}
    assert not found, found
