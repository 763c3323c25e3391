"""Of what type a four-bar is that was found, or that the first loop of a chain of stages is."""

from __future__ import annotations

from collections.abc import Mapping
from math import nan

from ...designs.base import Design
from ...designs.inversion.loops import Hinged, sides
from ...designs.inversion.plan import FRAME, Plan
from ...designs.inversion.stages import Stages
from ...designs.straight_line import StraightLine
from ...words import Words
from ..grashof import grashof

_BARS = ("AB", "BC", "CD", "AD")


def type_of(design: Design, values: Mapping[str, float]) -> tuple[Words | None, float]:
    """The type with these lengths, and the margin of Grashof's condition (mm); no type where there are no four bars."""
    if isinstance(design, StraightLine):  # nothing is read of its bars
        values = {bar: 1e3 * length.si for bar, length in design.bars.items()}
    lengths = _chained(design.plan(), values) if isinstance(design, Stages) else [values.get(bar) for bar in _BARS]
    known = [length for length in lengths if length is not None]
    return grashof(*known) if len(known) == len(_BARS) else (None, nan)


def _chained(plan: Plan, values: Mapping[str, float]) -> list[float | None]:
    """The lengths of the first loop of four hinges, which the driver of a chain moves; none where it has none."""
    loop = next((loop for loop in plan.loops if isinstance(loop, Hinged)), None)
    pivots = {pin.letter: pin.at for pin in plan.pins if pin.on == FRAME}
    if loop is None or (loop.a, loop.b, loop.c, loop.d) != tuple("ABCD"):
        return []
    found: list[float | None] = []
    for one, two in sides(loop):
        apart = 1e3 * abs(pivots[two] - pivots[one]) if {one, two} <= pivots.keys() else None
        found.append(values.get(one + two, values.get(two + one, apart)))
    return found
