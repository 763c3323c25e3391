"""The table of contents: its page numbers are forms that the document fills in when the pages are known.

Also what is done to a whole story before it is set: its contents told.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ...foundation.slotted import dataclass, replace
from ...tagging.tag import Role, Tag
from ...tagging.tree import artifact, marked, tree_of
from ...typeset.box import MM
from ...typeset.canvas import Ink
from ...typeset.words import layout_words
from ...words import Lang
from .base import Block, Tightness
from .blocks import Heading, spoken
from .style import BODY

_STEP, _CLOSER = {2: 19.0, 3: 15.5}, 0.35  # pt from an entry to the next; of what white is taken away, from these
_INDENT = {2: 0.0, 3: 16.0}  # pt
_GAP = 3.0  # pt between the dots of a leader
_ROOM = 22.0  # pt kept for the page number


@dataclass(frozen=True, slots=True)
class Entry:
    """A heading: its words, its level (2 or 3), the bookmark of its place."""

    text: str
    level: int
    key: str


def page_form(key: str) -> str:
    """The name of the form that holds the page number of a bookmark."""
    return f"vecpoly-page-{key}"


class Contents(Block):
    """Headings with dotted leaders to their page numbers; every line is a link. `entries` is set by the document."""

    role = Role.CONTENTS
    pieces = True

    def __init__(self, lang: Lang = "zh", entries: Sequence[Entry] = ()) -> None:
        super().__init__(4.0, 6.0)
        self.lang, self.entries, self._close = lang, tuple(entries), 1.0

    def tighten(self, degree: Tightness) -> None:
        """Its lines a little closer too."""
        super().tighten(degree)
        self._close = 1.0 - _CLOSER * (1.0 - degree.white)

    def _step(self, entry: Entry) -> float:
        return self._close * _STEP[entry.level]

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """Size in a column."""
        self.width, self.height = width, sum(map(self._step, self.entries))
        return width, self.height

    def split(self, width: float, height: float) -> list[Block]:
        """Whole entries to each page."""
        used, count = 0.0, 0
        while count < len(self.entries) and used + self._step(self.entries[count]) <= height:
            used += self._step(self.entries[count])
            count += 1
        if not 0 < count < len(self.entries):
            return []
        head, tail = Contents(self.lang, self.entries[:count]), Contents(self.lang, self.entries[count:])
        head._close = tail._close = self._close
        return [head.made_of(self, first=True), tail.made_of(self, first=False)]

    def draw(self) -> None:
        """Draw every entry."""
        y = self.height
        for entry in self.entries:
            y -= self._step(entry)
            self._entry(entry, y + 4.5)

    def _entry(self, entry: Entry, y: float) -> None:
        ink, left = Ink(self.canv), _INDENT[entry.level]
        chapter = entry.level == 2
        style = replace(BODY, size=10.5 if chapter else 10.0)
        text = layout_words(entry.text, style.em, chapter)
        said = spoken(entry.text)
        link = Tag(Role.LINK, Tag(Role.ENTRY, self.tag), said)
        ink.under(tree_of(self.canv).opener(link))
        ink.box(text, left, y)
        ink.flush()
        start, end = left + text.width * MM + 5.0, self.width - _ROOM
        if end > start:
            self._leader(start, end, y + 1.2)
        self.canv.saveState()
        self.canv.translate(self.width, y)
        with marked(self.canv, link):
            self.canv.doForm(page_form(entry.key))
        self.canv.restoreState()
        self.canv.link(entry.key, (0.0, y - 3.0, self.width, y + 10.0), said, link)

    def _leader(self, start: float, end: float, y: float) -> None:
        self.canv.saveState()
        self.canv.setLineWidth(0.6)
        self.canv.setLineCap(1)
        self.canv.setDash([0.1, _GAP])
        first = start + (end - start) % _GAP  # the dots of all lines stand under each other
        with artifact(self.canv):
            self.canv.line(first, y, end, y)
        self.canv.restoreState()


def tell_contents(story: Sequence[Any]) -> None:
    """Give headings and sheets their bookmarks, and every table of contents the headings after it.

    A sheet that floats is drawn behind headings that come after it: the bookmark is its own, wherever it is drawn.
    """
    outlined = [item for item in story if getattr(item, "outline", "") or isinstance(item, Contents)]
    count, entries, waiting = 0, list[Entry](), list[tuple[Contents, int]]()
    for item in outlined:
        if isinstance(item, Contents):
            waiting.append((item, len(entries)))
            continue
        count += 1
        item.bookmark = f"h{count}"
        if isinstance(item, Heading) and item.level in (2, 3):
            entries.append(Entry(item.text, item.level, item.bookmark))
    for contents, start in waiting:
        contents.entries = tuple(entries[start:])
