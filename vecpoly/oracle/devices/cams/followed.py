"""The follower at many angles of its cam: its law, the point of the profile that it touches, the curvature there."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece, piece_at
from .cam import spoilt as spoilt
from .laws import Array, raised
from .shape import Spots, pitch, supported

STRAIGHT = 1e-4  # 1/m: a smaller curvature is taken as this; the centre would be farther away than 10 km
ROWS = 6


@dataclass(frozen=True, slots=True, kw_only=True)
class Followed:
    """s′ and s″ (m, or rad); the follower in the frame, the profile in the cam's coordinates (m).

    tip: the follower's end from the cam's axis; of a flat face the foot of the axis on it. edge, centre, inward: the
    point of the profile, its centre of curvature, the unit normal into the cam.
    """

    slope: Array
    bend: Array
    tip: Spots
    edge: Spots
    centre: Spots
    inward: Spots


def follow(cam: Cam, turn: Array) -> Followed:
    """The cam turned by these angles (rad, counter-clockwise) from its first station."""
    pieces, sense = cam.pieces, cam.sense
    places = [piece_at(pieces, sense * float(one)) for one in turn]
    phi, which = np.array([at for _, at in places]), np.array([pieces.index(piece) for piece, _ in places])
    rows = np.zeros((ROWS, len(phi)), np.complex128)
    for i, piece in enumerate(pieces):
        rows[:, which == i] = _rows(cam, piece, phi[which == i])
    slope, bend = (np.ascontiguousarray(row.real) for row in rows[:2])
    tip, edge, centre, inward = rows[2:]
    return Followed(slope=slope, bend=bend, tip=tip, edge=edge, centre=centre, inward=inward)


def _rows(cam: Cam, piece: Piece, phi: Array) -> Spots:
    (_, *law), back = raised(piece, phi), np.exp(1j * cam.sense * phi)
    if cam.follower.flat:
        face = supported(cam, piece, phi)
        edge = face.touch
        return np.array([*law, back * face.normal * face.height, edge, edge - face.normal * face.radius, -face.normal])
    curve = pitch(cam, piece, phi)
    bent = curve.curvature
    bent = np.where(np.abs(bent) < STRAIGHT, np.copysign(STRAIGHT, bent), bent)
    edge = curve.z + cam.follower.radius * curve.inward
    return np.array([*law, back * curve.z, edge, curve.z + curve.inward / bent, curve.inward])
