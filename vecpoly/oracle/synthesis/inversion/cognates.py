"""The three four-bars whose coupler points draw one curve (Roberts and Chebyshev)."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Fourbar:
    """Fixed pins A and D, moving pins B (on A's link) and C (on D's), and the coupler point E, in one position (m)."""

    a: complex
    b: complex
    c: complex
    d: complex
    e: complex

    @property
    def lengths(self) -> tuple[float, float, float, float]:
        """AB, BC, CD, AD."""
        return abs(self.b - self.a), abs(self.c - self.b), abs(self.d - self.c), abs(self.d - self.a)

    @property
    def shape(self) -> complex:
        """k = BE / BC, as complex numbers."""
        return (self.e - self.b) / (self.c - self.b)


def third_pivot(bar: Fourbar) -> complex:
    """F, for which triangle ADF is similar to the coupler triangle BCE: F = A + k (D − A)."""
    return bar.a + bar.shape * (bar.d - bar.a)


def cognates(bar: Fourbar) -> tuple[Fourbar, Fourbar]:
    """The left and the right cognate, A B₁ C₁ F and D B₂ C₂ F, that lead E along the same curve.

    B₁ = A + BE, C₁ = B₁ + k AB; B₂ = D + CE, C₂ = B₂ + (1 − k) DC. Source: Roberts 1875; Dijksman, Motion Geometry.
    """
    k, pivot = bar.shape, third_pivot(bar)
    left, right = bar.a + bar.e - bar.b, bar.d + bar.e - bar.c
    return (
        Fourbar(a=bar.a, b=left, c=left + k * (bar.b - bar.a), d=pivot, e=bar.e),
        Fourbar(a=bar.d, b=right, c=right + (1 - k) * (bar.c - bar.d), d=pivot, e=bar.e),
    )
