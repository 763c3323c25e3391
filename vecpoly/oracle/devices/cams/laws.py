"""The laws of motion by formula, and the greatest value of a function over a piece of motion."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
import numpy.typing as npt

from ....devices.cams.motion import Law, Piece

Array = npt.NDArray[np.float64]
Raised = tuple[Array, Array, Array]  # s, ds/dφ, d²s/dφ²
GRID, ZOOMS = 241, 6
BESIDE = 1e-12  # of a piece: just before and just after the middle, where the acceleration jumps


def unit_law(law: Law, u: Array) -> Raised:
    """s, s′ and s″ over a rise of 1 in an angle of 1."""
    match law:
        case Law.UNIFORM:
            return u, np.ones_like(u), np.zeros_like(u)
        case Law.PARABOLIC:
            late = u > 0.5
            v = np.where(late, 1 - u, u)
            return np.where(late, 1 - 2 * v**2, 2 * v**2), 4 * v, np.where(late, -4.0, 4.0)
        case Law.COSINE:
            t = np.pi * u
            return (1 - np.cos(t)) / 2, np.pi / 2 * np.sin(t), np.pi**2 / 2 * np.cos(t)
        case Law.SINE:
            t = 2 * np.pi * u
            return u - np.sin(t) / (2 * np.pi), 1 - np.cos(t), 2 * np.pi * np.sin(t)
        case Law.POLYNOMIAL:
            return (
                10 * u**3 - 15 * u**4 + 6 * u**5,
                30 * u**2 - 60 * u**3 + 30 * u**4,
                60 * u - 180 * u**2 + 120 * u**3,
            )


def raised(piece: Piece, phi: Array) -> Raised:
    """s, s′ and s″ at angles of a piece; at a jump of the acceleration inside it that before the jump."""
    if piece.law is None:
        return np.full_like(phi, piece.low), np.zeros_like(phi), np.zeros_like(phi)
    u = (phi - piece.start) / piece.angle
    s, first, second = unit_law(piece.law, u)
    h, wide = piece.lift, piece.angle
    if piece.rises < 0:
        return piece.high - h * s, -h / wide * first, -h / wide**2 * second
    return piece.low + h * s, h / wide * first, h / wide**2 * second


def greatest(of: Callable[[Piece, Array], Array], pieces: Iterable[Piece]) -> tuple[float, float]:
    """The greatest value over these pieces, and the angle at which it is found."""
    return max(_greatest(of, piece, *span) for piece in pieces for span in spans(piece))


def spans(piece: Piece) -> tuple[tuple[float, float], ...]:
    """The stretches of a piece on which the acceleration is continuous."""
    if piece.law is not Law.PARABOLIC:
        return ((piece.start, piece.end),)
    middle, beside = piece.start + piece.angle / 2, BESIDE * piece.angle
    return (piece.start, middle - beside), (middle + beside, piece.end)


def _greatest(of: Callable[[Piece, Array], Array], piece: Piece, low: float, high: float) -> tuple[float, float]:
    for _ in range(ZOOMS):
        phi = np.linspace(low, high, GRID)
        values = of(piece, phi)
        best = int(np.argmax(values))
        low, high = float(phi[max(best - 1, 0)]), float(phi[min(best + 1, GRID - 1)])
    return float(values[best]), float(phi[best])
