"""Where a problem is from, as a page tells it."""

from __future__ import annotations

from ..words import Lang, Words

_OWN = ("自拟", "Our own")  # so a source begins that concerns only who made the problem


def printed_source(source: Words | None, lang: Lang) -> str:
    """The book and the number; nothing of a problem of one's own."""
    if source is None or source.of(lang).startswith(_OWN):
        return ""
    return source.of(lang)
