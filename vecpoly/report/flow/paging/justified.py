"""Pages of text end at one height: the white between the blocks of a page that is nearly full is opened as far as its
foot, as a compositor does by hand."""

from __future__ import annotations

from collections.abc import Sequence

NEARLY = 0.75  # of a page: what holds less ends where it ends
OPENEST = 1.04  # times as much white, at most
SHARE = 0.96  # of the room that is left: no block may be pushed from its page


def stretches(filled: Sequence[float], white: Sequence[float], height: float) -> tuple[float, ...]:
    """By how much the white of each page is opened; filled: how full it is, white: what it has of it, height: of its
    column, in points."""
    return tuple(_stretch(full, room, height) for full, room in zip(filled, white, strict=True))


def _stretch(full: float, white: float, height: float) -> float:
    left = SHARE * (1 - full) * height
    return min(OPENEST, 1 + left / white) if full >= NEARLY and white > 0 and left > 0 else 1.0
