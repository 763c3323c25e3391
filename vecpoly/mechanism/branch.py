"""Which of the two assemblies: a branch statement read on a set of positions."""

from __future__ import annotations

from collections.abc import Mapping

from .model import Side, SideOf


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
