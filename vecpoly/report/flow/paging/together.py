"""What stays with what follows: a heading, the one line that leads from it to a table or a figure, the formulas of a
step."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import FrameBreak
from reportlab.platypus.flowables import KeepTogether, _listWrapOn

from ..blocks import Divider, Heading
from ..para import Para
from ..table import DataTable

HOLE = 0.18  # of a page: less may be left white below a step that goes to the next page as a whole
_LINE = {"zh": 44, "en": 92}  # letters of a paragraph that takes one line


class HeldTogether(KeepTogether):  # type: ignore[misc]
    """Blocks on one page, where that leaves no hole; a table or a text behind others may be parted."""

    def split(self, width: float, height: float) -> list[Any]:
        """As they are where the first lines of the last one fit below the others, else on the next page; where that
        would leave a hole, parted behind a formula."""
        found: list[Any] = super().split(width, height)
        if not isinstance(found[0], type(FrameBreak)):
            return found
        if self._last_parted(width, height):
            return found[1:]
        if height <= HOLE * getattr(getattr(self, "_frame", None), "_aH", 0.0):
            return found
        count = self._first_ones(width, height)
        return [*self._content[:count], *found[:1], *self._content[count:]] if count else found

    def _last_parted(self, width: float, height: float) -> bool:
        """Whether all but the last fit here, and the first lines of that."""
        *lead, last = self._content
        parted = isinstance(last, (DataTable, Para)) or any(getattr(one, "leads", False) for one in lead)
        if not lead or not parted:
            return False
        _, used = _listWrapOn(lead, width, self.canv)
        room = height - used - max(last.getSpaceBefore(), lead[-1].getSpaceAfter())
        last.wrap(width, room)
        return room > 0 and bool(last.split(width, room))

    def _first_ones(self, width: float, height: float) -> int:
        """How many of them fit, the last of which is no sentence that leads to the next."""
        ends = (
            n for n in range(len(self._content) - 1, 1, -1) if not isinstance(self._content[n - 1], (Para, Divider))
        )
        return next((n for n in ends if _listWrapOn(self._content[:n], width, self.canv)[1] <= height), 0)


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
