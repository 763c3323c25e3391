"""Squared paper to work on, as much as the work needs (`room`): what is left of the page where that suffices, else it
goes on overleaf; the results stand at its foot."""

from __future__ import annotations

from collections.abc import Sequence

from ...tagging.tree import artifact
from ...typeset.box import MM
from ...words import Lang
from ..flow.base import Block
from ..flow.blocks import Heading
from ..flow.furniture import COLUMN
from ..flow.style import PALE
from .room import ROOMY

SQUARE = 5.0 * MM
LEAST_ROOM, LITTLE = 45.0 * MM, 25.0 * MM  # of squares under a heading; for a line or two, or over a tall table
STRIP = 25.0 * MM  # below the most that the work needs: so little more squares fill the page
_LOW = 75.0 * MM  # of results that have a page to themselves: lower ones have squares over them
BEGUN = 60.0 * MM  # of squares that go on overleaf: a lower strip stays white
_TALL, TALLEST = 180.0 * MM, 193.0 * MM  # of what stands at the foot, at most: it fits the lowest paper
GAP = 3.0 * MM
CLOSE, TIGHT = 0.7, 0.6  # of the room that the work needs: enough over its results; enough to spare a page
_ON = {"zh": "{}（续）", "en": "{} (continued)"}


class Squares(Block):
    """As many whole squares as this height (pt) and the width have room for."""

    pieces = True

    def __init__(self, height: float) -> None:
        super().__init__()
        self._room = height

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, self._room
        return width, self._room

    def draw(self) -> None:
        """Pale lines, from the upper edge on."""
        columns, rows = int(self.width / SQUARE), int(self.height / SQUARE)
        left = (self.width - columns * SQUARE) / 2
        self.canv.saveState()
        self.canv.setStrokeColorRGB(*PALE)
        self.canv.setLineWidth(0.25)
        across, down = range(columns + 1), range(rows + 1)
        with artifact(self.canv):
            self.canv.grid([left + i * SQUARE for i in across], [self.height - i * SQUARE for i in down])
        self.canv.restoreState()


class Working(Block):
    """Squares on this page where it has room enough for the work and its foot; else on what is left of it, and overleaf
    what is lacking.

    need: in points, of squares in all, at least; foot: blocks under the last of them.
    """

    level = 3
    pieces = True

    def __init__(self, title: str, need: float, foot: Sequence[Block], lang: Lang) -> None:
        super().__init__(6.0, 0.0)
        self._lang, self.outline, self._need, self._foot = lang, title, need, tuple(foot)
        self.name = title
        self._head = (Heading(title, 3, lang),) if title else ()
        self._least = min(LITTLE if sum(tall(one, COLUMN) for one in foot) > _TALL else LEAST_ROOM, need)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """All that is left, where it suffices and is no more than the work may fill."""
        other, need = self._other(width), max((CLOSE if self._foot else TIGHT) * self._need, self._least)
        room = min(height - 0.01 - other, ROOMY * self._need)
        if height - other <= ROOMY * self._need + STRIP * bool(self._need):
            room = height - 0.01 - other
        self.width, self.height = width, other + (room if room >= need - 0.02 else need)
        return width, self.height

    def split(self, width: float, height: float) -> list[Block]:
        """What is left of this page; overleaf the rest, or the results alone where nothing is lacking."""
        room = height - sum(tall(one, width) for one in self._head)
        if room < BEGUN:
            return []
        lacking = 0.0 if room >= TIGHT * self._need else self._need - room
        if lacking or sum(tall(one, width) for one in self._foot) < _LOW:
            rest = Working(_ON[self._lang].format(self.name), max(lacking, LEAST_ROOM), self._foot, self._lang)
        else:
            rest = Working("", 0.0, self._foot, self._lang)
        rest.name = self.name
        first = Working(self.outline, int(room / SQUARE) * SQUARE, (), self._lang)
        return [first.made_of(self, first=True), rest.made_of(self, first=False)]

    def draw(self) -> None:
        """The heading, the squares, the foot."""
        top = self.height
        for one in self._head:
            top -= tall(one, self.width)
            one.drawOn(self.canv, 0.0, top + one.getSpaceAfter())
        at = sum(tall(one, self.width) for one in self._foot)
        for one in self._foot:
            at -= tall(one, self.width)
            one.drawOn(self.canv, 0.0, at + one.getSpaceAfter())
        squares = Squares(self.height - self._other(self.width))
        squares.wrapOn(self.canv, self.width, self.height)
        if squares.height >= SQUARE:
            squares.drawOn(self.canv, 0.0, top - squares.height)

    def _other(self, width: float) -> float:
        """What is not for squares."""
        return sum(tall(one, width) for one in (*self._head, *self._foot)) + (GAP if self._foot else 0.0)


class Spare(Working):
    """Squares where no work is needed: what is left of the page below the results, if that is no strip."""

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """All that is left, or what stands at the foot alone."""
        self.width = width
        self.height = height - 0.01 if height >= LEAST_ROOM + self._other(width) else self._footed(width)
        return width, self.height

    def split(self, width: float, height: float) -> list[Block]:
        """Where the page has no room for the foot."""
        return [*self._foot]

    def draw(self) -> None:
        """The foot first, then the squares that are left."""
        spare, top = self.height > self._footed(self.width) + 0.02, self.height
        for one in (*self._foot, *(self._head if spare else ())):
            top -= tall(one, self.width)
            one.drawOn(self.canv, 0.0, top + one.getSpaceAfter())
        if spare:
            squares = Squares(top)
            squares.wrapOn(self.canv, self.width, top)
            squares.drawOn(self.canv, 0.0, 0.0)

    def _footed(self, width: float) -> float:
        return sum(tall(one, width) for one in self._foot)


def working(title: str, need: float, foot: Sequence[Block], lang: Lang) -> list[Block]:
    """Squares (need: in mm) with this at their foot; after them, where it would leave no room on a page; it alone where
    none are needed."""
    if not need and foot:
        return [Spare(title, 0.0, foot, lang)]
    need *= MM
    if sum(tall(one, COLUMN) for one in foot) <= TALLEST:
        return [Working(title, need, foot, lang)]
    return [Working(title, need, (), lang), *foot]


def tall(block: Block, width: float) -> float:
    """The height of a block with the white above and below it."""
    return float(block.wrap(width, 0.0)[1]) + block.getSpaceBefore() + block.getSpaceAfter()
