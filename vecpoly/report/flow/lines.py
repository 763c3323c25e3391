"""Cells drawn as lines, justified."""

from __future__ import annotations

from dataclasses import dataclass

from ...tagging.pieces import Marks
from ...tagging.tree import Open
from ...typeset.box import MM, Glyphs
from ...typeset.canvas import Ink
from ...typeset.fonts import Face
from .cells import BLANK, Cell, Gap, Kind
from .text.breaks import LOOSEST, Line


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
    loose = LOOSEST * line.em * stretch
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
