"""The three force polygons of a pair of wedges: driven, without friction, on the return stroke;
each joined from two at their common side."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from ...board.construction import Pane
from ...names import Named
from ...plane import Points
from ...words import Words
from .equilibrium import ALONG_N, OFF_N, frictionless, reversed_way


@dataclass(frozen=True, slots=True)
class Stroke:
    """One of the polygons: its title, the force on wedge 1 that it gives,
    what marks its corners and reactions, how these lie."""

    title: Words
    drive: Named
    mark: str
    force: Callable[[Named], Named]
    lean: Words

    def corners(self) -> tuple[str, str]:
        """Letters of the corners that differ: c and d, c_0 and d_0, c' and d'."""
        return f"c{self.mark}", f"d{self.mark}"


def strokes(drive: Named, ideal: Named, hold: Named, driven: Words, back: Words) -> tuple[Stroke, Stroke, Stroke]:
    """The strokes of a device from its forces: driving, ideal, holding;
    driven, back: what the first and the last are called."""
    polygon = Words("力多边形（", "Force polygon, ")
    end = Words("）", "")
    return (
        Stroke(polygon + driven + end, drive, "", lambda force: force, OFF_N),
        Stroke(polygon + Words("无摩擦", "no friction") + end, ideal, "_0", frictionless, ALONG_N),
        Stroke(polygon + back + end, hold, "'", reversed_way, OFF_N),
    )


@dataclass(frozen=True, slots=True)
class Corners:
    """The joined polygon as drawn: Q = ab; c on wedge 2, d on wedge 1."""

    place: Pane
    a: Points
    b: Points
    c: Points
    d: Points
