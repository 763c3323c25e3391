"""Equilibrium of bodies that only translate and press on each other through flat faces with Coulomb friction.

Unknown are the normal forces of the faces and one force. Friction is f times the normal force, against the sliding:
with the velocities given, ΣF = 0 of every body is a linear system,
solved for each choice of which face of a two-sided guide presses.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import product

import numpy as np
import numpy.typing as npt

NOTHING = 1e-12  # relative: a normal force smaller than this presses on either face
RESIDUAL = 1e-10  # of the largest force: forces that leave more than this are in no equilibrium


@dataclass(frozen=True, slots=True)
class Face:
    """Body `by` presses on body `on` with a normal force along `normal` (into `on`);
    a two-sided guide may also press the other way."""

    by: str
    on: str
    normal: complex
    f: float
    two_sided: bool = False


@dataclass(frozen=True, slots=True)
class Balance:
    """The size of the sought force along its direction, and R_ij by (i, j)."""

    size: float
    reactions: Mapping[tuple[str, str], complex]


def equilibrium(
    faces: tuple[Face, ...], velocity: Mapping[str, complex], known: Mapping[str, complex], sought: tuple[str, complex]
) -> Balance | None:
    """ΣF = 0 of every body that has a velocity; None where no normal force that presses will do.

    velocity: of each moving body, to any scale (others rest); known:
    given force on a body; sought: body and unit direction of the unknown force.
    """
    for signs in product(*((1.0, -1.0) if face.two_sided else (1.0,) for face in faces)):
        along = [_direction(face, sign, velocity) for face, sign in zip(faces, signs, strict=True)]
        forces = _solved(faces, along, tuple(velocity), known, sought)
        if forces is not None and (forces[:-1] >= -NOTHING * np.abs(forces).max()).all():
            reactions = {
                (face.by, face.on): complex(size * u) for face, u, size in zip(faces, along, forces[:-1], strict=True)
            }
            return Balance(float(forces[-1]), reactions)
    return None


def _direction(face: Face, sign: float, velocity: Mapping[str, complex]) -> complex:
    """Reaction per newton of normal force: the normal, and friction against the sliding."""
    slip = velocity.get(face.on, 0j) - velocity.get(face.by, 0j)
    tangent = 1j * face.normal
    return sign * face.normal - face.f * float(np.sign((slip * tangent.conjugate()).real)) * tangent


def _solved(
    faces: tuple[Face, ...],
    along: list[complex],
    bodies: tuple[str, ...],
    known: Mapping[str, complex],
    sought: tuple[str, complex],
) -> npt.NDArray[np.float64] | None:
    """Normal forces and the sought one; None where no finite forces balance.
    Symmetry may make equations say the same thing."""
    rows = {body: 2 * i for i, body in enumerate(bodies)}
    matrix, right = np.zeros((2 * len(bodies), len(faces) + 1)), np.zeros(2 * len(bodies))
    entries = [(face.on, j, u) for j, (face, u) in enumerate(zip(faces, along, strict=True))]
    entries += [(face.by, j, -u) for j, (face, u) in enumerate(zip(faces, along, strict=True))]
    for body, column, force in [*entries, (sought[0], len(faces), sought[1])]:
        if body in rows:
            matrix[rows[body] : rows[body] + 2, column] += force.real, force.imag
    for body, force in known.items():
        right[rows[body] : rows[body] + 2] -= force.real, force.imag
    forces, _, rank, _ = np.linalg.lstsq(matrix, right)
    balanced = np.abs(matrix @ forces - right).max() <= RESIDUAL * max(np.abs(right).max(), np.abs(forces).max())
    return np.asarray(forces, dtype=np.float64) if balanced and rank == len(faces) + 1 else None


def boundary(holds: Callable[[float], bool], low: float, high: float) -> float:
    """Where a condition that holds at `low` and not at `high` changes, by bisection to the last digit."""
    while low < (middle := (low + high) / 2) < high:
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low
