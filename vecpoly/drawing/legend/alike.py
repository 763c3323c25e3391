"""Entries of a legend whose samples cannot be told from each other: they share one, and its words name them all."""

from __future__ import annotations

from collections.abc import Sequence

from ...words import Words
from ..scene import Stroke
from .entry import Entry

NEARLY = 0.11  # mm: of two lines so near in width none looks the thicker one


def alike(some: Sequence[Entry]) -> list[list[Entry]]:
    """The entries, those together that look the same, each where the first of them stood."""
    found: list[list[Entry]] = []
    for one in some:
        same = next((shared for shared in found if _looks_like(one, shared[0])), None)
        if same is None:
            found.append([one])
        else:
            same.append(one)
    return found


def joined(shared: Sequence[Entry]) -> Words:
    """What one sample stands for: one thing, or several in few words."""
    if len(shared) == 1:
        return shared[0].words
    told = dict.fromkeys(one.words if one.brief is None else one.brief for one in shared)
    return Words("、".join(one.zh for one in told), ", ".join(one.en for one in told))


def _looks_like(one: Entry, other: Entry) -> bool:
    """Whether both are lines of one pattern and ink, of about one width, or the same altogether."""
    if one.sample == other.sample:
        return True
    if len(one.sample) != 1 or len(other.sample) != 1:
        return False
    (a,), (b,) = one.sample, other.sample
    if not (isinstance(a, Stroke) and isinstance(b, Stroke)) or a.points != b.points:
        return False
    return (a.dash, a.hue) == (b.dash, b.hue) and abs(a.width - b.width) < NEARLY
