"""A drawing sheet as it is bound into a report: a page of its own, or a plate in the text."""

from __future__ import annotations

from ....drawing.backends.pdf import draw_pdf
from ....drawing.sheets.sheet import Sheet
from ....drawing.sheets.space import FRAME, STRIP
from ....typeset.box import MM
from ..blocks import Plate, SheetPage


def bound_in(sheet: Sheet, name: str) -> SheetPage | Plate:
    """The sheet, called so in the bookmarks; of a plate no paper is left outside the frame."""
    if not sheet.plate:
        return SheetPage(
            lambda canvas, x, y: draw_pdf(sheet.scene, canvas, x, y), wide=sheet.landscape, title=name, alt=name
        )
    wide, high = sheet.room
    return Plate(
        wide, high + STRIP, lambda canvas, x, y: draw_pdf(sheet.scene, canvas, x - FRAME * MM, y - FRAME * MM), name
    )
