"""The printed page, read back by other programs: OpenCV finds the tags, ZXing reads the codes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from io import BytesIO
from typing import Any

import cv2
import numpy as np
import pdfplumber
import pypdfium2
import pytest
import zxingcpp
from pypdf import PdfReader
from reportlab.pdfgen.canvas import Canvas

from tests.variants.block import given
from vecpoly.batch.codes import page_code, sheet_id
from vecpoly.batch.sheet.compose import Composed, composed, layout_of
from vecpoly.batch.sheet.layout import HEIGHT, TAG, corners_of_tags
from vecpoly.batch.sheet.text import Placed, text_pages
from vecpoly.batch.sheet.write import sheet_bytes
from vecpoly.batch.student import Student
from vecpoly.board.paper.extent import extent
from vecpoly.problem.load import load
from vecpoly.report.question.working import Squares
from vecpoly.solution import solve
from vecpoly.typeset.box import MM
from vecpoly.variants.frames import JITTER, beside_sheet
from vecpoly.words import Lang

DPI = 200
PX = DPI / 25.4  # of a millimetre
WHO = Student(number="20230001", name="王小明", team="机械 1 班")
SHEET = sheet_id("hw3", "", WHO.number)


@cache
def pages(student: str = "20230000") -> tuple[Composed, ...]:
    one = given(student)
    return composed([(solve(one.problem), one.key, one.seed)], "zh")


@cache
def pdf(lang: Lang = "zh") -> bytes:
    return sheet_bytes(pages(), title="第三次作业", assignment="hw3", sheet=SHEET, student=WHO, lang=lang)


@cache
def image(number: int) -> Any:
    rendered = pypdfium2.PdfDocument(pdf())[number].render(scale=DPI / 72).to_numpy()
    return cv2.cvtColor(rendered, cv2.COLOR_BGR2GRAY)


def test_eight_tags_tell_the_page_and_stand_where_the_layout_says() -> None:
    detector = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_APRILTAG_36h11))
    assert len(pages()) >= 3
    for n, one in enumerate(pages()):
        corners, ids, _ = detector.detectMarkers(image(n))
        found = dict(zip(ids.ravel().tolist(), corners, strict=True))
        assert set(found) == set(one.page.tags)
        for tag, (x, y) in zip(one.page.tags, corners_of_tags(), strict=True):
            upper_left = found[tag][0][0] / PX  # upright: the first corner is the upper left
            assert upper_left == pytest.approx((x, HEIGHT - y - TAG), abs=0.25)


def test_no_two_pages_share_a_tag() -> None:
    ids = [tag for one in pages() for tag in one.page.tags]
    assert len(set(ids)) == len(ids)


def test_the_code_is_read_twice_on_every_page_and_has_no_name_in_it() -> None:
    for n, one in enumerate(pages()):
        texts = [found.text for found in zxingcpp.read_barcodes(image(n), formats=zxingcpp.BarcodeFormat.QRCode)]
        assert texts == [page_code("hw3", SHEET, one.page.number, layout_of(pages()).hash)] * 2
        assert WHO.number not in texts[0] and WHO.name not in texts[0]


def test_the_code_stands_in_letters_too() -> None:
    with pdfplumber.open(BytesIO(pdf())) as document:
        for n, page in enumerate(document.pages):
            assert (page.extract_text() or "").count("VP1-") == 2, n


def test_a_frame_has_one_size_and_nothing_but_ticks_and_a_pole_in_pale_blue() -> None:
    drawn = [one for one in pages() if one.page.frame is not None]
    assert len(drawn) == 3
    with pdfplumber.open(BytesIO(pdf())) as document:
        for one in drawn:
            frame = one.page.frame
            assert frame is not None and frame.size == (160.0, 150.0)
            page = document.pages[one.page.number - 1]
            (x, y), (wide, high) = frame.at, frame.size
            box = tuple(v * 72 / 25.4 for v in (x + 0.5, HEIGHT - y - high + 0.5, x + wide - 0.5, HEIGHT - y - 0.5))
            inside = page.crop(box)
            assert "".join(char["text"] for char in inside.chars).strip() in ("", "p", "p′")
            colours = {tuple(round(c, 2) for c in item["stroking_color"]) for item in inside.lines}
            assert colours == {(0.65, 0.8, 0.92)}


def test_the_pole_is_seeded_and_near_the_middle() -> None:
    poles = [
        one.page.frame.pole
        for who in ("20230000", "20230001", "20230002")
        for one in pages(who)
        if one.page.frame and one.page.frame.pole
    ]
    assert len(set(poles)) == len(poles) == 6
    assert all(abs(x - 105.0) <= JITTER and abs(y - (254.0 - 75.0)) <= JITTER for x, y in poles)


def test_the_sheet_tells_no_answer() -> None:
    """No exact value to three figures, and no length on paper, stands anywhere in its text."""
    with pdfplumber.open(BytesIO(pdf())) as document:
        text = " ".join(page.extract_text() or "" for page in document.pages)
    for one in given("20230000").key.quantities:
        if one.asked and one.exact:
            assert f"{abs(one.exact):.3g}" not in text.split()
            assert one.mm is None or f"{one.mm:.1f}" not in text.split()


def test_the_same_sheet_has_the_same_bytes_and_a_layout_of_its_own() -> None:
    again = sheet_bytes(pages(), title="第三次作业", assignment="hw3", sheet=SHEET, student=WHO, lang="zh")
    assert again == pdf()
    assert layout_of(pages()).hash != layout_of(pages("20230001")).hash


def test_nothing_is_drawn_over_the_white_round_a_tag() -> None:
    for n, _ in enumerate(pages()):
        page = image(n)
        for x, y in corners_of_tags():
            left, top, side = (round(v * PX) for v in (x - 1.5, HEIGHT - y - TAG - 1.5, TAG + 3.0))
            ring = page[top : top + side, left : left + side].copy()
            edge = round(1.2 * PX)
            ring[edge:-edge, edge:-edge] = 255
            assert int(np.min(ring)) > 200


@pytest.mark.parametrize(("lang", "said"), [("zh", "画在下面计算过程的方格中"), ("en", "on the squares below")])
def test_a_diagram_too_large_for_a_frame_is_told_where_to_draw_and_has_the_room_there(lang: Lang, said: str) -> None:
    """The displacement of a cam is 162 mm wide; its scales stood on the sheet, and no frame for it."""
    solution = solve(load("cam-flat-face"), by="exact", repeats=0, precise=False)
    (beside,) = beside_sheet(solution.construction.figures)
    text = text_pages(solution, lang)
    printed = PdfReader(BytesIO(_printed(text))).pages[0].extract_text()
    assert said in "".join(printed.split("\n")) and beside.title.of(lang).split(" $")[0] in printed
    squares = [one.block.height / MM for page in text for one in page if isinstance(one.block, Squares)]
    assert max(squares) > extent(beside.marks)[1]


def _printed(pages: Sequence[Sequence[Placed]]) -> bytes:
    out = BytesIO()
    canvas = Canvas(out)
    for page in pages:
        for one in page:
            one.draw(canvas)
        canvas.showPage()
    canvas.save()
    return out.getvalue()
