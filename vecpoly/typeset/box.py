"""What layout yields: runs of glyphs and filled rules at fixed places, in mm, y upwards from the baseline."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..foundation.slotted import dataclass, replace

MM = 72 / 25.4  # points in a millimetre
Rgb = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class Glyphs:
    """A run of text in one face: font (registered name), size in pt, left end of its baseline in mm; rgb: its own ink,
    from 0 to 1, where it has not that of its surroundings."""

    font: str
    size: float
    x: float
    y: float
    text: str
    rgb: Rgb | None = None


@dataclass(frozen=True, slots=True)
class Rule:
    """A filled rectangle: lower left corner and extent in mm."""

    x: float
    y: float
    width: float
    height: float


Item = Glyphs | Rule


@dataclass(frozen=True, slots=True)
class Box:
    """A piece of set type; origin: left end of its baseline; ascent and descent are positive, in mm."""

    width: float
    ascent: float
    descent: float
    items: tuple[Item, ...] = ()

    @property
    def height(self) -> float:
        """Ascent and descent together, mm."""
        return self.ascent + self.descent

    @property
    def text(self) -> str:
        """Its letters, as they come."""
        return "".join(item.text for item in self.items if isinstance(item, Glyphs))

    def moved(self, dx: float, dy: float) -> Iterator[Item]:
        """The items with the origin put at (dx, dy)."""
        for item in self.items:
            match item:
                case Glyphs(font, size, x, y, text, rgb):
                    yield Glyphs(font, size, x + dx, y + dy, text, rgb)
                case Rule(x, y, width, height):
                    yield Rule(x + dx, y + dy, width, height)


EMPTY = Box(0.0, 0.0, 0.0)


def place(parts: Iterable[tuple[float, float, Box]], width: float) -> Box:
    """One box of several, each with its origin at (x, y)."""
    items: list[Item] = []
    ascent = descent = 0.0
    for x, y, box in parts:
        items.extend(box.moved(x, y) if x or y else box.items)
        ascent = max(ascent, box.ascent + y)
        descent = max(descent, box.descent - y)
    return Box(width, ascent, descent, tuple(items))


def scaled(box: Box, factor: float) -> Box:
    """The box at another size."""
    items: list[Item] = []
    for item in box.items:
        match item:
            case Glyphs(font, size, x, y, text, rgb):
                items.append(Glyphs(font, size * factor, x * factor, y * factor, text, rgb))
            case Rule(x, y, width, height):
                items.append(Rule(x * factor, y * factor, width * factor, height * factor))
    return Box(box.width * factor, box.ascent * factor, box.descent * factor, tuple(items))


def inked(box: Box, rgb: Rgb) -> Box:
    """The box with its letters in an ink of their own."""
    return replace(box, items=tuple(replace(one, rgb=rgb) if isinstance(one, Glyphs) else one for one in box.items))


def beside(boxes: Iterable[Box]) -> Box:
    """Boxes side by side on one baseline."""
    parts: list[tuple[float, float, Box]] = []
    x = 0.0
    for box in boxes:
        parts.append((x, 0.0, box))
        x += box.width
    return place(parts, x)
