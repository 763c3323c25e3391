"""The exact tooth that a rack with sharp corners generates: involute, trochoid, and where they part."""

from __future__ import annotations

from math import acos, cos, hypot, pi, sin, tan

import numpy as np
import numpy.typing as npt

from ....devices.gears.generation import GearGeneration
from ..registry import Values, answers

Array = npt.NDArray[np.float64]
GRID, ZOOMS = 2001, 6


@answers(GearGeneration)
def generation(device: GearGeneration) -> Values:
    """Lengths in mm; the tip of a tooth whose flanks meet before is 0 thick."""
    m, z, alpha, ha = device.m.si, device.z, device.alpha.si, device.ha.si
    r = m * z / 2
    rb, ra, rf = r * cos(alpha), r + (ha + device.x) * m, r - (ha + device.c.si - device.x) * m
    limit = _limit(device)
    thick = m * (pi / 2 + 2 * device.x * tan(alpha))
    tip = ra * (thick / r + 2 * (_involute(alpha) - _involute(acos(rb / ra))))
    lengths = {
        "r": r,
        "rb": rb,
        "ra": ra,
        "rf": rf,
        "s": thick,
        "s_tip": max(tip, 0.0),
        "r_start": _start(device, r, rb),
    }
    found = {key: 1e3 * value for key, value in lengths.items()}
    return found | {"x_min": limit, "z_min": 2 * ha / sin(alpha) ** 2, "undercut": float(device.x < limit)}


def _involute(angle: float) -> float:
    return tan(angle) - angle


def _limit(device: GearGeneration) -> float:
    """x_min."""
    return device.ha.si - device.z * sin(device.alpha.si) ** 2 / 2


def _start(device: GearGeneration, r: float, rb: float) -> float:
    """Where the trochoid of the rack's corner meets the involute; without undercut where it touches it."""
    m, alpha = device.m.si, device.alpha.si
    depth = (device.ha.si - device.x) * m  # of the corner below the rolling line
    if device.x >= _limit(device):
        return hypot(r - depth, depth / tan(alpha))
    turned = np.linspace(0.0, depth / tan(alpha) / r, GRID)  # from the corner on the line of centres outwards
    for _ in range(ZOOMS):
        gap = _gap(device, r, rb, depth, turned)
        first = int(np.argmax(gap > 0))
        turned = np.linspace(turned[max(first - 1, 0)], turned[first], GRID)
    return float(hypot(r - depth, r * turned[-1]))


def _gap(device: GearGeneration, r: float, rb: float, depth: float, turned: Array) -> Array:
    """Of the corner's place, by how much of the circle it stands off the involute, positive clear of the tooth."""
    m, alpha = device.m.si, device.alpha.si
    radius = np.hypot(r - depth, r * turned)
    corner = pi * m / 4 + device.ha.si * m * tan(alpha)  # from the middle of the space
    trochoid = corner / r + turned - np.arctan2(r * turned, r - depth)
    slope = np.arccos(np.minimum(rb / radius, 1.0))
    flank = pi / (2 * device.z) + 2 * device.x * tan(alpha) / device.z + _involute(alpha) - (np.tan(slope) - slope)
    return np.where(radius < rb, -1.0, trochoid - flank)
