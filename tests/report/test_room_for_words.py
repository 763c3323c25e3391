"""What a statement asks in words has lines on the question sheet, or a cell that is answered by yes or no."""

from __future__ import annotations

import re
from io import BytesIO
from typing import get_args

import pdfplumber
import pytest

from tests.drawn_library import LIBRARY, drafted, drawn, given
from tests.each import each
from vecpoly.problem.asked.asks import AskCoriolis
from vecpoly.report.document import report_bytes
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.lined import Lined, lined
from vecpoly.report.statement.asked import asked
from vecpoly.solution import YES_NO
from vecpoly.typeset.box import MM
from vecpoly.words import Lang, bare

IN_WORDS = re.compile(r"说明(?!理由)|指出|为什么|提出|能否|是否相同|判断\w+类型|分析该|以哪一|哪一项|变尖")
PLACES = ("phi_max", "phi_min")  # 指出最大转速的位置: a number


@each(LIBRARY)
def test_what_is_asked_in_words_has_a_place_on_the_sheet(name: str) -> None:
    problem = given(name)
    if not IN_WORDS.search(problem.statement.zh):
        return
    told = {ask.rel.key for ask in problem.asks}
    asks = any(isinstance(ask, AskCoriolis) for ask in problem.asks) or bool(told & {*PLACES})
    either = any(one.reading.unit == YES_NO for one in drawn(name).solution.answers.values())
    assert problem.explain or asks or either, problem.statement.zh


@each(LIBRARY)
def test_what_is_to_be_explained_is_asked_in_the_statement_and_by_no_symbol_of_the_results(name: str) -> None:
    problem = given(name)
    for one in problem.explain:
        assert one.zh and one.en and one.zh != one.en and len(one.zh) < 40
        assert bare(one.zh) not in bare(asked(drawn(name).solution, "zh")), "it has a cell"


def test_a_sheet_without_such_a_question_has_no_lines() -> None:
    assert given("3-9").explain == () and lined((), "zh") == []


@pytest.mark.parametrize("lang", get_args(Lang))
@pytest.mark.parametrize("name", ["8-1", "8-10", "2-6"])
def test_each_name_stands_once_before_its_lines(name: str, lang: Lang) -> None:
    solution = drafted(name) or drawn(name).solution
    _, lines = lined(solution.problem.explain, lang)
    assert isinstance(lines, Lined) and len(lines.names) == len(solution.problem.explain)
    with pdfplumber.open(BytesIO(report_bytes([solution], lang=lang, style="question"))) as pdf:
        words = "".join(page.extract_text() for page in pdf.pages)
    for one in lines.names:
        assert re.sub(r"[\s$]", "", one) in re.sub(r"\s", "", words)


def test_a_line_begins_behind_its_name_and_under_a_long_one_at_the_edge() -> None:
    long = "a name that is much too long to leave any room for a line behind it, as it goes on:"
    lines = Lined(("short:", "somewhat longer:", long))
    lines.wrap(170 * MM, 0.0)
    short, longer, edge = lines.starts()
    assert 5 * MM < short < 40 * MM and edge == 0.0
    assert short == longer, "one under the other"


def test_of_a_term_that_may_not_exist_the_row_says_what_is_written_then() -> None:
    rows = [row[0] for row in empty_table(drawn("3-7b").solution, "en").rows]
    assert any("Coriolis term" in row and "0 if none" in row for row in rows)
    rows = [row[0] for row in empty_table(drawn("3-9").solution, "en").rows]
    assert not any("0 if none" in row for row in rows)
