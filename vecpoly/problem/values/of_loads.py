"""The quantities of a load."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...units.reading import Dim
from ..schema.faults import Path
from ..text.source import Value
from .slot import Slot, keyed


def of_load(path: Path, name: str, load: Mapping[str, Value]) -> Iterator[Slot]:
    """Size and direction; of a spring k_F_s, l_0_F_s, c_F_s; the ends of windows: from_F and to_F, low_F and high_F."""
    force = "direction" in load or "cylinder" in load
    ends = str(load.get("spring") or load.get("damper") or "")
    turns = ends[:1].isdigit()
    kinds = {
        "size": (name, Dim.FORCE if force else Dim.MOMENT),
        "direction": (f"direction_{name}", Dim.ANGLE),
        "k": (f"k_{name}", Dim.TWIST if turns else Dim.STIFFNESS),
        "l_0": (f"l_0_{name}", Dim.LENGTH),
        "phi_0": (f"phi_0_{name}", Dim.ANGLE),
        "preload": (f"preload_{name}", Dim.MOMENT if turns else Dim.FORCE),
        "c": (f"c_{name}", Dim.DRAG if turns else Dim.DAMPING),
    }
    yield from keyed(path, load, kinds)
    yield from keyed(
        (*path, "size"), load.get("size"), {"bore": (f"bore_{name}", Dim.LENGTH), "area": (f"area_{name}", Dim.AREA)}
    )
    yield from _pair((*path, "motor"), load.get("motor"), ((f"a_{name}", Dim.MOMENT), (f"b_{name}", Dim.DRAG)))
    yield from _pair((*path, "during"), load.get("during"), ((f"from_{name}", Dim.ANGLE), (f"to_{name}", Dim.ANGLE)))


def _pair(path: Path, value: Value, names: tuple[tuple[str, Dim], tuple[str, Dim]]) -> Iterator[Slot]:
    if isinstance(value, list) and len(value) == 2:
        for i, (name, dim) in enumerate(names):
            yield Slot((*path, i), dim, (name,))
