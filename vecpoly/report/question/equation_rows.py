"""Rows in which a vector equation is written by hand, term by term, with its signs between: as many cells as any
equation of its kind has terms, so that nothing tells how many this one has, on which side the unknown stands, or
whether there is a Coriolis term."""

from __future__ import annotations

from collections.abc import Sequence

from ...board.construction import Pane, Step, View
from ...solution import Solution
from ...tagging.tree import artifact, marked
from ...typeset.box import MM, Box
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.style import CELL, GREY, PALE
from .equations import equated
from .kinds import kinds
from .ruled import FAINT

_CAPTIONS = (
    Words("方程", "Equation"),
    Words("方向", "Direction"),
    Words("大小", "Magnitude"),
    Words("图上长度 /mm", "On paper /mm"),
)
_ROWS = len(_CAPTIONS)
_ROW, _TITLE = 8.0 * MM, 6.5 * MM
_BASE = (_ROW - CELL.size) / 2 + 1.5  # of type in a row
MOVING = {View.VELOCITY: 5, View.ACCELERATION: 7}  # cells, unless an equation of the kind has more terms than that
SUMMED = 5  # likewise of a sum of forces
_SIGN = 5.0 * MM  # width of the column for the sign behind a term


class EquationRows(Block):
    """A vector equation to be written term by term, the signs in narrow columns between, with the direction, the
    magnitude and the length on paper of each term below; over it, what it is for."""

    pieces = True

    def __init__(self, number: int, purpose: str, lang: Lang, *, cells: int = SUMMED) -> None:
        super().__init__(4.0, 7.0)
        self._number, self.purpose, self._lang, self.cells = number, purpose, lang, cells

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, _ROWS * _ROW + _TITLE
        return width, self.height

    def draw(self) -> None:
        """The name, the captions, the cells to write in."""
        ink, start = Ink(self.canv), self._start
        ink.box(self._name, 0.0, _ROWS * _ROW + 1.8 * MM)
        for row, words in enumerate(reversed(_CAPTIONS)):
            ink.box(layout_words(words.of(self._lang), CELL.em), 2.0 * MM, row * _ROW + _BASE)
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

    def _cells(self, start: float) -> None:
        """A closed frame with full lines, pale ones between the terms; a sign between two of them has the row of the
        equation alone."""
        self.colour(PALE)
        self.canv.setLineWidth(0.4)
        wide, top = self.term, _ROWS * _ROW
        self.canv.setFillColorRGB(*FAINT)
        for n in range(1, self.cells):
            end = start + n * (wide + _SIGN)
            self.canv.line(end - _SIGN, 0.0, end - _SIGN, top)
            self.canv.line(end, 0.0, end, top)
            self.canv.rect(end - _SIGN, 0.0, _SIGN, top - _ROW, stroke=0, fill=1)
        self.colour(GREY)
        for row in range(_ROWS + 1):
            self.canv.setLineWidth(0.9 if row in (0, _ROWS) else 0.4)
            self.canv.line(0.0, row * _ROW, self.width, row * _ROW)
        for edge in (0.0, start, self.width):
            self.canv.line(edge, 0.0, edge, top)

    @property
    def term(self) -> float:
        """How wide the cell of a term is."""
        return (self.width - self._start + _SIGN) / self.cells - _SIGN


def equation_rows(solution: Solution, lang: Lang) -> list[EquationRows]:
    """Cells for the terms of each equation that the solution has, with its kind and the part of the analysis that it
    belongs to."""
    drawn = solution.construction
    needed = equated(drawn)
    told = zip(needed, kinds(needed, lang, drawn.figures), strict=True)
    return [EquationRows(n, purpose, lang, cells=_cells_of(step, needed)) for n, (step, purpose) in enumerate(told, 1)]


def _cells_of(step: Step, needed: Sequence[Step]) -> int:
    """As many for each equation of a kind: velocities, accelerations, or sums of forces, mass-radius products, couples;
    wide ones for velocities, which have few terms."""
    kind = _kind(step)
    alike = [one.equation for one in needed if _kind(one) is kind]
    fewest = SUMMED if kind is None else MOVING[kind]
    return max([fewest, *(len(one.symbols) for one in alike if one is not None)])


def _kind(step: Step) -> View | None:
    """Whether an equation is one of velocities or of accelerations; None of what is summed."""
    view = step.view.view if isinstance(step.view, Pane) else step.view
    return view if view in MOVING else None
