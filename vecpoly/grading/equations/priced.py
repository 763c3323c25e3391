"""What the rows of equations are worth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...foundation.slotted import replace
from ..key import Graded
from .row import EquationRow


def priced(
    rows: Sequence[EquationRow], graded: Sequence[Graded], equation: Mapping[str, float]
) -> tuple[EquationRow, ...]:
    """The rows with their points: of each part so many, and no more than there are for its lines.

    equation: part → points.
    """
    found = []
    for row in rows:
        lines = sum(one.points.method for one in graded if one.block == row.block)
        beside = sum(other.block == row.block for other in rows)
        found.append(replace(row, points=min(equation.get(row.block, 0.0), lines) / beside))
    return tuple(found)
