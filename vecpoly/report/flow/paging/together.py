"""What stays with what follows: a heading, and the one line that leads from it to a table or a figure."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.doctemplate import FrameBreak
from reportlab.platypus.flowables import KeepTogether, _listWrapOn

from ..blocks import Heading
from ..para import Para

_LINE = {"zh": 44, "en": 92}  # letters of a paragraph that takes one line


class HeldTogether(KeepTogether):  # type: ignore[misc]
    """Blocks on one page; behind a line that only leads to it the last may be parted, as without that line."""

    def split(self, width: float, height: float) -> list[Any]:
        """As they are where the first lines of the last one fit below the others, else on the next page."""
        found: list[Any] = super().split(width, height)
        parted = any(getattr(one, "leads", False) for one in self._content)
        if not parted or not isinstance(found[0], type(FrameBreak)):
            return found
        *lead, last = self._content
        _, used = _listWrapOn(lead, width, self.canv) if lead else (0.0, 0.0)
        room = height - used - max(last.getSpaceBefore(), lead[-1].getSpaceAfter() if lead else 0.0)
        last.wrap(width, room)
        return found[1:] if lead and room > 0 and last.split(width, room) else found


def led(story: Sequence[Any]) -> list[Any]:
    """The story in which a heading's only line is not parted from what it leads to."""
    out = list(story)
    for at in range(1, len(out)):
        line = out[at]
        leads = isinstance(out[at - 1], Heading) and isinstance(line, Para) and not isinstance(line, Heading)
        if leads and len(line.text) <= _LINE[line.lang] and not line.keepWithNext:
            out[at] = copy(line)
            out[at].keepWithNext, out[at].leads = 1, True
    return out
