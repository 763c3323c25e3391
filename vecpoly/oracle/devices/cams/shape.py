"""The pitch curve of a cam by formula: points in the cam's plane with their derivatives by φ, complex numbers (m)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from ....devices.cams.cam import Cam
from ....devices.cams.motion import Piece
from .laws import Array, raised, spans

Spots = npt.NDArray[np.complex128]
NEAR = 1e-5  # m: by how much a point of the profile may lie inside the roller
DENSE = 721  # points a stretch, where profile and roller are tried against each other
CORNER = 1e-9  # of the stroke a radian: a smaller jump of s′ is none


@dataclass(frozen=True, slots=True)
class Curve:
    """Points z with z′ and z″, the direction of the follower's motion there; turning: −1 where it is run clockwise."""

    z: Spots
    first: Spots
    second: Spots
    moves: Spots
    turning: int

    @property
    def inward(self) -> Spots:
        """The unit normal towards the inside of the cam."""
        return 1j * self.turning * self.first / np.abs(self.first)

    @property
    def pressure(self) -> Array:
        """The acute angle between the normal and the follower's motion (rad)."""
        along = np.conj(self.moves) * self.inward
        acute: Array = np.arctan2(np.abs(along.imag), np.abs(along.real))
        return acute

    @property
    def curvature(self) -> Array:
        """1/ρ (1/m), positive where the curve bulges outward."""
        bent: Array = self.turning * (np.conj(self.first) * self.second).imag / np.abs(self.first) ** 3
        return bent


def pitch(cam: Cam, piece: Piece, phi: Array) -> Curve:
    """The pitch curve: the follower's end turned back by the angle that the cam has turned."""
    s, s1, s2 = raised(piece, phi)
    assert cam.r0
    if cam.arm:
        (oa, ab), side = cam.arm, cam.side
        arm = -side * ab * np.exp(-1j * side * (cam.psi0 + s))
        w, w1, w2 = side * oa + arm, -1j * side * s1 * arm, (-1j * side * s2 - s1**2) * arm
        moves = -1j * side * arm / ab
    else:
        e = cam.follower.e
        s0 = np.sqrt(cam.r0.si**2 - e**2)
        w, w1, w2, moves = e + 1j * (s0 + s), 1j * s1, 1j * s2, np.full_like(s, 1) * 1j
    turn, back = np.exp(-1j * cam.sense * phi), -1j * cam.sense
    return Curve(turn * w, turn * (w1 + back * w), turn * (w2 + 2 * back * w1 - w), turn * moves, -cam.sense)


@dataclass(frozen=True, slots=True)
class Face:
    """A flat face: its unit normal out of the cam, its distance from the axis (m) and where it touches (m), in the
    cam's plane; the radius of curvature of the profile there (m)."""

    normal: Spots
    height: Array
    touch: Spots
    radius: Array


def supported(cam: Cam, piece: Piece, phi: Array) -> Face:
    """The profile under a flat face by its support function h over the direction ν of the normal.

    It touches at h n + dh/dν in, and its radius of curvature is h + d²h/dν².
    """
    s, s1, s2 = raised(piece, phi)
    assert cam.r0
    if cam.arm:
        oa, level = cam.arm[0], cam.psi0 + s
        h, h1 = cam.face + oa * np.sin(level), oa * np.cos(level) * s1
        h2 = oa * (np.cos(level) * s2 - np.sin(level) * s1**2)
        lean, n1, n2 = -cam.side * level, -cam.sense - cam.side * s1, -cam.side * s2
    else:
        h, h1, h2 = cam.r0.si + s, s1, s2
        lean, n1, n2 = np.zeros_like(s), np.full_like(s, -cam.sense), np.zeros_like(s)
    normal = 1j * np.exp(1j * (lean - cam.sense * phi))
    first = h1 / n1
    return Face(normal, h, normal * (h + 1j * first), h + (h2 - first * n2) / n1**2)


def profile(cam: Cam, piece: Piece, phi: Array) -> Spots:
    """The profile that touches knife edge, roller or face."""
    if not cam.follower.flat:
        curve = pitch(cam, piece, phi)
        return curve.z + cam.follower.radius * curve.inward
    return supported(cam, piece, phi).touch


def jumps(cam: Cam) -> Array:
    """By how much s′ jumps from each piece to the next."""
    ends = [raised(piece, np.array([piece.start, piece.end]))[1] for piece in cam.pieces]
    found = np.array([after[0] - before[1] for before, after in zip(ends, [*ends[1:], ends[0]], strict=True)])
    return np.where(np.abs(found) > CORNER * cam.lift, found, 0.0)


def interferes(cam: Cam) -> bool:
    """Whether a point of the profile lies inside the roller at some other place."""
    centres, edge = [], []
    for piece in cam.pieces:
        for low, high in spans(piece):
            phi = np.linspace(low, high, DENSE)
            centres.append(pitch(cam, piece, phi).z)
            edge.append(profile(cam, piece, phi))
    every, limit = np.concatenate(centres)[::4], cam.follower.radius - NEAR
    return any(bool((np.abs(part[::6, None] - every[None, :]) < limit).any()) for part in edge)
