"""A device: what no linkage is; its construction is a method of its own."""

from __future__ import annotations

from ...board.hand import Hand
from ...board.otherwise.amended import Amended
from ...devices.base import Device
from ...problem.problem import Problem
from ..desk import Desk
from ..devices.plan import construct_device
from ..drawing import Paper, draws
from ..drawn import Drawn


@draws(Device)
class DeviceDrawing:
    """The construction of a device; a moment on it has no sense."""

    turning = ("rad/s", "rad/s^2")

    def draw(self, problem: Problem, by: Hand, paper: Paper, amended: Amended, sketch: Desk | None = None) -> Drawn:
        """Figures of the size in which they are usually drawn."""
        return construct_device(problem, by, paper, amended)
