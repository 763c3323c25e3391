"""A kind of line or symbol that a legend explains."""

from __future__ import annotations

from collections.abc import Callable

from ...board.paper.marks import Mark
from ...foundation.slotted import dataclass
from ...words import Words
from .met import Met
from .samples import Marks


@dataclass(frozen=True, slots=True, kw_only=True)
class Kind:
    """met: whether a mark of a figure is one; sample: how it looks, by one that was met; brief: its words beside those
    of another kind that looks the same."""

    words: Words
    met: Met
    sample: Callable[[Mark], Marks]
    black: bool = False
    plain: bool = False
    brief: Words | None = None
