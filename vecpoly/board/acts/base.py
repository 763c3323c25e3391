"""What every act knows."""

from __future__ import annotations

from typing import ClassVar

from ...foundation.slotted import dataclass
from ...words import Words
from ..place import Place, called, named


@dataclass(frozen=True, slots=True, kw_only=True)
class Head:
    """What every act knows of itself."""

    number: int
    step: int
    inputs: tuple[int, ...] = ()
    place: Place | None = None
    key: str = ""
    owner: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Done:
    """An act: what it is and what it gave is told by its kind.

    verb: what is done, as a list of acts tells it; None of acts that only leave ink.
    """

    verb: ClassVar[Words | None] = None
    head: Head

    @property
    def number(self) -> int:
        """Its number on the sheet."""
        return self.head.number

    @property
    def key(self) -> str:
        """What it stands for."""
        return self.head.key

    @property
    def figure(self) -> str:
        """The figure it was done on: ``velocity``, ``force 23``."""
        return "" if self.head.place is None else called(self.head.place)

    @property
    def names(self) -> tuple[str, ...]:
        """Its key with the figure before it, ``velocity:bc``, and alone; none where it stands for nothing."""
        return named(self.head.place, self.key) if self.key else ()

    @property
    def inputs(self) -> tuple[int, ...]:
        """The numbers of the acts that it needed."""
        return self.head.inputs
