"""Tables and figures of a course report are called by their numbers before they stand; a parted table says so."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

from tests.laws import few
from tests.studies import course_text
from vecpoly.report.flow.table import DataTable
from vecpoly.report.flow.text.continued import continued
from vecpoly.words import Lang

REPORTS = [(name, lang) for name in ("3-9", "4-6", "six-bar-dynamic", "shaper-flywheel") for lang in ("zh", "en")]
CALLED = {
    "zh": r"({kind} ?)([\dA-Z]+)-(\d+)(?:至{kind} ?[\dA-Z]+-(\d+))?",
    "en": r"({kind} )([\dA-Z]+)-(\d+)(?: to {kind} [\dA-Z]+-(\d+))?",
}
KINDS = {"zh": ("表", "图"), "en": ("Table", "Figure")}


def numbers(text: str, kind: str, lang: Lang) -> Iterator[tuple[str, int]]:
    """Chapter and number of all that is called of a kind, ranges through."""
    for match in re.finditer(CALLED[lang].format(kind=kind), text):
        for n in range(int(match[3]), int(match[4] or match[3]) + 1):
            yield match[2], n


@pytest.mark.parametrize(("name", "lang"), few(REPORTS, 8))
def test_every_table_and_figure_is_called_in_the_text_before_it(name: str, lang: Lang) -> None:
    text, objects = course_text(name, lang)
    wanted = 0
    for match in re.finditer(r'<(table|figure) ref="(\w+)"', text):
        thing = objects.named[match[2]]
        caption = thing.caption if isinstance(thing, DataTable) else thing.tag.alt  # type: ignore[attr-defined]
        for kind in KINDS[lang]:
            for number in numbers(caption, kind, lang):
                wanted += 1
                called = text[: match.start()]
                assert number in set(numbers(called, kind, lang)), caption
    assert wanted > 10


def test_the_part_of_a_table_on_a_later_page_says_of_which_it_is_one() -> None:
    assert continued("Table 5-2. Angles of the links", "en") == "Table 5-2 (continued)"
    assert continued("表 A-1　其他数据", "zh") == "续表 A-1"
    assert continued("续表 A-1", "zh") == "续表 A-1" and continued("Main symbols", "en") == ""
    rows = [(str(n), str(n)) for n in range(80)]
    whole = DataTable(["a", "b"], rows, None, "rr", lang="en", caption="Table 5-2. Angles")
    head, _, tail = whole.split(400.0, 300.0)
    assert head.caption == whole.caption and tail.caption == "Table 5-2 (continued)"
    assert head.goal == whole.goal and tail.goal == ""
    assert (*head.rows, *tail.rows) == whole.rows
