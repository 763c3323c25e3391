"""A page whose figures are laid out anew, closer together, over the band of its legend."""

from __future__ import annotations

from ...foundation.slotted import replace
from ..sheets.boxes.redbox import BAND
from ..sheets.packing import pack
from ..sheets.pages import pairs_of
from ..sheets.settling.settled import settled
from ..sheets.sheet import Sheet, placed


def over_band(sheet: Sheet, height: float, white: float) -> Sheet | None:
    """The sheet with its figures in what a band of this height leaves of it, with so much white between them at least
    (mm); None where they find no room."""
    group, (wide, high) = sheet.groups, sheet.room
    rest = wide, high - height - (BAND if sheet.warning is not None else 0.0)
    layout = pack([one.size for one in group], rest, tuple(pairs_of(group)))
    if layout is None or layout.white < white:
        return None
    low = settled(group, layout)
    risen = replace(low, page=sheet.room, corners=tuple(at + 1j * height for at in low.corners))
    return placed(group, risen, sheet.strip, sheet.lang, sheet.warning)
