"""What stands on every page beside its text: the running title above, what the pages carry and n / N below."""

from __future__ import annotations

from typing import Any

from ...tagging.tree import FOOTER, HEADER, artifact
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from .style import GREY

MARGIN = 20 * MM
FOOT, SHEET_FOOT = 11 * MM, 4.5 * MM  # of what stands at the foot of a page, and under the frame of a sheet
SMALL = 8.5 / MM
TOTAL = "vecpoly-total"  # the form of the number of pages


def head(canvas: Any, title: str) -> None:
    """The running title over a rule."""
    width, height = canvas._pagesize
    canvas.saveState()
    canvas.setFillColorRGB(*GREY)
    ink, box = Ink(canvas), layout_words(title, SMALL)
    ink.box(box, width - MARGIN - box.width * MM, height - MARGIN + 4 * MM)
    ink.rule(MARGIN, height - MARGIN + 2.4 * MM, width - 2 * MARGIN, 0.4)
    with artifact(canvas, HEADER):
        ink.flush()
    canvas.restoreState()


def foot(canvas: Any, y: float, identity: str, *, numbered: bool = True) -> None:
    """What all pages carry at the left of the foot, page n / N in its middle; y: of the baseline, in points."""
    canvas.saveState()
    canvas.setFillColorRGB(*GREY)
    ink, middle = Ink(canvas), canvas._pagesize[0] / 2
    if identity:
        ink.box(layout_words(identity, SMALL), MARGIN, y)
    if numbered:
        number = layout_words(f"{canvas.getPageNumber()} / ", SMALL)
        ink.box(number, middle - number.width * MM, y)
    with artifact(canvas, FOOTER):
        ink.flush()
        if numbered:
            canvas.translate(middle, y)
            canvas.doForm(TOTAL)
    canvas.restoreState()
