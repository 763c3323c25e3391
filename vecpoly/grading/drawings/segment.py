"""What is on a drawing, whatever it was made with: segments in mm with an uncertainty, lettering, and remarks."""

from __future__ import annotations

from dataclasses import dataclass

from ...foundation.slotted import replace
from ...words import Words

TOUCH = 0.3  # mm: ends that are meant to be one
SHORTEST = 0.3  # mm: a shorter line is a slip of the mouse, and nobody draws one
CAD_SIGMA = 0.02  # mm: how well an end that was set by a program is known


@dataclass(frozen=True, slots=True, kw_only=True)
class Segment:
    """A straight line from start to end (mm, x right, y up).

    name: of the vector, where the file has one; layer: or group; sigma: of each end, mm; where: in the file; headed: an
    arrow head stands at its end; width: of its ink, mm, 0 where unknown.
    """

    start: complex
    end: complex
    name: str = ""
    layer: str = ""
    sigma: float = CAD_SIGMA
    where: str = ""
    headed: bool = False
    width: float = 0.0

    @property
    def along(self) -> complex:
        """From start to end."""
        return self.end - self.start

    def turned(self) -> Segment:
        """The same line the other way."""
        return replace(self, start=self.end, end=self.start)


@dataclass(frozen=True, slots=True, kw_only=True)
class Label:
    """Lettering that begins at a point; height: of its letters, mm."""

    text: str
    at: complex
    height: float = 3.0
    layer: str = ""

    @property
    def middle(self) -> complex:
        """About the middle of its letters."""
        return self.at + complex(0.3 * len(self.text), 0.4) * self.height


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """A file as read; remarks: what had to be assumed."""

    file: str
    segments: tuple[Segment, ...]
    labels: tuple[Label, ...] = ()
    remarks: tuple[Words, ...] = ()
