"""A circle about a crowded place, and what of it is too near to be told apart on the figure itself."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.ruler import READABLE
from ...foundation.slotted import dataclass

FACTORS = (2.0, 2.5, 4.0, 5.0, 10.0, 20.0)  # GB/T 14690
FULL, LEAST = 40.0, 26.0  # mm across that a detail is at most: on any figure; on one that is no larger than it
HALF = 0.5  # of the figure, that a detail is at most if that is more
EDGE, TIGHT = 9.0, 0.8  # mm between the crowd and the ring about it: in the detail, at least on the figure
IMAGE, CLEARLY = 52.0, 16.0  # mm across: the detail of an image of a link at most; an image that can be read
SMALLEST = 1.0  # mm: radius of a circle that can be seen
WIDE, LONG = 8.0, 5.0  # mm in the detail: between letters, of a vector, if there is room;
ROUND = 2.5  # times larger: a circle on which one is to see where a line touches it, if there is room
FREE = 14.0  # mm in the detail between letters about which many lines end
LEGIBLE = 5.0  # mm between letters in the detail, at least
SEEN = 3  # what a knot is worth at least: three pairs of letters, or one vector


@dataclass(frozen=True, slots=True)
class Knot:
    """A circle about a crowded place, and how many times it is to be enlarged."""

    centre: complex
    radius: float
    factor: float

    def holds(self, at: complex) -> bool:
        """Whether a point lies within."""
        return abs(at - self.centre) <= self.radius

    def moved(self, at: complex) -> complex:
        """A point as it lies in the detail."""
        return (at - self.centre) * self.factor

    def meets(self, other: Knot) -> bool:
        """Whether the circles overlap."""
        return abs(self.centre - other.centre) < self.radius + other.radius


@dataclass(frozen=True, slots=True)
class Trouble:
    """Two places that are too near: the ends of a short vector, or two letters; crossed: letters about which so many
    lines end that they hide each other; rim: the ends of a diameter of a circle, which so many lines touch."""

    a: complex
    b: complex
    vector: bool
    crossed: bool = False
    rim: bool = False
    touched: int = 0

    @property
    def length(self) -> float:
        """How far apart they are, mm."""
        return abs(self.b - self.a)

    @property
    def worth(self) -> int:
        """How much it is to draw them apart."""
        return SEEN + self.touched if self.vector or self.crossed else 1

    def solved(self, factor: float, *, well: bool = False) -> bool:
        """Whether they are far enough apart so many times larger."""
        if self.crossed:
            return self.length * factor >= (FREE if well else WIDE)
        if self.rim:
            return self.length * factor >= LONG and (not well or factor >= ROUND)
        least = (LONG if well else READABLE) if self.vector else (WIDE if well else LEGIBLE)
        return self.length * factor >= least


def ring(bare: float, factor: float) -> float:
    """Radius (mm) of the ring about a crowd in a circle of this radius, to be enlarged so many times."""
    return max(SMALLEST, bare + max(TIGHT, EDGE / factor))


def largest(across: float) -> float:
    """How large (mm across) a detail of a figure of this length may be: it stands back behind its figure."""
    return min(max(HALF * across, LEAST), FULL)


def finds_room(bare: float, factor: float, most: float) -> bool:
    """Whether such a detail is not larger than this (mm). The larger the factor, the larger the detail."""
    return 2 * ring(bare, factor) * factor <= most


def about_image(corners: Sequence[complex]) -> Knot | None:
    """The circle about the image of a link that is enlarged as far as its detail finds room; None where the image is
    large enough, or no factor makes it so."""
    x, y = [z.real for z in corners], [z.imag for z in corners]
    centre = complex(min(x) + max(x), min(y) + max(y)) / 2
    bare, long = max(abs(z - centre) for z in corners), max(abs(a - b) for a in corners for b in corners)
    made = [factor for factor in FACTORS if finds_room(bare, factor, IMAGE)]
    if not made or long < SMALLEST or long >= CLEARLY or made[-1] * long < CLEARLY:
        return None
    return Knot(centre, ring(bare, made[-1]), made[-1])
