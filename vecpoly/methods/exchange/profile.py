"""A cam's profile replaced by its osculating circle at the contact (高副低代, 瞬时替代).

The cam is drawn by inversion on scratch paper, as the cam problem draws it; Hartmann's construction gives the centre
of curvature K. With the disc about K the higher pair is replaced like that of an eccentric: the follower then has
the same position, velocity and acceleration, at this one place of the cam. The law itself is not asked.
"""

from __future__ import annotations

from functools import lru_cache
from math import degrees, pi
from typing import TYPE_CHECKING

import numpy as np

from ...algebra.quantity import number
from ...board.board import Board
from ...board.construction import View
from ...board.hand import hand
from ...errors import NoMethodError
from ...foundation.slotted import replace
from ...mechanism.model import CamProfile, Mechanism
from ...plane import nominal
from ...problem.problem import Scales
from ...words import Words
from .disc import Osculating, with_disc

if TYPE_CHECKING:
    from ...devices.cams.cam import Cam
    from ..devices.cam.pose import Pose

EVERY = 3.0  # deg of the cam between the points of the outline that is drawn
RESTS = 1e-6  # mm on paper: a centre of curvature so near to the axis lies on it
FARTHEST = 5.0  # sizes of the cam: a centre of curvature farther away is on no sheet


def osculated(mech: Mechanism) -> tuple[Mechanism, Words | None]:
    """The mechanism with a disc for each profile, and what is said of it.

    Raises NoMethodError where the profile is undercut, or so flat that its centre is on no sheet.
    """
    said: Words | None = None
    for profile in mech.cams:
        found = _circle(profile, mech.drive.position)
        mech, told = with_disc(mech, profile, found, _drawn(profile)), _told(profile, found, mech.drive.position)
        said = told if said is None else said + told
    return mech, said


def touching(mech: Mechanism) -> Mechanism:
    """The mechanism with a disc for each profile that only touches where the profile does: position and velocity are
    the same whatever point of the common normal is its centre. Half as large as the base circle, it is never about the
    cam's axis.

    Raises NoMethodError where the profile is undercut.
    """
    for profile in mech.cams:
        mech = with_disc(mech, profile, _disc(profile, mech.drive.position), _drawn(profile))
    return mech


@lru_cache(maxsize=256)
def _circle(profile: CamProfile, turn: float) -> Osculating:
    """By Hartmann's construction on scratch paper."""
    from ..devices.cam.pose import osculating

    board, cam, phi, it = _turned(profile, turn)
    centre, tip = (complex(nominal(spot)) for spot in osculating(board, cam, it))
    inward = complex(nominal(-it.outward(cam)))
    mm = board.scale_of(View.MECHANISM).value
    radius = float(((centre - tip) * inward.conjugate()).real)
    _refuse(profile, phi, centre, mm * radius, FARTHEST * cam.size)
    return Osculating(centre=mm * centre, radius=mm * radius, tip=mm * tip)


@lru_cache(maxsize=1024)
def _disc(profile: CamProfile, turn: float) -> Osculating:
    """By inversion on scratch paper: the contact with its normal."""
    board, cam, _, it = _turned(profile, turn)
    assert cam.r0 is not None
    mm = board.scale_of(View.MECHANISM).value
    tip, outward = (complex(nominal(spot)) for spot in (it.foot if cam.follower.flat else it.b, it.outward(cam)))
    radius = cam.r0.si / 2
    return Osculating(centre=mm * tip - radius * outward, radius=radius, tip=mm * tip)


def corners(mech: Mechanism) -> list[float]:
    """Positions of the drive (rad, within a turn) where a cam's law passes from one piece to another."""
    from ...devices.cams.cam import Cam
    from ..devices.cam.laws import stretches

    cams = [profile.cam for profile in mech.cams]
    return [
        cam.sense * place % (2 * pi)
        for cam in cams
        if isinstance(cam, Cam)
        for piece in cam.pieces
        for low, high, _ in stretches(piece)
        for place in (low, high)
    ]


def _turned(profile: CamProfile, turn: float) -> tuple[Board, Cam, float, Pose]:
    """The follower where the cam has turned so far, drawn about the standing cam."""
    from ...devices.cams.cam import Cam  # late: pydantic, which checks its data, is slow to load
    from ...devices.cams.motion import piece_at
    from ..devices.cam.diagram import place_of
    from ..devices.cam.laws import lift, stretches
    from ..devices.cam.pose import pose

    cam = profile.cam
    assert isinstance(cam, Cam)
    board = _paper(cam)
    piece, phi = piece_at(cam.pieces, cam.sense * turn)
    late = [late for low, _, late in stretches(piece) if low < phi][-1]
    at = lift(board, place_of(cam), piece, phi, late=late)
    return board, cam, phi, pose(board, View.MECHANISM, cam, phi, at)


