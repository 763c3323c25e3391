"""The problem file in the appendix: in the report's language, and never begun on a page inside a string."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import ruamel.yaml

from tests.each import each
from tests.laws import few
from vecpoly.foundation.data import data_dir
from vecpoly.report.course.one_language import in_one_language
from vecpoly.report.flow.listing import Listing
from vecpoly.words import Lang

FILES = tuple(sorted(data_dir("problems").rglob("*.yaml")))
LANGS: tuple[Lang, Lang] = ("zh", "en")
TEXT = "\n".join(
    f"key_{n}: " + "a sentence of many words that is folded on the next line, and on the one after " * 3
    for n in range(12)
)


def told(value: Any, lang: str) -> Any:
    """What a file says, of what it says twice in this language alone."""
    if isinstance(value, dict):
        both = {"zh", "en"} <= set(value)
        return {k: told(v, lang) for k, v in value.items() if not both or k not in ("zh", "en") or k == lang}
    return [told(one, lang) for one in value] if isinstance(value, list) else value


@each(few(FILES, 24))
def test_a_file_in_one_language_says_all_else_as_before(file: Path) -> None:
    text = file.read_text(encoding="utf-8")
    reader = ruamel.yaml.YAML(typ="safe")
    for lang in LANGS:
        made, told_before = reader.load(in_one_language(text, lang)), told(reader.load(text), lang)
        assert repr(made) == repr(told_before)


@pytest.mark.parametrize("height", range(40, 400, 7))
def test_a_page_of_a_listing_never_begins_inside_a_string(height: int) -> None:
    parts = Listing(TEXT).split(400.0, float(height))
    assert not parts or parts[1]._lines[0][1].startswith("key_")
