"""By what the dashed circles of a curvature drawing, and the positions of a rack, are told from their like."""

from __future__ import annotations

from ...board.construction import Figure
from ...board.paper.marks import Arc, Mark, Role, Segment
from .letters import is_of_gear
from .met import Met, on_curvature, traced


def is_return_circle(figure: Figure, mark: Mark) -> bool:
    """Whether it is the mirror image of the inflection circle, as large as that."""
    inflection = (one.radius for one in figure.marks if isinstance(one, Arc) and one.role is Role.GIVEN)
    drawn = on_curvature(Role.HIDDEN, Arc)(figure, mark)
    return drawn and isinstance(mark, Arc) and any(abs(mark.radius - radius) < 1e-6 for radius in inflection)


def osculating(figure: Figure, mark: Mark) -> bool:
    """Whether it is the circle that a path has in common with its centre of curvature."""
    return on_curvature(Role.HIDDEN, Arc)(figure, mark) and not is_return_circle(figure, mark)


def of_rack(*, generating: bool) -> Met:
    """Whether it is another position of a rack that generates a gear, or of something else."""
    drawn = traced(Role.PLACE, Segment)
    return lambda figure, mark: drawn(figure, mark) and is_of_gear(figure) is generating
