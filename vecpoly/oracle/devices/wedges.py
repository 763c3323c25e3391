"""Exact answers of a wedge pair: equilibrium of both wedges with friction, limits by bisection."""

from __future__ import annotations

from math import atan, degrees, pi, radians, tan

import numpy as np

from ...devices.wedges import FACES, Wedges
from .registry import Values, answers
from .sliding import Balance, Face, boundary, equilibrium


@answers(Wedges)
def wedges(device: Wedges) -> Values:
    """φ, F, F_0, η, R_12, R_32, R_31; F', η'; limits of φ."""
    f = {face: device.friction(face).si for face in FACES}
    lock_direct = boundary(lambda phi: _way(device, dict.fromkeys(FACES, tan(phi)), 1) is not None, 0.0, pi / 2 - 1e-9)
    lock_reverse = boundary(lambda phi: _held(device, dict.fromkeys(FACES, tan(phi))).size > 0, 0.0, pi / 2 - 1e-9)
    moved = _way(device, f, 1)
    if moved is None:
        raise device.locked(degrees(atan(f["12"]) + atan(f["23"])))
    ideal, held = _way(device, dict.fromkeys(FACES, 0.0), 1), _held(device, f)
    assert ideal is not None
    angles = {device.angle(face).key: degrees(atan(f[face])) for face in FACES}
    reactions = {f"R_{by}{on}": moved.reactions[by, on] for by, on in (("1", "2"), ("3", "2"), ("3", "1"))}
    return (
        angles
        | reactions
        | {
            "F": moved.size,
            "F_sine": moved.size,
            "F_0": ideal.size,
            "eta": ideal.size / moved.size,
            "F_r": held.size,
            "eta_r": held.size / ideal.size,
            "lock_direct": degrees(lock_direct),
            "lock_reverse": degrees(lock_reverse),
        }
    )


def _held(device: Wedges, f: dict[str, float]) -> Balance:
    found = _way(device, f, -1)
    assert found is not None, "a wedge that sinks always presses on its faces"
    return found


def _way(device: Wedges, f: dict[str, float], sense: int) -> Balance | None:
    """Equilibrium while 2 rises (sense 1) or sinks (−1): velocities keep the wedges in contact."""
    across, guide = (
        np.exp(1j * device.beta.si),
        np.exp(1j * (radians(90) - device.alpha.si)),
    )  # normal from 1 into 2; way of 1
    rise = (guide * np.conj(across)).real / (1j * np.conj(across)).real
    faces = (
        Face("1", "2", complex(across), f["12"]),
        Face("3", "2", -1 + 0j, f["23"], two_sided=True),
        Face("3", "1", complex(1j * guide), f["13"], two_sided=True),
    )
    velocity = {"1": sense * complex(guide), "2": sense * 1j * float(rise)}
    return equilibrium(faces, velocity, {"2": -1j * device.Q.si}, ("1", complex(guide)))
