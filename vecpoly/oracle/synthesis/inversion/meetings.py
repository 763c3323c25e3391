"""Where two circles meet, and where a ray meets a circle, in closed form."""

from __future__ import annotations

from math import sqrt


def beyond(one: complex, to_one: float, two: complex, to_two: float, side: int) -> complex | None:
    """The point at these distances from two others, left (1) or right (−1) of the ray one → two; none out of reach.

    P = P₁ + (x + i side y) u, x = (d² + r₁² − r₂²) / 2d, y² = r₁² − x².
    """
    span = two - one
    d = abs(span)
    if not d:  # both in one place: no circle meets the other, or each point of it
        return None
    along = (d * d + to_one**2 - to_two**2) / (2 * d)
    square = to_one**2 - along**2
    return None if square < 0 else one + span / d * (along + 1j * side * sqrt(square))


def ray_and_circle(start: complex, along: complex, centre: complex, radius: float) -> tuple[complex, ...]:
    """Where a ray meets a circle, the nearer point first: t² − 2 t Re(u* (Z − S)) + |Z − S|² − r² = 0, t > 0."""
    middle = (along.conjugate() * (centre - start)).real
    square = middle**2 - abs(centre - start) ** 2 + radius**2
    if square < 0:
        return ()
    return tuple(start + t * along for t in (middle - sqrt(square), middle + sqrt(square)) if t > 0)