def _refuse(profile: CamProfile, phi: float, centre: complex, radius: float, most: float) -> None:
    """NoMethodError where the centre of curvature (mm on paper) is on no sheet, or on the axis."""
    turned = number(round(degrees(phi), 9) % 360)
    if not np.isfinite(radius) or abs(radius) > most:
        raise NoMethodError(
            Words(
                f"凸轮 {profile.link} 在 φ = {turned}° 处廓线近于直线，曲率中心落在图纸之外，"
                "高副低代作不出；"
                "请改取凸轮的另一位置，或用 vecpoly exact",
                f"the profile of cam {profile.link} is nearly straight at φ = {turned}°: its centre of "
                "curvature lies on no sheet and the higher pair cannot be replaced; take another place of the cam, or "
                "'vecpoly exact'",
            ),
            code="no-centre",
        )
    if abs(centre) < RESTS:
        raise NoMethodError(
            Words(
                f"凸轮 {profile.link} 转到 φ = {turned}° 时廓线的曲率中心就是轴心，"
                "从动件静止（或正从静止起动），"
                "没有多边形可作；请改取凸轮的另一位置，或用 vecpoly exact",
                f"at φ = {turned}° the profile of cam {profile.link} has its centre of curvature on the "
                "axis: the follower rests there and there is no polygon to draw; take another place of the cam, or "
                "'vecpoly exact'",
            ),
            code="follower-rests",
        )


def _paper(cam: object) -> Board:
    from ...devices.cams.cam import Cam
    from ..devices.cam.scales import cam_scales

    assert isinstance(cam, Cam)
    board = Board(hand("exact"), cam_scales(cam, Scales()))
    board.step(Words("试作", "trial"))
    return board


def _drawn(profile: CamProfile) -> tuple[complex, ...]:
    """Its outline, the same whether one was drawn already."""
    return _outline(replace(profile, outline=()))


@lru_cache(maxsize=32)
def _outline(profile: CamProfile) -> tuple[complex, ...]:
    """Points of the profile by inversion; NoMethodError where it is undercut."""
    from ...devices.cams.cam import Cam
    from ..devices.cam.curvature import is_spoilt
    from ..devices.cam.trying import outlined

    cam = profile.cam
    assert isinstance(cam, Cam)
    board = _paper(cam)
    if is_spoilt(board, cam):
        raise NoMethodError(
            Words(
                f"凸轮 {profile.link} 的廓线失真，从动件不能按运动规律运动；",
                f"the profile of cam {profile.link} is undercut, so that the follower cannot keep to its law; ",
            )
            + cam.follower.remedy,
            code="undercut",
        )
    return tuple(complex(spot) for edge in outlined(board, cam, EVERY) for spot in edge)


def _curve(profile: CamProfile) -> Words:
    """Whose curvature counts: that of the profile under a face, else of the curve of the follower's tip."""
    from ...devices.cams.cam import Cam

    flat = isinstance(profile.cam, Cam) and profile.cam.follower.flat
    return Words("廓线", "profile") if flat else Words("理论廓线", "pitch curve")


def _told(profile: CamProfile, found: Osculating, turn: float) -> Words:
    k, t, link, curve = profile.centre, profile.point, profile.link, _curve(profile)
    size = number(1e3 * abs(found.radius))
    hollow = Words("（内凹）", " (hollow)") if found.radius < 0 else Words("", "")
    return (
        Words(
            f"凸轮 {link} 的廓线及其曲率中心在另纸上作出，本图只取其结果：廓线用反转法作，转到 $φ_{link}$ = "
            f"{number(degrees(turn))}°；曲率中心 ${k}$ 用哈特曼法作，在过接触点 ${t}$ 的公法线上"
            f"（{curve.zh}在该处的曲率半径 $ρ$ = {size} mm",
            f"The profile of cam {link} and its centre of curvature are constructed on a sheet apart; only what they "
            f"give is taken here. The profile, drawn by inversion, is turned to $φ_{link}$ = {number(degrees(turn))}°. "
            f"Hartmann's construction gives the centre of curvature ${k}$ on the common normal through ${t}$ (radius "
            f"of curvature of the {curve.en} there: $ρ$ = {size} mm",
        )
        + hollow
        + Words(
            "）。以曲率圆代替廓线：此瞬时的位置、速度和加速度不变；对其他位置须重新作图。",
            "). The osculating circle replaces the profile: position, velocity and acceleration are the same at this "
            "instant; for any other position it must be constructed again.",
        )
    )
