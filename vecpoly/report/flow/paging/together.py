"""What stays with what follows: a heading, the one line that leads from it to a table or a figure, the formulas of a
step."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import ActionFlowable, FrameBreak
from reportlab.platypus.flowables import KeepTogether, _listWrapOn

from ..base import Block
from ..blocks import Divider, Heading
from ..furniture import FUZZ
from ..listing import Listing
from ..para import Para
from ..table import DataTable

HOLE = 0.18  # of a page: less may be left white below a step that goes to the next page as a whole
GAP = 0.42  # of a page: a step that would leave more is parted; what leaves more than a hole asks for a tighter text
_ANY, _PARTED = 0xFFFFFFF, 0xFFFFFF  # pt: as reportlab says "as high as you like", and "higher than any column"
_UNDER = 3  # lines under a heading at the foot of a page, at least
_LINE = {"zh": 44, "en": 92}  # letters of a paragraph that takes one line


class HeldTogether(KeepTogether):  # type: ignore[misc]
    """Blocks on one page, where that leaves no gap; a table or text that stands last may be parted, not in a step."""

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
        """As they are where the first lines of the last one fit below the others, else on the next page; where that
        would leave a gap, parted behind a formula."""
        found: list[Any] = super().split(width, height)
        if not isinstance(found[0], type(FrameBreak)):
            return found
        gap = height > GAP * getattr(getattr(self, "_frame", None), "_aH", 0.0)
        if (gap or not self._tabled) and self._last_parted(width, height):
            return found[1:]
        count = self._first_ones(width, height) if gap else 0
        if count:
            return [*self._content[:count], *found[:1], Parted(), *self._content[count:]]
        ruled = isinstance(self._content[0], Divider)  # no page opens with a rule
        return [found[0], HeldTogether(self._content[ruled:])]  # a figure may open that page, and leave as little room

    @property
    def _tabled(self) -> bool:
        """Whether they are a step with its table."""
        last = self._content[-1]
        return isinstance(last, DataTable) and last.tag.within is not None

    def _last_parted(self, width: float, height: float) -> bool:
        """Whether all but the last fit here, and the first lines of that."""
        *lead, last = self._content
        parted = isinstance(last, (DataTable, Para, Listing)) or any(getattr(one, "leads", False) for one in lead)
        if not lead or not parted:
            return False
        _, used = _listWrapOn(lead, width, self.canv)
        room = height - used - max(last.getSpaceBefore(), lead[-1].getSpaceAfter())
        last.wrap(width, room)
        parts = last.split(width, room) if room > 0 else []
        if parts and isinstance(lead[-1], Heading) and isinstance(last, Para):
            return len(parts[0].lines(width)) >= _UNDER
        return bool(parts)

    def _first_ones(self, width: float, height: float) -> int:
        """How many of them fit, the last of which is no sentence that leads to the next."""
        ends = (
            n for n in range(len(self._content) - 1, 1, -1) if not isinstance(self._content[n - 1], (Para, Divider))
        )
        return next((n for n in ends if _listWrapOn(self._content[:n], width, self.canv)[1] <= height), 0)


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
