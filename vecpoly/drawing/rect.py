"""A rectangle along the axes of a drawing."""

from __future__ import annotations

from ..foundation.slotted import dataclass


@dataclass(frozen=True, slots=True)
class Rect:
    """A rectangle along the axes, in mm."""

    x0: float
    y0: float
    x1: float
    y1: float

    @property
    def width(self) -> float:
        """Extent in x."""
        return self.x1 - self.x0

    @property
    def height(self) -> float:
        """Extent in y."""
        return self.y1 - self.y0

    @property
    def centre(self) -> complex:
        """The middle."""
        return complex((self.x0 + self.x1) / 2, (self.y0 + self.y1) / 2)

    @property
    def corners(self) -> tuple[complex, complex, complex, complex]:
        """From the lower left one counter-clockwise."""
        x0, y0, x1, y1 = self.x0, self.y0, self.x1, self.y1
        return complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1)

    def grown(self, by: float) -> Rect:
        """With a margin all round."""
        return Rect(self.x0 - by, self.y0 - by, self.x1 + by, self.y1 + by)

    def moved(self, by: complex) -> Rect:
        """As large, elsewhere."""
        return Rect(self.x0 + by.real, self.y0 + by.imag, self.x1 + by.real, self.y1 + by.imag)

    def __or__(self, other: Rect) -> Rect:
        return Rect(min(self.x0, other.x0), min(self.y0, other.y0), max(self.x1, other.x1), max(self.y1, other.y1))

    def overlaps(self, other: Rect) -> bool:
        """Whether the two have some area in common."""
        return self.x0 < other.x1 and other.x0 < self.x1 and self.y0 < other.y1 and other.y0 < self.y1
