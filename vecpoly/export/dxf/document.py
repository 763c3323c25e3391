"""A figure, or a sheet of figures, as a DXF file: model space in mm, true to scale on paper."""

from __future__ import annotations

import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from ...board.construction import Figure
from ...drawing.cleared import cleared
from ...drawing.figure import drawing
from ...drawing.scene import Item, Rect, TextBox
from ...drawing.sheets.boxes.redbox import red_box
from ...drawing.sheets.boxes.titleblock import furniture
from ...drawing.sheets.sheet import Sheet
from ...drawing.symbols.around import Surroundings
from ...errors import VecpolyError
from ...words import Lang, Words
from .entities import STYLES, Paper
from .layers import SHEET, TEXT, set_up

VERSION = "R2010"
MILLIMETRES = 4


@dataclass(frozen=True, slots=True)
class Part:
    """A figure, and where its origin lies on the page (mm)."""

    figure: Figure
    origin: complex = 0j


def figure_dxf(figure: Figure, lang: Lang = "zh", upto: int | None = None) -> bytes:
    """One figure about its own origin; upto: as it stands after that step."""
    return _written((Part(figure),), (), lang, upto)


def sheet_dxf(sheet: Sheet, upto: int | None = None) -> bytes:
    """A page with its frame and title strip, the lower left corner of the paper at the origin."""
    page = Rect(0.0, 0.0, *sheet.size)
    alarm = () if sheet.warning is None else red_box(page, sheet.warning.of(sheet.lang))
    return _written(tuple(_parts(sheet)), (*furniture(page, sheet.strip, sheet.lang), *alarm), sheet.lang, upto)


def _parts(sheet: Sheet) -> Iterator[Part]:
    """The figures of a page as it shows them, their details too."""
    return (Part(one.figure, one.origin) for one in sheet.figures if one.figure is not None)


def _written(parts: Sequence[Part], furnishing: Sequence[Item], lang: Lang, upto: int | None) -> bytes:
    ezdxf = library()
    doc = ezdxf.new(VERSION, units=MILLIMETRES)
    doc.header["$MEASUREMENT"] = 1
    doc.header["$LTSCALE"] = 1.0
    set_up(doc)
    for name, font in STYLES.items():
        doc.styles.add(name, font=font)
    paper = Paper(doc.modelspace())
    for part in parts:
        _figure(paper, part, lang, upto)
    for item in furnishing:
        paper.item(item, SHEET)
    into = io.StringIO()
    doc.write(into)
    return into.getvalue().encode(doc.output_encoding)


def library() -> Any:
    """The package ezdxf; raises VecpolyError where it is not installed."""
    try:
        import ezdxf
    except ModuleNotFoundError:
        raise VecpolyError(
            Words(
                "写 DXF 文件需要 ezdxf；请 pip install vecpoly[cad]",
                "DXF files are written by ezdxf; pip install vecpoly[cad]",
            ),
            code="package",
        ) from None
    return ezdxf


def _figure(paper: Paper, part: Part, lang: Lang, upto: int | None) -> None:
    """Marks from the lowest to the highest, then the lettering."""
    figure, marks = part.figure, cleared(part.figure.view, part.figure.marks)
    around = Surroundings.of(figure.view, marks, lang)
    for mark in marks:
        if upto is None or mark.step <= upto:
            paper.mark(mark, around, part.origin)
    drawn = drawing(figure, lang=lang)
    marked = set(drawn.obstacles)
    for item in drawn.scene.items:
        if (isinstance(item, TextBox) or item not in marked) and (upto is None or item.step <= upto):
            paper.item(item, TEXT, part.origin)
