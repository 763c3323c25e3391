"""Positions of a rigid body in the plane, and what one body's points do as another sees them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, sin

_UNTURNED = 1e-12  # |e^{iθ} − 1| below which two positions are only shifted


@dataclass(frozen=True, slots=True, kw_only=True)
class Pose:
    """Where the origin of a body lies (m), and how far the body is turned (a unit vector)."""

    at: complex = 0j
    turn: complex = 1 + 0j

    @classmethod
    def turned(cls, at: complex, angle: float) -> Pose:
        """The position in which the body is turned by an angle (rad)."""
        return cls(at=at, turn=complex(cos(angle), sin(angle)))

    def place(self, point: complex) -> complex:
        """Where a point of the body lies on the frame: at + e^{iθ} p."""
        return self.at + self.turn * point

    def trace(self, point: complex) -> complex:
        """The point of the body that lies here: (P − at) e^{−iθ}."""
        return (point - self.at) * self.turn.conjugate()


def carried(point: complex, pose: Pose, onto: Pose) -> complex:
    """Where a point of the frame comes to when it is carried with the body from a pose onto another."""
    return onto.place(pose.trace(point))


def inverted(points: Sequence[complex], poses: Sequence[Pose], onto: int) -> tuple[complex, ...]:
    """The places that points have in the eyes of a body, drawn where the body stands in its position `onto`.

    points: of each position, where the point lies on the frame then. Source: the method of inversion (刚化反转法).
    """
    return tuple(carried(point, pose, poses[onto]) for point, pose in zip(points, poses, strict=True))


def pole(one: Pose, two: Pose) -> complex | None:
    """The point that lies at one place in both positions: P = at + e^{iθ} p; none where the body is only shifted."""
    turned = two.turn * one.turn.conjugate()
    if abs(turned - 1) < _UNTURNED:
        return None
    return (two.at - turned * one.at) / (1 - turned)
