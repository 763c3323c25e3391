"""What has been read of a mechanism so far: the frame's points and the drafts of its links."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from ..errors import FaultError
from ..mechanism.model import Contact
from ..words import Words
from .draft import Draft
from .faults import meant


@dataclass(frozen=True, slots=True)
class Bodies:
    """The frame's points and the links read so far."""

    frame: Mapping[str, complex]
    drafts: dict[str, Draft]
    pitch: list[str] = field(default_factory=list)  # letters of pitch points and contacts
    contacts: list[Contact] = field(default_factory=list)

    def draft(self, name: str) -> Draft:
        """The moving link `name`."""
        if name not in self.drafts:
            raise FaultError(Words(f"构件“{name}”不存在", f"link '{name}' does not exist") + meant(name, self.drafts))
        return self.drafts[name]

    def letters(self) -> tuple[str, ...]:
        """All letters: the frame's first, then link by link."""
        return tuple(
            dict.fromkeys([*self.frame, *(p for draft in self.drafts.values() for p in draft.points)])
        )
