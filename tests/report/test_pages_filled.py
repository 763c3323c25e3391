"""No page of a report is mostly white but its last, and no box opens a page: measured where the story is laid out."""

from __future__ import annotations

from itertools import product

import pytest

from tests.drawn_library import IDS, drafted, drawn
from tests.each import each
from tests.laws import few
from vecpoly.report.document import markup
from vecpoly.report.flow.blocks import Divider, SheetPage
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.paging.running import run_on
from vecpoly.report.flow.paging.tight import settled
from vecpoly.report.flow.paging.together import first_of
from vecpoly.report.flow.para import Para
from vecpoly.report.flow.results.box import AnswerBox
from vecpoly.report.flow.xml import to_flowables
from vecpoly.solution import Solution
from vecpoly.words import Lang

FULL = 0.84  # of a page of text: what is less is a blank foot
HALF = 0.5
LAST = 0.3  # of the last one
SHORT = (  # texts that ended on a page of little before their sheets
    *("3-1a", "3-1b", "3-1e", "7-6", "8-5", "8-16", "D-3", "D-3-knife", "motor-run-up", "press-flywheel"),
    *("train-differential", "parallelogram-locomotive", "planetary-sun-drives", "stepped-planet"),
    *("compound-hinge-six-bar", "whitworth-quick-return", "3-9"),
)
NAMES = tuple(dict.fromkeys((*few(SHORT, 4), *few(IDS, 60))))
META = Metadata(title="t", subject="t", keywords=(), lang="zh")


def laid_out(solutions: list[Solution], lang: Lang) -> ReportDoc:
    """The report of these solutions on its pages."""
    document, objects = markup(solutions, lang, "solution", {}, None, None)
    return settled(to_flowables(document, objects.named, lang), META)


def sparse(doc: ReportDoc, enough: float = FULL) -> list[int]:
    """Pages of text that hold little, but for the last page of all."""
    ends_in_text = not isinstance(doc.heads[max(doc.heads)], SheetPage)
    told = doc.filled[:-1] if ends_in_text else doc.filled
    return [number for number, full in enumerate(told, start=1) if full < enough]


@each(NAMES)
def test_only_the_last_page_of_a_report_has_a_blank_foot(name: str) -> None:
    lang: Lang = "zh" if name in SHORT or len(name) % 2 else "en"
    solution = drafted(name)  # as it is printed: an exact hand has no deviations to check
    if solution is not None:
        doc = laid_out([solution], lang)
        assert not sparse(doc) and not doc.widows and doc.filled[-1] > LAST


@pytest.mark.parametrize(("name", "lang"), few([*product(("motor-run-up", "tipper"), ("zh", "en"))], 3))
def test_no_box_of_answers_is_parted_from_the_last_step(name: str, lang: Lang) -> None:
    doc = laid_out([drawn(name).solution], lang)
    opened = [first_of(head) for head in doc.heads.values()]
    assert not any(isinstance(head, AnswerBox) and not head.parted for head in opened)
    held = [item for item in doc.story if isinstance(item, AnswerBox)]
    assert len(held) == 1


def test_a_problem_begins_on_the_page_on_which_another_ends_early() -> None:
    doc = laid_out([drawn(name).solution for name in ("3-1a", "8-5", "3-1e", "3-4a")], "zh")
    assert len(doc.filled) > 4 and not sparse(doc, 0.8)


def text(lines: int) -> list[Para]:
    """So many paragraphs of one line."""
    return [Para(f"{n}", lang="en") for n in range(lines)]


def sheet() -> SheetPage:
    return SheetPage(lambda canvas, x, y: None, title="s")


def test_a_sheet_stands_before_the_page_that_holds_little_of_the_text_before_it() -> None:
    plain = ReportDoc([*text(45), sheet()], META)
    plain.counted()
    assert len(plain.filled) == 2 and plain.filled[1] < HALF and sparse(plain, HALF) == [2]
    moved, _ = run_on(plain.story, plain)
    assert isinstance(moved[1], SheetPage) and moved[1].behind == 1
    after = ReportDoc(moved, META)
    assert after.counted() == 3 and isinstance(after.heads[2], SheetPage) and not sparse(after, HALF)


def test_a_text_that_fills_its_pages_keeps_its_sheet_behind_it() -> None:
    doc = ReportDoc([*text(25), sheet()], META)
    doc.counted()
    assert doc.filled[0] > HALF and run_on(doc.story, doc)[0] == doc.story


def test_a_sheet_that_waits_for_more_pages_than_the_text_has_stands_at_its_end() -> None:
    late = sheet()
    late.behind = 5
    doc = ReportDoc([late, *text(10)], META)
    assert doc.counted() == 2 and isinstance(doc.heads[2], SheetPage)


def test_nothing_but_a_rule_parts_two_problems_of_one_page() -> None:
    one = laid_out([drawn(name).solution for name in ("3-1e", "8-5")], "zh")
    kinds = [type(item) for item in one.story]
    assert kinds.count(Divider) == 1


def test_behind_a_cover_too_it_is_the_text_with_little_that_shares_its_page() -> None:
    cover, first, second = sheet(), sheet(), sheet()
    doc = ReportDoc([cover, *text(45), first, *text(25), second], META)
    doc.counted()
    assert sparse(doc, HALF) == [2]
    moved, after = run_on(doc.story, doc)
    sheets = [item for item in moved if isinstance(item, SheetPage)]
    assert [item.behind for item in sheets] == [0, 1, 0] and moved[2] is sheets[1]
    assert moved[-1] is second and not sparse(after, HALF)


@pytest.mark.parametrize(("name", "lang"), few([("3-14", "en"), ("3-14", "zh"), ("4-3a", "en")], 3))
def test_no_page_within_a_course_report_is_a_fifth_white(name: str, lang: Lang) -> None:
    """A figure that has no room waits for the next page, and the text runs on."""
    document, objects = markup([drawn(name).solution], lang, "course", {}, None, None)
    filled = settled(to_flowables(document, objects.named, lang), META).filled
    assert len(filled) > 8 and min(filled[1:-1]) > 0.8
