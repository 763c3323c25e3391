"""The parts of a solution that are marked together: diagram, velocities, accelerations, forces."""

from __future__ import annotations

from ...board.place import View

DIAGRAM, VELOCITY, ACCELERATION, FORCE, OTHER = "diagram", "velocity", "acceleration", "force", "other"
_OF_UNIT = {
    "m": DIAGRAM,
    "m/s": VELOCITY,
    "rad/s": VELOCITY,
    "m/s^2": ACCELERATION,
    "rad/s^2": ACCELERATION,
    "N": FORCE,
    "N·m": FORCE,
}


def block_of(view: View | None, unit: str = "") -> str:
    """The part that a figure, or else a quantity of this unit, belongs to."""
    return _OF_UNIT.get(unit if view is None else view.mu.unit, OTHER)
