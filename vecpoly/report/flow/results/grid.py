"""Cells of the box of answers: each quantity a line, in columns of one width."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import ceil

from ....algebra.formula import Node
from ....tagging.copied import copied
from ....tagging.speech import said, words_said
from ....typeset.box import Box, beside, place
from ....typeset.words import layout_words
from ....words import Lang
from ...answers.line import AnswerLine
from ..blocks import spoken
from ..cells import cells, joined
from ..formula import lines as broken
from ..lines import break_lines

MOST = 3  # columns
GUTTER = 4.0  # mm between two of them
_BLANK = 1.2  # mm between what a quantity is called and its line
_LEAD = 0.9  # mm between the lines of a cell
SMALL = 0.88  # of the type: notes on the quantities, under them


@dataclass(frozen=True, slots=True, eq=False)
class Told:
    """One answer, or one sentence, in the structure of the document; node: none of a sentence."""

    node: Node | None
    before: str = ""
    after: str = ""

    def heard(self, lang: Lang) -> str:
        """As it is read out."""
        formula = said(self.node, lang) if self.node else ""
        return " ".join(filter(None, (words_said(self.before, lang), formula, words_said(self.after, lang))))

    @property
    def plain(self) -> str:
        """As it is copied."""
        formula = copied(self.node) if self.node else ""
        return " ".join(filter(None, (spoken(self.before), formula, spoken(self.after))))


GridRow = tuple[tuple[float, Box, Told], ...]  # boxes on one base line, with their left ends (mm)


def columns(lines: Sequence[AnswerLine], em: float, room: float) -> int:
    """So many columns that no line is wider than its own; two at least, where there is more than one line, and no more
    where these take as many rows."""
    if len(lines) < 2:
        return 1
    widest, sizes = max(_head(one, em).width for one in lines), Counter(one.group for one in lines).values()
    rows = {count: sum(ceil(size / count) for size in sizes) for count in (2, MOST)}
    return MOST if rows[MOST] < rows[2] and widest <= _wide(room, MOST) else 2


def laid(lines: Sequence[AnswerLine], count: int, em: float, room: float) -> Iterator[GridRow]:
    """The lines in so many columns of this room (mm), each at the left edge of its own, in reading order."""
    wide = _wide(room, count)
    made = [(_cell(one, em, wide), Told(one.node, one.before)) for one in lines]
    for start in range(0, len(made), count):
        row = made[start : start + count]
        yield tuple((n * (wide + GUTTER), box, told) for n, (box, told) in enumerate(row))


def sentence(text: str, em: float, room: float, chinese: bool) -> Iterator[Box]:
    """A text in lines of this width (mm), no blank of which is shrunk."""
    for line in break_lines(cells(text, em, chinese), room, em, least=1.0):
        yield joined(list(line.cells), em)


def _wide(room: float, count: int) -> float:
    return (room - (count - 1) * GUTTER) / count


def _head(one: AnswerLine, em: float) -> Box:
    """What a quantity is called, and its line, unbroken."""
    ((_, box),) = broken(one.node, em, float("inf"))
    return beside((*_called(one, em), box))


def _called(one: AnswerLine, em: float) -> tuple[Box, ...]:
    return (layout_words(one.before, em), Box(_BLANK, 0.0, 0.0)) if one.before else ()


def _cell(one: AnswerLine, em: float, wide: float) -> Box:
    """The line, broken where it is too wide."""
    called = _called(one, em)
    taken = sum(box.width for box in called)
    (start, first), *rest = broken(one.node, em, wide - taken)
    return _stacked([(start, beside((*called, first))), *((taken + x, box) for x, box in rest)])


def _stacked(lines: Sequence[tuple[float, Box]]) -> Box:
    """One box of several lines, on the base line of the first."""
    y, parts = 0.0, list[tuple[float, float, Box]]()
    for n, (x, box) in enumerate(lines):
        y -= (lines[n - 1][1].descent + _LEAD + box.ascent) if n else 0.0
        parts.append((x, y, box))
    return place(parts, max(x + box.width for x, box in lines))
