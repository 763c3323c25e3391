"""A task of synthesis: what is to be found is the mechanism itself."""

from __future__ import annotations

from ...board.hand import Hand
from ...board.otherwise.amended import Amended
from ...designs.base import Design
from ...problem.problem import Problem
from ..desk import Desk
from ..drawing import Paper, draws
from ..drawn import Drawn
from ..synthesis.plan import construct_design


@draws(Design)
class DesignDrawing:
    """The construction of every linkage that fits the data."""

    turning = ()

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """One sheet with all solutions, and one of each that tells its transmission angle."""
        return construct_design(problem, by, paper, amended)
