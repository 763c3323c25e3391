"""Exact answers of a block on an inclined plane: equilibrium with friction, the limit slope by bisection."""

from __future__ import annotations

from cmath import exp
from math import atan, degrees, pi

from ...devices.incline import Incline
from .registry import Values, answers
from .sliding import Balance, Face, boundary, equilibrium


@answers(Incline)
def incline(device: Incline) -> Values:
    """φ, limit of α, F, R_21, F_0, η; F', η'."""
    limit = boundary(lambda slope: not _slips(device, slope), 0.0, pi / 2)
    slope = limit if device.alpha is None else device.alpha.si
    moved = _way(device, slope, device.f.si, 1)
    if moved is None or moved.size <= 0:
        raise device.locked()
    ideal, held = _way(device, slope, 0.0, 1), _way(device, slope, device.f.si, -1)
    if ideal is None or held is None:
        raise device.stuck()
    return {
        "phi": degrees(atan(device.f.si)),
        "alpha_limit": degrees(limit),
        "F": moved.size,
        "F_sine": moved.size,
        "F_0": ideal.size,
        "R_21": moved.reactions["2", "1"],
        "eta": ideal.size / moved.size,
        "F_r": held.size,
        "eta_r": held.size / ideal.size,
    }


def _way(device: Incline, slope: float, f: float, sense: int) -> Balance | None:
    """Equilibrium while the block slides up (sense 1) or down (−1)."""
    along = exp(1j * slope)
    return equilibrium(
        (Face("2", "1", 1j * along, f),),
        {"1": sense * along},
        {"1": -1j * device.Q.si},
        ("1", exp(1j * device.beta.si)),
    )


def _slips(device: Incline, slope: float) -> bool:
    """Whether the weight alone drives the block down: along the plane a force uphill is needed to stop it."""
    along = exp(1j * slope)
    found = equilibrium(
        (Face("2", "1", 1j * along, device.f.si),), {"1": -along}, {"1": -1j * device.Q.si}, ("1", along)
    )
    return found is None or found.size > 0
