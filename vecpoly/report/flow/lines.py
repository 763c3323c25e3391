"""Cells broken into lines by Chinese and Latin rules, lines justified and drawn."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ...tagging.pieces import Marks
from ...tagging.tree import Open
from ...typeset.box import MM, Glyphs
from ...typeset.canvas import Ink
from ...typeset.fonts import Face
from .cells import BLANK, Cell, Gap, Kind, gap, parted
from .text.balanced import balanced, spaces

_LOOSEST = 0.1  # em added to a gap beyond which a line is rather left ragged
_NORM = 0.08  # em added to a gap beyond which the lines before share it
_SHARED = 0.25  # em added to each gap beyond which a line is rather broken within a long formula
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
    far, the lines of the paragraph share it, and only where these cannot a long formula is broken within.
    least: share of a blank that it may shrink to, 1 where the lines are set as they come."""
    cells = list(cells)
    gaps = spaces(cells, em)
    lines = _greedy([*cells], [*gaps], width, em, first, least, cut=False)
    if any(not line.last and _is_loose(line, width) for line in lines):
        ends = balanced(cells, gaps, width, em, first, least)
        shared = [_line(cells, gaps, start, end, 0.0 if start else first, em) for start, end in pairwise((0, *ends))]
        if shared and not any(not line.last and _is_loose(line, width, _SHARED) for line in shared):
            return shared
        return _greedy(cells, gaps, width, em, first, least, cut=True)
    return lines


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


@dataclass(frozen=True, slots=True)
class Setting:
    """How a line is fitted into its measure: space added for a unit of stretch, or shrinking of blanks."""

    x: float
    unit: float
    shrink: float


def fit(line: Line, width: float, align: str) -> Setting:
    """Where the line starts (mm) and how its gaps change."""
    spare = width - line.indent - line.width
    x = line.indent - line.cells[0].lead
    elastic = sum(g.width for g in line.gaps if g.stretch > 1.0)
    if spare < 0.0:
        return Setting(x, 0.0, min(1.0, -spare / elastic) if elastic else 0.0)
    if align == "centre":
        return Setting(x + spare / 2, 0.0, 0.0)
    if align == "right":
        return Setting(x + spare, 0.0, 0.0)
    stretch = sum(g.stretch for g in line.gaps)
    loose = _LOOSEST * line.em * stretch
    if align != "justify" or line.last or not stretch or spare > loose:
        return Setting(x, 0.0, 0.0)
    return Setting(x, spare / stretch, 0.0)


@dataclass(slots=True)
class _Run:
    """A growing run of one face whose characters or blanks are evenly spaced."""

    glyphs: Glyphs
    x: float
    text: str
    chars: float = 0.0
    blanks: float = 0.0
    kind: Kind = Kind.HAN
    goal: str = ""
    under: Open | None = None


def draw_line(ink: Ink, line: Line, x: float, y: float, width: float, align: str, marks: Marks) -> None:
    """Draw the line with the left end of its measure at (x, y) in pt; width in mm; marks: whose its pieces are."""
    setting = fit(line, width, align)
    at = x + setting.x * MM
    current: _Run | None = None
    for i, cell in enumerate(line.cells):
        between = line.gaps[i - 1] if i else None
        if between is not None:
            change = between.stretch * setting.unit
            if between.stretch > 1.0:
                change -= between.width * setting.shrink
            at += (between.width + change) * MM
            if current is not None and _continues(current, between, cell, change * MM):
                _opens(marks, cell, at, y, line.em)
                at += cell.box.width * MM
                continue
            if current is not None and cell.spaced:
                current.text += " "
        if current is not None:
            _show(ink, current, y)
        under = _opens(marks, cell, at, y, line.em)
        ink.under(under)
        current = _begin(ink, cell, at, y)
        if current is not None:
            current.under = under if current.text else marks.words
        at += cell.box.width * MM
    if current is not None:
        _show(ink, current, y)


def _opens(marks: Marks, cell: Cell, x: float, y: float, em: float) -> Open:
    """Whose the cell is: a reference leads to its place, if there is one."""
    if cell.goal:
        found = marks.link(cell.goal, f"{' ' * cell.spaced}{cell.text}", x, x + cell.box.width * MM, y, em * MM)
        if found is not None:
            return found
    return marks.of(cell.source, cell.joined)


def _continues(current: _Run, between: Gap, cell: Cell, change: float) -> bool:
    """Take the cell into the run if its gap is the run's own."""
    items = cell.box.items
    if cell.goal != current.goal or cell.source is not None:
        return False
    if len(items) != 1 or not isinstance(items[0], Glyphs) or items[0].font != current.glyphs.font:
        return False
    if cell.kind is Kind.WORD and current.kind is Kind.WORD and cell.spaced:
        blank = between.width * MM + change - BLANK * items[0].size
        if " " not in current.text or abs(blank - current.blanks) < 1e-6:
            current.blanks = blank
            current.text += " " + items[0].text
            return True
        return False
    han = (Kind.HAN, Kind.CLOSE, Kind.OPEN)
    if cell.kind not in han or current.kind not in han:
        return False
    extra = between.width * MM + change
    if len(current.text) > 1 and abs(extra - current.chars) > 1e-6:
        return False
    current.chars = extra
    current.text += items[0].text
    return True


def _begin(ink: Ink, cell: Cell, x: float, y: float) -> _Run | None:
    items = cell.box.items
    if len(items) == 1 and isinstance(items[0], Glyphs) and cell.kind is not Kind.FORMULA:
        return _Run(items[0], x, items[0].text, kind=cell.kind, goal=cell.goal)
    ink.box(cell.box, x, y)
    if cell.kind is Kind.FORMULA or cell.kind is Kind.WORD:
        blank = Glyphs(Face.STIX.value, items[-1].size if isinstance(items[-1], Glyphs) else 10.0, 0, 0, "")
        return _Run(blank, x + cell.box.width * MM, "", kind=Kind.FORMULA)
    return None


def _show(ink: Ink, run: _Run, y: float) -> None:
    if run.text:
        ink.under(run.under)
        glyphs = Glyphs(run.glyphs.font, run.glyphs.size, 0.0, 0.0, run.text)
        ink.text(glyphs, run.x, y, run.chars, run.blanks)
