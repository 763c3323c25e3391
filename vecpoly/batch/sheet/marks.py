"""What every page carries: tags, codes, the measuring bar; straight onto a canvas, in mm."""

from __future__ import annotations

import re
from functools import cache, lru_cache
from typing import Any

from ...typeset.box import MM
from ...typeset.canvas import draw as draw_type
from ...typeset.words import layout_words
from ...words import Lang, Words
from .apriltag import CELLS, CODES
from .layout import BAR, BAR_AT, BOXES, QR, QR_AT, QR_QUIET, TAG, Spot, corners_of_tags
from .qr import Rows, modules

PALE = (165 / 255, 205 / 255, 235 / 255)
SMALL, TINY = 3.2, 2.5  # mm, em
_BLACK = re.compile(rb"\x01+")
_BAR = Words("此线长 100 mm；量得：", "This bar is 100 mm; measured:")
_ADVICE = Words(
    "HB 铅笔、直尺；箭头 ≥ 2.5 mm；拍照时放平、八个方块全部可见、传原图，勿用扫描软件",
    "HB pencil, ruler; arrowheads ≥ 2.5 mm; photograph it flat, all eight squares visible, original file, "
    "no scanner app",
)


def write(canvas: Any, text: str, at: Spot, em: float, *, bold: bool = False) -> float:
    """A line of text with its left end at a place; how wide it is (mm)."""
    box = _typed(text, em, bold)
    draw_type(canvas, box, at[0] * MM, at[1] * MM)
    return box.width


_typed = lru_cache(maxsize=1024)(layout_words)  # on every page mostly the same


def line(canvas: Any, a: Spot, b: Spot) -> None:
    """A line in the pen that is set."""
    canvas.line(a[0] * MM, a[1] * MM, b[0] * MM, b[1] * MM)


def box(canvas: Any, at: Spot, width: float, height: float) -> None:
    """An empty rectangle."""
    canvas.rect(at[0] * MM, at[1] * MM, width * MM, height * MM)


def furniture(canvas: Any, tags: tuple[int, ...], code: str, lang: Lang) -> None:
    """The eight tags, the code twice as QR and twice in letters, the bar."""
    for tag, at in zip(tags, corners_of_tags(), strict=True):
        canvas._code.append(_squares(tag, at))
    for at in QR_AT:
        canvas._code.append(_cells(modules(code), at, QR))
    (right, _), (left, low) = QR_AT
    write(canvas, code, (right + QR + QR_QUIET, QR_AT[0][1] + 1.0), TINY)
    write(canvas, code, (left - QR_QUIET - _typed(code, TINY, False).width, low + 1.0), TINY)
    _bar(canvas, lang)


def code_squares(canvas: Any, code: str, at: Spot, side: float) -> None:
    """A QR code with its lower left corner at a place."""
    canvas._code.append(_cells(modules(code), at, side))


def _bar(canvas: Any, lang: Lang) -> None:
    x, y = BAR_AT
    canvas.setStrokeColorRGB(0, 0, 0)
    canvas.setLineWidth(0.25 * MM)
    line(canvas, (x, y), (x + BAR, y))
    for end in (x, x + BAR):
        line(canvas, (end, y - 1.5), (end, y + 1.5))
    at = x + write(canvas, _BAR.of(lang), (x, y - 5.5), TINY) + 1.0
    for measured in BOXES:
        box(canvas, (at, y - 5.8), 2.6, 2.6)
        at += 3.2 + write(canvas, str(measured), (at + 3.2, y - 5.5), TINY) + 1.6
    write(canvas, _ADVICE.of(lang), (x, 5.0), 2.3)


def _cells(rows: Rows, at: Spot, side: float) -> str:
    """Black squares, in runs along each row, as one path."""
    starts, lines, widths, high = _grid(len(rows), at, side)
    out = ["0 0 0 rg"]
    for row, line in zip(rows, lines, strict=True):
        for run in _BLACK.finditer(row):
            start, end = run.span()
            out.append(f"{starts[start]} {line} {widths[end - start]} {high} re")
    return " ".join((*out, "f"))


@lru_cache(maxsize=64)
def _grid(count: int, at: Spot, side: float) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...], str]:
    """So many squares each way, as a page has them: where each begins, across and from the top; how wide so many
    are; how high one is."""
    size = side / count
    starts = tuple(f"{(at[0] + n * size) * MM:.3f}" for n in range(count))
    lines = tuple(f"{(at[1] + side - (n + 1) * size) * MM:.3f}" for n in range(count))
    widths = tuple(f"{n * size * MM:.3f}" for n in range(count + 1))
    return starts, lines, widths, f"{size * MM:.3f}"


@cache
def _squares(tag: int, at: Spot) -> str:
    return _cells(_tag(tag), at, TAG)


@cache
def _tag(number: int) -> Rows:
    """The black cells of a tag, its black border of one cell with them."""
    code, wide = CODES[number], CELLS + 2
    inner = {
        (r + 1, c + 1): not code >> (CELLS * CELLS - 1 - (CELLS * r + c)) & 1
        for r in range(CELLS)
        for c in range(CELLS)
    }
    return tuple(bytes(inner.get((r, c), True) for c in range(wide)) for r in range(wide))
