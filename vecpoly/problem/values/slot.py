"""Where one quantity stands in the values of a problem, and the names by which it may be varied."""

from __future__ import annotations

from ...foundation.slotted import dataclass
from ...units.reading import Dim
from ..schema.faults import Path, dotted


@dataclass(frozen=True, slots=True)
class Slot:
    """Where one quantity stands: its path, its dimension (None: a pure number, or a device's), its short names.

    span: the part of the text that is the quantity, where it is not the whole; several: of several in one text. unit:
    the one that stands behind the bracket, where the number has none of its own. A point is two texts (`pair`).
    """

    path: Path
    dim: Dim | None
    names: tuple[str, ...] = ()
    span: tuple[int, int] | None = None
    pair: bool = False
    several: bool = False
    unit: str = ""

    @property
    def full(self) -> str:
        """The name that no other has: links.2.E.angle; of one of several in a text joints[0].e_3."""
        return dotted(self.path) + (f".{self.names[0]}" if self.several else "")
