"""What a drawing of one problem is graded by: found once, for as many students as have this problem."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property, lru_cache

from ...board.otherwise.amended import Amended
from ...board.otherwise.slip import Slip
from ...errors import VecpolyError
from ...methods.desk import Desk
from ...mistakes import slips
from ...problem.problem import Problem
from ..allowance import CAD, Allowance
from .expected import Expected, Shape, expected, settled, sketch_of
from .judging.tolerance import Allowed, tolerances

KEPT = 16  # keys that are remembered: a class has one problem, or a variant for each of few groups


@dataclass(frozen=True, kw_only=True)
class DrawingKey:
    """The figures as they should be, T of each vector, and the figures that each catalogued mistake leads to."""

    problem: Problem
    exact: Expected
    allowance: Allowance
    allowed: Mapping[tuple[str, str], Allowed]
    sketch: Desk | None = field(default=None, repr=False)

    @cached_property
    def worlds(self) -> tuple[tuple[Slip, Expected], ...]:
        """Every mistake that can be drawn to its end, with what is then drawn."""
        found = []
        for slip in slips(self.problem):
            try:
                found.append((slip, expected(self.problem, Amended(slip=slip), self.sketch)))
            except (VecpolyError, ValueError, ArithmeticError):
                continue  # nobody can finish this drawing
        return tuple(found)

    @cached_property
    def variants(self) -> tuple[tuple[Shape, ...], ...]:
        """Of each figure what it should be, then what mistakes make of it."""
        return tuple(
            (shape, *(there for _, world in self.worlds if (there := world.shape(shape.name)) is not None))
            for shape in self.exact.shapes
        )


@lru_cache(maxsize=KEPT)
def drawing_key(problem: Problem, allowance: Allowance = CAD) -> DrawingKey:
    """The key by which all drawings of a problem are graded, found once. Raises what `solve` raises."""
    fixed = settled(problem)
    sketch = sketch_of(fixed)
    exact = expected(fixed, sketch=sketch)
    allowed = tolerances(fixed, exact.shapes, allowance)
    return DrawingKey(problem=fixed, exact=exact, allowance=allowance, allowed=allowed, sketch=sketch)
