"""The box that ends a problem: a framed list of what was asked, side by side as far as there is room."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from math import ceil

from ....algebra.formula import Node
from ....tagging.copied import copied
from ....tagging.speech import said, words_said
from ....tagging.tag import Role, Tag
from ....tagging.tree import artifact, tree_of
from ....typeset.box import MM, Box, beside
from ....typeset.canvas import Ink
from ....typeset.words import layout_words
from ....words import Lang, Words
from ...answers.line import AnswerLine
from ..base import Block, Tightness
from ..blocks import spoken
from ..cells import cells, joined
from ..formula import lines as broken
from ..lines import break_lines
from ..style import CELL

TITLE = Words("答", "Answer")
_PAD, _SKIP, _GAP = 2.6, 1.7, 1.5  # mm: inside the frame, between rows, beside a line
_AFTER_TITLE = 3.0  # mm
_BLANK = 1.5  # mm: between a line and what is said after it
_STOPS = 4  # where a line may begin, in equal steps
WHOLE = 75.0 * MM  # a box no taller than this is not parted
_APART = 1.2  # mm between two kinds of quantity
_LEAST = 3  # rows that a page break leaves together
_FRAME = 0.6  # pt


@dataclass(frozen=True, slots=True, eq=False)
class _Told:
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


_Row = tuple[tuple[float, Box, _Told], ...]  # boxes on one base line, with their left ends (mm)
_Item = tuple[tuple[Box, ...], _Told]  # the lines of one answer


class AnswerBox(Block):
    """lines: one a quantity; said: sentences that are answers of their own."""

    role = Role.DIV
    pieces = True

    def __init__(self, lines: Sequence[AnswerLine], said: Sequence[str] = (), lang: Lang = "zh") -> None:
        super().__init__(7.0, 8.0)
        self.lines, self.said, self.lang = tuple(lines), tuple(said), lang
        self._em, self._skip = CELL.em, _SKIP
        self._title = layout_words(TITLE.of(lang), self._em, True)
        self._rows: tuple[_Row, ...] = ()
        self._named = _Told(None, after=TITLE.of(lang))
        self._set_in: dict[tuple[float, float], tuple[bool, tuple[_Row, ...]]] = {}  # by width and skip; for all copies
        self._above = False  # whether the title stands above the lines
        self._set = False  # a part of a box keeps the rows that it was given

    def tighten(self, degree: Tightness) -> None:
        """Rows closer too."""
        super().tighten(degree)
        self._skip = degree.white * _SKIP

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column: the title in the margin, or above where that takes less height."""
        self.width = width
        if not self._set:
            key = (width, self._skip)
            if key not in self._set_in:
                self._set_in[key] = self._best(width / MM - 2 * _PAD)
            self._above, self._rows = self._set_in[key]
        self.height = (self._high(self._rows) + 2 * _PAD) * MM
        return width, self.height

    def _best(self, room: float) -> tuple[bool, tuple[_Row, ...]]:
        """Whether the title stands above, and the rows, in a frame of this width (mm) inside."""
        beside_it, under = self._laid(room, False), self._laid(room, True)
        above = self._high(under) < self._high(beside_it)
        return above, under if above else beside_it

    def _high(self, rows: Sequence[_Row]) -> float:
        return sum(map(_height, rows)) + self._skip * (len(rows) - 1)

    def _laid(self, width: float, above: bool) -> tuple[_Row, ...]:
        """The rows in a frame of this width (mm) inside."""
        room = width if above else width - self._title.width - _AFTER_TITLE
        title: tuple[_Row, ...] = (((0.0, self._title, self._named),),) if above else ()
        return (*title, *self._grouped(room), *self._sentences(room))

    def _grouped(self, room: float) -> Iterator[_Row]:
        """The rows of each kind of quantity, a little white before each but the first."""
        for number, (_, lines) in enumerate(groupby(self.lines, key=lambda one: one.group)):
            first, *rest = _grid(list(_items(tuple(lines), self._em, room)), room)
            yield _lower(first) if number else first
            yield from rest

    def _sentences(self, room: float) -> Iterator[_Row]:
        for text in self.said:
            told = _Told(None, after=text)
            for line in break_lines(cells(text, self._em, self.lang == "zh"), room, self._em):
                yield ((0.0, joined(list(line.cells), self._em), told),)

    def split(self, width: float, height: float) -> list[Block]:
        """Whole answers to each page, of a box too tall to be kept together."""
        if self.wrap(width, height)[1] <= WHOLE:
            return []
        used, count = 2 * _PAD, 0
        room = (height - self.getSpaceBefore()) / MM  # the frame may leave that out here and ask for it of the part
        while count < len(self._rows) and used + _height(self._rows[count]) <= room:
            used += _height(self._rows[count]) + self._skip
            count += 1
        count = min(count, len(self._rows) - _LEAST)
        while count > 0 and self._rows[count][0][2] is self._rows[count - 1][-1][2]:
            count -= 1
        if count < _LEAST:
            return []
        return [self._part(self._rows[:count], True), self._part(self._rows[count:], False)]

    def _part(self, rows: tuple[_Row, ...], first: bool) -> AnswerBox:
        part = AnswerBox((), (), self.lang)
        part._rows, part._skip, part._set, part._above = rows, self._skip, True, self._above
        if not first:
            part._title = replace(self._title, items=())
        return part.made_of(self, first=first)

    def draw(self) -> None:
        """Draw the frame, the title in its margin, and the rows."""
        with artifact(self.canv):
            self.canv.setLineWidth(_FRAME)
            self.canv.rect(0.0, 0.0, self.width, self.height)
        ink, y, last = Ink(self.canv), self.height / MM - _PAD, None
        margin = 0.0 if self._above else self._title.width + _AFTER_TITLE
        for number, row in enumerate(self._rows):
            base = y - max(box.ascent for _, box, _ in row)
            if not number and not self._above:
                self._tell(ink, self._named)
                ink.box(self._title, _PAD * MM, base * MM)
            for x, box, told in row:
                if told is not last:
                    self._tell(ink, told)
                    last = told
                ink.box(box, (_PAD + margin + x) * MM, base * MM)
            y -= _height(row) + self._skip
        ink.flush()

    def _tell(self, ink: Ink, told: _Told) -> None:
        """What follows is this answer."""
        heard = told.heard(self.lang) if told.node else ""
        tag = Tag(Role.FORMULA if told.node else Role.P, self.tag, heard)
        ink.under(tree_of(self.canv).opener(tag, told.plain))


