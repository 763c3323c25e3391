"""Four positions of a body: which pins of the frame see a point of the body go round them (Burmester's theory).

A point A of the frame is a *centre point* where its four inverted places lie on one circle; the centre of this circle
is the *circle point* B of the body. The determinant |z|², x, y, 1 of the four places is a cubic along every line.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from .loci import Round, locus
from .motions import Pose, inverted

_REAL = 1e-7  # of a root: imaginary part below which a double root counts as real
_NODES = (-1.5, -0.5, 0.5, 1.5)  # where the cubic is computed, in sizes of the figure


@dataclass(frozen=True, slots=True, kw_only=True)
class CentrePoint:
    """A pin A of the frame (m), the circle point B in the first position, and the length AB."""

    fixed: complex
    moving: complex
    radius: float


def centre_points(poses: Sequence[Pose], through: complex, along: complex) -> tuple[CentrePoint, ...]:
    """The at most three centre points of four positions on a line of the frame, in the order along it."""
    size = max(abs(pose.at - through) for pose in poses) or 1.0
    found = [through + size * t * along for t in _roots(poses, through / size, along, size)]
    kept = (_centre_point(poses, at) for at in found)
    return tuple(point for point in kept if point is not None)


def circle_points(poses: Sequence[Pose], through: complex, along: complex) -> tuple[CentrePoint, ...]:
    """The same on a line of the body as it stands in the first position: body and frame change places."""
    first = poses[0]
    seen = tuple(Pose(at=first.place(pose.trace(0j)), turn=first.turn * pose.turn.conjugate()) for pose in poses)
    return tuple(
        CentrePoint(fixed=point.moving, moving=point.fixed, radius=point.radius)
        for point in centre_points(seen, through, along)
    )


def determinant(poses: Sequence[Pose], at: complex) -> float:
    """Zero where the four inverted places of a point of the frame lie on one circle (or line)."""
    places = np.array(inverted((at,) * 4, poses, 0))
    return float(np.linalg.det(np.stack([np.abs(places) ** 2, places.real, places.imag, np.ones(4)], axis=1)))


def _roots(poses: Sequence[Pose], through: complex, along: complex, size: float) -> list[float]:
    """Where the determinant vanishes along the line, lengths in sizes of the figure."""
    small = [Pose(at=pose.at / size, turn=pose.turn) for pose in poses]
    values = [determinant(small, through + t * along) for t in _NODES]
    cubic = np.polynomial.Polynomial(np.polynomial.polynomial.polyfit(_NODES, values, 3))
    roots = [complex(root) for root in cubic.trim(1e-13 * max(map(abs, values))).roots()]
    near = sorted(root.real for root in roots if abs(root.imag) < _REAL * max(1.0, abs(root)))
    slope = cubic.deriv()
    return [_polished(lambda t: determinant(small, through + t * along), slope, root) for root in near]


def _polished(of: Callable[[float], float], slope: Callable[[float], float], root: float) -> float:
    """A root by Newton's steps on the determinant itself, while they lessen it: then only rounding is left."""
    value = of(root)
    while value and (rise := float(slope(root))):
        there = root - value / rise
        if abs(of(there)) >= abs(value):
            break
        root, value = there, of(there)
    return root


def _centre_point(poses: Sequence[Pose], at: complex) -> CentrePoint | None:
    """The centre point with its circle point, from any three places that differ (at a pole two of them are one);
    none where they lie on a line, for then the circle point is at infinity."""
    for three in combinations(inverted((at,) * 4, poses, 0), 3):
        match locus(three):
            case Round() as circle:
                return CentrePoint(fixed=at, moving=circle.centre, radius=abs(circle.centre - at))
    return None
