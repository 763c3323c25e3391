"""Paragraphs of mixed Chinese and Latin text with formulas."""

from __future__ import annotations

from functools import lru_cache

from ...foundation.slotted import replace
from ...tagging.pieces import Marks
from ...tagging.tag import Role, Tag
from ...tagging.tree import tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...words import Lang
from .base import Block, Tightness
from .cells import cells, chopped, joined
from .lines import draw_line
from .style import Style, body
from .text.breaks import Line, break_lines

_WIDOWS = 2


@lru_cache(maxsize=512)
def _lines(text: str, em: float, chinese: bool, bold: bool, measure: float, first: float) -> tuple[Line, ...]:
    """A text in lines (mm); most sentences of a solution stand in the solutions of a whole class."""
    parts = [part for cell in cells(text, em, chinese, bold) for part in chopped(cell, measure, em, bold)]
    return tuple(break_lines(parts, measure, em, first))


class Para(Block):
    """Text in one style; a label hangs in the indent; splits between lines, never leaving one line alone."""

    pieces = True

    leads = False  # to what follows, from which it is not parted

    def __init__(self, text: str, style: Style | None = None, lang: Lang = "zh", label: str = "") -> None:
        self.style = style or body(lang)
        super().__init__(self.style.before, self.style.after)
        self.lang = lang
        self.text = text
        self._label = cells(label, self.style.em, lang == "zh", True) if label else ()
        self._broken: dict[float, list[Line]] = {}  # by width; one for the paragraph and all its copies
        self._heights: dict[float, float] = {}  # the same, of all that are set as closely
        self._item: Tag | None = None

    @property
    def labelled(self) -> bool:
        """Whether a number hangs before it."""
        return bool(self._label)

    def put_in_list(self, item: Tag, body: Tag) -> None:
        """It opens an item of a list, whose label is its own."""
        self.put_within(body)
        self._item = Tag(Role.LABEL, item)

    def tighten(self, degree: Tightness) -> None:
        """Its lines closer too."""
        super().tighten(degree)
        if degree.lines != 1.0:
            self.style, self._heights = replace(self.style, leading=degree.lines * self.style.leading), {}

    def _measure(self, width: float) -> float:
        return width / MM - self.style.left * self.style.em

    def lines(self, width: float) -> list[Line]:
        """The lines for a column of the given width (pt)."""
        if width not in self._broken:
            style, measure = self.style, self._measure(width)
            chinese, first = self.lang == "zh", style.first * style.em
            self._broken[width] = list(_lines(self.text, style.em, chinese, style.bold, measure, first))
        return self._broken[width]

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        if width not in self._heights:
            self._heights[width] = sum(self._advance(line) for line in self.lines(width))
        self.width, self.height = width, self._heights[width]
        return width, self.height

    def _advance(self, line: Line) -> float:
        """The leading of a line, more where a tall formula needs it."""
        over = line.ascent * MM - self._rise() - 1.0
        under = line.descent * MM - (self.style.leading - self._rise()) - 1.0
        return self.style.leading + max(0.0, over) + max(0.0, under)

    def _rise(self) -> float:
        """From the top of a line to its baseline."""
        return (self.style.leading - self.style.size) / 2 + 0.86 * self.style.size

    def split(self, width: float, height: float) -> list[Block]:
        """Two paragraphs, the first of which fits."""
        lines = self.lines(width)
        used, count = 0.0, 0
        while count < len(lines) and used + self._advance(lines[count]) <= height:
            used += self._advance(lines[count])
            count += 1
        count = min(count, len(lines) - _WIDOWS) if count < len(lines) else count
        if count < min(_WIDOWS, len(lines)):
            return []
        return [self._part(lines[:count], width, True), self._part(lines[count:], width, False)]

    def _part(self, lines: list[Line], width: float, head: bool) -> Para:
        part = Para("", self.style, self.lang)
        part._broken = {width: lines}
        if head:
            part._label, part._item = self._label, self._item
        return part.made_of(self, first=head)

    def draw(self) -> None:
        """Draw all lines."""
        style, ink, marks = self.style, Ink(self.canv), Marks(self.canv, self.tag)
        left = style.left * style.em * MM
        measure = self._measure(self.width)
        y = self.height
        for i, line in enumerate(self.lines(self.width)):
            advance = self._advance(line)
            over = max(0.0, line.ascent * MM - self._rise() - 1.0)
            baseline = y - over - self._rise()
            if i == 0 and self._label:
                label = joined(self._label, style.em)
                ink.under(marks.words if self._item is None else tree_of(self.canv).opener(self._item))
                ink.box(label, max(0.0, left - (label.width + 0.5 * style.em) * MM), baseline)
            draw_line(ink, line, left, baseline, measure, style.align, marks)
            y -= advance
        self.colour(style.colour)
        ink.flush()
        marks.finish()


def numbered(number: str, text: str, lang: Lang, style: Style | None = None) -> Para:
    """A paragraph whose number hangs before it."""
    base = style or body(lang)
    return Para(text, replace(base, first=0.0, left=2.0), lang, number)
