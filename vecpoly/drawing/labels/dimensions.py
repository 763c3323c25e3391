"""The letter of a dimension line: over it, or to its left, as drawings are read from below and from the right.
The name of a centre line or of a plane: in line with it."""

from __future__ import annotations

import cmath
import math

from ...board.paper.marks import Mark, Role, Segment, Vector
from ..style import THIN
from ..symbols.shapes import NEAR
from .want import Piece, Thing, Want

ALONG = (0.5, 0.42, 0.58, 0.34, 0.66, 0.26, 0.74)  # where along the line it may stand
LEVEL = 1e-9


def dimension_line(at: complex, marks: tuple[Mark, ...]) -> Vector | None:
    """The thin line with a head at both ends in the middle of which a letter stands."""
    thin = (m for m in marks if isinstance(m, Vector) and m.role is Role.CONSTRUCTION and not m.label)
    return next((m for m in thin if abs((m.a + m.b) / 2 - at) < NEAR and abs(m.b - m.a) > NEAR), None)


def over(line: Vector, pieces: tuple[Piece, ...]) -> Want:
    """Its letter, under the line only where there is no room over it."""
    n = 1j * (line.b - line.a) / abs(line.b - line.a)
    up = n if n.imag > LEVEL or (abs(n.imag) <= LEVEL and n.real < 0) else -n
    feet = tuple(line.a + (line.b - line.a) * part for part in ALONG)
    normals = (up,) * len(feet) + (-up,) * len(feet)
    return Want(pieces, feet * 2, normals, THIN / 2, (line.a, line.b), one_sided=True, thing=Thing.END)


def fan(ahead: complex, widest: int) -> tuple[complex, ...]:
    """This direction, and by 30° each those to both sides of it, the nearest first."""
    turns = (sign * math.radians(turn) for turn in range(30, widest + 1, 30) for sign in (1, -1))
    return (ahead, *(ahead * cmath.rect(1.0, turn) for turn in turns))


def beyond_end(pieces: tuple[Piece, ...], at: complex, line: Segment) -> Want:
    """A name at an end of a line, first of all in line with it."""
    u = (2 * at - line.a - line.b) / abs(line.b - line.a)
    ways = fan(u, 150)
    return Want(pieces, (at,) * len(ways), ways, THIN / 2, (at, at), one_sided=True, thing=Thing.END)
