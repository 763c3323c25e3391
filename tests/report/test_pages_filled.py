"""No page of a report is mostly white but one with which a text ends, and no box opens a page: measured where the story
is laid out."""

from __future__ import annotations

from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.laws import few
from vecpoly.report.document import markup
from vecpoly.report.flow.blocks import Divider, SheetPage
from vecpoly.report.flow.doc import Metadata, ReportDoc
from vecpoly.report.flow.paging.running import run_on
from vecpoly.report.flow.paging.tight import settled
from vecpoly.report.flow.para import Para
from vecpoly.report.flow.xml import to_flowables
from vecpoly.solution import Solution
from vecpoly.words import Lang

FULL = 0.4  # of a page of text
SHORT = (  # texts that ended on a page of little before their sheets
    *("3-1a", "3-1b", "3-1e", "7-6", "8-5", "8-16", "D-3", "D-3-knife", "motor-run-up", "press-flywheel"),
    *("train-differential", "parallelogram-locomotive", "planetary-sun-drives", "stepped-planet"),
    *("compound-hinge-six-bar", "whitworth-quick-return", "3-9"),
)
NAMES = tuple(dict.fromkeys((*SHORT, *few(IDS, 30))))
META = Metadata(title="t", subject="t", keywords=(), lang="zh")


def laid_out(solutions: list[Solution], lang: Lang) -> ReportDoc:
    """The report of these solutions on its pages."""
    document, objects = markup(solutions, lang, "solution", {}, None, None)
    doc = ReportDoc(settled(to_flowables(document, objects.named, lang), META), META)
    doc.counted()
    return doc


def sparse(doc: ReportDoc) -> list[int]:
    """Pages of text that hold little, but for the last of all and those before a sheet."""
    text = [page for page in sorted(doc.heads) if not isinstance(doc.heads[page], SheetPage)]
    ends = {page for page in text if isinstance(doc.heads.get(page + 1), SheetPage | None)}
    return [page for page, full in zip(text, doc.filled, strict=True) if full < FULL and page not in ends]


@each(NAMES)
def test_only_a_page_with_which_a_text_ends_may_be_mostly_white(name: str) -> None:
    lang: Lang = "zh" if name in SHORT or len(name) % 2 else "en"
    doc = laid_out([drawn(name).solution], lang)
    assert not sparse(doc) and not doc.widows and not doc.parted


def test_a_problem_begins_on_the_page_on_which_another_ends_early() -> None:
    doc = laid_out([drawn(name).solution for name in ("3-1a", "8-5", "3-1e", "3-4a")], "zh")
    assert len(doc.filled) > 4 and not sparse(doc)


def text(lines: int) -> list[Para]:
    """So many paragraphs of one line."""
    return [Para(f"{n}", lang="en") for n in range(lines)]


def sheet() -> SheetPage:
    return SheetPage(lambda canvas, x, y: None, title="s")


def test_a_text_that_fills_its_pages_keeps_its_sheet_behind_it() -> None:
    doc = ReportDoc([*text(25), sheet()], META)
    doc.counted()
    assert doc.filled[0] > FULL and run_on(doc.story, doc)[0] == doc.story


def test_nothing_but_a_rule_parts_two_problems_of_one_page() -> None:
    one = laid_out([drawn(name).solution for name in ("7-6", "8-5")], "zh")
    kinds = [type(item) for item in one.story]
    assert kinds.count(Divider) == 1
