"""The positions of a body or of a link that a synthesis is given: they stand in its frame, to scale, as a textbook
prints them."""

from __future__ import annotations

from collections.abc import Sequence

from ....board.paper.marks import Dot, Ground, Mark, Outline, Point, Role, Segment
from ....designs.generator.function_generator import FunctionGenerator
from ....designs.grashof import Grashof
from ....designs.inversion.angle_pairs import AnglePairs
from ....designs.inversion.positions import Positions
from ....designs.inversion.stages import Stages
from ....designs.limit_lines import LimitLines
from ....problem.problem import Problem
from ...sizes.limits import lines_of_limits

_SHOWN = (Role.GIVEN, Role.HIDDEN)


def poses(problem: Problem, told: Sequence[Mark]) -> tuple[Mark, ...]:
    """Points, lines and bodies in the positions that are given, without fixed pivots; told: all that is given. Angles
    at which a function is met are computed first, and none where they are."""
    match problem.subject:
        case Positions() | Stages() | AnglePairs() | FunctionGenerator(function=None):
            pivots = [mark.at for mark in told if isinstance(mark, Ground)]
            return tuple(mark for mark in told if _shown(mark, pivots))
        case LimitLines() as subject:
            return (*(mark for mark in told if isinstance(mark, Point)), *lines_of_limits(subject, told))
        case Grashof():  # the sums of lengths begin here
            return tuple(mark for mark in told if isinstance(mark, Point) and mark.label[:1] == "O")
        case _:
            return ()


def _shown(mark: Mark, pivots: Sequence[complex]) -> bool:
    if isinstance(mark, Segment):
        return mark.role in _SHOWN
    if isinstance(mark, Point):
        return mark.dot is not Dot.NONE and mark.at not in pivots
    return isinstance(mark, Outline)
