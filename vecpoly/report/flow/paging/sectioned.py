"""Sheets between two sections of a text, where the page before its last one would end in the midst of one: neither a
table nor a step is torn by sheets, and no page that holds little stands alone behind them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from copy import copy
from typing import Any

from ..blocks import Heading, Plate, SheetPage
from ..doc import ReportDoc
from .setting import faults_of
from .together import first_of

HALF = 0.5  # of the last page, at least, where it stands alone behind the sheets
FULL = 0.88  # of the page before the sheets, at least: a section is rather parted by them than a page left white


def sectioned(story: list[Any], doc: ReportDoc) -> tuple[list[Any], ReportDoc]:
    """The story with its sheets before the last heading that lets them stand so; as it is where its sheets do not
    float, where they stand well, or where none does. doc: it, laid out."""
    sheets = [item for item in story if isinstance(item, SheetPage) and item.behind]
    if any(one.led for one in sheets):
        return story, doc
    if not sheets or len(sheets) != sum(isinstance(item, SheetPage) for item in story) or _stands(doc):
        return story, doc
    text = [item for item in story if item not in sheets]
    for at in heads(text):
        found = [*text[:at], *map(settled, sheets), *text[at:]]
        tried = ReportDoc(found, doc.metadata)
        if tried.counted() <= doc.page and _parts_well(tried) and faults_of(tried) <= faults_of(doc):
            return found, tried
    return story, doc


def _stands(doc: ReportDoc) -> bool:
    """Whether the last page opens with a heading, and holds something."""
    return isinstance(first_of(doc.heads.get(doc.page)), Heading) and doc.filled[-1] >= HALF


def heads(text: Sequence[Any]) -> Iterator[int]:
    """Where sections begin, the last first, behind the plates of the text, which have the smaller numbers."""
    plates = max((at for at, item in enumerate(text) if isinstance(item, Plate)), default=0)
    for at in range(len(text) - 1, plates, -1):
        if isinstance(text[at], Heading) and not getattr(text[at - 1], "keepWithNext", 0):
            yield at


def _parts_well(doc: ReportDoc) -> bool:
    """Whether the text before the sheets, and behind them, fills its pages."""
    (_, before), (pages, last) = doc.ends
    return before >= FULL and (pages > 1 or last >= HALF)


def settled(sheet: SheetPage) -> SheetPage:
    """The sheet in its place."""
    own = copy(sheet)
    own.behind = 0
    return own
