"""What stands on every page beside its text: the running title above, what the pages carry and n / N below."""

from __future__ import annotations

from typing import Any

from reportlab.platypus.frames import Frame

from ...foundation.stock import A4
from ...tagging.tree import FOOTER, HEADER, artifact
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from .base import Block
from .style import GREY

MARGIN = 20 * MM  # above and below the text; beside it on A4
COLUMN = A4.width * MM - 2 * MARGIN  # the width of the text, on any paper
FOOT, SHEET_FOOT = 11 * MM, 4.5 * MM  # of what stands at the foot of a page, and under the frame of a sheet
SMALL = 8.5 / MM
FUZZ = 1e-6  # pt: what is lower by less has room
TOTAL = "vecpoly-total"  # the form of the number of pages


class TextFrame(Frame):  # type: ignore[misc]
    """The column of text, which reportlab copies with all that it holds for every step that is held together.

    stretch: by which the white between its blocks is multiplied; white: what it has of that, in points.
    """

    stretch, white = 1.0, 0.0
    _generated_content: Any = None  # what reportlab asks each time, and finds nowhere else without an error
    _frameBGs: Any = None

    def add(self, flowable: Any, canv: Any, trySplit: int = 0) -> int:
        before, top = self._prevASpace, self._atTop
        ours = isinstance(flowable, Block)
        added = self._took(flowable, canv) if ours else super().add(flowable, canv, trySplit)
        if added and self._y < self._y2:
            above = 0.0 if top else max(flowable.getSpaceBefore() - before, 0.0)
            self.white += above + flowable.getSpaceAfter()
        return int(added)

    def split(self, flowable: Any, canv: Any) -> list[Any]:
        """What of it finds room here, under as much white as it will have on this page."""
        if isinstance(flowable, Block):
            flowable._frame = self
        return list(super().split(flowable, canv))

    def _took(self, block: Block, canv: Any) -> bool:
        """Whether a block of ours found room, and was drawn there: as reportlab does it, less what we never ask for."""
        block._frame, block.canv = self, canv
        own, width = self.__dict__, self._aW
        before = 0.0 if self._atTop else max(block.getSpaceBefore() - self._prevASpace, 0)
        room = self._y - self._y1p - before
        high = block.wrap(width, room)[1] + before if room > 0 else 0.0
        y = self._y - high
        found = bool(room > 0 and y >= self._y1p - FUZZ)
        if found:
            after = block.getSpaceAfter()
            block.drawOn(canv, self._x, y)
            own["_prevASpace"] = after
            if (y := y - after) != self._y:
                own["_atTop"] = 0
            own["_y"] = y
        for name in ("canv", "_frame"):
            block.__dict__.pop(name, None)
        return found

    def __setattr__(self, name: str, value: Any) -> None:
        """What tells where a frame lies stands under other names, and is not changed after it was made."""
        self.__dict__[name] = value

    def __deepcopy__(self, memo: object) -> TextFrame:
        own = type(self).__new__(type(self))
        own.__dict__.update(self.__dict__)  # numbers and names
        return own


def beside(width: float) -> float:
    """The white beside the text of a page so wide, in points; a sheet across has that of one upright."""
    return (width - COLUMN) / 2


def head(canvas: Any, title: str) -> None:
    """The running title over a rule; none on a page that has no title to repeat."""
    if not title:
        return
    width, height = canvas._pagesize
    canvas.saveState()
    canvas.setFillColorRGB(*GREY)
    ink, box = Ink(canvas), layout_words(title, SMALL)
    left = beside(width)
    ink.box(box, width - left - box.width * MM, height - MARGIN + 4 * MM)
    ink.rule(left, height - MARGIN + 2.4 * MM, COLUMN, 0.4)
    with artifact(canvas, HEADER):
        ink.flush()
    canvas.restoreState()


def foot(canvas: Any, y: float, identity: str, *, numbered: bool = True) -> None:
    """What all pages carry at the left of the foot, page n / N in its middle; y: of the baseline, in points."""
    canvas.saveState()
    canvas.setFillColorRGB(*GREY)
    ink, middle = Ink(canvas), canvas._pagesize[0] / 2
    if identity:
        ink.box(layout_words(identity, SMALL), beside(min(canvas._pagesize)), y)
    if numbered:
        number = layout_words(f"{canvas.getPageNumber()} / ", SMALL)
        ink.box(number, middle - number.width * MM, y)
    with artifact(canvas, FOOTER):
        ink.flush()
        if numbered:
            canvas.translate(middle, y)
            canvas.doForm(TOTAL)
    canvas.restoreState()
