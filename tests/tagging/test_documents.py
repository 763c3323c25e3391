"""Claims about every kind of document that is printed: it can be read aloud, from the first word to the last."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from itertools import groupby
from pathlib import Path
from typing import Any

import pikepdf
import pytest
from pdfua import validate

from tests.each import each
from tests.laws import few
from tests.marked.classes import NUMBERS, answers, graded, register, wide
from tests.projects import printed as project
from tests.studies import course_report, solved
from tests.tagging.document_read import ARTIFACT, Piece, Read, kids
from vecpoly.batch.codes import sheet_id
from vecpoly.batch.sheet.compose import composed
from vecpoly.batch.sheet.write import sheet_bytes
from vecpoly.batch.student import Student
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.report.document import report_bytes
from vecpoly.variants.seeds import Seed


def class_sheet() -> bytes:
    """The sheet of a student who has 3-9 as it stands."""
    one = register().sheets[0]
    pages = composed(
        [(solved("3-9"), one.parts[0].key, Seed(assignment="hw", problem="3-9", student=NUMBERS[0]))], "zh"
    )
    sheet = sheet_id("hw", "", NUMBERS[0])
    who = Student(number=NUMBERS[0], name="张三", team="")
    return sheet_bytes(pages, title="作业", assignment="hw", sheet=sheet, student=who, lang="zh")


def drawn() -> bytes:
    made = sheets(solved("3-9").construction, lang="en")
    return to_pdf(*(one.scene for one in made), title="3-9")


@cache
def feedback() -> bytes:
    folder = Path(MADE.mktemp("feedback"))
    rows = {number: answers(number) for number in NUMBERS[:2]}
    graded(folder / "out", wide(folder / "a.csv", rows), feedback=True)
    return next((folder / "out" / "feedback").iterdir()).read_bytes()


MADE: pytest.TempPathFactory
KINDS: dict[str, Callable[[], bytes]] = {
    "solution 3-9": lambda: report_bytes([solved("3-9")], lang="zh"),
    "solution 4-3a": lambda: report_bytes([solved("4-3a")], lang="en", fields={"Name": "Chen Zhe"}),
    "solutions": lambda: report_bytes([solved("5-5"), solved("2-6"), solved("8-5")], lang="en"),
    "question": lambda: report_bytes([solved("3-5"), solved("7-3"), solved("6-3a")], lang="zh", style="question"),
    "course": lambda: course_report("A-27", "zh"),
    "project": lambda: project("design-feeder", "en"),
    "class sheet": class_sheet,
    "feedback": feedback,
    "drawing": drawn,
}


@cache
def data(kind: str) -> bytes:
    return KINDS[kind]()


@cache
def read(kind: str) -> Read:
    return Read(data(kind))


@pytest.fixture(scope="module", autouse=True)
def made(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    global MADE
    MADE = tmp_path_factory
    yield


@each(few(tuple(KINDS), 2))
def test_nothing_is_on_a_page_that_is_neither_told_nor_an_artifact(kind: str) -> None:
    it = read(kind)
    for page in range(len(it.pdf.pages)):
        assert "nothing" not in it.painted(page), f"page {page + 1}"


@each(KINDS)
def test_what_is_drawn_first_is_read_first_and_everything_once(kind: str) -> None:
    """A figure at the head of a page, or a sheet, may part a list: it is read behind that, in one piece."""
    it = read(kind)
    told = it.told
    floats = {piece for figure in it.of("Figure") for piece in _below(it, figure)}
    sheets = {page for page in range(len(it.pdf.pages)) if it.is_sheet(page)}
    for page in range(len(it.pdf.pages)):
        marked = list(dict.fromkeys(where for where in it.painted(page) if where != ARTIFACT))
        whole = [piece.number for piece in told if piece.page == page]
        numbers = (
            whole if page in sheets else [piece.number for piece in told if piece.page == page and piece not in floats]
        )
        assert numbers == sorted(set(numbers)) and set(marked) <= set(whole), f"page {page + 1}"
    text = [piece for piece in told if piece not in floats and piece.page not in sheets]
    assert len(told) == len(set(told)) and text == sorted(text, key=lambda piece: piece.page)
    turns = [page for page, _ in groupby(piece.page for piece in told if piece.page in sheets)]
    assert turns == sorted(set(turns)), "each sheet is told at once, and sheets in their order"


def _below(it: Read, element: Any) -> Iterator[Piece]:
    """The pieces of an element and of all in it."""
    yield from it.own(element)
    for kid in kids(element):
        if isinstance(kid, pikepdf.Dictionary) and "/S" in kid:
            yield from _below(it, kid)


@each(KINDS)
def test_marked_content_leads_back_to_the_element_that_holds_it(kind: str) -> None:
    it = read(kind)
    parents = it.parents()
    held = {}
    for element in it.elements:
        for piece in it.own(element):
            page = it.pdf.pages[piece.page]
            held[piece] = parents[int(page.obj.StructParents)][piece.number].objgen == element.objgen
    pages = [value for value in parents.values() if isinstance(value, pikepdf.Array)]
    assert all(held.values()) and len(held) == sum(map(len, pages))


@each(KINDS)
def test_every_figure_and_formula_has_words_in_its_place(kind: str) -> None:
    it = read(kind)
    wordless = [
        one for role in ("Figure", "Formula") for one in it.of(role) if len(str(one.get("/Alt", "")).strip()) < 1
    ]
    assert not wordless and (it.of("Figure") or it.of("Formula"))
    assert all("$" not in str(one.get("/Alt", "")) for one in it.elements)


@each(KINDS)
def test_headings_go_down_one_level_at_a_time(kind: str) -> None:
    levels = [int(str(one.S)[2:]) for one in read(kind).elements if str(one.S) in ("/H1", "/H2", "/H3")]
    assert all(b <= a + 1 for a, b in zip([0, *levels], levels, strict=False))
    assert levels or kind == "drawing"


@each(KINDS)
def test_rows_of_a_table_have_as_many_cells_as_its_heading(kind: str) -> None:
    for table in read(kind).of("Table"):
        rows = [row for row in table.K if row.S == "/TR"]
        wide = {len(row.get("/K", [])) for row in rows}
        assert len(wide) == 1 or kind == "title block of the last row"
        assert all("/A" in cell for row in rows for cell in row.K if cell.S == "/TH")


@each(KINDS)
def test_links_say_where_they_lead_and_belong_to_an_element(kind: str) -> None:
    it = read(kind)
    parents = it.parents()
    notes = [note for page in it.pdf.pages for note in page.get("/Annots", [])]
    for note in notes:
        assert str(note.Contents) and parents[int(note.StructParent)].S == "/Link"
        assert note.Dest[0].objgen in it.numbers
    assert notes or kind not in ("course", "project")


@each(KINDS)
def test_the_file_says_what_it_is_and_prints_at_its_true_size(kind: str) -> None:
    root = read(kind).pdf.Root
    assert root.MarkInfo.Marked and root.ViewerPreferences.DisplayDocTitle
    assert root.ViewerPreferences.PrintScaling == "/None" and str(root.Lang) in ("zh-CN", "en-GB")
    xmp = read(kind).pdf.open_metadata()
    assert xmp["pdfuaid:part"] == "1" and xmp["dc:title"] == str(read(kind).pdf.docinfo["/Title"]) != ""
    assert all(page.obj.Tabs == "/S" for page in read(kind).pdf.pages)


@each(few(tuple(KINDS), 2))
def test_a_checker_of_pdf_ua_finds_nothing_and_qpdf_no_fault(kind: str, tmp_path: Path) -> None:
    (file := tmp_path / "a.pdf").write_bytes(data(kind))
    assert [(one.rule_id, one.message) for one in validate(str(file)).findings] == []
    assert read(kind).pdf.check_pdf_syntax() == []
