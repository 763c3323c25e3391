"""Rows in which a vector equation is written by hand, term by term."""

from __future__ import annotations

from ...board.construction import Step
from ...solution import Solution
from ...tagging.tree import artifact, marked
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
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
# the signs between the columns to write in, the same for every equation: it tells no number of terms
_MOTION, _BALANCE, _NOTHING = ("=", "+", "=", "+", "+", "+"), ("+", "+", "+", "+", "+"), "= 0"
_SPARE = Words("用不到的格空着", "leave blank what is not needed")


class EquationRows(Block):
    """A vector equation to be written term by term, in columns with the signs between them, with the direction, the
    magnitude and the length on paper of each below; over it, what it is for. balance: its right side is zero, as that
    of forces."""

    pieces = True

    def __init__(self, number: int, purpose: str, lang: Lang, *, balance: bool = False) -> None:
        super().__init__(4.0, 7.0)
        self._number, self.purpose, self._lang = number, purpose, lang
        self.signs: tuple[str, ...] = _BALANCE if balance else _MOTION
        self._end = layout_words(_NOTHING, CELL.em) if balance else None

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, _ROWS * _ROW + _TITLE
        return width, self.height

    def draw(self) -> None:
        """The name, the captions, the cells to write in."""
        ink, captions = Ink(self.canv), [layout_words(words.of(self._lang), CELL.em) for words in _CAPTIONS]
        start = max(box.width for box in captions) * MM + 4.0 * MM
        ink.box(layout_words(f"({self._number})　{self.purpose}", CELL.em), 0.0, _ROWS * _ROW + 1.8 * MM)
        for row, box in enumerate(reversed(captions)):
            ink.box(box, 2.0 * MM, row * _ROW + _BASE)
        if self._number == 1:
            spare = layout_words(_SPARE.of(self._lang), CELL.em)
            ink.box(spare, self.width - spare.width * MM, _ROWS * _ROW + 1.8 * MM)
        self._signs(ink, start)
        with marked(self.canv, self.tag):
            ink.flush()
        with artifact(self.canv):
            self._cells(start)

    def _step(self, start: float) -> float:
        """The width of a column; what is printed at the end has its own room."""
        end = 0.0 if self._end is None else self._end.width * MM + 4.0 * MM
        return (self.width - start - end) / (len(self.signs) + 1)

    def _signs(self, ink: Ink, start: float) -> None:
        """Between the terms of the equation, and at its end."""
        for n, sign in enumerate(self.signs, 1):
            box = layout_words(sign, CELL.em)
            ink.box(box, start + n * self._step(start) - box.width * MM / 2, (_ROWS - 1) * _ROW + _BASE)
        if self._end is not None:
            ink.box(self._end, self.width - self._end.width * MM - 2.0 * MM, (_ROWS - 1) * _ROW + _BASE)

    def _cells(self, start: float) -> None:
        """A frame with full lines, and pale ones between the terms."""
        step = self._step(start)
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


def equation_rows(solution: Solution, lang: Lang) -> list[EquationRows]:
    """Cells for as many equations as the solution has, each with its kind and the part of the analysis that it belongs
    to."""
    drawn = solution.construction
    needed = [step for step in drawn.steps if step.equation is not None]
    return [
        EquationRows(n, told, lang, balance=_is_balance(step))
        for n, (told, step) in enumerate(zip(kinds(needed, lang, drawn.figures), needed, strict=True), 1)
    ]


def _is_balance(step: Step) -> bool:
    """Whether its terms add up to nothing, as forces and mass–radius products do."""
    return step.equation is not None and (step.equation.signs[-1], step.equation.symbols[-1]) == ("=", "0")
