"""What stays with what follows: a heading, the one line that leads from it to a table or a figure, the formulas of a
step."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import ActionFlowable, FrameBreak
from reportlab.platypus.flowables import KeepTogether

from ..base import Block
from ..blocks import Divider, Heading
from ..furniture import FUZZ
from ..para import Para
from .parting import parted

HOLE = 0.12  # of a page: less may be left white below a step that goes to the next page as a whole
GAP = 0.07  # of a page: less stays white below what goes to the next page as a whole; what would leave more is parted
_ANY, _PARTED = 0xFFFFFFF, 0xFFFFFF  # pt: as reportlab says "as high as you like", and "higher than any column"
_LINE = {"zh": 44, "en": 92}  # letters of a paragraph that takes one line


class HeldTogether(KeepTogether):  # type: ignore[misc]
    """Blocks on one page, where that leaves no gap; else parted where a book parts them (`parting`)."""

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """As reportlab finds it, without a copy of the column for blocks of ours, which put nothing into it; more than
        any column has, so that it is asked to part them."""
        if not all(isinstance(one, Block) for one in self._content):
            wide, high = super().wrap(width, height)
            return wide, high
        sizes = [one.wrapOn(self.canv, width, _ANY) for one in self._content]
        wide, high, below = 0.0, 0.0, None  # below: the white under the one before
        for one, (w, h) in zip(self._content, sizes, strict=True):
            if h <= FUZZ:
                continue
            wide, high = max(wide, min(w, width)), high + h
            if below is not None:
                high += max(one.getSpaceBefore() - below, 0)
            below = one.getSpaceAfter()
            high += below
        self._H, self._H0, self._wrapInfo = high - (below or 0), sizes[0][1] if sizes else 0, (width, height)
        return wide, _PARTED

    def split(self, width: float, height: float) -> list[Any]:
        """As they are where they have room, else on the next page; where that would leave a gap, parted."""
        found: list[Any] = super().split(width, height)
        if height >= self._H or not all(isinstance(one, Block) for one in self._content):
            return found
        turned, frame = isinstance(found[0], type(FrameBreak)), getattr(self, "_frame", None)
        whole = turned and height <= GAP * getattr(frame, "_aH", 0.0)
        halves = None if whole else parted(self._content, width, height, getattr(frame, "stretch", 1.0))
        if halves is not None:
            here, overleaf = halves
            return [*here, FrameBreak, Parted(), HeldTogether(overleaf)]
        if not turned:
            return found
        ruled = isinstance(self._content[0], Divider)  # no page opens with a rule
        return [found[0], HeldTogether(self._content[ruled:])]  # a figure may open that page, and leave as little room


def first_of(item: Any) -> Any:
    """The first of blocks that are held together; any other as it is."""
    return item._content[0] if isinstance(item, HeldTogether) and item._content else item


class Parted(ActionFlowable):  # type: ignore[misc]
    """Where a page break parts a step: the document counts them."""

    def __init__(self) -> None:
        super().__init__(())

    def apply(self, doc: Any) -> None:
        """One more."""
        doc.parted += 1


def led(story: Sequence[Any]) -> list[Any]:
    """The story in which a heading's only line is not parted from what it leads to."""
    out = list(story)
    for at in range(1, len(out)):
        line = out[at]
        leads = isinstance(out[at - 1], Heading) and isinstance(line, Para) and not isinstance(line, Heading)
        floats = any(getattr(one, "floats", False) for one in out[at + 1 : at + 2])
        if leads and len(line.text) <= _LINE[line.lang] and not (line.keepWithNext or floats):
            out[at] = copy(line)
            out[at].keepWithNext, out[at].leads = 1, True
    return out
