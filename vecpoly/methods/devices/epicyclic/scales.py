"""The scales of an epicyclic train: gears, velocities and angular velocities, such that rays may be carried over."""

from __future__ import annotations

from collections.abc import Mapping

from ....board.construction import Scale, View
from ....board.paper.scales import round_up
from ....board.place import view_named
from ....devices.gears.epicyclic import Epicyclic
from ....problem.problem import Scales

RADII, TURNS = view_named("radii"), view_named("turns")
HIGH, WIDE, SIDE = 110.0, 60.0, 60.0  # mm: across the gears; to the largest velocity; to the largest ω of a known link


def train_scales(train: Epicyclic, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    length = given.of(View.MECHANISM.mu) or round_up(2 * train.size / HIGH)
    known = {key: omega.si for key, omega in train.omegas.items() if omega is not None}
    fastest = max(abs(omega) * train.radii[key] for key, omega in known.items()) or 1.0
    speed = given.of(View.VELOCITY.mu) or round_up(fastest / WIDE)
    turn = given.of(TURNS.mu) or round_up(max(map(abs, known.values())) / SIDE or 1.0)
    return {
        View.MECHANISM: Scale.of(View.MECHANISM, length),
        View.VELOCITY: Scale.of(View.VELOCITY, speed),
        RADII: Scale.of(RADII, length, speed),
        TURNS: Scale.of(TURNS, turn),
    }
