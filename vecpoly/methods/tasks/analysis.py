"""A mechanism: position, velocities, accelerations, forces, group by group, its figures on one sheet where they fit."""

from __future__ import annotations

from collections.abc import Mapping

from ...board.hand import Hand
from ...board.otherwise.amended import Amended
from ...board.place import View, views
from ...mechanism.model import Mechanism
from ...problem.problem import Problem
from ..desk import Desk
from ..drawing import Paper, draws
from ..drawn import Drawn
from ..passes import needs_centres, stages
from ..plan import construct

POLYGON = (105.0, 70.0)  # mm that a force polygon should fill
BESIDE = (125.0, 85.0)  # mm that a diagram should fill beside the large figure of its curvatures


@draws(Mechanism)
class Analysis:
    """The analysis of a mechanism."""

    turning = ("rad/s", "rad/s^2", "N·m")

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """Each figure as large as its place on the sheet allows."""
        if problem.loads is not None or (problem.machine is not None and problem.machine.run is not None):
            return construct(problem, by, _of_forces(paper), amended=amended, sketch=sketch)
        if problem.curvature is not None:
            slots = {view: BESIDE if view is View.MECHANISM else POLYGON for view in views()}
            return construct(problem, by, slots, amended=amended, sketch=sketch)
        drawn = sorted({View.MECHANISM, *(stage.view for stage in stages(problem))})
        places = paper.slots(len(drawn) + needs_centres(problem))
        return construct(problem, by, dict(zip(drawn, places, strict=False)), paper.fits, amended, sketch)


def _of_forces(paper: Paper) -> Mapping[View, tuple[float, float]]:
    """Free bodies and force polygons go on sheets of their own, in pairs."""
    return {view: POLYGON if view is View.FORCE else paper.room(view, 3) for view in views()}
