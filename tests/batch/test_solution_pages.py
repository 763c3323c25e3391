"""Every page of a printed solution tells whose it is, the drawing sheets too."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from typing import Any

import pypdfium2
import pytest
import zxingcpp

from tests.marked.classes import register
from vecpoly import solve
from vecpoly.batch.solved import solution_bytes
from vecpoly.words import Lang

DPI = 150


@cache
def pages(lang: Lang) -> tuple[Any, ...]:
    """A student's solution as a printer's neighbour scans it."""
    sheet = register().sheets[0]
    solutions = [solve(register().variant(part), precise=False) for part in sheet.parts]
    document = pypdfium2.PdfDocument(solution_bytes(solutions, replace(register(), lang=lang), sheet))
    return tuple(page.render(scale=DPI / 72).to_numpy() for page in document)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_the_code_is_read_on_every_page_of_a_solution(lang: Lang) -> None:
    read = [[found.text for found in zxingcpp.read_barcodes(page)] for page in pages(lang)]
    assert len(read) >= 3 and all(len(texts) == 1 for texts in read)
    assert len({texts[0] for texts in read}) == 1 and register().sheets[0].sheet in read[0][0]
