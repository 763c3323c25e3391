"""A product resolved along two fixed directions, by Cramer's rule; weights rounded to what there is."""

from __future__ import annotations

from cmath import phase, rect
from math import degrees, floor, tau

from ....devices.balancing.plane import RotorPlane
from ....devices.balancing.refused import parallel_places

ALIKE = 1e-6
Share = tuple[float, float]  # direction (rad), product (kg·m)


def resolved(plane: RotorPlane, needed: complex) -> tuple[Share, Share]:
    """The two places that are used, with what each takes; negative: mass is removed there."""
    one, other = _chosen(plane, needed)
    u, v = rect(1, one), rect(1, other)
    det = (u.conjugate() * v).imag
    if abs(det) < ALIKE:
        raise parallel_places((degrees(one) % 360, degrees(other) % 360))
    return (one, (needed.conjugate() * v).imag / det), (other, (u.conjugate() * needed).imag / det)


def _chosen(plane: RotorPlane, needed: complex) -> tuple[float, float]:
    """Those that are asked for; else the neighbours on either side of the direction needed, or, where mass may only be
    removed, of the opposite one."""
    if plane.use is not None:
        return plane.use[0].si, plane.use[1].si
    assert plane.places is not None
    around = sorted(one.si % tau for one in plane.places)
    if len(around) == 2:
        return plane.places[0].si, plane.places[1].si
    way = phase(-needed if plane.only == "remove" else needed) % tau
    after = next((k for k, one in enumerate(around) if one > way + 1e-12), 0)
    return around[after - 1], around[after]


def rounded(share: float, step: float) -> float:
    """To the nearest multiple of the step, halves upwards in size."""
    size = floor(abs(share) / step + 0.5) * step
    return size if share >= 0 else -size
