"""Beside which part of an arc its letter may stand: nowhere where another arc about the same point lies between."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence

from ...board.paper.marks import Mark
from ..style import THIN
from ..symbols.angles import Arc, sweep_of
from ..symbols.shapes import NEAR
from .want import Piece, Thing, Want

BESIDE = math.radians(12)  # a letter beside an arc covers so much of it, to either side, and a little more
CHORDS = 8  # of an arc
REACH = 9.0  # mm beyond an arc within which its letter is taken for that of another


def bow(arc: Arc, piece: Piece, marks: Iterable[Mark], fractions: Sequence[float]) -> Want:
    """The letter of an arc, beside it, outside or inside."""
    sweep = sweep_of(arc)
    others = [one for one in marks if isinstance(one, Arc) and one is not arc and abs(one.at - arc.at) < NEAR]
    outer = [one for one in others if arc.radius + NEAR < one.radius < arc.radius + REACH]
    ways = [arc.start + sweep * f for f in fractions]
    free = [way for way in ways if not any(_spans(one, way) for one in outer)] or ways
    out = tuple(cmath.exp(1j * way) for way in free)
    feet, line = tuple(arc.at + arc.radius * u for u in out), along(arc)
    return Want((piece,), feet, out, THIN, (arc.at, arc.at), thing=Thing.ARC, bow=line)


def along(arc: Arc) -> tuple[complex, ...]:
    """An arc by points."""
    sweep = sweep_of(arc)
    return tuple(arc.at + cmath.rect(arc.radius, arc.start + sweep * k / CHORDS) for k in range(CHORDS + 1))


def _spans(arc: Arc, way: float) -> bool:
    """Whether an arc passes a direction, or ends beside it."""
    sweep = sweep_of(arc)
    turned = (way - arc.start) * math.copysign(1.0, sweep)
    return (turned + BESIDE) % (2 * math.pi) < abs(sweep) + 2 * BESIDE
