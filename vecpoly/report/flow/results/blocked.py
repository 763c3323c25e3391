"""A long list in blocks of columns beside each other, so that it is a short table: one block after another is read, on
each page."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any, Self

from ....words import Lang
from ..table import DataTable
from .banded import Rules

Items = Sequence[Sequence[str]]


class BlockTable(DataTable):
    """Rows of a list in so many blocks; a page break parts the list, and not its blocks."""

    items: Items = ()
    blocks = 1

    @classmethod
    def of(cls, head: Sequence[str], items: Items, blocks: int, align: str, lang: Lang, **said: Any) -> Self:
        """The table of this list, with a blank column between two blocks. align: of the columns of one; said: what else
        a table is told."""
        heads = [*head, *["", *head] * (blocks - 1)]
        made = cls(heads, in_blocks(items, blocks), None, "l".join([align] * blocks), lang=lang, **said)
        made.items, made.blocks = items, blocks
        return made

    def split(self, width: float, height: float) -> list[Any]:
        """As any table, but the first of the list on this page, all others on the next."""
        found = super().split(width, height)
        if len(found) < 2 or self.blocks == 1:
            return found
        head, *between, tail = found
        here = len(head.rows) * self.blocks
        return [
            _listing(head, self.items[:here], self.blocks),
            *between,
            _listing(tail, self.items[here:], self.blocks),
        ]


def _listing(part: BlockTable, items: Items, blocks: int) -> BlockTable:
    """The part with what it is to hold."""
    own = copy(part)
    own.items, own.blocks = items, blocks
    own.rows = tuple(map(tuple, in_blocks(items, blocks)))
    own.groups = ("",) * len(own.rows)
    own._before, own._ruling, own._found = 0, Rules.of(own.rows), {}
    return own


def in_blocks(items: Items, blocks: int) -> list[list[str]]:
    """The rows of the whole: the list fills one block after another, all as high as the first but the last ones."""
    high = -(-len(items) // blocks)
    blank = [""] * max(map(len, items), default=0)
    columns = [[*items[at * high : (at + 1) * high]] for at in range(blocks)]
    rows = [[[*column[n]] if n < len(column) else blank for column in columns] for n in range(high)]
    return [[cell for n, block in enumerate(row) for cell in (*[""][: n > 0], *block)] for row in rows]
