"""The columns of a table of results, each as wide as a hand needs; none that is for nothing."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest
from typing import NamedTuple

from ...typeset.box import MM
from ...typeset.words import layout_words
from ...words import Lang, Words
from ..flow.furniture import COLUMN
from ..flow.style import CELL
from ..flow.table import PAD
from .ruled import NONE, RuledTable

HEADS = (
    Words("量", "Quantity"),
    Words("图上长度 /mm", "On paper /mm"),
    Words("数值", "Value"),
    Words("单位", "Unit"),
    Words("方向（转向）", "Direction, sense"),
)
WITH_UNIT = Words("数值与单位", "Value with unit")  # in one cell
Cells = tuple[str, str, str, str, str]
_WIDTHS = (30.0, 32.0, 34.0, 22.0, 40.0)  # mm: the first at least
_LEAST = (30.0, 26.0, 28.0, 16.0, 30.0)  # mm: where names are long
_BROAD = 85.0  # mm for names at most
_PLACED = 54.0  # mm for the two coordinates of a place
_COUNT = 20.0  # mm for a count, a yes or a class, where two blocks have room side by side
_FEW = 6  # rows that do not stand in two blocks side by side


class Framed(NamedTuple):
    """The symbols of what has in a frame a line for its length on paper, and of what has one for its value."""

    lined: frozenset[str] = frozenset()
    valued: frozenset[str] = frozenset()

    def left_of(self, row: Cells, symbol: str) -> Cells:
        """The row without what has its place in a frame."""
        name, paper, value, unit, way = row
        paper = NONE if symbol in self.lined else paper
        return name, paper, NONE if symbol in self.valued else value, unit, way


UNFRAMED = Framed()


def headed(name: str) -> Cells:
    """The name of a group of rows."""
    return f"**{name[:1].upper()}{name[1:]}**", "", "", "", ""


def in_columns(rows: Sequence[Cells], lang: Lang) -> RuledTable:
    """The table of these rows, as wide as the squares above it; many rows of a few short cells in two blocks side by
    side."""
    if all(row[2] not in ("", NONE) for row in rows if not is_headed(row)):
        return _places(rows, lang)
    kept = [i for i in range(len(HEADS)) if i == 0 or any(not is_headed(row) and row[i] != NONE for row in rows)]
    heads, cells = [HEADS[i].of(lang) for i in kept], [[row[i] for i in kept] for row in rows]
    widths, align = _widths(rows, kept), "lcccc"[: len(kept)]
    if kept == [0, 2] and 2 * (widths[0] + _COUNT) <= COLUMN / MM:
        widths[1] = min(widths[1], COLUMN / MM / 2 - widths[0])
    if len(rows) > _FEW and 2 * sum(widths) <= COLUMN / MM:
        half = _middle(rows)
        cells = [[*one, *other] for one, other in zip_longest(cells[:half], cells[half:], fillvalue=[NONE] * len(kept))]
        heads, widths, align = heads * 2, widths * 2, align * 2
    share = COLUMN / MM / sum(widths)
    return RuledTable(heads, cells, [one * share for one in widths], align, lang=lang)


def _places(rows: Sequence[Cells], lang: Lang) -> RuledTable:
    """A table of nothing but places: a column for each coordinate."""
    heads = [HEADS[0].of(lang), "$x$ /mm", "$y$ /mm"]
    wide = COLUMN / MM
    return RuledTable(heads, [(row[0], "", "") for row in rows], [wide / 5, *(0.4 * wide,) * 2], "lcc", lang=lang)


def _middle(rows: Sequence[Cells]) -> int:
    """How many rows stand in the first of two blocks: half of them, or the whole groups that are nearest to half."""
    starts = [n for n, row in enumerate(rows) if is_headed(row) and n]
    return min(starts, key=lambda n: (max(n, len(rows) - n), n)) if starts else (len(rows) + 1) // 2


def is_headed(row: Cells) -> bool:
    """Whether it is the name of a group."""
    return row[0].startswith("**") and not any(row[1:])


def _widths(rows: Sequence[Cells], kept: Sequence[int]) -> list[float]:
    """Names have the room they need, up to half of the page; the other columns what is written in them, less of it
    beside long names."""
    named = max(layout_words(row[0], CELL.em).width for row in rows if not is_headed(row)) + 2 * PAD + 1.0
    for widths in (_WIDTHS, _LEAST):
        others = [_PLACED if i == 2 and any(row[i] not in ("", NONE) for row in rows) else widths[i] for i in kept[1:]]
        if named + sum(others) <= COLUMN / MM:
            break
    return [min(max(named, _WIDTHS[0]), _BROAD, max(COLUMN / MM - sum(others), _WIDTHS[0])), *others]
