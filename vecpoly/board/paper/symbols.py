"""A symbol: what a link, a joint, a load or a machine looks like on a figure."""

from __future__ import annotations

from collections.abc import Iterable

from ...foundation.slotted import dataclass
from .marks import Mark


@dataclass(frozen=True, slots=True, kw_only=True)
class Symbol:
    """Marks that belong together.

    owner: whose they are (``link 2``, ``joint A``, ``frame``); key: of the quantity that they stand for, if any.
    """

    owner: str
    marks: tuple[Mark, ...]
    key: str = ""

    @classmethod
    def of(cls, owner: str, marks: Iterable[Mark], key: str = "") -> Symbol:
        """These marks, in this order."""
        return cls(owner=owner, marks=tuple(marks), key=key)
