"""Short results that are read one after another, places above all: two or three stand on one line, in columns; lines
that reckon the same of one body after another, two by two."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import groupby

from ....algebra.formula import Node, plain
from ....tagging.copied import copied
from ....tagging.speech import said
from ....tagging.tag import Role, Tag
from ....tagging.tree import tree_of
from ....typeset.box import MM, Box
from ....typeset.canvas import Ink
from ....typeset.layout import layout, segments
from ..base import Block
from ..style import BODY

SEVERAL, MOST = 3, 3  # so many share lines, and so many stand on one
ALIKE, _HALF = 4, 78.0  # lines of one form that stand two by two; mm that each may take
_INDEX = re.compile(r"_\w+|[\d.]+")
_WIDEST, _BETWEEN = 46.0, 10.0  # mm: what may stand beside another; between columns
_LOW = 1.4  # em: what is higher has a fraction, and a line of its own
_STRUT, _CLOSE = (0.78, 0.26), 5.5  # em over and under a base line; pt between lines
_PLACE = re.compile(r"[^=]+ = \([−-]?[\d.]+, [−-]?[\d.]+\) mm|[^=]+ \(∠[\d.]+°\)")


class Abreast(Block):
    """Such results in rows, each under another by its left end."""

    role = Role.DIV
    pieces = True

    def __init__(self, nodes: Sequence[Node]) -> None:
        super().__init__(5.0, 6.0)
        self.nodes, self._em = tuple(nodes), BODY.em

    @property
    def _boxes(self) -> list[Box]:
        return [layout(node, self._em) for node in self.nodes]

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        rows = self._rows(width)
        self.width, self.height = width, sum(up + down for up, down in rows) * MM + (len(rows) - 1) * _CLOSE
        return width, self.height

    def _rows(self, width: float) -> list[tuple[float, float]]:
        """How far each row reaches over and under its base line (mm)."""
        across, boxes, (up, down) = self._across(width), self._boxes, (self._em * part for part in _STRUT)
        rows = [boxes[n : n + across] for n in range(0, len(boxes), across)]
        return [(max(up, *(b.ascent for b in row)), max(down, *(b.descent for b in row))) for row in rows]

    def _across(self, width: float) -> int:
        """How many stand on a line: of four, two by two."""
        most = max(1, min(MOST, int((width / MM + _BETWEEN) / (self._step + 1e-9))))
        return 2 if len(self.nodes) == 4 and most > 2 else most

    @property
    def _step(self) -> float:
        return max(box.width for box in self._boxes) + _BETWEEN

    @property
    def reach(self) -> tuple[float, float]:
        """Where its ink begins and ends in the column (mm)."""
        wide = self._across(self.width) * self._step - _BETWEEN
        left = max(0.0, (self.width / MM - wide) / 2)
        return left, left + wide

    def draw(self) -> None:
        """Row by row, in the middle of the column."""
        ink, tree, across = Ink(self.canv), tree_of(self.canv), self._across(self.width)
        left, _ = self.reach
        rows, top = self._rows(self.width), self.height
        for n, (node, box) in enumerate(zip(self.nodes, self._boxes, strict=True)):
            row, column = divmod(n, across)
            if row and not column:
                top -= sum(rows[row - 1]) * MM + _CLOSE
            ink.under(tree.opener(Tag(Role.FORMULA, self.tag.within, said(node, tree.lang)), copied(node)))
            ink.box(box, (left + column * self._step) * MM, top - rows[row][0] * MM)
        ink.flush()


def abreast(nodes: Sequence[Node]) -> list[Node | Abreast]:
    """The equations of a step: its places first, where there are several; of others, several short ones in a row."""
    if _is_reckoned_alike(nodes):
        return [Abreast(nodes)]
    places = [node for node in nodes if _is_place(node)]
    if len(places) < SEVERAL:
        return [*_rows(nodes)]
    return [Abreast(places), *_rows([node for node in nodes if not _is_place(node)])]


def _is_reckoned_alike(nodes: Sequence[Node]) -> bool:
    """Whether they are many lines of one form or two, W_1I = W_1 (L − z_1)/L ..., which need half the width each."""
    forms = {_INDEX.sub("", plain(node)) for node in nodes}
    return len(nodes) >= ALIKE and len(forms) <= 2 and all(layout(node, BODY.em).width <= _HALF for node in nodes)


def _rows(nodes: Sequence[Node]) -> Iterator[Node | Abreast]:
    for short, some in groupby(nodes, key=_is_short):
        run = [*some]
        if short and len(run) >= SEVERAL:
            yield Abreast(run)
        else:
            yield from run


@lru_cache(maxsize=4096)
def _is_place(node: Node) -> bool:
    return _PLACE.fullmatch(plain(node)) is not None


@lru_cache(maxsize=4096)
def _is_short(node: Node) -> bool:
    box = layout(node, BODY.em)
    return len(segments(node, BODY.em, before=True)) <= 2 and box.width <= _WIDEST and box.height <= _LOW * BODY.em
