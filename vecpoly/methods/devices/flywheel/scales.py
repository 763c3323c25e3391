"""The scales of a flywheel's figures: the diagram as wide as a page, so high that its areas can be read."""

from __future__ import annotations

from collections.abc import Mapping

from ....board.construction import Scale, View
from ....board.place import view_named
from ....devices.dynamics.flywheel import Flywheel
from ....devices.dynamics.given import Torques
from ....problem.problem import Scales
from ..cam.scales import fitting

TORQUE, INDICATOR = view_named("torque"), view_named("indicator")
WIDE, HIGH, BAR = 155.0, 90.0, 90.0  # mm: along φ; from the lowest moment to the highest; the bar from end to end


def flywheel_scales(wheel: Flywheel, given: Scales) -> Mapping[View, Scale]:
    """As given, or round ones that fit."""
    load = wheel.load
    energy = given.of(INDICATOR.mu) or fitting(load.swing / BAR)
    scales = {INDICATOR: Scale.of(INDICATOR, energy)}
    if isinstance(load, Torques):
        low, high = load.highest
        assert TORQUE.across is not None
        moment = given.of(TORQUE.mu) or fitting((high - low) / HIGH)
        scales[TORQUE] = Scale.of(TORQUE, moment, given.of(TORQUE.across) or fitting(load.period / WIDE))
    return scales
