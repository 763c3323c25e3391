"""A drawing as an immutable value: strokes, fills and lettering in mm, x right, y up;
every backend draws this and nothing else."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from enum import IntEnum

from ..foundation.slotted import dataclass, replace
from ..typeset import Box
from .rect import Rect as Rect
from .style import Dash, Hue


class Layer(IntEnum):
    """What lies over what: a later layer is drawn over an earlier one."""

    TINT = 0
    THIN = 1
    LINE = 2  # links and vectors
    SLOT = 3  # a slot is open: it hides the lines under it
    BODY = 4  # slider blocks hide the rod that passes through them
    OVER = 5  # links pinned to a block lie over it
    HEAD = 6
    JOINT = 7  # open circles hide the line ends under them
    TEXT = 8


@dataclass(frozen=True, slots=True, kw_only=True)
class Stroke:
    """A line through points, of a width in mm."""

    points: tuple[complex, ...]
    width: float
    dash: Dash = Dash.FULL
    hue: Hue = Hue.BLACK
    closed: bool = False
    layer: Layer = Layer.LINE
    step: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Fill:
    """A filled polygon."""

    points: tuple[complex, ...]
    hue: Hue = Hue.BLACK
    layer: Layer = Layer.HEAD
    step: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class TextBox:
    """Set type with the left end of its baseline at (x, y)."""

    box: Box
    x: float
    y: float
    hue: Hue = Hue.BLACK
    layer: Layer = Layer.TEXT
    step: int = 0

    @property
    def rect(self) -> Rect:
        """The rectangle it covers."""
        return Rect(self.x, self.y - self.box.descent, self.x + self.box.width, self.y + self.box.ascent)


Item = Stroke | Fill | TextBox


def rect_of(item: Item) -> Rect:
    """The rectangle an item covers, with its line width."""
    return Rect(*_sides(item))


def _sides(item: Item) -> tuple[float, float, float, float]:
    """The sides of that."""
    match item:
        case TextBox(box=box, x=x, y=y):
            return x, y - box.descent, x + box.width, y + box.ascent
        case Stroke(points=points, width=width):
            xs, ys, by = [z.real for z in points], [z.imag for z in points], width / 2
            return min(xs) - by, min(ys) - by, max(xs) + by, max(ys) + by
        case Fill(points=points):
            xs, ys = [z.real for z in points], [z.imag for z in points]
            return min(xs), min(ys), max(xs), max(ys)


def moved(item: Item, by: complex) -> Item:
    """The item shifted by a vector."""
    match item:
        case TextBox(x=x, y=y):
            return replace(item, x=x + by.real, y=y + by.imag)
        case Stroke(points=points) | Fill(points=points):
            return replace(item, points=tuple(z + by for z in points))


@dataclass(frozen=True, slots=True)
class Scene:
    """Items and the rectangle they need on the page."""

    items: tuple[Item, ...]
    extents: Rect

    @classmethod
    def of(cls, items: tuple[Item, ...]) -> Scene:
        """The scene of these items, with the extents they cover."""
        if not items:
            return cls((), Rect(0.0, 0.0, 0.0, 0.0))
        lefts, feet, rights, heads = zip(*map(_sides, items), strict=True)
        return cls(items, Rect(min(lefts), min(feet), max(rights), max(heads)))

    def __iter__(self) -> Iterator[Item]:
        """The items in drawing order: by layer, then as they were drawn."""
        return iter(sorted(self.items, key=lambda item: item.layer))

    def __add__(self, other: Scene) -> Scene:
        return Scene(self.items + other.items, self.extents | other.extents)

    def moved(self, by: complex) -> Scene:
        """The scene shifted by a vector."""
        return Scene(tuple(moved(item, by) for item in self.items), self.extents.moved(by))

    def upto(self, step: int) -> Scene:
        """What stands on the board after a step; lettering and extents stay where they are."""
        return self._kept(lambda item: item.step <= step)

    def highlighted(self, step: int) -> Scene:
        """One step in its own ink, all others faded."""
        return Scene(
            tuple(
                item if item.step == step or item.hue.is_tint else replace(item, hue=Hue.GHOST) for item in self.items
            ),
            self.extents,
        )

    def _kept(self, wanted: Callable[[Item], bool]) -> Scene:
        return Scene(tuple(item for item in self.items if wanted(item)), self.extents)
