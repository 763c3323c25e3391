"""A drawing sheet as a page of a report: every figure of it is an element, which says in words what it shows."""

from __future__ import annotations

from typing import Any

from ...board.construction import Construction
from ...drawing.backends.pdf import draw_pdf
from ...drawing.sheets.sheet import Sheet
from ...tagging.tag import Role, Tag, boxed
from ...tagging.tree import marked
from ...typeset.box import MM
from ..flow.blocks import SheetPage
from .shown import placed


def sheet_page(sheet: Sheet, construction: Construction, name: str) -> SheetPage:
    """The sheet, called so in the bookmarks."""

    def draw(canvas: Any, x: float, y: float) -> None:
        with marked(canvas, Tag(Role.P)):  # the title strip tells what the sheet is, and by whom
            draw_pdf(sheet.furniture, canvas, x, y)
        for one, scene in sheet.parts:
            e = scene.extents
            tag = Tag(Role.FIGURE, alt=placed(one, construction, sheet.lang))
            with marked(canvas, boxed(tag, x + e.x0 * MM, y + e.y0 * MM, x + e.x1 * MM, y + e.y1 * MM)):
                draw_pdf(scene, canvas, x, y)
        if sheet.warning is not None:
            with marked(canvas, Tag(Role.P)):
                draw_pdf(sheet.alarm, canvas, x, y)

    return SheetPage(draw, wide=sheet.landscape, title=name, told=True)
