"""Exact answers of a cam: pressure angles, radii of curvature, undercut, and every station."""

from __future__ import annotations

from math import degrees

import numpy as np

from ....devices.cams.asked import least_polar
from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from ..registry import Values, answers
from .laws import Array, greatest, raised
from .least import least
from .shape import interferes, jumps, pitch, profile, supported


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
    rho = _least_radius(device)
    first = (
        {"psi0": degrees(device.psi0)} if device.arm else {"s0": 1e3 * (device.r0.si**2 - device.follower.e**2) ** 0.5}
    )
    found = first | {"alpha_max": degrees(max(up, down)), "alpha_rise": degrees(up), "alpha_return": degrees(down)}
    found["rho_min"] = 1e3 * rho
    if not device.follower.roller:
        return found
    found["rho_profile"] = 1e3 * (rho - device.follower.radius)
    return found | {"undercut": float(spoilt(device))}


def _flat(device: Cam) -> dict[str, float]:
    rise = greatest(lambda p, phi: raised(p, phi)[1], device.pieces)[0]
    back = greatest(lambda p, phi: -raised(p, phi)[1], device.pieces)[0]
    found = {"rho_min": 1e3 * _least_radius(device), "undercut": float(spoilt(device))}
    if device.arm:
        return found | {"psi0": degrees(device.psi0)} | _span(device)
    return found | {"b_rise": 1e3 * rise, "b_return": 1e3 * back}


def _span(device: Cam) -> dict[str, float]:
    """Between which distances from the foot of A the contact wanders along a face that swings (mm)."""
    assert device.arm

    def along(piece: Piece, phi: Array) -> Array:
        face = supported(device, piece, phi)
        pivot = device.side * device.arm[0] * np.exp(-1j * device.sense * phi) if device.arm else 0.0
        return np.abs(face.touch - pivot - device.face * face.normal)

    near = -greatest(lambda p, phi: -along(p, phi), device.pieces)[0]
    return {"l_min": 1e3 * near, "l_max": 1e3 * greatest(along, device.pieces)[0]}


def _least_radius(device: Cam) -> float:
    """Of the profile under a flat face, else of the pitch curve where it bulges outward (m)."""
    if device.follower.flat:
        return -greatest(lambda p, phi: -supported(device, p, phi).radius, device.pieces)[0]
    return 1 / greatest(lambda p, phi: pitch(device, p, phi).curvature, device.pieces)[0]


def spoilt(device: Cam) -> bool:
    """Whether the follower cannot keep to its law, because the profile is cut or breaks off; never of a knife edge."""
    radius = device.follower.radius
    if not (device.follower.flat or radius):
        return False
    rho = _least_radius(device)
    cut = rho <= 0 if device.follower.flat else rho < radius or interferes(device)
    return cut or bool((jumps(device) < 0).any())


def _stations(device: Cam) -> dict[str, float]:
    found: dict[str, float] = {}
    first = profile(device, device.pieces[0], np.zeros(1))
    for phi, piece in device.places:
        name, at = f"{round(degrees(phi), 6):g}", np.array([phi])
        s = float(raised(piece, at)[0][0])
        if phi:
            found |= {f"psi_{name}": degrees(s)} if device.arm else {f"s_{name}": 1e3 * s}
        found[f"r_{name}"] = 1e3 * float(np.abs(profile(device, piece, at))[0])
        if phi:
            turned = float(np.degrees(np.angle(profile(device, piece, at) / first))[0])
            least = least_polar(degrees(phi), device.sense)
            found[f"theta_{name}"] = (turned - least) % 360.0 + least
        if not device.follower.flat:
            found[f"alpha_{name}"] = degrees(float(pitch(device, piece, at).pressure[0]))
    return found
