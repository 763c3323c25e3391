"""The Chinese manual of the problem file says what the English one says: same headings, blocks, tables, keys and
numbers."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from vecpoly.problem.load import loads
from vecpoly.problem.schema.models import ProblemSpec

DOCS = Path(__file__).resolve().parents[2] / "docs"
EN, ZH = ((DOCS / name).read_text(encoding="utf-8") for name in ("problem-file.md", "problem-file.zh.md"))


def headings(text: str) -> list[int]:
    return [len(mark) for mark in re.findall(r"^(#+) ", text, re.M)]


def blocks(text: str) -> list[str]:
    """The YAML blocks without their comments."""
    return [re.sub(r" +#.*", "", block) for block in re.findall(r"```yaml\n(.*?)```", text, re.S)]


def tables(text: str) -> list[list[list[str]]]:
    """Of each table the code in the first cell of every row."""
    found = re.findall(r"(?:^\|.*\n)+", text, re.M)
    return [
        [re.findall(r"`([^`]+)`", re.sub(r"\\\|", "¦", row).split("|")[1]) for row in table.splitlines()[2:]]
        for table in found
    ]


def sections(text: str) -> list[str]:
    return re.split(r"^#+ .*\n", text, flags=re.M)[1:]


def codes(section: str) -> set[str]:
    """What stands in code, but words that are in the other language by nature."""
    bare = re.sub(r"```.*?```", "", section, flags=re.S)
    return {code for code in re.findall(r"`([^`\n]+)`", bare) if code.isascii() and not re.search(r"HEADER", code)}


def test_both_manuals_have_the_same_headings() -> None:
    assert headings(EN) == headings(ZH) and len(headings(EN)) >= 16


def test_both_manuals_have_the_same_examples() -> None:
    assert blocks(EN) == blocks(ZH) and len(blocks(EN)) >= 8


def test_both_manuals_have_the_same_tables() -> None:
    assert tables(EN) == tables(ZH) and len(tables(EN)) >= 7


@pytest.mark.parametrize("number", range(len(headings(EN))))
def test_each_section_names_the_same_keys_symbols_and_commands(number: int) -> None:
    assert codes(sections(EN)[number]) == codes(sections(ZH)[number])


def test_every_key_of_a_problem_stands_in_both() -> None:
    for key in ProblemSpec.model_fields:
        assert f"`{key}`" in EN and f"`{key}`" in ZH, key


def test_the_first_example_of_the_chinese_manual_loads() -> None:
    assert loads(re.findall(r"```yaml\n(.*?)```", ZH, re.S)[0]).id == "A-27"


def test_the_links_of_the_chinese_manual_lead_to_its_headings() -> None:
    named = set(re.findall(r"^#+ (.+)$", ZH, re.M))
    assert set(re.findall(r"\]\(#([^)]+)\)", ZH)) <= named
    assert "(problem-file.zh.md)" in EN and "docs/problem-file.zh.md" in (DOCS.parent / "README.zh.md").read_text(
        encoding="utf-8"
    )


def test_the_manuals_of_a_class_have_the_same_files_options_and_commands() -> None:
    en, zh = ((DOCS / name).read_text(encoding="utf-8") for name in ("class.md", "class.zh.md"))
    assert blocks(en) == blocks(zh) and len(blocks(en)) == 3
    assert tables(en) == tables(zh) and headings(en) == headings(zh)
    commands = [re.findall(r"^    (vecpoly [^#\n]*?) *(?:#|$)", text, re.M) for text in (en, zh)]
    assert commands[0] == commands[1] and len(commands[0]) == 11
