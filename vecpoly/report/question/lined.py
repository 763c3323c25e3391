"""Lines to write words on: for each thing that is to be explained, which no cell of a table has room for."""

from __future__ import annotations

from collections.abc import Sequence

from ...tagging.tree import artifact, marked
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang, Words, begun
from ..flow.base import Block
from ..flow.blocks import Heading
from ..flow.style import BODY, GREY

_TITLE = Words("回答", "Answers")
_COLON = Words("：", ":")
_EACH, _LINE, _GAP = 2, 7.0 * MM, 2.0 * MM  # lines for an answer; from one to the next; behind its name
_RISE = 1.5 * MM  # of a name over its line
_LEAST = 50.0 * MM  # of the first line behind a name


class Lined(Block):
    """Two lines for each answer, the first behind its name, one under the other, or below a name that is long."""

    pieces = True

    def __init__(self, names: tuple[str, ...]) -> None:
        super().__init__(2.0, 6.0)
        self.names = names

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """The whole width."""
        self.width, self.height = width, len(self.names) * _EACH * _LINE
        return width, self.height

    def draw(self) -> None:
        """The names, each before its first line."""
        ink, starts = Ink(self.canv), self.starts()
        rows = [self.height - (n + 1) * _LINE for n in range(len(self.names) * _EACH)]
        for name, y in zip(self.names, rows[::_EACH], strict=True):
            ink.box(layout_words(name, BODY.em), 0.0, y + _RISE)
        with marked(self.canv, self.tag):
            ink.flush()
        self.colour(GREY)
        self.canv.setLineWidth(0.4)
        with artifact(self.canv):
            for n, y in enumerate(rows):
                self.canv.line(0.0 if n % _EACH else starts[n // _EACH], y, self.width, y)

    def starts(self) -> list[float]:
        """Where the first line of each begins: behind the longest of the names; at the edge, where a longer one stands
        on it."""
        ends = [layout_words(name, BODY.em).width * MM + _GAP for name in self.names]
        most = max((end for end in ends if end <= self.width - _LEAST), default=0.0)
        return [most if end <= self.width - _LEAST else 0.0 for end in ends]


def lined(explain: Sequence[Words], lang: Lang) -> list[Block]:
    """Lines under a heading; none where nothing is to be explained."""
    names = tuple((begun(one) + _COLON).of(lang) for one in explain)
    return [Heading(_TITLE.of(lang), 3, lang), Lined(names)] if names else []
