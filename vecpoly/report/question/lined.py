"""Lines to write words on: for each numbered question of a statement, which no cell of a table has room for."""

from __future__ import annotations

import re

from ...tagging.tree import artifact, marked
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.base import Block
from ..flow.blocks import Heading
from ..flow.style import BODY, GREY

_TITLE = Words("回答", "Answers")
_QUESTION = re.compile(r"\((\d)\)[^?？]*[?？]")
_EACH, _LINE, _INDENT = 2, 9.0 * MM, 8.0 * MM  # lines for a question; from one to the next; behind its number
_RISE = 1.5 * MM  # of a number over its line


class Lined(Block):
    """Two lines for the answer to each of these questions, by its number."""

    pieces = True

    def __init__(self, numbers: tuple[str, ...]) -> None:
        super().__init__(2.0, 6.0)
        self.numbers = numbers

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, len(self.numbers) * _EACH * _LINE
        return width, self.height

    def draw(self) -> None:
        """The numbers, each before its first line."""
        ink = Ink(self.canv)
        rows = [self.height - (n + 1) * _LINE for n in range(len(self.numbers) * _EACH)]
        for number, y in zip(self.numbers, rows[::_EACH], strict=True):
            ink.box(layout_words(f"({number})", BODY.em), 0.0, y + _RISE)
        with marked(self.canv, self.tag):
            ink.flush()
        self.colour(GREY)
        self.canv.setLineWidth(0.4)
        with artifact(self.canv):
            for y in rows:
                self.canv.line(_INDENT, y, self.width, y)


def lined(statement: Words | None, lang: Lang) -> list[Block]:
    """Lines under a heading; none where no numbered question ends as one, for then quantities are asked."""
    numbers = tuple(_QUESTION.findall(statement.of(lang))) if statement is not None else ()
    return [Heading(_TITLE.of(lang), 3, lang), Lined(numbers)] if numbers else []
