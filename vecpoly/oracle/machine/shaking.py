"""What a mechanism in motion does to its frame by its masses alone: the shaking force and the shaking moment.

F_I = −Σ m a_S (N), M_I = −Σ [(r_S − r_O) × m a_S + J α] (N·m, counter-clockwise), O the fixed pivot of the drive.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...mechanism.loads import Mass
from ..motion import Motion
from ..state import Points, Reals


def shaking_force(motion: Motion, masses: Sequence[Mass]) -> Points:
    """−Σ m a_S at every position (N)."""
    total: Points = sum((-one.mass * _pull(motion, one) for one in masses), np.zeros(motion.shape, np.complex128))
    return total


def shaking_moment(motion: Motion, masses: Sequence[Mass], about: complex) -> Reals:
    """−Σ [(r_S − r_O) × m a_S + J α] at every position (N·m)."""
    total: Reals = sum((-_turn(motion, one, about) for one in masses), np.zeros(motion.shape))
    return total


def _pull(motion: Motion, mass: Mass) -> Points:
    return motion.bodies[mass.link].acceleration_of(_centre(motion, mass))


def _turn(motion: Motion, mass: Mass, about: complex) -> Reals:
    body = motion.bodies[mass.link]
    arm = body.point(_centre(motion, mass)) - about
    turning: Reals = mass.mass * (arm.conjugate() * _pull(motion, mass)).imag + mass.inertia * body.alpha
    return turning


def _centre(motion: Motion, mass: Mass) -> complex:
    return motion.mech.link(mass.link).points[mass.centre]
