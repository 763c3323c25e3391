"""How much room a sheet offers: the board chooses its scales from these sizes,
the sheet places figures in them. All in mm."""

from __future__ import annotations

from ...board.construction import View
from ...foundation.stock import A4, FORMATS, Format, Paper

FRAME = 10.0  # paper edge to frame
STRIP = 16.0  # title strip at the foot, inside the frame
PLATE = 170.0  # width of a sheet in the text, which is that of the text
HIGHEST = 155.0  # of a plate over its strip, for which figures are made smaller: what is higher has a page
LARGEST = 198.0  # of a plate in place of a page of which bands are white
TALLEST = 238.0  # of a plate with its legend, over its strip: no page of text holds a higher one
LEGEND = 13.0  # mm of a sheet that a legend of two rows takes, over the strip
SPARSE = 0.6  # share of a page below which figures look lost on it
CLEAR = 5.0  # white between the frame and the first figure, and between figures
CAPTION = 15.0  # title and scale under a figure
LETTERING = 8.0  # what letters may stand out from a figure on each side


def usable(landscape: bool = False, of: Format = A4) -> tuple[float, float]:
    """Width and height inside frame and strip, with white around."""
    width, height = room_inside(landscape, of)
    return width - 2 * CLEAR, height - 2 * CLEAR


def room_inside(landscape: bool = False, of: Format = A4) -> tuple[float, float]:
    """Width and height inside the frame, over the strip."""
    width, height = of.turned(landscape)
    return width - 2 * FRAME, height - 2 * FRAME - STRIP


def is_page(room: tuple[float, float]) -> bool:
    """Whether this is the room of a whole sheet; that of a plate is lower."""
    return is_across(room) or any(room == room_inside(False, of) for of in FORMATS)


def is_across(room: tuple[float, float]) -> bool:
    """Whether this is the room of a whole sheet that lies across."""
    return any(room == room_inside(True, of) for of in FORMATS)


def rooms(on: Paper, kept: float = 0.0) -> tuple[tuple[float, float], ...]:
    """The room of a sheet of this paper, each way in which it may lie; so much (mm) over the strip kept free."""
    return tuple((wide, high - kept) for wide, high in (room_inside(across, on.format) for across in on.ways))


def room(view: View, count: int = 1, of: Format = A4) -> tuple[float, float]:
    """Width and height (mm) that the bare lines of each of `count` figures of a kind should fill.

    The mechanism has the width of a page (so may another kind). A free body stands beside its force polygon, a page
    being two columns wide: one or two pairs a page, half a page high; three pairs a page where there are more.
    """
    width, height = usable(of=of)
    wide, half = width - 2 * LETTERING, (width - CLEAR) / 2 - 2 * LETTERING
    rows = 2 if count <= 2 or not view.paired else 3
    deep = (height - (rows - 1) * CLEAR) / rows - CAPTION - LETTERING
    return (wide if view.wide else half, deep)
