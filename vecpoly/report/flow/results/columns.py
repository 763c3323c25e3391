"""How wide the columns of a table are that has no room for all of its cells in one line each."""

from __future__ import annotations

from collections.abc import Sequence

from ..cells import Cell
from ..text.balanced import spaces

_NARROW = 2 / 3  # of the column of text: how wide a table is at least


def evened(wanted: Sequence[float], width: float) -> tuple[float, ...]:
    """Columns of a table that has two thirds of the width, or all of it, so that tables of one page are alike."""
    total = sum(wanted)
    more = (width * _NARROW if total <= width * _NARROW else width) - total
    return tuple(one + more / len(wanted) for one in wanted)


def shared(wanted: Sequence[float], least: Sequence[float], width: float) -> tuple[float, ...]:
    """Narrow columns keep the width they want, the wide ones share what is left; none is narrower than its least,
    unless there is no room for that."""
    fair = width / len(wanted)
    kept = {n: one for n, one in enumerate(wanted) if one <= fair}
    found = first = _parted(wanted, kept, width)
    while tight := {n: least[n] for n, one in enumerate(found) if n not in kept and one < least[n]}:
        kept |= tight
        if len(kept) == len(wanted):
            return first
        found = _parted(wanted, kept, width)
    return found


def _parted(wanted: Sequence[float], kept: dict[int, float], width: float) -> tuple[float, ...]:
    share = (width - sum(kept.values())) / sum(one for n, one in enumerate(wanted) if n not in kept)
    return tuple(kept[n] if n in kept else one * share for n, one in enumerate(wanted))


def longest(cells: Sequence[Cell], em: float) -> float:
    """The width (mm) of the longest part of a text that no line break enters."""
    runs = [0.0]
    for cell, before in zip(cells, [None, *spaces(cells, em)], strict=True) if cells else ():
        if before is None or before.breakable:
            runs.append(cell.box.width - cell.lead)
        else:
            runs[-1] += before.width + cell.box.width
    return max(runs)


def over(align: str) -> str:
    """How the heads of columns stand: those over words begin where the words do."""
    return "".join("l" if side == "l" else "c" for side in align)
