"""Where a problem is from stands on its page as far as a reader needs it."""

from __future__ import annotations

import re

import pytest

import vecpoly
from tests.drawn_library import LIBRARY, given
from vecpoly.algebra.formula import plain
from vecpoly.check.printed.answers import check_problem
from vecpoly.report.answers.line import result_of
from vecpoly.report.answers.notes import remark_of
from vecpoly.report.sources import printed_source
from vecpoly.report.statement.asked import asked
from vecpoly.words import Lang, Words

ADAPTED = re.compile("另定|改为")


@pytest.mark.parametrize(
    ("name", "zh", "en"),
    [
        ("3-1a", "改编自习题 3-1（尺寸另定）", "Adapted from Exercise 3-1 (different dimensions)"),
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
    told = [printed_source(given(name).source, lang) for name in LIBRARY]
    assert len(list(filter(None, told))) > 80
    assert not [one for one in told if "自拟" in one or "失" in one or " our" in one or "lost" in one]


def test_a_problem_that_is_judged_by_the_book_says_what_it_has_in_common_with_it() -> None:
    """ "Different mechanism" stood on the first page, and "All counts agree with the textbook answers" on the last."""
    adapted = [one for one in map(given, LIBRARY) if one.printed and one.source and ADAPTED.search(one.source.zh)]
    assert len(adapted) > 12
    for one in adapted:
        assert one.source is not None
        counts = all(printed.symbol.split("_")[0] in ("n", "p", "F") for printed in one.printed)
        shared = "同原题" in one.source.zh and " same " in one.source.en
        by_book = "原书" in one.source.zh and "printed" in one.source.en
        assert shared or by_book or (counts and "尺寸另定" in one.source.zh), one.id


def test_lengths_to_a_lost_figure_are_told_to_be_no_answers_of_these_data() -> None:
    whole = check_problem(given("8-5")).whole
    assert whole is not None and "不属于本题的尺寸" in whole.zh and "not to the dimensions here" in whole.en


def test_the_source_of_a_problem_without_one_is_nothing() -> None:
    assert printed_source(None, "zh") == "" and printed_source(Words.same("Hibbeler 16-3"), "en") == "Hibbeler 16-3"


def test_a_moment_that_is_found_by_another_way_is_asked_once_more() -> None:
    solution = vecpoly.load("plate-reactions").solve(by="exact")
    assert asked(solution, "zh").startswith("平衡力矩$M_{1}$") and asked(solution, "zh").endswith(
        "$M_{1}$ 的校核值（速度多边形杠杆法）"
    )
    assert asked(solution, "en").endswith("$M_{1}$ as a check, by the Zhukovsky lever")


def test_a_condition_that_is_met_says_so_and_gives_no_reason_twice() -> None:
    solution = vecpoly.load("flywheel-rim").solve(by="exact")
    safe = solution.answers["v_allowed"]
    assert (result_of(safe, "zh"), result_of(safe, "en")) == ("满足", "satisfied")
    assert safe.reading.remark is not None and remark_of(safe, "en") == ""


def test_readings_of_a_station_stand_with_their_table() -> None:
    steps = vecpoly.load("cam-roller-offset").solve(by="exact").construction.steps
    (shown,) = (step for step in steps if step.listing is not None)
    assert {plain(line).split(" = ")[0] for line in shown.formulas} == {"α_60", "r_60", "θ_60"}
