"""The Chinese page of limits says what the English one says, and both say what `limits.py` holds."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.house.test_manuals_equal import codes, headings, sections, tables
from vecpoly import limits

DOCS = Path(__file__).resolve().parents[2] / "docs"
EN, ZH = ((DOCS / name).read_text(encoding="utf-8") for name in ("limits.md", "limits.zh.md"))
TOLD = (
    limits.SCALAR,
    limits.PROSE,
    limits.ENTRIES,
    limits.TABLE_ROWS,
    limits.TABLE_COLUMNS,
    limits.CELL,
    limits.REPEATS,
    limits.POSITIONS,
    limits.DEPTH,
    limits.EXTENDS,
    limits.FAULTS,
)


def rows(text: str) -> list[list[str]]:
    """The numbers in each row of the table."""
    return [
        re.findall(r"\d+(?:[,.]\d+)*(?:e\d+)?", row.partition("|")[2].partition("|")[2])
        for row in text.splitlines()
        if row.startswith("| ")
    ]


def blocks(text: str) -> list[str]:
    """The commands without what is said of them."""
    return re.findall(r"^    (python .+?)(?: +#.*)?$", text, re.M)


def test_both_pages_have_the_same_headings_tables_and_commands() -> None:
    assert headings(EN) == headings(ZH) and len(headings(EN)) >= 6
    assert tables(EN) == tables(ZH) and tables(EN)
    assert blocks(EN) == blocks(ZH) and len(blocks(EN)) == 6


def test_both_pages_tell_the_same_numbers() -> None:
    assert [sorted(row) for row in rows(EN)] == [sorted(row) for row in rows(ZH)] and len(rows(EN)) >= 10


@pytest.mark.parametrize("number", range(len(headings(EN))))
def test_each_section_names_the_same_keys_files_and_commands(number: int) -> None:
    assert codes(sections(EN)[number]) - {"statement"} == codes(sections(ZH)[number]) - {"statement"}


@pytest.mark.parametrize("limit", TOLD)
def test_the_pages_tell_the_limits_that_the_code_holds(limit: int) -> None:
    assert f"{limit:,}" in EN and f"{limit:,}" in ZH


def test_each_page_leads_to_the_other_and_the_manuals_to_their_own() -> None:
    assert "(limits.zh.md)" in EN and "(limits.md)" in ZH
    assert "(limits.md)" in (DOCS / "problem-file.md").read_text(encoding="utf-8")
    assert "(limits.zh.md)" in (DOCS / "problem-file.zh.md").read_text(encoding="utf-8")
