"""A sheet as it stands while it is drawn."""

from __future__ import annotations

from ...foundation.slotted import replace
from ..scene import Item
from .sheet import Sheet


def after(sheet: Sheet, step: int) -> Sheet:
    """The sheet after a step: a figure that is not begun has no title yet, and nothing has come out."""
    kept: list[Item] = []
    first = 0
    for one in sheet.figures:
        own = sheet.drawn[first : first + one.count]
        first += one.count
        if any(0 < item.step <= step for item in own):
            kept += [item for item in own if item.step <= step]
    rest = (item for item in sheet.drawn[first:] if item.step <= step)
    return replace(sheet, drawn=(*kept, *rest), figures=(), results=())
