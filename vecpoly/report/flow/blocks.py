"""Headings, the title block, call-outs and figures."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy
from typing import Any

from ...algebra.formula import plain, row, split_words
from ...tagging.references import goal_of
from ...tagging.speech import words_said
from ...tagging.tag import Role, Tag, boxed
from ...tagging.tree import artifact, marked, tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...words import Lang
from .base import Block, Tightness
from .cells import cells, joined
from .para import Para
from .style import CAPTION, GREY, HEADINGS, Colour, Style

SMALLEST, LARGEST = 0.85, 1.15  # of a sketch on a page that is closed or opened up: its letters stay near those of text
Draw = Callable[[Any, float, float], None]

KINDS: dict[str, Colour] = {
    "pass": (0.10, 0.45, 0.20),
    "warn": (0.70, 0.42, 0.0),
    "fail": (0.70, 0.10, 0.10),
    "note": (0.15, 0.30, 0.55),
}


def spoken(text: str) -> str:
    """A text without its marks, for bookmarks."""
    parts = (plain(row(piece)) if formula else piece for formula, piece in split_words(text))
    return "".join(parts).replace("**", "")


class _Head(Para):
    """A heading of any level; it stays with what follows."""

    keepWithNext = 1
    airy = 0.7

    def __init__(self, text: str, level: int, lang: Lang) -> None:
        super().__init__(text, HEADINGS[level - 1], lang)
        self.tag = Tag(Role(f"H{level}"))

    def split(self, width: float, height: float) -> list[Block]:
        """A heading stays whole."""
        return []


class Heading(_Head):
    """A heading of level 1 (the title) to 3, with an outline entry."""

    def __init__(self, text: str, level: int = 2, lang: Lang = "zh") -> None:
        super().__init__(text, level, lang)
        self.level = level
        self.outline = spoken(text)
        self.goal = goal_of(self.outline)


class Subheading(_Head):
    """A heading within a section, at the margin and without an outline entry."""

    def __init__(self, text: str, lang: Lang = "zh") -> None:
        super().__init__(text, 4, lang)


class Callout(Block):
    """A verdict or remark on a tinted ground with a coloured bar; kind: pass, warn, fail, note."""

    role = Role.DIV
    pieces = True

    def __init__(self, text: str, kind: str = "note", lang: Lang = "zh") -> None:
        super().__init__(5.0, 7.0)
        self.kind = kind
        self._tint = KINDS[kind]
        self._para = Para(text, Style(size=10.0, leading=15.5), lang)

    _PAD = 7.0

    def tighten(self, degree: Tightness) -> None:
        """The lines in it closer too."""
        super().tighten(degree)
        self._para = copy(self._para)
        self._para.tighten(degree)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width = width
        _, inner = self._para.wrap(width - 2 * self._PAD - 4.0, height)
        self.height = inner + self._PAD
        return width, self.height

    def draw(self) -> None:
        """Draw ground, bar and text."""
        canv = self.canv
        with artifact(canv):
            canv.setFillColorRGB(*(1.0 - 0.07 * (1.0 - part) for part in self._tint))
            canv.rect(0.0, 0.0, self.width, self.height, stroke=0, fill=1)
            canv.setFillColorRGB(*self._tint)
            canv.rect(0.0, 0.0, 2.4, self.height, stroke=0, fill=1)
        self._para.put_within(self.tag)
        self._para.drawOn(canv, self._PAD + 4.0, self._PAD / 2)


_UNDER = 5.5  # pt between a drawing, which may end with a ground, and the line of its caption


class Drawing(Block):
    """A figure of true size, or a sketch, drawn by a callback at its lower left corner, centred, captioned below."""

    role = Role.FIGURE
    pieces = True
    over = 0.0  # points of white above it, at the top of a page too
    ampler: Callable[[float], Drawing | None] | None = None  # gives the same sketch so many times as large

    def __init__(
        self, width_mm: float, height_mm: float, draw: Draw, alt: str = "", caption: str = "", *, sketch: bool = False
    ) -> None:
        super().__init__(6.0, 6.0)
        self.floats = sketch  # where the page has no room for it, the text runs on, and it opens the next page
        self.size = (width_mm * MM, height_mm * MM)
        self.alt, self._draw, self._sketch, self._factor = alt, draw, sketch, 1.0
        chinese = any(char >= "\u2e80" for char in caption)
        self._caption = joined(cells(caption, CAPTION.em, chinese), CAPTION.em) if caption else None
        said = alt or words_said(caption, "zh" if chinese else "en")
        self.tag, self.goal = Tag(Role.FIGURE, alt=said), goal_of(caption)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column; only a sketch is ever made smaller."""
        self.width = max(width, self.size[0])
        self.height = self.over + self._factor * self.size[1] + (CAPTION.leading + _UNDER if self._caption else 0.0)
        return width, self.height

    def draw(self) -> None:
        """Call back, then set the caption."""
        factor = self._factor
        width, height = (factor * side for side in self.size)
        left, low = (self.width - width) / 2, self.height - self.over - height
        x, y = self.canv.absolutePosition(left, low)
        tag = boxed(self.tag, x, y, x + width, y + height)
        with marked(self.canv, tag):
            self.canv.saveState()
            if factor != 1.0:
                self.canv.scale(factor, factor)
            self._draw(self.canv, left / factor, low / factor)
            self.canv.restoreState()
        if self._caption is not None:
            ink = Ink(self.canv)
            ink.under(tree_of(self.canv).opener(Tag(Role.CAPTION, tag)))
            ink.box(self._caption, (self.width - self._caption.width * MM) / 2, CAPTION.size * 0.35)
            ink.flush()

    def tighten(self, degree: Tightness) -> None:
        """A sketch, which is not to scale, is drawn smaller too."""
        super().tighten(degree)
        self._factor = min(max(degree.figures, SMALLEST), LARGEST) if self._sketch else 1.0

    def fitted(self, room: float) -> Drawing | None:
        """Itself where there is room for so many points, a sketch a little smaller; None where that will not do."""
        lines = self.wrap(0.0, room)[1] - self._factor * self.size[1]
        if self.height <= room:
            return self
        factor = (room - lines) / self.size[1]
        if not self._sketch or factor < min(SMALLEST, self._factor):
            return None
        own = copy(self)
        own._factor = factor
        return own

    def draw_bare(self, canvas: Any, x: float, y: float) -> None:
        """Draw the figure alone with its lower left corner at (x, y) points."""
        with marked(canvas, boxed(self.tag, x, y, x + self.size[0], y + self.size[1])):
            self._draw(canvas, x, y)


