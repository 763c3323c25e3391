"""A curve over axes as a figure of its own: what was tried, or how good a linkage is, place by place."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...board.construction import Scale, View
from ...board.paper.marks import Dot, Role
from ...board.paper.scales import round_up
from ...board.place import Pane
from ...plane import Points
from ...words import Words
from ..diagrams.axes import divisions, numbers
from .draft import Draft

WIDE, HIGH = 100.0, 45.0  # mm: of a chart, at most
BEYOND, TICK = 8.0, 1.5  # mm: the axes run on; marks on them
DIVISIONS = 7  # marks on an axis, about


@dataclass(frozen=True, slots=True, kw_only=True)
class Axis:
    """What is set out along an axis: its symbol, its unit, from where to where."""

    symbol: str
    unit: str
    low: float
    high: float

    def scale(self, room: float) -> Scale:
        """A round scale by which it fills the room (mm)."""
        return Scale(symbol=f"μ_{self.symbol[0]}", value=round_up((self.high - self.low) / room), unit=self.unit)

    @property
    def numbered(self) -> list[tuple[float, str]]:
        """Round numbers from end to end, and how they are written."""
        values = divisions(self.low, self.high, DIVISIONS)
        return [*zip(values, numbers(values), strict=True)]


@dataclass(frozen=True, slots=True, kw_only=True)
class Chart:
    """Axes on paper; the origin of the figure is where both begin, or where the upright one is 0."""

    draft: Draft
    place: Pane
    right: Axis
    up: Axis

    @property
    def _scale(self) -> Scale:
        return self.draft.board.scale_of(self.place)

    @property
    def base(self) -> float:
        """The value of the upright axis at the level one."""
        return min(max(self.up.low, 0.0), self.up.high)

    def at(self, right: float, up: float) -> complex:
        """A place on paper."""
        return complex((right - self.right.low) / self._scale.right.value, (up - self.base) / self._scale.value)

    def curve(self, rights: Sequence[float], ups: Sequence[float]) -> None:
        """A smooth curve through these places."""
        points: list[Points] = [np.complex128(self.at(x, y)) for x, y in zip(rights, ups, strict=True)]
        self.draft.board.curve(self.place, points, Role.RESULT)

    def point(self, right: float, up: float, letter: str) -> None:
        """A marked place, its ordinate and its letter."""
        at = np.complex128(self.at(right, up))
        self.draft.board.join(self.place, at.real + 0j, at, Role.CONSTRUCTION)
        self.draft.board.plot(self.place, at, letter, Dot.POINT)

    def ruled(self) -> None:
        """Both axes, with round numbers beside them."""
        board, place = self.draft.board, self.place
        far, low, high = self.at(self.right.high, self.base), self.at(self.right.low, self.up.low), 0j
        high = self.at(self.right.low, self.up.high)
        for start, end, axis in ((0j, far + BEYOND, self.right), (low, high + 1j * BEYOND, self.up)):
            board.arrow(place, start, end, Role.DIRECTION)
            board.plot(place, end, f"{axis.symbol}/{axis.unit}" if axis.unit else axis.symbol, Dot.NONE)
        for x, text in self.right.numbered:
            self._tick(self.at(x, self.base), 1j, -1j, text)
        for y, text in self.up.numbered:
            self._tick(self.at(self.right.low, y), 1 + 0j, -1 + 0j, text)

    def _tick(self, at: complex, along: complex, side: complex, text: str) -> None:
        board = self.draft.board
        board.join(self.place, at - along * TICK / 2, at + along * TICK / 2, Role.CONSTRUCTION)
        board.note(self.place, at + TICK / 2 * side, Words.same(text), side)


def chart(draft: Draft, name: str, title: Words, right: Axis, up: Axis) -> Chart:
    """Open a figure with these axes."""
    scale, across = up.scale(HIGH), right.scale(WIDE)
    own = Scale(symbol=scale.symbol, value=scale.value, unit=scale.unit, across=across)
    place = draft.board.open_pane(View.MECHANISM, name, title, own, aside=True)
    return Chart(draft=draft, place=place, right=right, up=up)
