"""The marks of a figure as they are inked: supports and arcs where they cross nothing, each angle once and with both
rays, short strokes of the compass."""

from __future__ import annotations

from ..board.construction import View
from ..board.paper.marks import Ground, Mark
from .hung import hung
from .rays import rayed
from .strokes import short
from .swung import marked_once, swung


def cleared(view: View, marks: tuple[Mark, ...], held: tuple[Ground, ...] = ()) -> tuple[Mark, ...]:
    """held: the supports as they stand in another position, to stay so."""
    return short(rayed(view, swung(hung(marked_once(marks), held))))
