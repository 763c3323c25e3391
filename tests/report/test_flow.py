"""Claims about pages."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pdfplumber
import pytest
from pypdf import PdfReader
from reportlab.platypus.flowables import Spacer

from tests.laws import few
from tests.texts import ZH, equation
from vecpoly.report.flow import (
    Callout,
    DataTable,
    Drawing,
    EquationFlow,
    Heading,
    Metadata,
    Para,
    ReportDoc,
    SheetPage,
    TitleBlock,
)
from vecpoly.typeset.box import MM


def write(tmp_path: Path, story: list[Any], name: str = "a.pdf") -> Path:
    return ReportDoc(story, Metadata(title="作业", author="陈喆")).write(tmp_path / name).path


def pages(path: Path) -> list[str]:
    with pdfplumber.open(path) as pdf:
        return [page.extract_text() or "" for page in pdf.pages]


def squeezed(text: str) -> str:
    return re.sub(r"\s", "", text)


def test_chinese_text_comes_out_as_it_went_in(tmp_path: Path) -> None:
    plain = re.sub(r"[*$]", "", re.sub(r"\$[^$]*\$", "", ZH))
    (page,) = pages(write(tmp_path, [Para(re.sub(r"\$[^$]*\$", "", ZH))]))
    assert squeezed(plain) in squeezed(page)


def test_formulas_are_extracted_in_place(tmp_path: Path) -> None:
    path = write(tmp_path, [Para("由极点 $pb$ 作线，过 $bc$ 作线。")])
    with pdfplumber.open(path) as pdf:
        drawn = "".join(char["text"] for char in pdf.pages[0].chars)
    assert "由极点pb作线，过bc作线。" in squeezed(drawn)


def test_english_words_keep_their_spaces(tmp_path: Path) -> None:
    text = "The crank turns counter-clockwise and drives the coupler of the four-bar linkage. " * 3
    (page,) = pages(write(tmp_path, [Para(text, None, "en")]))
    assert " ".join(text.split()) in " ".join(page.split())


def test_all_fonts_are_embedded(tmp_path: Path) -> None:
    sheet = SheetPage(lambda c, x, y: None)
    path = write(tmp_path, [Heading("题"), Para(ZH), EquationFlow(equation()), sheet])
    data = path.read_bytes()
    used = [font for page in PdfReader(path).pages for font in page["/Resources"]["/Font"].values()]
    assert len(used) > 3 and all("/FontFile2" in font.get_object()["/FontDescriptor"] for font in used)
    assert data.startswith(b"%PDF-1.7")
    assert b"ASCII85" not in data


def test_the_same_story_gives_the_same_bytes(tmp_path: Path) -> None:
    first, second = (write(tmp_path, [Para(ZH), EquationFlow(equation())], f"{i}.pdf") for i in range(2))
    assert first.read_bytes() == second.read_bytes()


def test_a_failed_document_leaves_nothing_behind(tmp_path: Path) -> None:
    def fail(*_: object) -> None:
        raise RuntimeError("no")

    with pytest.raises(RuntimeError):
        write(tmp_path, [SheetPage(fail)])
    assert not list(tmp_path.iterdir())


def test_a_character_without_glyph_is_reported_and_seen(tmp_path: Path) -> None:
    written = ReportDoc([Para("字\U0001f9ff。")], Metadata(title="t")).write(tmp_path / "a.pdf")
    assert written.missing == ("\U0001f9ff",)
    assert "[U+1F9FF]" in pages(written.path)[0]


def test_a_paragraph_splits_over_pages_without_loss(tmp_path: Path) -> None:
    text = re.sub(r"[*$]", "", re.sub(r"\$[^$]*\$", "", ZH)) * 25
    found = pages(write(tmp_path, [Para(text)]))
    assert len(found) == 2
    body = "".join(squeezed(page)[2 * bool(n) : -3] for n, page in enumerate(found))  # the head begins on page 2
    assert body == squeezed(text)


def test_the_equation_has_its_captions_in_the_readers_language(tmp_path: Path) -> None:
    (page,) = pages(write(tmp_path, [EquationFlow(equation()), EquationFlow(equation(), "en")]))
    for caption in ("方向", "大小", "Direction", "Magnitude"):
        assert caption in page


def test_the_table_repeats_its_header_on_every_page(tmp_path: Path) -> None:
    rows = [(str(i), f"$v_{i}$") for i in range(100)]
    table = DataTable(("序号", "数值"), rows, None, "cr", caption="表 1")
    found = pages(write(tmp_path, [Para(ZH), table]))
    assert len(found) >= 3
    assert all("序号" in page for page in found)
    assert ["表1" in page.replace(" ", "") for page in found] == [True] + [False] * (len(found) - 1)
    assert ["续表" in page for page in found] == [False] + [True] * (len(found) - 1), "what goes on says so"


@pytest.mark.parametrize("room", few(range(180, 240, 4), 5))
@pytest.mark.parametrize("whole", [False, True])
def test_a_table_begun_anywhere_on_a_page_keeps_all_rows_in_order(tmp_path: Path, room: int, whole: bool) -> None:
    table = DataTable(["$φ$", "ω"], [[f"r{i}", "1.0"] for i in range(33)], lang="en")
    table.whole = whole
    text = "".join(pages(write(tmp_path, [Para("first", lang="en"), Spacer(1, room), table, Para("end", lang="en")])))
    assert re.findall(r"r(\d+)", text) == [str(i) for i in range(33)]


def test_headings_and_sheets_are_in_the_outline(tmp_path: Path) -> None:
    sheet = SheetPage(lambda c, x, y: None, wide=True, title="图纸")
    path = write(tmp_path, [Heading("报告", 1), Heading("速度 $v_C$", 2), Para(ZH), sheet, Heading("末", 3)])
    with pdfplumber.open(path) as pdf:
        titles = [title for _, title, *_ in pdf.doc.get_outlines()]
    assert titles == ["报告", "速度 v_C", "图纸", "末"]


def test_a_sheet_takes_a_whole_page_in_true_millimetres(tmp_path: Path) -> None:
    def line(canvas: Any, x: float, y: float) -> None:
        canvas.line(x + 10 * MM, y + 20 * MM, x + 110 * MM, y + 20 * MM)

    path = write(tmp_path, [Para(ZH), SheetPage(line), SheetPage(line, wide=True), Para("完")])
    with pdfplumber.open(path) as pdf:
        assert [round(p.width / MM) for p in pdf.pages] == [210, 210, 297, 210]
        for page in pdf.pages[1:3]:
            (found,) = page.lines
            assert found["x0"] == pytest.approx(10 * MM, abs=1e-3)
            assert found["x1"] - found["x0"] == pytest.approx(100 * MM, abs=1e-3)
        assert "完" in (pdf.pages[3].extract_text() or "")


def test_every_text_page_tells_its_number_and_the_total(tmp_path: Path) -> None:
    found = pages(write(tmp_path, [Para(ZH * 30)]))
    for i, page in enumerate(found, 1):
        assert page.splitlines()[-1] == f"{i} / {len(found)}"


def test_a_drawing_is_not_scaled(tmp_path: Path) -> None:
    path = write(tmp_path, [Drawing(60, 40, lambda c, x, y: c.rect(x, y, 60 * MM, 40 * MM), "alt", "图 1")])
    with pdfplumber.open(path) as pdf:
        box = pdf.pages[0].rects[-1]
    assert box["width"] == pytest.approx(60 * MM, abs=1e-3)


def test_title_block_and_callout_keep_their_words(tmp_path: Path) -> None:
    story = [TitleBlock([("班级", "机械1班"), ("姓名", "陈喆")]), Callout("在允许范围之内。", "pass")]
    (page,) = pages(write(tmp_path, story))
    for word in ("班级", "机械1班", "陈喆", "在允许范围之内。"):
        assert word in squeezed(page)
