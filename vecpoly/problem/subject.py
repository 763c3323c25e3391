"""What a problem may be about, beside a mechanism: anything that says what is given and what may be asked of it."""

from __future__ import annotations

from typing import ClassVar, Protocol

from ..names import Named


class Subject(Protocol):
    """The data of a task: a device, or what another sort of task is about."""

    kind: ClassVar[str]  # the sort of task, in a word

    def quantities(self) -> tuple[Named, ...]:
        """All that may be asked of it, in the order in which a solution gives it."""
        ...

    def given(self) -> tuple[tuple[str, str], ...]:
        """Symbol (notation of `formula`) and value as written of everything given, for the line 已知."""
        ...
