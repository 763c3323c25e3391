"""What is done to a whole story before it is set: its contents told, its white made less."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .base import Block
from .blocks import Heading
from .contents import Contents, Entry

TIGHT = 0.5  # of the white between parts, where that saves a page


def tightened(story: Sequence[Any]) -> Sequence[Any]:
    """The story with less white between its parts, as one sets it to save a page."""
    for item in story:
        if isinstance(item, Block):
            item.spaceBefore, item.spaceAfter = TIGHT * item.spaceBefore, TIGHT * item.spaceAfter
    return story


def tell_contents(story: Sequence[Any]) -> None:
    """Give every table of contents the headings after it, under the bookmarks they will have."""
    outlined = [item for item in story if getattr(item, "outline", "") or isinstance(item, Contents)]
    count, entries, waiting = 0, list[Entry](), list[tuple[Contents, int]]()
    for item in outlined:
        if isinstance(item, Contents):
            waiting.append((item, len(entries)))
            continue
        count += 1
        if isinstance(item, Heading) and item.level in (2, 3):
            entries.append(Entry(item.text, item.level, f"h{count}"))
    for contents, start in waiting:
        contents.entries = tuple(entries[start:])
