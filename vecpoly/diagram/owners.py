"""Whose a symbol is: a link's, a joint's, the frame's."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import groupby

from ..board.paper.marks import FixedGuide, Ground, Mark
from ..board.paper.symbols import Symbol
from ..mechanism.joints import FRAME

FIXED = "frame"


def link(name: str) -> str:
    """A link as an owner."""
    return FIXED if name == FRAME else f"link {name}"


def joint(letter: str) -> str:
    """A joint as an owner."""
    return f"joint {letter}"


def owned(owner: str, marks: Iterable[Mark]) -> Iterator[Symbol]:
    """Marks of one owner, in order; grounds and fixed guides among them are the frame's."""
    for whose, own in groupby(marks, lambda mark: FIXED if isinstance(mark, Ground | FixedGuide) else owner):
        yield Symbol.of(whose, own)
