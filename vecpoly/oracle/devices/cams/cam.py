"""Exact answers of a cam: pressure angles, radii of curvature, undercut, and every station."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ..registry import Values, answers
from .laws import Array, greatest, raised
from .least import least
from .shape import interferes, jumps, pitch, profile


@answers(Cam)
def cam(device: Cam) -> Values:
    """Lengths in mm, angles in degrees."""
    if device.alpha is not None:
        return least(device)
    found = _flat(device) if device.follower.flat else _pitched(device)
    return found | _stations(device)


def _pitched(device: Cam) -> dict[str, float]:
    assert device.r0
    rises, backs = ([p for p in device.pieces if p.rises == way] for way in (1, -1))
    up, down = (greatest(lambda p, phi: pitch(device, p, phi).pressure, part)[0] for part in (rises, backs))
    rho = 1 / greatest(lambda p, phi: pitch(device, p, phi).curvature, device.pieces)[0]
    first = (
        {"psi0": degrees(device.psi0)} if device.arm else {"s0": 1e3 * (device.r0.si**2 - device.follower.e**2) ** 0.5}
    )
    found = first | {"alpha_max": degrees(max(up, down)), "alpha_rise": degrees(up), "alpha_return": degrees(down)}
    found["rho_min"] = 1e3 * rho
    if not device.follower.roller:
        return found
    radius = device.follower.radius
    spoilt = rho < radius or bool((jumps(device) < 0).any()) or interferes(device)
    return found | {"rho_profile": 1e3 * (rho - radius), "undercut": float(spoilt)}


def _flat(device: Cam) -> dict[str, float]:
    r0 = device.r0.si if device.r0 else 0.0

    def bulge(piece: Piece, phi: Array) -> Array:
        s, _, s2 = raised(piece, phi)
        return -(r0 + s + s2)

    rho = -greatest(bulge, device.pieces)[0]
    rise = greatest(lambda p, phi: raised(p, phi)[1], device.pieces)[0]
    back = greatest(lambda p, phi: -raised(p, phi)[1], device.pieces)[0]
    spoilt = rho <= 0 or bool((jumps(device) < 0).any())
    return {"rho_min": 1e3 * rho, "undercut": float(spoilt), "b_rise": 1e3 * rise, "b_return": 1e3 * back}


def _stations(device: Cam) -> dict[str, float]:
    found: dict[str, float] = {}
    for phi, piece in device.places:
        name, at = f"{round(degrees(phi), 6):g}", np.array([phi])
        s = float(raised(piece, at)[0][0])
        if phi:
            found |= {f"psi_{name}": degrees(s)} if device.arm else {f"s_{name}": 1e3 * s}
        found[f"r_{name}"] = 1e3 * float(np.abs(profile(device, piece, at))[0])
        if not device.follower.flat:
            found[f"alpha_{name}"] = degrees(float(pitch(device, piece, at).pressure[0]))
    return found
