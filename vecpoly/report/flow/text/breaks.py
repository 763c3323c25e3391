"""Cells broken into lines by Chinese and Latin rules."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ..cells import Cell, Gap, gap, parted
from .balanced import balanced, spaces
from .equations import LONGEST, whole

LOOSEST = 0.1  # em added to a gap beyond which a line is rather left ragged
_NORM = 0.08  # em added to a gap beyond which the lines before share it
_SHARED = 0.25  # em added to each gap beyond which a line is rather broken within a long formula
_SHORTER = 12.0  # em of an equation that is not parted where a whole longer one would leave a line ragged
_ORPHAN = 4.5  # em of the last line of a paragraph: less is a word or a symbol alone
_NARROW = 20.0  # em of a measure in which last lines are left as they come
_LEAST_GAP = 0.75  # how far blanks may shrink before a line is broken earlier


@dataclass(frozen=True, slots=True)
class Line:
    """One line: its cells, the gaps between them, its indent and natural width without outer blanks, how far its ink
    stands above and below its baseline (mm)."""

    cells: tuple[Cell, ...]
    gaps: tuple[Gap, ...]
    indent: float
    width: float
    em: float
    last: bool
    ascent: float
    descent: float


def break_lines(
    cells: Sequence[Cell], width: float, em: float, first: float = 0.0, *, least: float = _LEAST_GAP
) -> list[Line]:
    """Lines of the given width (mm), the first one indented, filled one after the other; where one would be stretched
    far, the lines of the paragraph share it, and only where these cannot an equation is parted, and then a long formula
    broken within. A last line of a word or a symbol takes more from those before it, where they can spare it.
    least: share of a blank that it may shrink to, 1 where the lines are set as they come."""
    cells = list(cells)
    gaps, terms = (whole(cells, spaces(cells, em), em, longest) for longest in (LONGEST, 0.0))
    measure = _Measure(width, em, first, least)
    halves = whole(cells, spaces(cells, em), em, _SHORTER)
    ways = ((gaps, LOOSEST), (halves, LOOSEST), (gaps, _SHARED), (terms, _SHARED))
    lines = next((made for some, most in ways if (made := _found(cells, some, measure, most))), None)
    if lines is None:
        return _greedy(cells, terms, width, em, first, least, cut=True)
    return _last_filled(cells, gaps, measure, lines)


@dataclass(frozen=True, slots=True)
class _Measure:
    """What lines are broken to: their width (mm), the em, the indent of the first, the share blanks may shrink to."""

    width: float
    em: float
    first: float
    least: float


def _found(cells: list[Cell], gaps: list[Gap], to: _Measure, most: float) -> list[Line] | None:
    """The lines, where none of them is stretched far or the paragraph can share it."""
    lines = _greedy([*cells], [*gaps], to.width, to.em, to.first, to.least, cut=False)
    if not _loosest(lines, to.width, _NORM):
        return lines
    shared = _shared(cells, gaps, to)
    return shared if shared and not _loosest(shared, to.width, most) else None


def _shared(cells: list[Cell], gaps: list[Gap], to: _Measure, floor: float = 0.0) -> list[Line]:
    """The lines of a paragraph as evenly stretched as may be, the last of them at least so wide."""
    ends = balanced(cells, gaps, to.width, to.em, to.first, to.least, floor)
    return [_line(cells, gaps, start, end, 0.0 if start else to.first, to.em) for start, end in pairwise((0, *ends))]


def _last_filled(cells: list[Cell], gaps: list[Gap], to: _Measure, lines: list[Line]) -> list[Line]:
    """The lines, of which the last is more than a word or a symbol where those before it can spare some."""
    if len(lines) < 2 or to.width < _NARROW * to.em or lines[-1].width >= _ORPHAN * to.em:
        return lines
    for floor in (_ORPHAN, _ORPHAN * 0.75):
        filled = _shared(cells, gaps, to, floor * to.em)
        if len(filled) == len(lines) and not _loosest(filled, to.width, LOOSEST):
            return filled
    return lines


def _loosest(lines: Sequence[Line], width: float, most: float) -> bool:
    return any(not line.last and _is_loose(line, width, most) for line in lines)


def _greedy(
    cells: list[Cell], gaps: list[Gap], width: float, em: float, first: float, least: float, *, cut: bool
) -> list[Line]:
    """Each line as full as it may be; cut: long formulas are, where a line would be stretched far else."""
    lines: list[Line] = []
    start = 0
    while start < len(cells):
        indent = first if start == 0 else 0.0
        end = _fill(cells, gaps, start, width - indent, least)
        line = _line(cells, gaps, start, end, indent, em)
        if cut and not line.last and _is_loose(line, width):
            end = _fuller(cells, gaps, start, end, width - indent, em)
            line = _line(cells, gaps, start, end, indent, em)
        lines.append(line)
        start = end
    return lines


def _is_loose(line: Line, width: float, most: float = _NORM) -> bool:
    return width - line.indent - line.width > most * line.em * sum(g.stretch for g in line.gaps)


def _fuller(cells: list[Cell], gaps: list[Gap], start: int, end: int, width: float, em: float) -> int:
    """The index after the last cell of a line that goes on into a long formula after it, which is cut behind one of its
    signs; its end where nothing of it fits."""
    best, cut = end, None
    for at in range(end, len(cells)):
        for halves in parted(cells[at], em):
            if _fits(cells, gaps, start, at, halves[0], width):
                best, cut = at + 1, halves
        if not _fits(cells, gaps, start, at, cells[at], width) or at == len(gaps):
            break
    if cut is not None:
        cells[best - 1 : best] = cut
        gaps[best - 1 : best - 1] = [gap(*cut, em)]
    return best


def _fits(cells: Sequence[Cell], gaps: Sequence[Gap], start: int, at: int, last: Cell, width: float) -> bool:
    """Whether a line that ends with this cell in that place is no wider than it may be."""
    used = sum(cell.box.width for cell in cells[start:at]) + sum(g.width for g in gaps[start:at]) + last.box.width
    return used - cells[start].lead - last.trail <= width


def _fill(cells: Sequence[Cell], gaps: Sequence[Gap], start: int, width: float, least: float) -> int:
    """The index after the last cell of the line that begins at `start`."""
    used = cells[start].box.width - cells[start].lead
    shrink = 0.0
    best = fallback = start + 1
    for i in range(start + 1, len(cells) + 1):
        if used - shrink - cells[i - 1].trail > width + 1e-6 and i > start + 1:
            return best if best > start + 1 or gaps[start].breakable else fallback
        if i == len(cells):
            return i
        if gaps[i - 1].breakable:
            best = i
        fallback = i
        if gaps[i - 1].stretch > 1.0:
            shrink += gaps[i - 1].width * (1 - least)
        used += gaps[i - 1].width + cells[i].box.width
    return len(cells)


def _line(cells: Sequence[Cell], gaps: Sequence[Gap], start: int, end: int, indent: float, em: float) -> Line:
    inner, boxes = tuple(gaps[start : end - 1]), [cell.box for cell in cells[start:end]]
    width = sum([box.width for box in boxes]) + sum([g.width for g in inner])
    width -= cells[start].lead + cells[end - 1].trail
    ascent, descent = max([box.ascent for box in boxes]), max([box.descent for box in boxes])
    return Line(tuple(cells[start:end]), inner, indent, width, em, end == len(cells), ascent, descent)
