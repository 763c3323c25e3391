"""Round scales of the diagrams of a period: as wide as a page, so high that their areas can be read."""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose

import numpy as np

from ...board.construction import Scale
from ...board.paper.scales import finer, round_up
from ...board.place import view_named
from ...problem.problem import Scales
from .french import French

TORQUE, ENERGY, INDICATOR = view_named("torque"), view_named("energy"), view_named("indicator")
INERTIA, WITTENBAUER = view_named("inertia"), view_named("energy-mass")
WIDE, HIGH, LOW, BAR = 150.0, 80.0, 55.0, 90.0  # mm: along φ; moments; inertias; energies
LOOP, TALL = 130.0, 200.0  # mm: along J_e; energies on its figure, as high as a page
ALIKE = 1.6  # times: the bar is so much shorter, at most, for the sake of one μ_E
POLES = (60.0, 50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 10.0, 8.0, 5.0, 4.0, 3.0, 2.0, 1.0)  # mm: pole distances


@dataclass(frozen=True, slots=True, kw_only=True)
class Sizes:
    """The scales; pole: H (mm), with which μ_E = H μ_M μ_φ."""

    torque: Scale
    inertia: Scale
    energy: Scale
    indicator: Scale
    loop: Scale
    pole: float


def sizes_of(
    curve: French, given: Scales, heights: tuple[float, float], swing: float, *, speed: float = 1.0, reach: float = 0.0
) -> Sizes:
    """As given, or round ones; heights: least and greatest moment on the diagram; swing: of the energy (J); reach: the
    energies (J) that stand one over the other on the loop's figure; speed: the mean one (rad/s), at which tangents of
    a linkage without masses stand at about 45°."""
    turned = TORQUE.across and given.of(TORQUE.across)
    across = turned or fitting(curve.period / WIDE)
    moment = given.of(TORQUE.mu) or fitting((max(heights[1], 0.0) - min(heights[0], 0.0)) / HIGH)
    most = max(curve.inertia(float(psi)) for psi in np.linspace(0.0, curve.period, 73))
    least = max(swing / BAR, reach / TALL)
    pole = next((h for h in POLES[::-1] if h * moment * across >= least), POLES[0])
    energy, bar = pole * moment * across, fitting(swing / BAR)
    massless = 2.0 * energy / speed**2
    inertia, mass = (given.of(INERTIA.mu) or fitting(most / wide or massless) for wide in (LOW, LOOP))
    alike = bar <= energy <= ALIKE * bar and isclose(energy, round_up(energy))
    return Sizes(
        torque=Scale.of(TORQUE, moment, across),
        inertia=Scale.of(INERTIA, inertia, across),
        energy=Scale.of(ENERGY, energy, across),
        indicator=Scale.of(INDICATOR, energy if alike else bar),
        loop=Scale.of(WITTENBAUER, energy, mass),
        pole=pole,
    )


def fitting(least: float) -> float:
    """The finest round scale that is not below this."""
    scale = round_up(least if least > 0 else 1.0)
    while finer(scale) >= least > 0:
        scale = finer(scale)
    return scale
