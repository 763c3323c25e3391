"""A mechanism: position, velocities, accelerations, forces, group by group, its figures on one sheet where they fit."""

from __future__ import annotations

from ...board.hand import Hand
from ...board.otherwise.amended import Amended
from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from ..desk import Desk
from ..drawing import Paper, draws
from ..drawn import Drawn
from ..plan import construct


@draws(Mechanism)
class Analysis:
    """The analysis of a mechanism."""

    turning = ("rad/s", "rad/s^2", "N·m")

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """Each figure as large as the sheets allow."""
        return construct(problem, by, paper, amended, sketch)
