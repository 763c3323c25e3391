"""The one place where our flowables meet reportlab's."""

from __future__ import annotations

from copy import copy
from typing import Any, Self

from reportlab.platypus.flowables import Flowable

from ...foundation.slotted import dataclass, replace
from ...tagging.tag import Role, Tag
from ...tagging.tree import marked
from .style import Colour


@dataclass(frozen=True, slots=True, kw_only=True)
class Tightness:
    """How tightly a part is set: its share of the white between paragraphs, of the leading, of the size of sketches."""

    white: float = 1.0
    lines: float = 1.0
    figures: float = 1.0

    def towards(self, other: Tightness, share: float) -> Tightness:
        """Between this and another."""
        return Tightness(
            white=self.white + share * (other.white - self.white),
            lines=self.lines + share * (other.lines - self.lines),
            figures=self.figures + share * (other.figures - self.figures),
        )


class Block(Flowable):  # type: ignore[misc]
    """A flowable of ours; lengths in points. `tag`: what it is in the structure of the document.

    All its ink is that element's, unless it says itself which piece belongs to what (`pieces`).
    """

    role = Role.P
    pieces = False
    bookmark = ""  # of a heading or a sheet, among those of the document
    goal = ""  # the place that it marks, to which references lead
    canv: Any
    width: float
    height: float
    keepWithNext: int = 0
    clings = False  # to what stands before it, where both are held together
    ghost = False  # takes its room and leaves no ink
    airy = 0.0  # share of the white around it that it keeps, however tightly it is set

    def __init__(self, before: float = 0.0, after: float = 0.0) -> None:
        super().__init__()
        self.spaceBefore = before
        self.spaceAfter = after
        self.tag = Tag(self.role)

    def __copy__(self) -> Self:
        """As Python copies it, in a quarter of the time."""
        own = type(self).__new__(type(self))
        own.__dict__.update(self.__dict__)
        return own

    def put_within(self, outer: Tag) -> None:
        """It is a part of this element."""
        self.tag = replace(self.tag, within=outer)

    def made_of(self, whole: Block, *, first: bool) -> Self:
        """Itself as a part of a block that a page break parts: its element, and its white at the outer end."""
        self.tag, self.ghost = whole.tag, whole.ghost
        self.spaceBefore, self.spaceAfter = (whole.spaceBefore, 0.0) if first else (0.0, whole.spaceAfter)
        return self

    def drawOn(self, canvas: Any, x: float, y: float, _sW: float = 0) -> None:
        """As reportlab draws it, as marked content; where references lead to it, with a bookmark."""
        if self.ghost:
            return
        if self.goal:
            canvas.mark_place(self.goal, x, y + self.height)
        if self.pieces:
            super().drawOn(canvas, x, y, _sW)
            return
        with marked(canvas, self.tag):
            super().drawOn(canvas, x, y, _sW)

    def getSpaceBefore(self) -> float:
        """Space above, given up at the head of a page."""
        return self._stretch * self.spaceBefore

    def getSpaceAfter(self) -> float:
        """Space below."""
        return self._stretch * self.spaceAfter

    @property
    def _stretch(self) -> float:
        """As wide as the column has its white where it stands now."""
        return float(getattr(getattr(self, "_frame", None), "stretch", 1.0))

    def tighten(self, degree: Tightness) -> None:
        """Set with less white around it."""
        share = max(degree.white, self.airy)
        self.spaceBefore, self.spaceAfter = share * self.spaceBefore, share * self.spaceAfter

    def undrawn(self) -> Self:
        """A copy that takes its room and leaves no ink."""
        own = copy(self)
        own.ghost = True
        return own

    def colour(self, rgb: Colour) -> None:
        """Set fill and stroke."""
        self.canv.setFillColorRGB(*rgb)
        self.canv.setStrokeColorRGB(*rgb)
