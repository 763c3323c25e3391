"""A part of a report whose last page of text holds little shares it: its sheets stand before that page, and what comes
next begins on it."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.flowables import PageBreak

from ..blocks import Divider, Heading, SheetPage
from ..doc import ReportDoc
from ..para import Para
from .together import first_of, led

ROUNDS = 8  # what begins on a page of another may end on one that holds little
FEW = 2  # pages behind its sheets that a part may have, at most
FULL = 0.88  # of the last page of a part: what is less is shared with what comes next


def run_on(story: Sequence[Any], doc: ReportDoc) -> tuple[list[Any], ReportDoc]:
    """The story with fewer pages that hold little, and it laid out; doc: the story as it is, laid out."""
    found = list(story)
    for _ in range(ROUNDS):
        again = _shared(found, doc)
        if again is None:
            break
        found = again
        doc = ReportDoc(found, doc.metadata)
        doc.counted()
    return found, doc


def _shared(story: Sequence[Any], doc: ReportDoc) -> list[Any] | None:
    """One round: every part that ends on a sparse page; doc: the story, laid out."""
    out: list[Any] = []
    parts, told, opened = split(story), iter(doc.ends), iter(_opened(doc))
    for number, (text, behind) in enumerate(parts):
        pages, full = next(told, (0, 1.0)) if text else (0, 1.0)
        heads = [next(opened, None) for _ in range(pages)]
        last, changed = number == len(parts) - 1, len(out) != sum(len(a) + len(b) for a, b in parts[:number])
        sheets = [item for item in behind if isinstance(item, SheetPage)]
        if full >= FULL or any(sheet.fixed for sheet in sheets) or (last and (not sheets or pages < 2 or changed)):
            out += [*text, *behind]
            continue
        head = opening(text)
        after = max(pages - 1, 1) if len(parts) == 1 else _after(heads)
        floating = (put_behind(sheet, after) for sheet in sheets)
        ends = not last and any(isinstance(item, PageBreak) for item in behind)  # else it goes on behind its sheets
        out += [*text[:head], *floating, *text[head:], *([Divider()] if ends else [])]
    return out if len(out) != len(story) or any(a is not b for a, b in zip(out, story, strict=True)) else None


def _opened(doc: ReportDoc) -> list[Any]:
    """What each page of text opens with."""
    return [first_of(head) for _, head in sorted(doc.heads.items()) if not isinstance(head, SheetPage)]


def _after(heads: Sequence[Any]) -> int:
    """Behind how many pages of a part that open so its sheets stand: before the last page that opens with a section, or
    else with a step, so that no table or formula is torn from what it belongs to; no farther from where they belong
    than a few pages."""
    pages = range(len(heads) - 1, max(0, len(heads) - 1 - FEW), -1)
    for kind in (Heading, Para):
        if (found := next((page for page in pages if isinstance(heads[page], kind)), None)) is not None:
            return found
    return max(len(heads) - 1, 1)


def opening(text: Sequence[Any]) -> int:
    """How many blocks stand together where it begins: its heading, and what is not parted from that."""
    held = led(text)
    return 1 + next((at for at, item in enumerate(held) if not getattr(item, "keepWithNext", 0)), len(held) - 1)


def put_behind(sheet: SheetPage, pages: int) -> SheetPage:
    """The sheet, so many pages behind the place where it is met."""
    own = copy(sheet)
    own.behind = pages
    return own


def split(story: Sequence[Any]) -> list[tuple[list[Any], list[Any]]]:
    """Each part of text with the sheets and turns behind it; the first has no text where the story opens with these,
    as with a cover."""
    parts: list[tuple[list[Any], list[Any]]] = [([], [])]
    for item in story:
        if turns(item):
            parts[-1][1].append(item)
        elif parts[-1][1]:
            parts.append(([item], []))
        else:
            parts[-1][0].append(item)
    return parts


def turns(item: Any) -> bool:
    """Whether the text ends before it, and goes on on another page."""
    return isinstance(item, PageBreak) or (isinstance(item, SheetPage) and not item.behind)
