"""The motion of one link over all positions of the drive, as arrays."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from ..foundation.slotted import dataclass

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
_Number = TypeVar("_Number", np.complex128, np.float64)

STILL: Points = np.zeros(1, np.complex128)
NONE: Reals = np.zeros(1)


def cross(a: Points, b: Points) -> Reals:
    """a × b = a_x b_y - a_y b_x."""
    product: Points = a.conj() * b
    return product.imag


def dot(a: Points, b: Points) -> Reals:
    """a · b = a_x b_x + a_y b_y."""
    product: Points = a.conj() * b
    return product.real


@dataclass(frozen=True, slots=True)
class Body:
    """A link in motion: r = at + unit (p - local); a point p of the link in its own coordinates.

    at (m), velocity (m/s) and acceleration (m/s²) are those of the link's point `local`; unit = e^{iφ};
    omega (rad/s), alpha (rad/s²). turn: φ followed without jumps (rad), where a law of motion needs it.
    Arrays have one element per position, or one element where the link does not change.
    """

    local: complex
    at: Points
    unit: Points
    turn: Reals | None = None
    velocity: Points = field(default_factory=lambda: STILL)
    omega: Reals = field(default_factory=lambda: NONE)
    acceleration: Points = field(default_factory=lambda: STILL)
    alpha: Reals = field(default_factory=lambda: NONE)

    def moving(self, velocity: Points, omega: Reals, acceleration: Points, alpha: Reals) -> Body:
        """The same pose with these rates."""
        return Body(self.local, self.at, self.unit, self.turn, velocity, omega, acceleration, alpha)

    def point(self, local: complex) -> Points:
        """Place of the link's point (m)."""
        return self.at if local == self.local else self.at + self.unit * (local - self.local)

    def velocity_of(self, local: complex) -> Points:
        """v = v_0 + iω (r - r_0)."""
        if local == self.local:
            return self.velocity
        return self.velocity + self.omega * (self.unit * (1j * (local - self.local)))

    def acceleration_of(self, local: complex) -> Points:
        """a = a_0 + (iα - ω²) (r - r_0)."""
        if local == self.local:
            return self.acceleration
        spin = 1j * self.alpha - self.omega * self.omega
        return self.acceleration + spin * (self.unit * (local - self.local))

    def velocity_at(self, place: Points) -> Points:
        """Velocity of the link's point that is at this place now."""
        return self.velocity + 1j * self.omega * (place - self.at)

    def acceleration_at(self, place: Points) -> Points:
        """Acceleration of the link's point that is at this place now."""
        return self.acceleration + (1j * self.alpha - self.omega * self.omega) * (place - self.at)

    def take(self, index: slice | NDArray[np.intp]) -> Body:
        """Only these positions."""
        return Body(
            self.local,
            _cut(self.at, index),
            _cut(self.unit, index),
            None if self.turn is None else _cut(self.turn, index),
            _cut(self.velocity, index),
            _cut(self.omega, index),
            _cut(self.acceleration, index),
            _cut(self.alpha, index),
        )


def _cut(values: NDArray[_Number], index: slice | NDArray[np.intp]) -> NDArray[_Number]:
    return values if len(values) == 1 else values[index]


Bodies = Mapping[str, Body]


def at_rest() -> Body:
    """The frame: its coordinates are those of the plane."""
    return _FRAME


_FRAME = Body(0j, STILL, np.ones(1, np.complex128), NONE)
