"""A file as it was written: monospaced lines with their numbers, long ones folded."""

from __future__ import annotations

import re

from ...tagging.tag import Role
from ...tagging.tree import artifact, tree_of
from ...typeset.box import MM, Box
from ...typeset.canvas import Ink
from ...typeset.fonts import Face
from ...typeset.runs import run
from ...typeset.words import is_han
from .base import Block
from .style import GREY

_SIZE, _LEADING = 8.0, 11.2  # pt
_MARGIN = 22.0  # pt for the numbers
_CELL = 0.602  # em, the advance of the face
_ENTRY = re.compile(r"\s*(- |#|[^\s:]+:(\s|$))")
_LONG = 30  # lines of one string: more than these a page break may part
_WHOLE = 50  # lines of a file that is not parted
_GAP = 215.0  # pt under its headings: what would leave more white, 0.42 of a page with them, is parted all the same
_LEAST = 3  # lines that a page break leaves together


class Listing(Block):
    """Lines of a text file; (number, text) pairs, the number empty on the folded rest of a line."""

    role = Role.CODE
    pieces = True

    def __init__(self, text: str = "", lines: tuple[tuple[str, str], ...] = ()) -> None:
        super().__init__(4.0, 8.0)
        self._text = text
        self._lines = lines

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        if not self._lines and self._text:
            cells = int((width - _MARGIN) / (_CELL * _SIZE))
            self._lines = tuple(
                pair
                for i, line in enumerate(self._text.rstrip("\n").split("\n"), 1)
                for pair in _folded(str(i), line, cells)
            )
        self.width, self.height = width, _LEADING * len(self._lines) + 4.0
        return width, self.height

    def split(self, width: float, height: float) -> list[Block]:
        """Whole lines to each page, of a file for which a page has no room, or that would leave a gap."""
        self.wrap(width, height)
        if len(self._lines) <= _WHOLE and height <= _GAP:
            return []
        room = height - self.getSpaceBefore()  # the frame may leave that out here and ask for it of the part
        fit = min(int((room - 4.0) / _LEADING), len(self._lines) - _LEAST)
        if fit < _LEAST:
            return []
        count = next((n for n in range(fit, _LEAST - 1, -1) if _begins(*self._lines[n])), fit if fit > _LONG else 0)
        if not count:
            return []
        head, tail = Listing(lines=self._lines[:count]), Listing(lines=self._lines[count:])
        return [head.made_of(self, first=True), tail.made_of(self, first=False)]

    def draw(self) -> None:
        """Draw numbers, a fine rule, and the lines."""
        canv, y = self.canv, self.height - 2.0
        canv.saveState()
        canv.setFillColorRGB(*GREY)
        ink = Ink(canv)
        ink.rule(_MARGIN - 5.0, 0.0, 0.4, self.height)
        for i, (number, _) in enumerate(self._lines, 1):
            box = _set(number, 0.8)
            ink.box(box, _MARGIN - 9.0 - box.width * MM, y - i * _LEADING + 3.0)
        with artifact(canv):
            ink.flush()
        canv.restoreState()
        ink.under(tree_of(canv).opener(self.tag))
        for i, (_, text) in enumerate(self._lines, 1):
            ink.box(_set(text), _MARGIN, y - i * _LEADING + 3.0)
        ink.flush()


def _begins(number: str, text: str) -> bool:
    """Whether a line begins a key or an entry: a page never begins inside a string."""
    return bool(number) and _ENTRY.match(text) is not None


def _set(text: str, factor: float = 1.0) -> Box:
    return run(text, Face.MONO, factor * _SIZE / MM)


def _wide(char: str) -> float:
    """Cells that a character takes."""
    return 1 / _CELL if is_han(char) else 1.0


def _folded(number: str, line: str, cells: int) -> list[tuple[str, str]]:
    """The line cut after so many cells, at a blank where one is near; the rest is indented."""
    indent = " " * (len(line) - len(line.lstrip(" ")) + 2)
    out: list[tuple[str, str]] = []
    rest = line
    while sum(map(_wide, rest)) > cells:
        used, count = 0.0, 0
        while used + _wide(rest[count]) <= cells:
            used += _wide(rest[count])
            count += 1
        blank = rest.rfind(" ", len(indent) + count // 2, count)
        count = blank + 1 if blank > 0 else count
        out.append((number if not out else "", rest[:count]))
        rest = indent + rest[count:]
    return [*out, (number if not out else "", rest)]
