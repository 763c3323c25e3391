"""PDF with vectors: lines and outlines of its pages at 1 pt = 25.4/72 mm, and its words."""

from __future__ import annotations

import io
import re
import zlib
from base64 import a85decode
from collections.abc import Sequence
from typing import Any

from ....errors import FaultError
from ....limits import DRAWING_PAGES, DRAWING_UNPACKED
from ....words import Words
from ..segment import Drawing, Label, Segment
from .found import Found, is_straight
from .refuse import reading, too_large_unpacked

MM = 25.4 / 72
APART = 1_000.0  # mm between pages
_STREAM = re.compile(rb"stream\r?\n")
_TWICE = re.compile(rb"/(?:FlateDecode|Fl)\s*/(?:FlateDecode|Fl|LZWDecode|RunLengthDecode)\b")


def read_pdf(file: str, data: bytes) -> Drawing:
    """The drawing on the pages of a PDF, one page beside the other. Raises FaultError."""
    _unpacks_small(data)
    found = Found(file)
    with reading("PDF"):
        import pdfplumber

        with pdfplumber.open(io.BytesIO(data)) as document:
            if len(document.pages) > DRAWING_PAGES:
                raise _too_many(len(document.pages))
            for number, page in enumerate(document.pages):
                _page(page, number, found)
        return found.drawing()


def _unpacks_small(data: bytes) -> None:
    """Refuse streams that unpack beyond all measure, before any library unpacks them."""
    if _TWICE.search(data):
        raise too_large_unpacked("PDF")
    room = DRAWING_UNPACKED
    for start in _STREAM.finditer(data):
        body = data[start.end() : data.find(b"endstream", start.end())]
        room -= max(_unpacked(body, room), _unpacked(_plain(body), room))
        if room < 0:
            raise too_large_unpacked("PDF")


def _unpacked(body: bytes, room: int) -> int:
    """How long a stream becomes, as far as there is room; 0 for what is not packed."""
    try:
        return len(zlib.decompressobj().decompress(body, room + 1))
    except zlib.error:
        return 0


def _plain(body: bytes) -> bytes:
    """A stream without the Base 85 around it; empty where there is none."""
    try:
        return a85decode(body.strip().removesuffix(b"~>"))
    except ValueError:
        return b""


def _too_many(pages: int) -> FaultError:
    return FaultError(
        Words(
            f"PDF 有 {pages} 页，多于 {DRAWING_PAGES} 页；请只交作图的页",
            f"the PDF has {pages} pages, more than {DRAWING_PAGES}; hand in those with the drawing",
        ),
        code="too-many",
        numbers={"pages": pages, "most": DRAWING_PAGES},
    )


def _page(page: Any, number: int, found: Found) -> None:
    unit = MM * float(page.page_obj.attrs.get("UserUnit") or 1.0)
    shift, where = number * APART, f"p. {number + 1}"

    def at(point: Sequence[float]) -> complex:
        return complex(point[0], -point[1]) * unit + shift

    for shape in (*page.lines, *page.curves):
        straight = _is_straight(shape.get("path", ()))
        points = [at(point) for point in shape["pts"]]
        if shape.get("fill") and straight:
            found.area(points)
        if shape.get("stroke") and straight:
            width = float(shape.get("linewidth") or 0.0) * unit
            found.line(points, Segment(start=0j, end=0j, layer="", where=where, width=width))
    for word in page.extract_words(extra_attrs=["size"], keep_blank_chars=False):
        height = float(word["size"]) * unit
        found.letter(Label(text=word["text"], at=at((word["x0"], word["bottom"])) + 0.2j * height, height=0.7 * height))


def _is_straight(path: Sequence[Sequence[Any]]) -> bool:
    """Whether an outline has straight sides alone."""
    at = 0j
    for kind, *points in path:
        before, through = at, [complex(*point) for point in points]
        at = through[-1] if through else at
        if kind not in "mlh" and not (kind == "c" and is_straight(before, *through[:-1], end=at)):
            return False
    return True
