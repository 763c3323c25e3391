"""The cover of a report: what it is, what it is about, a drawing, and blanks for names."""

from __future__ import annotations

from collections.abc import Sequence

from ...tagging.tag import Role, Tag
from ...tagging.tree import Tree, tree_of
from ...typeset.box import MM, Box
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from .blocks import Drawing, SheetPage

_PAGE = (210.0, 297.0)  # mm
_LABEL, _BLANK, _ROW = 30.0, 62.0, 11.0  # mm
_WIDEST = 160.0  # mm of a title


class Cover(SheetPage):
    """A page without header or number: kind of report, title, subtitle, figure, fields with their values."""

    def __init__(
        self, kind: str, title: str, subtitle: str, fields: Sequence[tuple[str, str]], figure: Drawing | None
    ) -> None:
        super().__init__(self._page)
        self.kind, self.title, self.subtitle = kind, title, subtitle
        self.fields, self.figure = tuple(fields), figure

    def draw(self) -> None:
        """Every line of it is an element, the title the heading of the document."""
        self._page(self.canv, 0.0, 0.0)

    def _page(self, canvas: object, x: float, y: float) -> None:
        ink, tree = Ink(canvas), tree_of(canvas)
        for text, em, at, role in (
            (self.kind, 6.2, 247.0, Role.P),
            (self.title, 8.6, 226.0, Role.H1),
            (self.subtitle, 4.4, 213.0, Role.P),
        ):
            ink.under(tree.opener(Tag(role)))
            _centred(ink, text, em, at, bold=at > 220.0)
        ink.rule(35 * MM, 237.5 * MM, 140 * MM, 0.9)
        ink.rule(35 * MM, 206.0 * MM, 140 * MM, 0.45)
        if self.figure is not None:
            self.figure.wrap(_PAGE[0] * MM, 0.0)
            width, height = self.figure.size
            self.figure.draw_bare(canvas, (_PAGE[0] * MM - width) / 2, (147.0 * MM) - height / 2)
        self._fields(ink, tree)
        ink.flush()

    def _fields(self, ink: Ink, tree: Tree) -> None:
        left, top = (_PAGE[0] - _LABEL - _BLANK) / 2, 34.0 + _ROW * (len(self.fields) - 1)
        for i, (label, value) in enumerate(self.fields):
            y = top - i * _ROW
            ink.under(tree.opener(Tag(Role.P)))
            box = layout_words(label, 4.4)
            ink.box(box, (left + _LABEL - 6.0 - box.width) * MM, y * MM)
            ink.rule((left + _LABEL) * MM, (y - 1.6) * MM, _BLANK * MM, 0.45)
            filled = _fit(layout_words(value, 4.4), value, 4.4, _BLANK, False)
            ink.box(filled, (left + _LABEL + (_BLANK - filled.width) / 2) * MM, y * MM)


def _centred(ink: Ink, text: str, em: float, y: float, *, bold: bool = True) -> None:
    box = _fit(layout_words(text, em, bold), text, em, _WIDEST, bold)
    ink.box(box, (_PAGE[0] - box.width) / 2 * MM, y * MM)


def _fit(box: Box, text: str, em: float, width: float, bold: bool) -> Box:
    """The text set smaller where it is too wide."""
    return box if box.width <= width else layout_words(text, em * width / box.width, bold)
