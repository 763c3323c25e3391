"""Which of the two assemblies: a branch statement read on a set of positions."""

from __future__ import annotations

from collections.abc import Mapping

from .model import Side, SideOf


def nearer(guesses: Mapping[str, complex], one: Mapping[str, complex], two: Mapping[str, complex], hair: float) -> int | None:
    """Which of two assemblies (0 or 1: positions of letters, m) lies nearer to the rough places; None where they do not tell.

    hair: sums of distances (m) that differ by less are the same.
    """
    off = [sum(abs(at[p] - place) for p, place in guesses.items() if p in one and p in two) for at in (one, two)]
    return None if abs(off[0] - off[1]) < hair else int(off[1] < off[0])


def margin(statement: SideOf, at: Mapping[str, complex]) -> float:
    """How far (m) the statement is fulfilled at these positions; negative where it is not.

    left/right of a ray: signed distance from the ray's line; above/below a line: signed distance with the line
    directed to the right; left/right/above/below of a single point: difference of abscissas or ordinates.
    """
    point = at[statement.point]
    first = at[statement.ref[0]]
    if len(statement.ref) == 1:
        gap = point - first
        value = gap.real if statement.side in (Side.LEFT, Side.RIGHT) else gap.imag
        return -value if statement.side in (Side.LEFT, Side.BELOW) else value
    ray = at[statement.ref[1]] - first
    if statement.side in (Side.ABOVE, Side.BELOW) and ray.real < 0:
        ray = -ray
    left = (ray.conjugate() * (point - first)).imag / abs(ray)
    return left if statement.side in (Side.LEFT, Side.ABOVE) else -left
