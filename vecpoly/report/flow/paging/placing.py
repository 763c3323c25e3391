"""The places in which the sheets and plates of a text may stand: sheets behind one of its pages or before a section of
it, a plate before a step or a section, where it is met a little earlier."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from ..base import Block
from ..blocks import Drawing, Heading, Plate, SheetPage
from ..doc import ReportDoc
from ..furniture import COLUMN
from ..para import Para
from .running import FEW, opening, put_behind
from .sectioned import settled
from .together import first_of

Story = Sequence[Any]
NEARLY = 0.7  # of a page that a text so low fills when it is set more openly, at least


def placed(plain: Story, doc: ReportDoc) -> Iterator[Story]:
    """The story, its sheets behind the text, behind one of its last pages, before a section or a step there where the
    page before them would be nearly full; doc: it, laid out in some way."""
    count = next((n for n, item in enumerate(reversed(plain)) if not isinstance(item, SheetPage)), 0)
    text, sheets = plain[: len(plain) - count], [*map(settled, plain[len(plain) - count :])]
    yield [*text, *sheets]
    if sheets and not any(sheet.fixed for sheet in sheets):
        at = opening(text)
        last = len(doc.filled) - 1
        for before in range(last, max(0, last - FEW), -1):
            yield [*text[:at], *(put_behind(sheet, before) for sheet in sheets), *text[at:]]
        for at in reversed([*_at_feet(text, doc.column, last - FEW)]):
            yield [*text[:at], *sheets, *text[at:]]


def advanced(story: Story) -> Iterator[Story]:
    """The story with the last plate of its text met earlier, before a step or a section, a little and more and more."""
    at = next((n for n in range(len(story) - 1, 0, -1) if isinstance(story[n], Plate)), 0)
    for n in range(at - 1, 0, -1):
        if isinstance(story[n], SheetPage | Drawing):
            return
        if _is_free(story, n):
            yield [*story[:n], story[at], *story[n:at], *story[at + 1 :]]


def _at_feet(text: Story, column: float, pages: int) -> Iterator[int]:
    """Where a section or a step begins near the foot of a page of this column behind so many pages, as far as
    heights tell, behind the plates, which have the smaller numbers."""
    depth, plates = 0.0, max((at for at, item in enumerate(text) if isinstance(item, Plate)), default=0)
    for at, item in enumerate(text):
        if at > plates and _is_free(text, at) and depth > pages * column and depth % column >= NEARLY * column:
            yield at
        if isinstance(item, Block):
            depth += item.wrap(COLUMN, column)[1] + max(item.spaceBefore, item.spaceAfter)


def _is_free(story: Story, at: int) -> bool:
    """Whether a step or a section begins there, to which no heading before it belongs."""
    return _begins(story[at]) and not getattr(story[at - 1], "keepWithNext", 0)


def torn(doc: ReportDoc) -> int:
    """How many sheets stand in the midst of a step or a table."""
    return sum(not (isinstance(item, Plate) or _begins(item)) for item in _behind_sheets(doc))


def amid(doc: ReportDoc) -> int:
    """How many stand in the midst of a section."""
    return sum(not isinstance(item, Heading) for item in _behind_sheets(doc))


def _behind_sheets(doc: ReportDoc) -> Iterator[Any]:
    """What the pages behind sheets open with."""
    for page, head in doc.heads.items():
        after = first_of(doc.heads.get(page + 1))
        if isinstance(head, SheetPage) and not (after is None or isinstance(after, SheetPage)):
            yield after


def _begins(item: Any) -> bool:
    """Whether a section or a step begins with it."""
    return isinstance(item, Heading) or (isinstance(item, Para) and item.labelled)
