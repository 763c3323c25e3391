"""Text files are UTF-8 on every machine, whatever its own encoding is."""

from __future__ import annotations

import ast
from collections.abc import Iterator

import pytest

from tests.sources import nodes, sources, text

TEXT = ("read_text", "write_text")


def of_this_machine(source: str) -> Iterator[int]:
    """The line of every text that is read or written as this machine does it."""
    for node in nodes(source):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in TEXT:
            told = [keyword.value for keyword in node.keywords if keyword.arg == "encoding"]
            told += node.args[TEXT.index(node.func.attr) :][:1]
            if [ast.unparse(one).lower() for one in told] not in (["'utf-8'"], ["'utf-8-sig'"]):
                yield node.lineno


@pytest.mark.parametrize("text", ["file.read_text()", "file.write_text(words)", "file.read_text(encoding='gbk')"])
def test_a_text_that_depends_on_the_machine_is_seen(text: str) -> None:
    assert list(of_this_machine(text))
    assert not list(of_this_machine("a.read_text('utf-8'), a.write_text(words, encoding='utf-8')"))


def test_every_text_is_read_and_written_as_utf_8() -> None:
    found = [f"{file}:{line}" for file in sources() for line in of_this_machine(text(file))]
    assert not found, found
