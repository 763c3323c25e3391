"""Numbers of a column under each other by their decimal points, those of one unit at a time."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence, Sized
from functools import lru_cache

from ....foundation.slotted import dataclass
from ..cells import cells, joined

BREAKS = "≙"  # after a length on paper, before its value: there a cell is broken where room is short
# up to the point, or to the end of a whole number; after a length on paper (210 mm ≙) that of its value
_NUMBER = re.compile(r"(?:[^≙]*≙)?\s*[+−-]?\d+")
_DECIMALS, _UNLIKE = (
    re.compile(r"[+−-]?\d+(?:\.(\d+))?"),
    2,
)  # decimals that one number of a column has more than another


@dataclass(frozen=True, slots=True)
class Aligned:
    """before, after: the widest parts of the column's numbers on each side of the point (mm)."""

    before: float
    after: float
    em: float
    chinese: bool
    ragged: bool = False  # numbers of so unlike decimals, 724 and 0.0051, that points under each other leave a zigzag

    @property
    def width(self) -> float:
        """What the numbers take together."""
        return 0.0 if self.ragged else self.before + self.after

    def indent(self, text: str, room: float) -> float | None:
        """Where a cell begins in a column of this width, its numbers in the middle; None of what is no number, of a
        plain 0 among numbers with decimals, which has no decimals to stand by, and where the column is too narrow."""
        if self.ragged or (text == "0" and self.after > 0.0):
            return None
        parts = _parts(text, self.em, self.chinese)
        if parts is None or self.width > room + 0.01:
            return None
        return (room - self.width) / 2 + self.before - parts[0]


def aligned(texts: Iterable[str], em: float, chinese: bool) -> Aligned:
    """The column of these texts."""
    texts = [*texts]
    parts = [part for text in texts if (part := _parts(text, em, chinese)) is not None]
    before, after = max((a for a, _ in parts), default=0.0), max((b for _, b in parts), default=0.0)
    places = [len(found[1] or "") for text in texts if text != "0" and (found := _DECIMALS.fullmatch(text)) is not None]
    return Aligned(before, after, em, chinese, bool(places) and max(places) - min(places) >= _UNLIKE)


def grouped(texts: Sequence[str], groups: Sequence[str], em: float, chinese: bool) -> tuple[Aligned, ...]:
    """The column of each text: those of one group under each other, each group in the middle."""
    found = {
        group: aligned((text for text, other in zip(texts, groups, strict=True) if other == group), em, chinese)
        for group in dict.fromkeys(groups)
    }
    return tuple(found[group] for group in groups)


Columns = tuple[tuple[Aligned, ...] | None, ...]


def aligned_columns(
    rows: Sequence[Sequence[str]], ways: str, groups: Sequence[str], em: float, chinese: bool
) -> Columns:
    """How the numbers of each column stand under each other, row by row: all (d), or those of a group of rows (u)."""
    return tuple(
        grouped([row[i] for row in rows], groups if way == "u" else [""] * len(rows), em, chinese)
        if way in "du"
        else None
        for i, way in enumerate(ways)
    )


def unbroken(rows: Sequence[Sequence[str]], lines: Sequence[Sequence[Sized]]) -> list[list[str]]:
    """The texts of the cells of one line: in others no number stands by its point."""
    return [
        [text if len(cell) == 1 else "" for text, cell in zip(texts, row, strict=True)]
        for texts, row in zip(rows, lines, strict=True)
    ]


@lru_cache(maxsize=4096)
def _parts(text: str, em: float, chinese: bool) -> tuple[float, float] | None:
    """The widths of a number before its point and from there on."""
    found = _NUMBER.match(text)
    if found is None:
        return None
    whole, before = (joined(cells(part, em, chinese), em).width for part in (text, found[0]))
    return before, whole - before
