"""Where everything stands on the pages of a question sheet, in mm from the lower left corner of an A4 page."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from ...foundation.short import short

WIDTH, HEIGHT = 210.0, 297.0
TAG, EDGE, QUIET = 10.0, 9.0, 3.0  # side of a tag, its distance from the paper's edge, what stays white round it
QR, QR_QUIET = 20.0, 3.2
LEFT, RIGHT, BOTTOM, TOP = 24.0, 186.0, 38.0, 262.0  # of what is written and drawn
SETS = 73  # of eight tags each, of the 587 there are
BAR = 100.0
BAR_AT = (24.0, 32.0)  # left end of the measuring bar
BOXES = tuple(range(95, 104))  # measured lengths to be ticked
QR_AT = ((128.0, 266.0), (160.0, 10.0))  # lower left corners
Spot = tuple[float, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """A frame to draw in: which figure, lower left corner, size, the pole where the figure has one, its scale (SI per
    mm)."""

    figure: str
    at: Spot
    size: Spot
    pole: Spot | None
    letter: str
    mu: str
    scale: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Blank:
    """Where an answer is written: baseline of its symbol; whether a length on paper, a direction, a sense are asked
    with it; place: whether it is two coordinates, origin: from which point."""

    key: str
    symbol: str
    unit: str
    at: Spot
    length: bool
    direction: bool
    sense: bool
    place: bool = False
    origin: str = ""

    @property
    def plain(self) -> bool:
        """Whether a number is all that is asked, so that two go beside each other."""
        return not (self.length or self.direction or self.sense or self.place)


@dataclass(frozen=True, slots=True, kw_only=True)
class Page:
    """A page: its number, the problem it belongs to, the ids of its eight tags from the upper left corner clockwise."""

    number: int
    problem: str
    tags: tuple[int, ...]
    frame: Frame | None = None
    blanks: tuple[Blank, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Layout:
    """All pages of a student's sheet."""

    pages: tuple[Page, ...]

    @property
    def hash(self) -> str:
        """Four letters that change wherever anything stands elsewhere."""
        return short(json.dumps(self.as_json(), ensure_ascii=False, sort_keys=True), 4)

    def as_json(self) -> dict[str, Any]:
        """Plain data."""
        return asdict(self)


def corners_of_tags() -> tuple[Spot, ...]:
    """Lower left corners of the eight tags: corners and middles of the edges, from the upper left clockwise."""
    x = (EDGE, (WIDTH - TAG) / 2, WIDTH - EDGE - TAG)
    y = (EDGE, (HEIGHT - TAG) / 2, HEIGHT - EDGE - TAG)
    return (
        (x[0], y[2]),
        (x[1], y[2]),
        (x[2], y[2]),
        (x[2], y[1]),
        (x[2], y[0]),
        (x[1], y[0]),
        (x[0], y[0]),
        (x[0], y[1]),
    )


def tags_of(page: int) -> tuple[int, ...]:
    """The ids of the tags of a page: eight of its own, as long as there are any; then they begin again, and the code
    alone tells the page."""
    first = 8 * ((page - 1) % SETS)
    return tuple(range(first, first + 8))
