"""What a load may ask of the mechanism as it stands and moves.

The oracle answers exactly, the drawing off paper. Each answer is one number, or one for every position.
"""

from __future__ import annotations

from typing import Any, Protocol

from .springs import Coil, Spring

Reals = Any  # a number, or an array of them: this part of the house knows arithmetic, and no arrays


class Standing(Protocol):
    """The mechanism in one position, or in many."""

    def drive(self) -> Reals:
        """The drive's own coordinate (rad, or m)."""

    def travelled(self, link: str, point: str, direction: float) -> tuple[Reals, float]:
        """How far a point is from where its stroke along the direction begins, and how long the stroke is (m)."""

    def speed(self, link: str, point: str, direction: float) -> Reals:
        """The component of a point's velocity along the direction (m/s); 0 where it is only rounding."""

    def spin(self, link: str) -> Reals:
        """ω of a link (rad/s); 0 where it is only rounding."""

    def length(self, spring: Spring) -> Reals:
        """The distance of the spring's two ends (m)."""

    def lengthening(self, spring: Spring) -> Reals:
        """dl/dt (m/s)."""

    def turned(self, coil: Coil) -> Reals:
        """φ - φ_0 of a torsion spring, within half a turn (rad)."""

    def turning(self, coil: Coil) -> Reals:
        """ω - ω' of its links (rad/s)."""
