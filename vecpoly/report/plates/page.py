"""A drawing sheet in a report: a page of its own, every figure of it an element that says in words what it shows; or a
plate in the text."""

from __future__ import annotations

from typing import Any

from ...board.construction import Construction
from ...drawing.backends.pdf import draw_pdf
from ...drawing.scene import Scene
from ...drawing.sheets.boxes.titleblock import TO_BE_DRAWN
from ...drawing.sheets.sheet import Sheet
from ...drawing.sheets.space import FRAME, STRIP
from ...tagging.tag import Role, Tag, boxed
from ...tagging.tree import marked
from ...typeset.box import MM
from ..flow.blocks import Plate, SheetPage
from .shown import placed


def sheet_page(sheet: Sheet, construction: Construction, name: str) -> SheetPage | Plate:
    """The sheet, called so in the bookmarks; of a plate no paper is left outside the frame."""
    return _plate(sheet, construction, name) if sheet.plate else _page(sheet, construction, name)


def _plate(sheet: Sheet, construction: Construction, name: str) -> Plate:
    """One figure, of which all is told together."""
    wide, high = sheet.room
    alt = " ".join((name, *(placed(one, construction, sheet.lang) for one in sheet.figures)))

    def draw(canvas: Any, x: float, y: float) -> None:
        draw_pdf(sheet.scene, canvas, x - FRAME * MM, y - FRAME * MM)

    return Plate(wide, high + STRIP, draw, name, alt)


def _page(sheet: Sheet, construction: Construction, name: str) -> SheetPage:

    def draw(canvas: Any, x: float, y: float) -> None:
        with marked(canvas, Tag(Role.P)):  # the title strip tells what the sheet is, and by whom
            draw_pdf(sheet.furniture, canvas, x, y)
        for one, scene in sheet.parts:
            e = scene.extents
            tag = Tag(Role.FIGURE, alt=placed(one, construction, sheet.lang))
            with marked(canvas, boxed(tag, x + e.x0 * MM, y + e.y0 * MM, x + e.x1 * MM, y + e.y1 * MM)):
                draw_pdf(scene, canvas, x, y)
        if sheet.results:
            with marked(canvas, Tag(Role.P)):
                draw_pdf(Scene(sheet.results, sheet.scene.extents), canvas, x, y)
        if sheet.warning is not None:
            with marked(canvas, Tag(Role.P)):
                draw_pdf(sheet.alarm, canvas, x, y)

    page = SheetPage(draw, wide=sheet.landscape, title=name, told=True)
    page.fixed = construction.hand == TO_BE_DRAWN  # blank ones stand behind the table of results
    return page
