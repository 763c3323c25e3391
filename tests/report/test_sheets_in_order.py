"""Sheets are met in the order of their numbers, plates in the text and pages of their own alike."""

from __future__ import annotations

import re
from io import BytesIO

import pdfplumber

from tests.drawn_library import LIBRARY
from tests.each import each
from tests.laws import few
from vecpoly.problem.load import load
from vecpoly.report.document import report_bytes
from vecpoly.solution import solve

NUMBER = re.compile(r"Sheet (\d) of \d")


@each(["3-12", *few(LIBRARY, 30)])
def test_no_sheet_is_met_before_one_of_a_smaller_number(name: str) -> None:
    """The polygons of 3-12 stood before the diagram, and the page before them had white for a plate."""
    data = report_bytes([solve(load(name), repeats=20)], lang="en")
    with pdfplumber.open(BytesIO(data)) as document:
        met = [int(number) for page in document.pages for number in NUMBER.findall(page.extract_text())]
    assert met == sorted(met)
