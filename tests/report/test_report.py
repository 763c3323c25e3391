"""The report as a person gets it: text, fonts, lines true to scale, pages that are whole, the same bytes twice."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

import pdfplumber
import pypdfium2
import pytest
from pypdf import PdfReader
from pypdf.generic import DictionaryObject

from tests.laws import few
from vecpoly.board.construction import Construction, Figure, View
from vecpoly.board.paper.marks import Role, Vector
from vecpoly.drawing.beside import beside
from vecpoly.drawing.details.apart import is_detail
from vecpoly.drawing.legend.on_sheet import with_legend
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.drawing.sheets.space import FRAME
from vecpoly.errors import UnknownNameError
from vecpoly.problem.library import library
from vecpoly.problem.load import load
from vecpoly.report.document import write_report
from vecpoly.solution import Solution, solve
from vecpoly.words import Lang

MM = 72 / 25.4


@pytest.fixture(scope="module")
def solution() -> Solution:
    return solve(load("3-9"))


@pytest.fixture(scope="module")
def chinese(solution: Solution, tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_report(
        [solution], tmp_path_factory.mktemp("report") / "3-9.zh.pdf", lang="zh", fields={"班级": "机械 21"}
    )


def test_chinese_text_can_be_selected(chinese: Path) -> None:
    with pdfplumber.open(chinese) as document:
        text = "".join(page.extract_text() for page in document.pages).replace(" ", "")
    for words in ("摇块机构", "速度多边形", "加速度影像", "哥氏加速度", "班级", "机械21", "原书答案"):
        assert words in text, words


def test_every_font_is_embedded(chinese: Path) -> None:
    for page in PdfReader(chinese).pages:
        for font in cast("DictionaryObject", page["/Resources"]).get("/Font", {}).values():
            descriptor = font.get_object().get("/FontDescriptor")
            assert descriptor is not None and "/FontFile2" in descriptor.get_object()


def test_the_same_report_is_the_same_bytes(solution: Solution, chinese: Path, tmp_path: Path) -> None:
    again = write_report([solve(load("3-9"))], tmp_path / "again.pdf", lang="zh", fields={"班级": "机械 21"})
    assert again.read_bytes() == chinese.read_bytes()


def test_the_document_has_bookmarks_and_metadata(chinese: Path) -> None:
    reader = PdfReader(chinese)
    titles = re.sub(r"\s", "", str([o.title for o in _flat(reader.outline)]))
    assert "速度分析" in titles and "图纸" in titles
    assert reader.metadata is not None and "3-9" in (reader.metadata.title or "")


def _flat(outline: list[Any]) -> Iterator[Any]:
    for item in outline:
        if isinstance(item, list):
            yield from _flat(item)
        else:
            yield item


def _figure(construction: Construction, view: View) -> Figure:
    figure = construction.figure(view)
    assert figure is not None
    return figure


def _vectors(figure: Figure) -> list[Vector]:
    """Those of the results, as they are inked where several lie on one line."""
    return [m for m in beside(figure.view, figure.marks) if isinstance(m, Vector) and m.role is Role.RESULT]


def _ink(page: Any) -> list[Any]:
    """The strokes of a page."""
    return [*page.lines, *page.curves, *(one for one in page.rects if one["stroke"])]


def _drawn_page(document: Any) -> Any:
    """The page with the figures drawn to scale, wherever the text lets it stand."""
    return max(document.pages, key=lambda page: len(_ink(page)))


@pytest.mark.parametrize("name", few(["3-9", "3-5", "3-8"], 3))
def test_result_vectors_measure_on_the_page_what_they_measure_on_the_board(name: str, tmp_path: Path) -> None:
    """Both ends of every result vector lie on the page where the construction has them,
    within 0.01 mm (the tip under its arrowhead), those in a detail where the detail has them; a plate in the text is
    told by the corner of its frame."""
    it = solve(load(name))
    path = write_report([it], tmp_path / "r.pdf")
    (bare,) = sheets(it.construction, title=it.problem.title, plates=True, bands=False)
    sheet = with_legend(bare)
    with pdfplumber.open(path) as document:
        page = _drawn_page(document)
        framed = [one for one in page.rects if one["stroke"]]
        ends = [complex(x, float(page.height) - y) / MM for line in _ink(page) for x, y in line["pts"]]
        frame = max(framed, key=lambda one: one["width"] * one["height"])
        shift = complex(frame["x0"], frame["y0"]) / MM - complex(FRAME, FRAME)
    for placed in sheet.figures:
        if placed.view is View.MECHANISM:
            continue
        assert placed.figure is not None
        figure = _figure(it.construction, placed.view)
        for vector in _vectors(placed.figure if is_detail(placed.name, figure) else figure):
            for z in (vector.a, vector.b):
                assert min(abs(e - shift - placed.origin - z) for e in ends) < 0.01


def test_the_check_bar_is_fifty_millimetres_long(chinese: Path) -> None:
    with pdfplumber.open(chinese) as document:
        lengths = [abs(line["x1"] - line["x0"]) / MM for line in _drawn_page(document).lines]
    assert any(abs(length - 50.0) < 0.01 for length in lengths)


def test_nothing_lies_outside_the_page(chinese: Path) -> None:
    with pdfplumber.open(chinese) as document:
        for page in document.pages:
            for char in page.chars:
                assert (
                    char["x0"] >= 0 and char["x1"] <= page.width and char["top"] >= 0 and char["bottom"] <= page.height
                )


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_no_page_of_text_is_nearly_empty(lang: Lang, tmp_path: Path) -> None:
    chapter = [entry.id for entry in library() if entry.path.parent.name == "ch3"]
    names = few(chapter[lang == "en" :: 2], 3)  # laid out alike in any language
    half = [solve(load(name), repeats=10, precise=False) for name in names]
    path = write_report(half, tmp_path / "r.pdf", lang=lang)
    with pypdfium2.PdfDocument(path) as document:
        assert len(document) > len(half)
        for number, page in enumerate(document, 1):
            assert len(page.get_textpage().get_text_range().splitlines()) >= 6, number


def test_the_question_sheet_gives_no_answer_away(solution: Solution, tmp_path: Path) -> None:
    path = write_report([solution], tmp_path / "q.pdf", lang="en", style="question")
    with pdfplumber.open(path) as document:
        text = "".join(page.extract_text() for page in document.pages)
        labels = {c["text"] for c in document.pages[-1].chars}
    for answer in solution.answers.values():
        if answer.key not in ("v_B", "a_B"):
            assert f"{answer.drawn:.4g}" not in text
    assert "e" not in {w for w in labels if w == "′e"}


def test_an_unknown_style_is_refused_by_name(solution: Solution, tmp_path: Path) -> None:
    with pytest.raises(UnknownNameError, match="solution, question"):
        write_report([solution], tmp_path / "x.pdf", style="poster")
    assert not list(tmp_path.iterdir())


def test_a_lecturer_s_own_template_comes_first(solution: Solution, tmp_path: Path) -> None:
    (tmp_path / "solution.en.xml.j2").write_text(
        '<doc title="t" lang="en"><h1>My own sheet</h1><p>{{ problems[0].asked }}</p></doc>', encoding="utf-8"
    )
    path = write_report([solution], tmp_path / "own.pdf", lang="en", templates=tmp_path)
    with pdfplumber.open(path) as document:
        assert "My own sheet" in document.pages[0].extract_text()
