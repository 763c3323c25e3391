"""Strokes of the compass as they are inked: short ones about the point that they find."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from ..board.paper.marks import Arc, Mark, Role

STROKE, SWUNG = 9.0, 14.0 + 1e-6  # mm: length of a stroke as it is inked, and as it is swung at most
TURN = 1.0 + 1e-9  # rad through which it is swung at most: a longer arc is a part of a circle


def short(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks with shorter strokes, so that the letter of the point that they find has room beside it."""
    return tuple(_short(mark) if isinstance(mark, Arc) and mark.role is Role.CONSTRUCTION else mark for mark in marks)


def _short(arc: Arc) -> Arc:
    """About the same middle; a part of a circle stays as it is."""
    if not STROKE < arc.radius * arc.sweep <= SWUNG or arc.sweep > TURN:
        return arc
    sweep = STROKE / arc.radius
    return replace(arc, start=arc.start + (arc.sweep - sweep) / 2, sweep=sweep)
