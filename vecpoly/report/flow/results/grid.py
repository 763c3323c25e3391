"""Cells of the box of answers: each quantity a line, one under the other in two or three columns, all rows alike."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import accumulate, groupby
from math import ceil

from ....algebra.formula import Node
from ....foundation.slotted import replace
from ....tagging.copied import copied
from ....tagging.speech import said, words_said
from ....typeset.box import Box, beside, place
from ....typeset.words import layout_words
from ....words import Lang
from ...answers.line import AnswerLine
from ..blocks import spoken
from ..cells import cells, joined
from ..formula import lines as broken
from ..text.breaks import break_lines

MOST = 3  # columns
GUTTER, NARROW = 12.0, 5.0  # mm between two of them, and where they would have no room else
_BLANK = 1.2  # mm between what a quantity is called and its line
_LEAD = 0.9  # mm between the lines of a cell


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


Placed = tuple[Box, Told]
GridRow = tuple[tuple[float, Box, Told], ...]  # boxes on one base line, with their left ends (mm)


def columns(parts: Sequence[Sequence[AnswerLine]], em: float, room: float) -> tuple[float, ...]:
    """The left edges of three columns, or of two where these take as many rows, each as wide as its widest line; of one
    where a line would be broken in more."""
    wide = [[_head(one, em).width for one in part] for part in parts]
    rows = {count: sum(ceil(len(part) / count) for part in wide) for count in range(1, MOST + 1)}
    for count in range(MOST, 1, -1):
        if rows[count] == rows[count - 1]:
            continue
        widths = [max(column, default=0.0) for column in zip(*(_widest(part, count) for part in wide), strict=True)]
        white = room - sum(widths)
        if white >= (count - 1) * NARROW:
            gutter = min(GUTTER, white / (count - 1))
            return tuple(accumulate((width + gutter for width in widths[:-1]), initial=0.0))
    return (0.0,)


def _widest(widths: Sequence[float], count: int) -> list[float]:
    """Of lines that run down so many columns: the widest in each."""
    rows = ceil(len(widths) / count)
    return [max(widths[n * rows : (n + 1) * rows], default=0.0) for n in range(count)]


def laid(lines: Sequence[AnswerLine], edges: Sequence[float], em: float, room: float) -> Iterator[GridRow]:
    """The lines down the columns with these left edges, in so much room (mm)."""
    wide = room if len(edges) == 1 else float("inf")
    return gridded([(_cell(one, em, wide), Told(one.node, one.before)) for one in lines], edges)


def gridded(cells: Sequence[Placed], edges: Sequence[float]) -> Iterator[GridRow]:
    """What is read down one column after the other, in rows."""
    rows = ceil(len(cells) / len(edges))
    for n in range(rows):
        yield tuple((x, *placed) for x, placed in zip(edges, cells[n::rows], strict=False))


def in_reading_order(rows: Sequence[GridRow]) -> Iterator[tuple[int, float, Box, Told]]:
    """What stands in these rows with the number of its row: quantities down one column after the other."""
    numbered = groupby(enumerate(rows), key=lambda row: row[1][0][2].node is not None)
    for block in (tuple(some) for _, some in numbered):
        for column in range(max(len(row) for _, row in block)):
            yield from ((n, *row[column]) for n, row in block if column < len(row))


def even(rows: Sequence[GridRow], lines: Iterable[AnswerLine], em: float) -> Iterator[GridRow]:
    """The rows, none lower than the highest of them but for what is broken: of one height where nothing is."""
    whole = [_head(one, em) for one in lines] + [box for row in rows for _, box, told in row if told.node is None]
    up, down = max((box.ascent for box in whole), default=0.0), max((box.descent for box in whole), default=0.0)
    for row in rows:
        yield tuple((x, _raised(box, up, down), told) for x, box, told in row)


def _raised(box: Box, up: float, down: float) -> Box:
    return replace(box, ascent=max(box.ascent, up), descent=max(box.descent, down))


@lru_cache(maxsize=4096)
def sentence(text: str, em: float, room: float, chinese: bool) -> tuple[Box, ...]:
    """A text in lines of this width (mm), no blank of which is shrunk."""
    lines = break_lines(cells(text, em, chinese), room, em, least=1.0)
    return tuple(joined(list(line.cells), em) for line in lines)


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