def _items(answers: Sequence[AnswerLine], em: float, room: float) -> Iterator[_Item]:
    """Each answer as the boxes of its lines."""
    for one in answers:
        yield tuple(_lines(one, em, room)), _Told(one.node, one.before, one.after)


def _lines(one: AnswerLine, em: float, room: float) -> list[Box]:
    """What it is called, the line itself, and what is said after it."""
    before = (layout_words(f"{one.before} ", em), Box(_BLANK, 0.0, 0.0)) if one.before else ()
    parts = [Box(x + box.width, box.ascent, box.descent, tuple(box.moved(x, 0.0))) for x, box in _broken(one, em, room)]
    parts[0] = beside((*before, parts[0]))
    if not one.after:
        return parts
    after = layout_words(one.after, em * 0.92)
    if parts[-1].width + 2 * _BLANK + after.width <= room:
        return [*parts[:-1], beside((parts[-1], Box(2 * _BLANK, 0.0, 0.0), after))]
    return [*parts, *_folded(one.after, em * 0.92, room)]


def _broken(one: AnswerLine, em: float, room: float) -> tuple[tuple[float, Box], ...]:
    taken = layout_words(f"{one.before} ", em).width + _BLANK if one.before else 0.0
    return broken(one.node, em, room - taken)


def _folded(text: str, em: float, room: float) -> Iterator[Box]:
    """What is said after a line, under it and a little in."""
    chinese = any(char >= "\u2e80" for char in text)
    for line in break_lines(cells(text, em, chinese), room - 2 * em, em):
        yield beside((Box(2 * em, 0.0, 0.0), joined(list(line.cells), em)))


def _grid(items: Sequence[_Item], room: float) -> Iterator[_Row]:
    """The items in reading order, each at a quarter of the width, side by side as far as there is room."""
    pitch = room / _STOPS
    row: list[tuple[float, Box, _Told]] = []
    stop = 0
    for boxes, told in items:
        takes = _STOPS if len(boxes) > 1 else min(_STOPS, ceil((boxes[0].width + _GAP) / pitch))
        if row and stop + takes > _STOPS:
            yield tuple(row)
            row, stop = [], 0
        row.append((stop * pitch, boxes[0], told))
        stop += takes
        for box in boxes[1:]:
            yield tuple(row)
            row = [(0.0, box, told)]
    if row:
        yield tuple(row)


def _lower(row: _Row) -> _Row:
    """The row with white over it."""
    return tuple((x, replace(box, ascent=box.ascent + _APART), told) for x, box, told in row)


def _height(row: _Row) -> float:
    return max(box.ascent for _, box, _ in row) + max(box.descent for _, box, _ in row)
