"""The cover of a report: what it is, what it is about, a drawing, and blanks for names; such blanks over a text."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...tagging.tag import Role, Tag, heading_of_row
from ...tagging.tree import Tree, artifact, tree_of
from ...typeset.box import MM, Box, scaled
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from .base import Block
from .blocks import Drawing, SheetPage
from .style import BODY

TITLE_FIELDS = ("班级", "姓名", "学号", "成绩", "任课教师", "批改日期")
_LABEL, _BLANK, _ROW, _LAST = 30.0, 62.0, 9.5, 34.0  # mm; of the last blank from the foot of the page
_WIDEST, _RULE = 136.0, 140.0  # mm of a title, of the rules about it
_KIND, _TITLE, _ALONE, _UNDER, _RULES = 35.0, 56.0, 63.0, 69.0, (44.5, 76.0)  # mm from the head of the page
_CLEAR = 8.0  # mm above the uppermost blank


class Cover(SheetPage):
    """A page without header or number: kind of report, title, subtitle, figure, fields with their values."""

    numbered = False

    def __init__(
        self, kind: str, title: str, subtitle: str, fields: Sequence[tuple[str, str]], figure: Drawing | None
    ) -> None:
        super().__init__(self._page)
        self.kind, self.title, self.subtitle = kind, title, subtitle
        self.fields, self.figure = tuple(fields), figure

    def draw(self) -> None:
        """Every line of it is an element, the title the heading of the document."""
        self._page(self.canv, 0.0, 0.0)

    def _page(self, canvas: Any, x: float, y: float) -> None:
        ink, tree, (width, height) = Ink(canvas), tree_of(canvas), canvas._pagesize[:2]
        top = height / MM
        under = ((self.subtitle, 4.4, top - _UNDER, Role.P),) if self.subtitle else ()
        for text, em, at, role in (
            (self.kind, 6.2, top - _KIND, Role.P),
            (self.title, 8.6, top - (_TITLE if under else _ALONE), Role.H1),
            *under,
        ):
            ink.under(tree.opener(Tag(role)))
            _centred(ink, text, em, (width / MM / 2, at), bold=text != self.subtitle)
        left = (width - _RULE * MM) / 2
        for down, heavy in zip(_RULES, (0.9, 0.45), strict=True):
            ink.rule(left, (top - down) * MM, _RULE * MM, heavy)
        if self.figure is not None:
            self.figure.wrap(width, 0.0)
            wide, high = self.figure.size
            middle = (top - _RULES[-1] + self._uppermost + _CLEAR) / 2
            self.figure.draw_bare(canvas, (width - wide) / 2, middle * MM - high / 2)
        self._fields(ink, tree, width)
        ink.flush()

    @property
    def _uppermost(self) -> float:
        """The height of the first blank (mm)."""
        return _LAST + _ROW * (len(self.fields) - 1)

    def _fields(self, ink: Ink, tree: Tree, width: float) -> None:
        left, top = (width / MM - _LABEL - _BLANK) / 2, self._uppermost
        for i, (label, value) in enumerate(self.fields):
            y = top - i * _ROW
            ink.under(tree.opener(Tag(Role.P)))
            box = layout_words(label, 4.4)
            ink.box(box, (left + _LABEL - 6.0 - box.width) * MM, y * MM)
            ink.rule((left + _LABEL) * MM, (y - 1.6) * MM, _BLANK * MM, 0.45)
            filled = _fit(layout_words(value, 4.4), value, 4.4, _BLANK, False)
            ink.box(filled, (left + _LABEL + (_BLANK - filled.width) / 2) * MM, y * MM)


def _centred(ink: Ink, text: str, em: float, at: tuple[float, float], *, bold: bool = True) -> None:
    box = _fit(layout_words(text, em, bold), text, em, _WIDEST, bold)
    ink.box(box, (at[0] - box.width / 2) * MM, at[1] * MM)


def _fit(box: Box, text: str, em: float, width: float, bold: bool) -> Box:
    """The text set smaller where it is too wide."""
    return box if box.width <= width else layout_words(text, em * width / box.width, bold)


class TitleBlock(Block):
    """A ruled box of labelled blanks, filled where a value is known."""

    role = Role.TABLE
    pieces = True

    def __init__(self, fields: Sequence[tuple[str, str]], columns: int = 3) -> None:
        super().__init__(2.0, 8.0)
        self.fields, self.columns = tuple(fields), columns

    _ROW = 8.0 * MM

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width = width
        self.height = self._ROW * -(-len(self.fields) // self.columns)
        return width, self.height

    def draw(self) -> None:
        """Draw the frame, then labels and values row by row."""
        canv, step = self.canv, self.width / self.columns
        labels = [layout_words(label, BODY.em) for label, _ in self.fields]
        room = [max((box.width for box in labels[i :: self.columns]), default=0.0) + 4.0 for i in range(self.columns)]
        with artifact(canv):
            self._ruled(step, room)
        ink, row = Ink(canv), Tag(Role.ROW, self.tag)
        for i, (box, (_, value)) in enumerate(zip(labels, self.fields, strict=True)):
            down, column = divmod(i, self.columns)
            row = row if column else Tag(Role.ROW, self.tag)
            y = self.height - (down + 0.5) * self._ROW - 0.36 * BODY.size
            left, edge = column * step, column * step + room[column] * MM
            self._under(ink, heading_of_row(row))
            ink.box(box, left + (edge - left - box.width * MM) / 2, y)
            self._under(ink, Tag(Role.CELL, row))
            ink.box(_within(layout_words(value, BODY.em), left + step - edge - 3.0 * MM), edge + 2.0 * MM, y)
        ink.flush()

    def _under(self, ink: Ink, tag: Tag) -> None:
        tree_of(self.canv).element(tag)  # an empty blank is one too
        ink.under(tree_of(self.canv).opener(tag))

    def _ruled(self, step: float, room: Sequence[float]) -> None:
        """Rules between rows and columns, and a heavy one around."""
        canv = self.canv
        canv.setLineWidth(0.4)
        for i in range(1, -(-len(self.fields) // self.columns)):
            canv.line(0.0, i * self._ROW, self.width, i * self._ROW)
        for column, wide in enumerate(room):
            for x in (column * step, column * step + wide * MM):
                if x:
                    canv.line(x, 0.0, x, self.height)
        canv.setLineWidth(0.9)
        canv.rect(0.0, 0.0, self.width, self.height)


def _within(box: Box, width: float) -> Box:
    """The box, made smaller if it is wider than `width` (pt)."""
    factor = min(1.0, width / MM / box.width) if box.width else 1.0
    return box if factor == 1.0 else scaled(box, factor)
