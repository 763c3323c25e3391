"""The small figure that an equation draws, at the right margin beside the displays of its step: on paper that would
stay blank."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from itertools import accumulate, pairwise
from typing import Any

from ....foundation.slotted import dataclass
from ....tagging.tag import Role, Tag
from ....typeset.box import MM
from ..base import Block, Tightness
from ..blocks import Drawing
from ..equation import EquationFlow, Inset
from ..formula import Formula
from ..furniture import COLUMN
from .abreast import Abreast

Display = EquationFlow | Formula | Abreast

WIDE, NARROW = 44.0, 33.0  # mm: how wide the place of such a figure is, and has to be
HIGH, LOW = 36.0, 24.0  # mm: how high it is, and may be even where its displays are lower
CLEAR, INDENT = 6.0, 8.0  # mm between displays and figure; what displays keep of the margin at which steps begin


class Beside(Block):
    """Displays in the order in which they are read, moved aside by so many mm, and the figure at the right margin."""

    role = Role.DIV
    pieces = True

    def __init__(self, displays: Sequence[Display], figure: Drawing | None, aside: float = 0.0) -> None:
        super().__init__(displays[0].spaceBefore, displays[-1].spaceAfter)
        self.displays, self.figure, self.aside = (*displays,), figure, aside
        self.clings = figure is not None and not isinstance(displays[0], EquationFlow)  # to the equation of the figure

    def put_within(self, outer: Tag) -> None:
        """All that it holds is a part of this element."""
        for one in (*self.displays, *((self.figure,) if self.figure else ())):
            one.put_within(outer)
        super().put_within(outer)

    def tighten(self, degree: Tightness) -> None:
        """Its displays closer too; the figure stays, for its letters are as small as may be."""
        self.displays = tuple(map(copy, self.displays))
        for one in self.displays:
            one.tighten(degree)
        self.spaceBefore, self.spaceAfter = self.displays[0].spaceBefore, self.displays[-1].spaceAfter

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width = width
        self.height = max(_high(self.displays, width), self.figure.size[1] if self.figure else 0.0)
        return width, self.height

    def draw(self) -> None:
        """The displays under each other, then the figure, both in the middle of the height."""
        y = (self.height + _high(self.displays, self.width)) / 2
        for one, top in zip(self.displays, _tops(self.displays, self.width), strict=True):
            one.drawOn(self.canv, -self.aside * MM, y - top - one.height)
        if self.figure is not None:
            wide, high = self.figure.size
            self.figure.wrap(wide, high)
            self.figure.drawOn(self.canv, self.width - wide, (self.height - high) / 2)


@dataclass(frozen=True, slots=True)
class _Place:
    """A place for the figure: beside the displays from one on, if all of them move aside by so many mm."""

    first: int
    aside: float
    width: float
    height: float


def illustrated(blocks: Sequence[Any]) -> list[Any]:
    """The blocks, displays of a step beside their figure where its equation has one that finds a place there."""
    for at, one in enumerate(blocks):
        if isinstance(one, EquationFlow) and one.inset is not None:
            end = next((n for n in range(at + 1, len(blocks)) if not isinstance(blocks[n], Display)), len(blocks))
            return [*blocks[:at], *_beside([one.alone(), *blocks[at + 1 : end]], one.inset), *illustrated(blocks[end:])]
    return list(blocks)


def _beside(displays: list[Display], inset: Inset) -> list[Block]:
    """The displays with the figure in the first place that it finds."""
    for place in _places(displays):
        figure = inset(place.width, place.height)
        if figure is not None:
            before, some = displays[: place.first], displays[place.first :]
            count, aside = _count(some, figure.size[1]), max(0.0, place.aside - place.width + figure.size[0] / MM)
            behind = [Beside([one], None, aside) if aside else one for one in some[count:]]
            return [*before, Beside(some[:count], figure, aside), *behind]
    return [*displays]


def _places(displays: list[Display]) -> Iterator[_Place]:
    """Beside the equation, beside the lines worked out under it, beside both moved to the left."""
    for first in (0, 1):
        if some := displays[first:]:
            high = _room_up(some)
            _, right = _reach(some[: _count(some, high * MM)])
            if (wide := COLUMN / MM - CLEAR - right) >= NARROW and (not first or _high(some, COLUMN) >= LOW * MM):
                yield _Place(first, 0.0, min(wide, WIDE), high)
    high = _room_up(displays)
    _, right = _reach(displays[: _count(displays, high * MM)])
    left, _ = _reach(displays)
    wanted = min(WIDE - (COLUMN / MM - CLEAR - right), left - INDENT)
    if (wide := COLUMN / MM - CLEAR - right + wanted) >= NARROW and wanted > 0:
        yield _Place(0, wanted, min(wide, WIDE), high)


def _room_up(displays: Sequence[Display]) -> float:
    """How high a figure beside them may be (mm)."""
    return min(max(_high(displays, COLUMN) / MM, LOW), HIGH)


def _reach(displays: Sequence[Display]) -> tuple[float, float]:
    """Where their ink begins and ends in the column (mm)."""
    lefts, rights = zip(*(one.reach for one in displays), strict=True)
    return min(lefts), max(rights)


def _count(displays: Sequence[Display], height: float) -> int:
    """How many of them it takes to be so high (pt)."""
    tops = _tops(displays, COLUMN)
    return next(
        (n for n, (one, top) in enumerate(zip(displays, tops, strict=True), 1) if top + one.height >= height), len(tops)
    )


def _high(displays: Sequence[Display], width: float) -> float:
    """How high they are together (pt)."""
    return _tops(displays, width)[-1] + displays[-1].height


def _tops(displays: Sequence[Display], width: float) -> list[float]:
    """How far under the first one's head each begins (pt)."""
    high = [one.wrap(width, 0.0)[1] for one in displays]
    white = [max(one.spaceAfter, two.spaceBefore) for one, two in pairwise(displays)]
    return [*accumulate((a + b for a, b in zip(high, white, strict=False)), initial=0.0)]
