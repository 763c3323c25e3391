"""Exact answers of a ring-spring buffer: equilibrium of the pushed wedge and both side wedges, limits by bisection."""

from __future__ import annotations

from cmath import exp
from math import atan, degrees, pi

from ...devices.ring_spring import RingSpring
from .registry import Values, answers
from .sliding import Balance, Face, boundary, equilibrium


@answers(RingSpring)
def ring_spring(device: RingSpring) -> Values:
    """φ, R_21, R_42, F, F_0, η, F', η', limits of α."""
    alpha, f = device.alpha.si, device.f.si
    least = pi / 2 - boundary(lambda rest: _moves(pi / 2 - rest, f, 1), 0.0, pi / 2)
    greatest = boundary(lambda angle: _moves(angle, f, -1), 1e-9, pi / 2)
    moved = _way(alpha, f, device.Q.si, 1)
    if moved is None or moved.size <= 0:
        raise device.locked()
    ideal, held = _way(alpha, 0.0, device.Q.si, 1), _way(alpha, f, device.Q.si, -1)
    assert ideal is not None and held is not None, "the springs always press on the faces"
    return {
        "phi": degrees(atan(f)),
        "R_21": moved.reactions["2", "1"],
        "R_42": moved.reactions["4", "2"],
        "F": moved.size,
        "F_sine": moved.size,
        "F_0": ideal.size,
        "eta": ideal.size / moved.size,
        "alpha_min": degrees(least),
        "F_r": held.size,
        "F_r_sine": held.size,
        "eta_r": held.size / ideal.size,
        "alpha_max": degrees(greatest),
    }


def _moves(alpha: float, f: float, sense: int) -> bool:
    found = _way(alpha, f, 1.0, sense)
    return found is not None and found.size > 0


def _way(alpha: float, f: float, spring: float, sense: int) -> Balance | None:
    """Equilibrium while 1 goes down (sense 1) or up (−1):
    2 to the right of it, 3 to its left, 4 under them, at rest."""
    up, down = exp(1j * (pi / 2 - alpha)), exp(-1j * (pi / 2 - alpha))  # normals into 2 of the faces under and over it
    faces = (
        Face("2", "1", -down, f),
        Face("3", "1", down.conjugate(), f),
        Face("4", "2", up, f),
        Face("4", "3", -up.conjugate(), f),
    )
    sideways = sense * (down.imag / (2 * down.real))  # of 2, while 1 goes at −i and 2 half as fast down
    velocity = {"1": -1j * sense, "2": complex(-sideways, -0.5 * sense), "3": complex(sideways, -0.5 * sense)}
    known = {"2": complex(-spring), "3": complex(spring)}
    return equilibrium(faces, velocity, known, ("1", -1j))
