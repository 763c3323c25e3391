"""Exact answers of a clamping wedge: equilibrium while it slips out, the limit of its angle by bisection."""

from __future__ import annotations

from cmath import exp
from math import atan, degrees, pi

from ...devices.wedge_clamp import WedgeClamp
from .registry import Values, answers
from .sliding import Balance, Face, boundary, equilibrium


@answers(WedgeClamp)
def wedge_clamp(device: WedgeClamp) -> Values:
    """φ, limit of α, F', F'_0, R_13, η'."""
    f, size = device.f.si, device.R.si
    limit = boundary(lambda alpha: _out(alpha, f).size <= 0, 0.0, pi / 2)
    held, ideal = _out(device.alpha.si, f), _out(device.alpha.si, 0.0)
    scale, scale0 = (size / abs(found.reactions["2", "3"]) for found in (held, ideal))
    return {
        "phi": degrees(atan(f)),
        "alpha_limit": degrees(limit),
        "F": held.size * scale,
        "F_sine": held.size * scale,
        "F_0": ideal.size * scale0,
        "R_13": held.reactions["1", "3"] * scale,
        "eta": held.size * scale / (ideal.size * scale0),
    }


def _out(alpha: float, f: float) -> Balance:
    """Equilibrium while the wedge slips out along the work's face, under a normal force of 1 N on that face."""
    lower, upper = 1j, -1j * exp(-1j * alpha)  # normals into the wedge: of the work under it, of body 2 over it
    face = Face("2", "3", upper, f)
    found = equilibrium((face,), {"3": -1 + 0j}, {"3": lower + f}, ("3", 1 + 0j))
    assert found is not None
    return Balance(found.size, {**found.reactions, ("1", "3"): lower + f})
