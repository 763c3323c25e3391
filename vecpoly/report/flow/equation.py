"""The vector equation over its rows of directions and magnitudes, as the textbooks of 机械原理 print it."""

from __future__ import annotations

from collections.abc import Callable
from copy import copy

from ...algebra.formula import Node, Row, Sym, Vec, row, sym
from ...board.construction import EquationTable
from ...drawing.hues import hue_of
from ...foundation.slotted import dataclass
from ...tagging.speech import equation_said
from ...tagging.tag import Role, Tag
from ...tagging.tree import Open, Tree, tree_of
from ...typeset.box import MM, Box, inked
from ...typeset.canvas import Ink
from ...typeset.fonts import Face
from ...typeset.layout import layout
from ...typeset.runs import run
from ...typeset.words import layout_words
from ...words import Lang, Words, bare
from .base import Block, Tightness
from .blocks import Drawing
from .style import BODY

Inset = Callable[[float, float], Drawing | None]  # the small figure beside it, in a place so many mm wide and high

CAPTIONS = (Words("方向", "Direction"), Words("大小", "Magnitude"))
_ROW_SKIP = 1.7  # mm between the rows
_CLEAR = 5.5  # pt below the rows, however tightly they are set
_LEAST = 0.75  # how far a wide equation may be made smaller before it is broken


@dataclass(frozen=True, slots=True)
class _Column:
    """One term: the sign before it and the three things under each other, with the column's width."""

    sign: Box
    cells: tuple[Box, Box, Box]
    width: float
    texts: tuple[str, str, str]  # as they are copied


@dataclass(frozen=True, slots=True)
class _Pieces:
    """The pieces of the equation, each with the text that it is copied as."""

    tree: Tree
    tag: Tag

    def of(self, text: str) -> Open:
        """What opens such a piece."""
        return self.tree.opener(self.tag, text)


@dataclass(frozen=True, slots=True)
class _Grid:
    """The equation at one size, cut into groups of columns that fit the measure."""

    captions: tuple[Box, Box]
    margin: float
    groups: tuple[tuple[_Column, ...], ...]
    em: float


def vector(symbol: str) -> Node:
    """The symbol with an arrow, and each of those in brackets; a row (``μ_a n'n``) stays as it is."""
    if symbol.startswith("(") and symbol.endswith(")"):
        return Row(tuple(Vec(one) if isinstance(one, Sym) else one for one in row(symbol).items))
    try:
        return Vec(sym(symbol))
    except ValueError:
        return row(symbol)


class EquationFlow(Block):
    """An equation table; too wide, it is set smaller, then broken between two terms.

    inset: draws its polygon, for whoever finds a place beside it (`results/illustrated.py`).
    """

    role = Role.FORMULA
    pieces = True

    def __init__(
        self, table: EquationTable, lang: Lang = "zh", size: float = BODY.size, inset: Inset | None = None
    ) -> None:
        super().__init__(6.0, 8.0)
        self.table, self.lang, self._size, self.inset = table, lang, size, inset
        self._grids: dict[float, _Grid] = {}  # by width; one for the table and all its copies

    def alone(self) -> EquationFlow:
        """A copy without the figure."""
        own = copy(self)
        own.inset = None
        return own

    def tighten(self, degree: Tightness) -> None:
        """Its last row never so near to the line below that it looks like one more."""
        super().tighten(degree)
        self.spaceAfter = max(self.spaceAfter, _CLEAR)

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width = width
        grid = self.set_in(width)
        self.height = sum(_height(grid, group) for group in grid.groups) * MM
        self.height += (len(grid.groups) - 1) * 2 * _ROW_SKIP * MM
        return width, self.height

    def set_in(self, width: float) -> _Grid:
        """Its columns where the measure is so many points wide."""
        if width not in self._grids:
            self._grids[width] = _fit(self.table, self.lang, self._size / MM, width / MM)
        return self._grids[width]

    @property
    def reach(self) -> tuple[float, float]:
        """Where its ink begins and ends in the column (mm)."""
        grid = self.set_in(self.width)
        widest = max(_width(grid, group) for group in grid.groups)
        left = max(0.0, (self.width / MM - widest) / 2)
        return left, left + widest

    def draw(self) -> None:
        """Draw every group of columns under the other."""
        grid, ink = self.set_in(self.width), Ink(self.canv)
        left, _ = self.reach
        y = self.height / MM
        tag = Tag(Role.FORMULA, self.tag.within, _said(self.table, tree_of(self.canv).lang))
        marks = _Pieces(tree_of(self.canv), tag)
        for group in grid.groups:
            _draw(ink, marks, grid, group, left, y)
            y -= _height(grid, group) + 2 * _ROW_SKIP
        ink.flush()


