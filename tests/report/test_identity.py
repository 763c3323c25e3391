"""Every page of a report carries the names of its problems and a code of what they say."""

from __future__ import annotations

import re
from functools import cache
from io import BytesIO

import pdfplumber
import pytest
from pypdf import PdfReader
from pypdfium2 import PdfDocument

from tests.laws import few
from tests.studies import course_report, solved
from tests.texts import CRANK
from vecpoly.problem.load import load, loads
from vecpoly.report import identity as module
from vecpoly.report.document import report_bytes
from vecpoly.report.identity import identity, told
from vecpoly.words import Lang

CODE = re.compile(r"[0-9A-HJKMNP-TV-Z]{4}")


@cache
def feet(data: bytes) -> list[list[str]]:
    """The lines at the left of each page's foot, first that under the text or under the frame of a sheet."""
    with PdfDocument(data) as document:
        strips = [page.get_textpage().get_text_bounded(50, 0, page.get_width() / 2 - 20, 34) for page in document]
        return [[line.strip() for line in strip.splitlines()] for strip in strips]


@cache
def report(name: str, lang: Lang, style: str) -> bytes:
    return course_report(name, lang) if style == "course" else report_bytes([solved(name)], lang=lang, style=style)


STYLES = [(style, lang) for style in ("solution", "question", "course") for lang in ("zh", "en")]


@pytest.mark.parametrize(("style", "lang"), few(STYLES, 2))
def test_every_page_of_text_and_every_sheet_carries_it(style: str, lang: Lang) -> None:
    data = report("3-9", lang, style)
    said = identity([load("3-9")])
    assert CODE.fullmatch(said.removeprefix("3-9 · "))
    assert [foot[0] for foot in feet(data)] == [said] * len(PdfReader(BytesIO(data)).pages)


def test_it_is_told_among_the_key_words_of_the_file() -> None:
    info = PdfReader(BytesIO(report("3-9", "en", "solution"))).metadata
    assert info is not None and identity([load("3-9")]) in str(info["/Keywords"])


def test_a_page_that_is_stamped_for_a_student_does_not_carry_it_too() -> None:
    data = report_bytes([solved("3-9")], stamp=lambda canvas, sheet: None)
    assert not any(CODE.search(line.rpartition(" · ")[2]) for foot in feet(data) for line in foot if " · " in line)
    info = PdfReader(BytesIO(data)).metadata
    assert info is not None and " · " not in str(info["/Keywords"])


def test_other_numbers_another_name_or_another_version_give_another_code(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = (CRANK, CRANK.replace("AB: 30 mm", "AB: 31 mm"), CRANK.replace("id: t", "id: u"))
    codes = [identity([loads(text)]).rpartition(" ")[2] for text in texts]
    assert len({*codes}) == 3 and identity([loads(CRANK)]) == identity([loads(CRANK)])
    monkeypatch.setattr(module, "__version__", "0.0.0")
    assert identity([loads(CRANK)]).rpartition(" ")[2] not in codes


def test_many_problems_are_told_by_the_first_and_the_last_and_a_long_name_is_cut() -> None:
    assert told(["6-1", "6-2", "6-3", "6-4"], "abcd").startswith("6-1 … 6-4 · ")
    assert told(["6-1", "6-2"], "ab").startswith("6-1, 6-2 · ")
    cut = told(["x" * 200], "a")
    assert len(cut) < 60 and "… · " in cut


def test_a_cover_bears_no_number_and_the_page_behind_it_is_the_second() -> None:
    data = report("3-9", "zh", "course")
    count = len(PdfReader(BytesIO(data)).pages)
    with pdfplumber.open(BytesIO(data), pages=[1, 2]) as document:
        last = [page.extract_text().splitlines()[-1] for page in document.pages]
    assert f"/ {count}" not in last[0] and f"2 / {count}" in last[1]