class Divider(Block):
    """A fine rule across the column, between what ends and what begins; no page ends or begins with it."""

    pieces = True
    keepWithNext = 1

    def __init__(self) -> None:
        super().__init__(4.0, 6.0)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width, self.height = width, 0.5
        return width, 0.5

    def draw(self) -> None:
        """Draw the rule."""
        with artifact(self.canv):
            self.colour(GREY)
            self.canv.rect(0.0, 0.0, self.width, 0.4, stroke=0, fill=1)


class Plate(Drawing):
    """A sheet that is lower than a page, framed in the text; in the bookmarks like the others."""

    over = 8.0

    def __init__(self, width_mm: float, height_mm: float, draw: Draw, title: str = "", alt: str = "") -> None:
        super().__init__(width_mm, height_mm, draw, alt or title)
        self.outline, self.level, self.floats = title, 2, True

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column, which it exceeds on both sides alike where it is wider."""
        super().wrap(width, height)
        self.width = width
        return width, self.height


class SheetPage(Block):
    """A whole A4 page drawn by a callback at the paper's lower left corner, in true millimetres.

    behind: it stands after so many pages of the text that goes on behind it; none where it stands in its place.

    told: the callback says itself what is what on it; else the page is one figure, which `alt` tells of.
    """

    role = Role.FIGURE
    pieces = True
    numbered = True  # under the frame stands the number of the page
    fixed = False  # it never stands before text that comes before it
    led = False  # a plate is met behind it, which must not come first

    def __init__(self, draw: Draw, *, wide: bool = False, title: str = "", alt: str = "", told: bool = False) -> None:
        super().__init__()
        self._draw, self.wide, self.outline, self.alt = draw, wide, title, alt
        self._told, self.level, self.behind = told, 2, 0
        self.tag, self.goal = Tag(Role.FIGURE, alt=alt or title), goal_of(title)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole page."""
        self.width, self.height = width, height
        return width, height

    def draw(self) -> None:
        """Call back."""
        if self._told:
            self._draw(self.canv, 0.0, 0.0)
            return
        with marked(self.canv, boxed(self.tag, 0.0, 0.0, self.width, self.height)):
            self._draw(self.canv, 0.0, 0.0)
