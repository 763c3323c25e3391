"""A file that is held in memory: what a resolver gives in its place."""

from __future__ import annotations

from dataclasses import field
from pathlib import PurePath

from ...foundation.slotted import dataclass


@dataclass(frozen=True, slots=True)
class Held:
    """The bytes of a file and its name; to be read where a path may be read."""

    path: str
    data: bytes = field(repr=False)

    @property
    def name(self) -> str:
        """The last part of its path."""
        return PurePath(self.path).name

    @property
    def suffix(self) -> str:
        """.csv, .xlsx."""
        return PurePath(self.path).suffix

    def __str__(self) -> str:
        return self.path
