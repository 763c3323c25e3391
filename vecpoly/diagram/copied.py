"""A figure of a mechanism drawn once more: its symbols, without what only helped to find the position."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

from ..board.paper.marks import AngleMark, Dot, Mark, Point, RightAngle, Role, Segment
from ..board.paper.symbols import Symbol
from ..foundation.slotted import replace


def copied(marks: Iterable[Mark], *, lettered: bool) -> Iterator[Symbol]:
    """The symbols on a figure, each still its owner's."""
    kept = (mark if lettered else _unlettered(mark) for mark in marks if not _helps(mark))
    for owner, own in groupby(kept, key=lambda mark: mark.owner):
        yield Symbol.of(owner, (replace(mark, step=0) for mark in own))


def _helps(mark: Mark) -> bool:
    """Whether a mark belongs to a construction: thin lines, their letters, angles."""
    lines = isinstance(mark, Segment) and mark.role in (Role.CONSTRUCTION, Role.HIDDEN)
    return lines or isinstance(mark, AngleMark | RightAngle) or (isinstance(mark, Point) and mark.dot is Dot.NONE)


def _unlettered(mark: Mark) -> Mark:
    return replace(mark, label="") if isinstance(mark, Point) else mark
