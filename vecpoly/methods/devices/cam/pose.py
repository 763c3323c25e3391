"""The follower at one place of the inversion: its end B, the instant centre P, the common normal."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ....board.board import Board
from ....board.construction import Place
from ....board.strokes import spot
from ....devices.cams.cam import Cam
from ....plane import Line, Points, Reals, dot, foot, unit
from ....plane.traced import acts_of, bare, traced
from ....words import Words
from .laws import Lift

FAR = 1e7  # lengths of OA: where P is taken to be that is at infinity
ALIKE = 2e-9  # rad a radian: arm and cam turn alike, and the lines to P are parallel
LONG, OVER = 400.0, 60.0  # mm: as far as P is drawn; of the normal towards it, where it is not


@dataclass(frozen=True, slots=True, kw_only=True)
class Pose:
    """B, or the foot of the flat face on the guide; base: where it would be at s = 0; from: foot of the guide, or A.

    way: unit vector of the follower's motion on the rise; the normal of a flat face, out of the cam.
    spin: ω of the follower against the cam, for the cam's 1.
    normal: unit vector from B along the common normal, into the cam: towards P, or away from it where an arm turns
    faster than the cam. drift: the velocity of P in the cam's plane, as a vector on paper (mm).
    """

    start: Points
    base: Points
    b: Points
    way: Points
    pole: Points
    normal: Points
    spin: Reals
    drift: Points

    def outward(self, cam: Cam) -> Points:
        """The unit normal at the contact, out of the cam."""
        return self.way if cam.follower.flat else -self.normal

    def touch(self, cam: Cam, mm: float) -> Points:
        """Where the follower touches the profile; mm: what a mm on paper is (m)."""
        return self.foot if cam.follower.flat else self.b + cam.follower.radius / mm * self.normal

    @property
    def foot(self) -> Points:
        """Where a flat face touches: the foot of P on it."""
        return foot(Line(self.b, 1j * self.way), self.pole)

    @property
    def beyond(self) -> Reals:
        """How far the centre of curvature of the profile under a flat face lies from P into the cam: PK = u′/ω_r."""
        return dot(1j * self.way, self.drift) / self.spin

    @property
    def near(self) -> bool:
        """Whether P is on the sheet, or not far from it."""
        return abs(spot(self.pole - self.b)) < LONG

    @property
    def sighted(self) -> Points:
        """P, or a point of the normal on the way there."""
        return self.pole if self.near else self.b + OVER * unit(self.pole - self.b)


def pose(board: Board, place: Place, cam: Cam, phi: Reals, lift: Lift) -> Pose:
    """Where guide or arm stands when the whole is turned back by φ, against the cam."""
    return _swung(board, place, cam, phi, lift) if cam.arm else _guided(board, place, cam, phi, lift)


def _back(board: Board, cam: Cam, phi: Reals) -> Points:
    """The direction of the x axis turned back by φ, against the cam; forwards by somebody who inverts the wrong way."""
    turned = np.exp(-1j * cam.sense * phi)
    return board.inverted(turned, lambda: np.conj(turned), key="inversion")


def _guided(board: Board, place: Place, cam: Cam, phi: Reals, lift: Lift) -> Pose:
    assert cam.r0
    mm, sense = board.scale_of(place).value, cam.sense
    across = _back(board, cam, phi)
    e = cam.follower.e / mm
    start = board.lay_off(0j, across if e > 0 else -across, abs(e), key="e") if e else 0j * across
    guide = board.parallel(start, 1j * across)
    if cam.follower.e:
        base = board.arc_on_line(guide, 0j, cam.r0.si / mm, Words("导路与基圆", "the guide and the base circle"))[0]
    else:
        base = board.lay_off(start, guide.along, cam.r0.si / mm)
    b = board.lay_off(base, guide.along, lift.s / mm, key="s")
    pole = board.lay_off(0j, sense * across, lift.slope / mm, key="OP")
    return Pose(
        start=start,
        base=base,
        b=b,
        way=guide.along,
        pole=pole,
        normal=unit(pole - b),
        spin=-sense + 0.0 * lift.s,
        drift=sense * across * (lift.bend / mm) - 1j * across * (lift.slope / mm),
    )


def _swung(board: Board, place: Place, cam: Cam, phi: Reals, lift: Lift) -> Pose:
    """P parts OA as ψ′ to 1: by two parallels that bear these lengths."""
    assert cam.r0 and cam.arm
    mm, sense, side = board.scale_of(place).value, cam.sense, cam.side
    oa, towards = cam.arm[0], side * _back(board, cam, phi)
    pivot = board.lay_off(0j, towards, oa / mm)
    base, b, facing = _face(board, cam, pivot, lift.s, mm) if cam.follower.flat else _tip(board, cam, pivot, lift.s, mm)
    slope, spin, alike = _apart(lift.slope, side * sense)
    one = board.lay_off(0j, 1j * towards, side * slope * oa / mm)
    other = board.lay_off(pivot, -1j * sense * towards, oa / mm)
    joined, line = board.parallel(other, unit(one - other)), board.parallel(0j, towards)
    paper = board.scratch() if np.any(alike) else board  # nobody looks for a meeting that is far away
    pole = paper.meet(joined, line, Words("瞬心 $P$", "the instant centre $P$"))
    normal = unit(pole - b) * np.sign(spin)
    if np.any(alike):
        normal = traced(np.where(alike, -bare(towards), bare(normal)), acts_of(normal))
    rest = np.abs(pole - pivot)
    along = side * sense * lift.bend * rest**2 / (oa / mm)
    return Pose(
        start=pivot,
        base=base,
        b=b,
        way=facing if cam.follower.flat else -1j * side * unit(b - pivot),
        pole=pole,
        normal=normal,
        spin=-sense * spin,
        drift=towards * along - 1j * sense * towards * dot(towards, pole),
    )


def _apart(slope: Reals, way: int) -> tuple[Reals, Reals, Any]:
    """ψ′, and by how much the cam turns faster than the arm; where both turn alike, P being at infinity, so little
    apart that P is far away, and where that is."""
    apart = 1.0 + way * slope
    alike = np.abs(bare(apart)) < ALIKE
    if not np.any(alike):
        return slope, apart, alike
    far = np.where(alike, -way * (1.0 - 1.0 / FAR), bare(slope))
    return traced(far, acts_of(slope)), np.where(alike, 1.0 / FAR, bare(apart)), alike


def _tip(board: Board, cam: Cam, pivot: Points, s: Reals, mm: float) -> tuple[Points, Points, Points]:
    """B where the arc about A meets the base circle, above OA; then turned on by ψ."""
    assert cam.r0 and cam.arm
    ab, circles = cam.arm[1], Words("基圆与摆杆", "the base circle and the arm")
    base = board.arcs(0j, cam.r0.si / mm, pivot, ab / mm, circles)[0 if cam.side > 0 else 1]
    b = board.lay_off(pivot, board.leaned(unit(base - pivot), -cam.side * s, key="ψ"), ab / mm)
    return base, b, unit(b)


def _face(board: Board, cam: Cam, pivot: Points, s: Reals, mm: float) -> tuple[Points, Points, Points]:
    """The face as a tangent of the base circle, by the circle over OA; its foot under A, and its normal."""
    assert cam.r0 and cam.arm
    level, off = (cam.r0.si - cam.face) / mm, cam.face / mm
    circles = Words("半径 $r_0$ − $d$ 的圆与以 $OA$ 为直径的圆", "the circle of radius r_0 − d and that over OA")
    thales = board.arcs(0j, level, pivot / 2, cam.arm[0] / mm / 2, circles)[0 if cam.side > 0 else 1]
    first = unit(thales)
    facing = board.leaned(first, -cam.side * s, key="ψ")
    if not cam.face:
        return pivot, pivot, facing
    return board.lay_off(pivot, first, off), board.lay_off(pivot, facing, off), facing


def centre_of_curvature(board: Board, it: Pose, share: float = 1.0) -> tuple[Points, Points, Points]:
    """Hartmann: v_B ⊥ PB and the part of P's own velocity beside it; the line of their tips meets PB in the centre K.

    Gives K and the two tips, both velocities drawn to this share.
    """
    along = unit(it.pole - it.b)
    tip = board.lay_off(it.b, -1j * along, share * it.spin * np.abs(it.pole - it.b))
    sideways = board.parallel(it.pole, -1j * along)
    moved = board.meet(board.parallel(it.pole + share * it.drift, along), sideways, "")
    joined = board.parallel(tip, unit(moved - tip))
    at = board.meet(joined, Line(it.b, board.turn(along)), Words("曲率中心 $K$", "the centre of curvature $K$"))
    return at, tip, moved


def osculating(board: Board, cam: Cam, it: Pose) -> tuple[Points, Points]:
    """The centre of curvature and the follower's tip; under a flat face the point of contact."""
    if not cam.follower.flat:
        return centre_of_curvature(board, it)[0], it.b
    return board.lay_off(it.pole, -it.way, it.beyond), it.foot
