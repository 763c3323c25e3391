"""The scales of an epicyclic train: gears, velocities and angular velocities, such that rays may be carried over."""

from __future__ import annotations

from collections.abc import Mapping

from ....board.construction import Scale, View
from ....board.paper.scales import round_up
from ....board.place import view_named
from ....devices.gears.epicyclic import Epicyclic
from ....problem.problem import Scales

RADII, TURNS = view_named("radii"), view_named("turns")
HIGH, WIDE, SIDE = 110.0, 90.0, 110.0  # mm: across the gears; from the velocity farthest left to that farthest right; ω


def train_scales(train: Epicyclic, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    length = given.of(View.MECHANISM.mu) or round_up(2 * train.size / HIGH)
    speeds, turns = _sketched(train)
    speed = given.of(View.VELOCITY.mu) or round_up(_span(speeds) / WIDE)
    turn = given.of(TURNS.mu) or round_up(_span(turns) / SIDE)
    return {
        View.MECHANISM: Scale.of(View.MECHANISM, length),
        View.VELOCITY: Scale.of(View.VELOCITY, speed),
        RADII: Scale.of(RADII, length, speed),
        TURNS: Scale.of(TURNS, turn),
    }


def farthest_left(train: Epicyclic) -> float:
    """The greatest velocity to the left (m/s), by the sketch; 0 where there is none."""
    return max(*_sketched(train)[0], 0.0)


def _sketched(train: Epicyclic) -> tuple[list[float], list[float]]:
    """Velocities and angular velocities by a rough sketch: the planet's straight line through the two known points."""
    radii = train.radii
    (r1, v1), (r2, v2) = ((radii[key], omega.si * radii[key]) for key, omega in train.omegas.items() if omega)
    slope = (v2 - v1) / (r2 - r1)
    third = v1 + slope * (radii[train.sought] - r1)
    return [v1, v2, third], [v1 / r1, v2 / r2, third / radii[train.sought], slope]


def _span(values: list[float]) -> float:
    return max(*values, 0.0) - min(*values, 0.0)
