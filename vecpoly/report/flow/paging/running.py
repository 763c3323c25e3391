"""A part of a report whose last page of text holds little shares it, and what comes next begins on it; one that has
sheets does not: they stand behind the whole of its text, and parting the text of the next is no better."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from typing import Any

from reportlab.platypus.flowables import PageBreak

from ..base import Block
from ..blocks import Divider, SheetPage
from ..doc import ReportDoc

ROUNDS = 8  # what begins on a page of another may end on one that holds little
FULL = 0.8  # of the last page of a part: what is less is shared with what comes next


def run_on(story: Sequence[Any], doc: ReportDoc) -> tuple[list[Any], ReportDoc]:
    """The story with fewer pages that hold little, and it laid out; doc: the story as it is, laid out."""
    found = list(story)
    for _ in range(ROUNDS):
        again = _shared(found, doc.ends)
        if again is None:
            break
        found = again
        doc = ReportDoc(fresh(found), doc.metadata)
        doc.counted()
    return found, doc


def fresh(story: Sequence[Any]) -> list[Any]:
    """The story as no page has put it off yet."""
    found = [copy(item) if isinstance(item, Block) else item for item in story]
    for item in found:
        getattr(item, "__dict__", {}).pop("_postponed", None)
    return found


def _shared(story: Sequence[Any], ends: Sequence[tuple[int, float]]) -> list[Any] | None:
    """One round: every part that ends on a sparse page, with no sheet behind it."""
    out: list[Any] = []
    parts, told = split(story), iter(ends)
    for number, (text, behind) in enumerate(parts):
        full = next(told, (0, 1.0))[1] if text else 1.0
        sheets = any(isinstance(item, SheetPage) for item in behind)
        kept = full >= FULL or sheets or number == len(parts) - 1
        out += [*text, *(behind if kept else [Divider()])]
    return out if len(out) != len(story) or any(a is not b for a, b in zip(out, story, strict=True)) else None


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
    return isinstance(item, (PageBreak, SheetPage))