def _columns(table: EquationTable, lang: Lang, em: float) -> list[_Column]:
    columns: list[_Column] = []
    rows = zip(table.symbols, table.signs, table.directions, table.magnitudes, table.tones, strict=True)
    for symbol, sign, direction, magnitude, tone in rows:
        below = (_words(direction.of(lang), em), _words(magnitude, em))
        head = layout(vector(symbol), em)
        cells = (inked(head, hue_of(tone).value) if tone else head, *below)
        texts = (f"{sign} {bare(symbol)}".strip(), bare(direction.of(lang)), bare(magnitude))
        columns.append(_Column(_sign(sign, em), cells, max(cell.width for cell in cells) + 0.3 * em, texts))
    return columns


def _words(text: str, em: float) -> Box:
    return layout_words(text, em * 0.92)


def _sign(sign: str, em: float) -> Box:
    if not sign:
        return Box(0.0, 0.0, 0.0)
    glyph = run(sign.replace("-", "−"), Face.STIX, em)
    side = 0.45 * em
    return Box(glyph.width + 2 * side, glyph.ascent, glyph.descent, tuple(glyph.moved(side, 0.0)))


def _fit(table: EquationTable, lang: Lang, em: float, width: float) -> _Grid:
    columns = _columns(table, lang, em)
    captions = (layout_words(CAPTIONS[0].of(lang), em), layout_words(CAPTIONS[1].of(lang), em))
    margin = max(caption.width for caption in captions) + em
    full = margin + sum(column.sign.width + column.width for column in columns)
    if full > width and em > _LEAST * BODY.size / MM:
        return _fit(table, lang, em * max(_LEAST, 0.99 * width / full, 0.9), width)
    return _Grid(captions, margin, _groups(columns, width - margin), em)


def _groups(columns: list[_Column], width: float) -> tuple[tuple[_Column, ...], ...]:
    groups: list[list[_Column]] = [[]]
    used = 0.0
    for column in columns:
        need = column.sign.width + column.width
        if groups[-1] and used + need > width:
            groups.append([])
            used = 0.0
        groups[-1].append(column)
        used += need
    return tuple(tuple(group) for group in groups)


def _row_metrics(grid: _Grid, group: tuple[_Column, ...], index: int) -> tuple[float, float]:
    boxes = [column.cells[index] for column in group]
    least = (0.8 * grid.em, 0.2 * grid.em)
    return max(least[0], *(b.ascent for b in boxes)), max(least[1], *(b.descent for b in boxes))


def _height(grid: _Grid, group: tuple[_Column, ...]) -> float:
    return sum(sum(_row_metrics(grid, group, i)) for i in range(3)) + 2 * _ROW_SKIP


def _width(grid: _Grid, group: tuple[_Column, ...]) -> float:
    return grid.margin + sum(column.sign.width + column.width for column in group)


def _draw(ink: Ink, marks: _Pieces, grid: _Grid, group: tuple[_Column, ...], left: float, y: float) -> None:
    for index in range(3):
        ascent, descent = _row_metrics(grid, group, index)
        y -= ascent
        if index:
            ink.under(marks.of(""))
            ink.box(grid.captions[index - 1], left * MM, y * MM)
        x = left + grid.margin
        for column in group:
            ink.under(marks.of(column.texts[index]))
            if index == 0:
                ink.box(column.sign, x * MM, y * MM)
            x += column.sign.width
            cell = column.cells[index]
            ink.box(cell, (x + (column.width - cell.width) / 2) * MM, y * MM)
            x += column.width
        y -= descent + _ROW_SKIP


def _said(table: EquationTable, lang: Lang) -> str:
    """The equation and its rows, as they are read out."""
    rows = (tuple(direction.of(lang) for direction in table.directions), table.magnitudes)
    return equation_said(table.symbols, table.signs, rows, lang)
