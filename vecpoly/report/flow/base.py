"""The one place where our flowables meet reportlab's."""

from __future__ import annotations

from typing import Any

from reportlab.platypus.flowables import Flowable

from .style import Colour


class Block(Flowable):  # type: ignore[misc]
    """A flowable of ours; lengths in points."""

    canv: Any
    width: float
    height: float
    keepWithNext: int = 0

    def __init__(self, before: float = 0.0, after: float = 0.0) -> None:
        super().__init__()
        self.spaceBefore = before
        self.spaceAfter = after

    def getSpaceBefore(self) -> float:
        """Space above, given up at the head of a page."""
        return self.spaceBefore

    def getSpaceAfter(self) -> float:
        """Space below."""
        return self.spaceAfter

    def colour(self, rgb: Colour) -> None:
        """Set fill and stroke."""
        self.canv.setFillColorRGB(*rgb)
        self.canv.setStrokeColorRGB(*rgb)
