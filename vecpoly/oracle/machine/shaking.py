"""What a mechanism in motion does to its frame by its masses alone: the shaking force and the shaking moment.

F_I = −Σ m a_S (N), M_I = −Σ [(r_S − r_O) × m a_S + J α] (N·m, counter-clockwise), O the fixed pivot of the drive.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from ...mechanism.loads import Mass
from ...mechanism.model import Mechanism
from ..motion import Motion
from ..state import Points, Reals

Placed = tuple[str, float, complex]  # a link, a mass on it (kg), and where on the link that is (m)


def placed(mech: Mechanism, mass: Mass) -> Placed:
    """A mass at the centre of mass of its link."""
    return mass.link, mass.mass, mech.link(mass.link).points[mass.centre]


def inertia_force(motion: Motion, masses: Iterable[Placed]) -> Points:
    """−Σ m a of masses anywhere on their links, at every position (N)."""
    pulls = (-mass * motion.bodies[link].acceleration_of(at) for link, mass, at in masses)
    total: Points = sum(pulls, np.zeros(motion.shape, np.complex128))
    return total


def shaking_force(motion: Motion, masses: Sequence[Mass]) -> Points:
    """−Σ m a_S at every position (N)."""
    return inertia_force(motion, [placed(motion.mech, one) for one in masses])


def shaking_moment(motion: Motion, masses: Sequence[Mass], about: complex) -> Reals:
    """−Σ [(r_S − r_O) × m a_S + J α] at every position (N·m)."""
    total: Reals = sum((-_turn(motion, one, about) for one in masses), np.zeros(motion.shape))
    return total


def _turn(motion: Motion, mass: Mass, about: complex) -> Reals:
    body, (_, size, centre) = motion.bodies[mass.link], placed(motion.mech, mass)
    arm = body.point(centre) - about
    turning: Reals = size * (arm.conjugate() * body.acceleration_of(centre)).imag + mass.inertia * body.alpha
    return turning
