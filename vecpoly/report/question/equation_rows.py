"""Rows in which a vector equation is written by hand, term by term: as many cells as it has terms."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...board.construction import EquationTable
from ...problem.asked.asks import AskCoriolis
from ...solution import Solution
from ...tagging.tree import artifact, marked
from ...typeset.box import MM, Box
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.furniture import COLUMN
from ..flow.style import CELL, GREY, PALE
from .kinds import kinds

_CAPTIONS = (
    Words("方程", "Equation"),
    Words("方向", "Direction"),
    Words("大小", "Magnitude"),
    Words("图上长度 /mm", "On paper /mm"),
)
_ROWS = len(_CAPTIONS)
_ROW, _TITLE = 8.0 * MM, 6.5 * MM
_BASE = (_ROW - CELL.size) / 2 + 1.5  # of type in a row
_BALANCE = "= 0"
# where it is asked whether there is a Coriolis term the cells must not tell it: as many as any equation of motion needs
_OPEN = 7
_SPARE = Words("符号自填，用不到的格空着", "put in the signs; leave blank what is not needed")
_APART, _NARROWEST = 6.0 * MM, 16.0 * MM  # between two equations side by side; of a cell there


class EquationRows(Block):
    """A vector equation to be written term by term, in columns with the signs between them, with the direction, the
    magnitude and the length on paper of each below; over it, what it is for.

    signs: between its terms, none of an equation whose number of terms is asked; balance: its right side is zero, as
    that of forces.
    """

    pieces = True

    def __init__(self, number: int, purpose: str, lang: Lang, *, signs: Sequence[str], balance: bool = False) -> None:
        super().__init__(4.0, 7.0)
        self._number, self.purpose, self._lang = number, purpose, lang
        self.signs: tuple[str, ...] = tuple(signs)
        self._end = layout_words(_BALANCE, CELL.em) if balance else None

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, _ROWS * _ROW + _TITLE
        return width, self.height

    def pairs(self, width: float) -> bool:
        """Whether its cells and its name have room in this width."""
        return self._step(width) >= _NARROWEST and self._name.width * MM <= width and any(self.signs)

    def draw(self) -> None:
        """The name, the captions, the cells to write in."""
        ink, start = Ink(self.canv), self._start
        ink.box(self._name, 0.0, _ROWS * _ROW + 1.8 * MM)
        for row, words in enumerate(reversed(_CAPTIONS)):
            ink.box(layout_words(words.of(self._lang), CELL.em), 2.0 * MM, row * _ROW + _BASE)
        if not any(self.signs):
            spare = layout_words(_SPARE.of(self._lang), CELL.em)
            ink.box(spare, self.width - spare.width * MM, _ROWS * _ROW + 1.8 * MM)
        self._signs(ink, start)
        with marked(self.canv, self.tag):
            ink.flush()
        with artifact(self.canv):
            self._cells(start)

    @property
    def _name(self) -> Box:
        return layout_words(f"({self._number})　{self.purpose}", CELL.em)

    @property
    def _start(self) -> float:
        """Where the cells begin."""
        return max(layout_words(words.of(self._lang), CELL.em).width for words in _CAPTIONS) * MM + 4.0 * MM

    def _step(self, width: float) -> float:
        """The width of a column; what is printed at the end has its own room."""
        end = 0.0 if self._end is None else self._end.width * MM + 4.0 * MM
        return (width - self._start - end) / (len(self.signs) + 1)

    def _signs(self, ink: Ink, start: float) -> None:
        """Between the terms of the equation, and at its end."""
        for n, sign in enumerate(self.signs, 1):
            box = layout_words(sign, CELL.em)
            ink.box(box, start + n * self._step(self.width) - box.width * MM / 2, (_ROWS - 1) * _ROW + _BASE)
        if self._end is not None:
            ink.box(self._end, self.width - self._end.width * MM - 2.0 * MM, (_ROWS - 1) * _ROW + _BASE)

    def _cells(self, start: float) -> None:
        """A frame with full lines, and pale ones between the terms."""
        step = self._step(self.width)
        self.colour(PALE)
        self.canv.setLineWidth(0.4)
        for n in range(1, len(self.signs) + 2):
            top = (_ROWS - (n <= len(self.signs))) * _ROW  # in the row of the equation stand the signs
            if start + n * step < self.width - 1.0:
                self.canv.line(start + n * step, 0.0, start + n * step, top)
        self.colour(GREY)
        for row in range(_ROWS + 1):
            self.canv.setLineWidth(0.9 if row in (0, _ROWS) else 0.4)
            self.canv.line(0.0, row * _ROW, self.width, row * _ROW)
        self.canv.line(start, 0.0, start, _ROWS * _ROW)


class SideBySide(Block):
    """Two short equations on one line."""

    pieces = True

    def __init__(self, left: EquationRows, right: EquationRows) -> None:
        super().__init__(left.spaceBefore, left.spaceAfter)
        self.parts = left, right

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width, half of which each has."""
        self.width = width
        self.height = max(part.wrap((width - _APART) / 2, height)[1] for part in self.parts)
        return width, self.height

    def draw(self) -> None:
        """The one beside the other."""
        for part, left in zip(self.parts, (0.0, (self.width + _APART) / 2), strict=True):
            part.drawOn(self.canv, left, 0.0)


def equation_rows(solution: Solution, lang: Lang) -> list[EquationRows]:
    """Cells for the terms of each equation that the solution has, with its kind and the part of the analysis that it
    belongs to."""
    drawn = solution.construction
    needed = [step for step in drawn.steps if step.equation is not None]
    free = any(isinstance(ask, AskCoriolis) for ask in solution.problem.asks)
    equations = [step.equation for step in needed if step.equation is not None]
    told = zip(kinds(needed, lang, drawn.figures), equations, strict=True)
    return [_row(n, purpose, one, lang, free=free) for n, (purpose, one) in enumerate(told, 1)]


def _row(number: int, purpose: str, one: EquationTable, lang: Lang, *, free: bool) -> EquationRows:
    """The cells of an equation; free: of an acceleration as many as there may be, without signs."""
    if free and one.symbols[0].startswith("a"):
        return EquationRows(number, purpose, lang, signs=("",) * (_OPEN - 1))
    balance = _is_balance(one)
    return EquationRows(number, purpose, lang, signs=one.signs[1 : -1 if balance else None], balance=balance)


def laid(rows: Sequence[EquationRows]) -> Iterator[Block]:
    """The rows as they stand on the page: short ones that follow each other side by side."""
    waiting = [*rows]
    while waiting:
        two = waiting[:2]
        if len(two) == 2 and all(one.pairs((COLUMN - _APART) / 2) for one in two):
            yield SideBySide(*two)
            del waiting[:2]
        else:
            yield waiting.pop(0)


def _is_balance(one: EquationTable) -> bool:
    """Whether its terms add up to nothing, as forces and mass–radius products do."""
    return (one.signs[-1], one.symbols[-1]) == ("=", "0")
