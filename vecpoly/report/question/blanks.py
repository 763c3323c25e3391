"""What is filled in by hand: rows for a vector equation, and the table of results."""

from __future__ import annotations

from ...solution import Answer, Solution
from ...tagging.tree import artifact, marked
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.style import BODY, GREY
from ..flow.table import DataTable
from ..values import called

_HEAD = {
    "zh": ("量", "图上长度 /mm", "数值与单位", "方向（转向）"),
    "en": ("Quantity", "On paper, mm", "Value with unit", "Direction, sense"),
}
_WIDTHS = (40.0, 34.0, 48.0, 40.0)
_NONE = "—"
_BLANK = "＿" * 8
_CAPTIONS = (Words("方程", "Equation"), Words("方向", "Direction"), Words("大小", "Magnitude"))
_ROW = 9.0 * MM


class EquationRows(Block):
    """Three ruled rows in which a vector equation is written, with directions and magnitudes under its terms."""

    pieces = True

    def __init__(self, number: int, lang: Lang) -> None:
        super().__init__(4.0, 6.0)
        self._number, self._lang = number, lang

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, 3 * _ROW
        return width, self.height

    def draw(self) -> None:
        """The captions, and a line to write on in each row."""
        ink = Ink(self.canv)
        named = [layout_words(words.of(self._lang), BODY.em) for words in _CAPTIONS]
        number = layout_words(f"({self._number})", BODY.em)
        left = 9.0 * MM
        start = left + max(box.width for box in named) * MM + 2.5 * MM
        ink.box(number, 0.0, 2 * _ROW + 1.5 * MM)
        for row, box in enumerate(reversed(named)):
            ink.box(box, left, row * _ROW + 1.5 * MM)
        with marked(self.canv, self.tag):
            ink.flush()
        self.colour(GREY)
        self.canv.setLineWidth(0.4)
        with artifact(self.canv):
            for row in range(3):
                self.canv.line(start, row * _ROW, self.width, row * _ROW)


def equation_rows(solution: Solution, lang: Lang) -> list[EquationRows]:
    """Rows for as many equations as the solution has."""
    count = sum(step.equation is not None for step in solution.construction.steps)
    return [EquationRows(n, lang) for n in range(1, count + 1)]


def empty_table(solution: Solution, lang: Lang) -> DataTable:
    """What is asked, with room for what is read, what it comes to, and where it points."""
    asked = list(solution.answers.values())
    read = any(answer.reading.mm is not None for answer in asked)
    kept = [i for i, shown in enumerate((True, read, True, any(map(_points, asked)))) if shown]
    rows = [
        [
            (called(one.reading.symbol, one.reading.key, lang), _BLANK, _BLANK, _BLANK if _points(one) else _NONE)[i]
            for i in kept
        ]
        for one in asked
    ]
    return DataTable([_HEAD[lang][i] for i in kept], rows, [_WIDTHS[i] for i in kept], "lccc"[: len(kept)], lang=lang)


def _points(answer: Answer) -> bool:
    """Whether it has a direction or a sense: a moment of inertia has none."""
    return answer.drawn_vector is not None or answer.turns


def working_room(solution: Solution) -> float:
    """How much room the work needs, mm: more for a step with an equation or a formula than for a line ruled."""
    return float(
        sum(14 if step.formulas or step.equation or step.listing else 6 for step in solution.construction.steps)
    )
