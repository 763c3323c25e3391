"""Where a problem is from, as a page tells it."""

from __future__ import annotations

from ..words import Lang, Words

_EXERCISE = Words("习题 ", "Exercise ")
_OWN = ("自拟", "Our own")  # so a source begins that concerns only who made the problem


def printed_source(source: Words | None, lang: Lang, called: Words | None = None) -> str:
    """The book and the number; nothing of a problem of one's own, or of an exercise that is called by that number."""
    if source is None or source.of(lang).startswith(_OWN):
        return ""
    told = source.of(lang)
    return "" if called is not None and told == _EXERCISE.of(lang) + called.of(lang).partition(" ")[2] else told
