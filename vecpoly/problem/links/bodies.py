"""What has been read of a mechanism so far: the frame's points and the drafts of its links."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import field

from ...errors import FaultError
from ...foundation.slotted import dataclass
from ...mechanism.model import Contact
from ...words import Words
from ..problem import Shape
from ..schema.faults import meant
from .draft import Draft


@dataclass(frozen=True, slots=True)
class Bodies:
    """The frame's points and the links read so far."""

    frame: Mapping[str, complex]
    drafts: dict[str, Draft]
    pitch: list[str] = field(default_factory=list)  # letters of pitch points and contacts
    contacts: list[Contact] = field(default_factory=list)
    welded: dict[str, str] = field(default_factory=dict)  # rollers -> the links to which they were welded

    def draft(self, name: str) -> Draft:
        """The moving link `name`; for a roller the link to which it is welded."""
        name = self.welded.get(name, name)
        if name not in self.drafts:
            raise FaultError(
                Words(f"构件“{name}”不存在", f"link '{name}' does not exist") + meant(name, self.numbers),
                code="unknown-name",
            )
        return self.drafts[name]

    @property
    def numbers(self) -> tuple[str, ...]:
        """The moving links that the file names,
        without those that are only thought about pins in slots and at contacts."""
        return tuple(name for name, draft in self.drafts.items() if draft.shape is not Shape.PIN)

    def free(self, name: str) -> str:
        """A name that no link has yet."""
        while name in self.drafts:
            name += "′"
        return name

    def letters(self) -> tuple[str, ...]:
        """All letters: the frame's first, then link by link."""
        return tuple(dict.fromkeys([*self.frame, *(p for draft in self.drafts.values() for p in draft.points)]))


def frame_number(bodies: Bodies) -> str:
    """The frame's number as printed: one more than the highest of the links."""
    return str(1 + max(int(m[0]) for name in (*bodies.drafts, *bodies.welded) if (m := re.match(r"\d+", name))))
