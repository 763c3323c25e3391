"""Where a problem is from stands on its page as far as a reader needs it."""

from __future__ import annotations

import pytest

import vecpoly
from tests.drawn_library import IDS, given
from vecpoly.report.sources import printed_source
from vecpoly.words import Lang, Words


@pytest.mark.parametrize(
    ("name", "zh", "en"),
    [
        ("3-1a", "据习题 3-1，尺寸另定", "After Exercise 3-1, with other dimensions"),
        ("3-2", "习题 3-2", "Exercise 3-2"),
        ("class-iii-slides", "", ""),
        ("six-bar-dynamic", "", ""),
    ],
)
def test_a_page_tells_the_exercise_and_nothing_of_a_problem_of_ones_own(name: str, zh: str, en: str) -> None:
    source = vecpoly.load(name).source
    assert source is not None and (printed_source(source, "zh"), printed_source(source, "en")) == (zh, en)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_no_page_tells_what_only_its_makers_need(lang: Lang) -> None:
    told = [printed_source(given(name).source, lang) for name in IDS]
    assert len(list(filter(None, told))) > 80
    assert not [one for one in told if "自" in one or "失" in one or " our" in one or "lost" in one]


def test_the_source_of_a_problem_without_one_is_nothing() -> None:
    assert printed_source(None, "zh") == "" and printed_source(Words.same("Hibbeler 16-3"), "en") == "Hibbeler 16-3"
