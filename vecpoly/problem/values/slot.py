"""Where one quantity stands in the values of a problem, and the names by which it may be varied."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from ...foundation.patterns import pattern
from ...foundation.slotted import dataclass
from ...units.reading import Dim
from ..schema.faults import Path, dotted
from ..text.source import Value

_ANGLED = pattern(r"(.+?)(?:\s+from\s.*)?", re.S)  # 50 deg from BC


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


def there(data: Value, keys: Mapping[str, object]) -> list[str]:
    """Those of these keys under which a single value stands."""
    return [
        key
        for key in keys
        if isinstance(data, Mapping) and data.get(key) is not None and not isinstance(data[key], Mapping | list)
    ]


def keyed(path: Path, data: Value, keys: Mapping[str, tuple[str, Dim]]) -> Iterator[Slot]:
    """The quantities under these keys, each with its short name and its dimension."""
    for key in there(data, keys):
        name, dim = keys[key]
        yield Slot((*path, key), dim, (name,), angle_span(data[key]) if dim is Dim.ANGLE else None)


def angle_span(text: Value) -> tuple[int, int] | None:
    """The angle alone of `50 deg from BC`."""
    m = _ANGLED.fullmatch(text) if isinstance(text, str) else None
    return m.span(1) if m and m.end(1) < len(text) else None
