"""Which of the two assemblies: a branch statement read on a set of positions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import assert_never

from ...foundation.slotted import replace
from ...words import Words
from ..dimensions.placements import Side
from .statements import Form, Shaped, SideOf, Statement

_OPPOSITE = {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT, Side.ABOVE: Side.BELOW, Side.BELOW: Side.ABOVE}


def nearer(
    guesses: Mapping[str, complex], one: Mapping[str, complex], two: Mapping[str, complex], hair: float
) -> int | None:
    """Which of two assemblies (0 or 1: positions of letters, m) lies nearer to the rough places;
    None where they do not tell.

    hair: sums of distances (m) that differ by less are the same.
    """
    off = [sum(abs(at[p] - place) for p, place in guesses.items() if p in one and p in two) for at in (one, two)]
    return None if abs(off[0] - off[1]) < hair else int(off[1] < off[0])


def margin(statement: Statement, at: Mapping[str, complex]) -> float:
    """How far (m) the statement is fulfilled at these positions; negative where it is not.

    left/right of a ray: signed distance from the ray's line; above/below a line: signed distance with the line directed
    to the right, 0 where the two points of the ray fall together; left/right/above/below of a single point: difference
    of abscissas or ordinates. Of a four-bar: how much nearer its third corner is to its place in the one figure than in
    the other.
    """
    match statement:
        case SideOf():
            return _beside(statement, at)
        case Shaped(corners=(a, b, c, d), form=form):
            crossed, parallel = (abs(at[c] - corner) for corner in third_corners(at[a], at[b], at[d]))
            return crossed - parallel if form is Form.PARALLELOGRAM else parallel - crossed
        case _:
            assert_never(statement)


def third_corners(a: complex, b: complex, d: complex) -> tuple[complex, complex]:
    """C of the antiparallelogram ABCD (A mirrored in the bisector of BD), and of the parallelogram: B + D - A."""
    across = (d - b) / abs(d - b) if d != b else 1 + 0j
    middle = (b + d) / 2
    return middle - across * ((a - middle) / across).conjugate(), b + d - a


def not_yet(statements: Iterable[Statement], about: str, placed: Iterable[str]) -> Words | None:
    """Why the first statement about this letter that could tell does not: it names a letter that is placed later."""
    known = {*placed}
    for statement in statements:
        if about in statement.letters and (later := sorted({*statement.letters} - known)):
            names, verb = " and ".join(later), "is" if len(later) == 1 else "are"
            return Words(
                f"“{statement}”在这里无法判断，因为点 {'、'.join(later)} 在其后才能定位",
                f"'{statement}' cannot be read here, for {names} {verb} placed later",
            )
    return None


def opposite(statement: Statement) -> Statement:
    """The statement of the other assembly."""
    match statement:
        case SideOf(side=side):
            return replace(statement, side=_OPPOSITE[side])
        case Shaped(form=form):
            return replace(statement, form=next(other for other in Form if other is not form))
        case _:
            assert_never(statement)


def _beside(statement: SideOf, at: Mapping[str, complex]) -> float:
    point = at[statement.point]
    first = at[statement.ref[0]]
    if len(statement.ref) == 1:
        gap = point - first
        value = gap.real if statement.side in (Side.LEFT, Side.RIGHT) else gap.imag
        return -value if statement.side in (Side.LEFT, Side.BELOW) else value
    ray = at[statement.ref[1]] - first
    if statement.side in (Side.ABOVE, Side.BELOW) and ray.real < 0:
        ray = -ray
    left = (ray.conjugate() * (point - first)).imag / abs(ray) if ray else 0.0
    return left if statement.side in (Side.LEFT, Side.ABOVE) else -left
