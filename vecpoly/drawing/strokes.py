"""Strokes of the compass as they are inked: short ones about the point that they find."""

from __future__ import annotations

import cmath
from typing import TypeGuard

from ..board.paper.marks import Arc, Block, Mark, Role
from ..board.paper.walls import holds
from ..foundation.slotted import replace

STROKE, SWUNG = 9.0, 14.0 + 1e-6  # mm: length of a stroke as it is inked, and as it is swung at most
TURN = 1.0 + 1e-9  # rad through which it is swung at most: a longer arc is a part of a circle


def short(marks: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """The marks with shorter strokes, so that the letter of the point that they find has room beside it; none about the
    pin of a block, beside which the rest of it would look like a sign."""
    blocks = [mark for mark in marks if isinstance(mark, Block)]
    return tuple(_short(mark) for mark in marks if not (_is_stroke(mark) and any(_under(mark, b) for b in blocks)))


def _short(mark: Mark) -> Mark:
    """A stroke, shorter about the same middle."""
    if not _is_stroke(mark) or mark.radius * mark.sweep <= STROKE:
        return mark
    sweep = STROKE / mark.radius
    return replace(mark, start=mark.start + (mark.sweep - sweep) / 2, sweep=sweep)


def _is_stroke(mark: Mark) -> TypeGuard[Arc]:
    """Whether it was swung about a point that it finds; a part of a circle is none."""
    if not isinstance(mark, Arc) or mark.role is not Role.CONSTRUCTION:
        return False
    return mark.radius * mark.sweep <= SWUNG and mark.sweep <= TURN


def _under(stroke: Arc, block: Block) -> bool:
    """Whether the block hides the point that a stroke finds."""
    return holds(block, stroke.centre + cmath.rect(stroke.radius, stroke.start + stroke.sweep / 2))
