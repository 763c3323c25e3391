"""A cam's profile replaced by its osculating circle at the contact (高副低代, 瞬时替代).

The cam is drawn by inversion on scratch paper, as the cam problem draws it; Hartmann's construction gives the centre
of curvature K. With the disc about K the higher pair is replaced like that of an eccentric: the follower then has
the same position, velocity and acceleration, at this one place of the cam. The law itself is not asked.
"""

from __future__ import annotations

import cmath
from dataclasses import replace
from functools import lru_cache
from math import degrees

import numpy as np

from ...algebra.quantity import number
from ...board.board import Board
from ...board.construction import View
from ...board.hand import hand
from ...errors import NoMethodError
from ...foundation.slotted import dataclass
from ...mechanism.model import CamProfile, Circle, Contact, Joint, Link, Mechanism, Prismatic, Rack, Side, SideOf
from ...plane import nominal
from ...problem.problem import Scales
from ...words import Words

EVERY = 3.0  # deg of the cam between the points of the outline that is drawn
RESTS = 1e-6  # mm on paper: a centre of curvature so near to the axis lies on it
FARTHEST = 5.0  # sizes of the cam: a centre of curvature farther away is on no sheet


@dataclass(frozen=True, slots=True, kw_only=True)
class Osculating:
    """The circle of the profile at the contact: centre in the cam's coordinates (m), radius (m) of the pitch curve,
    or of the profile under a face, negative where it is hollow; the follower's tip in the same coordinates."""

    centre: complex
    radius: float
    tip: complex


def osculated(mech: Mechanism) -> tuple[Mechanism, Words | None]:
    """The mechanism with a disc for each profile, and what is said of it.

    Raises NoMethodError where the profile is undercut, or so flat that its centre is on no sheet.
    """
    said: Words | None = None
    for profile in mech.cams:
        found = _circle(profile, mech.drive.position)
        mech, told = _with(mech, profile, found), _told(profile, found, mech.drive.position)
        said = told if said is None else said + told
    return mech, said


@lru_cache(maxsize=256)
def _circle(profile: CamProfile, turn: float) -> Osculating:
    """By Hartmann's construction on scratch paper."""
    from ...devices.cams.cam import Cam  # late: pydantic, which checks its data, is slow to load
    from ...devices.cams.motion import piece_at
    from ..devices.cam.diagram import place_of
    from ..devices.cam.laws import lift, stretches
    from ..devices.cam.pose import osculating, pose

    cam = profile.cam
    assert isinstance(cam, Cam)
    board = _paper(cam)
    piece, phi = piece_at(cam.pieces, cam.sense * turn)
    late = [late for low, _, late in stretches(piece) if low < phi][-1]
    at = lift(board, place_of(cam), piece, phi, late=late)
    it = pose(board, View.MECHANISM, cam, phi, at)
    centre, tip = (complex(nominal(spot)) for spot in osculating(board, cam, it))
    inward = complex(nominal(-it.way if cam.follower.flat else it.normal))
    mm = board.scale_of(View.MECHANISM).value
    radius = float(((centre - tip) * inward.conjugate()).real)
    _refuse(profile, phi, centre, mm * radius, FARTHEST * cam.size)
    return Osculating(centre=mm * centre, radius=mm * radius, tip=mm * tip)


def _refuse(profile: CamProfile, phi: float, centre: complex, radius: float, most: float) -> None:
    """NoMethodError where the centre of curvature (mm on paper) is on no sheet, or on the axis."""
    if not np.isfinite(radius) or abs(radius) > most:
        raise NoMethodError(
            Words(
                f"凸轮 {profile.link} 在 φ = {number(degrees(phi))}° 处廓线近于直线，曲率中心落在图纸之外，"
                "高副低代作不出；"
                "请改取凸轮的另一位置，或用 vecpoly exact",
                f"the profile of cam {profile.link} is nearly straight at φ = {number(degrees(phi))}°: its centre of "
                "curvature lies on no sheet and the higher pair cannot be replaced; take another place of the cam, or "
                "'vecpoly exact'",
            ),
            code="no-centre",
        )
    if abs(centre) < RESTS:
        raise NoMethodError(
            Words(
                f"凸轮 {profile.link} 转到 φ = {number(degrees(phi))}° 时廓线的曲率中心就是轴心，"
                "从动件静止（或正从静止起动），"
                "没有多边形可作；请改取凸轮的另一位置，或用 vecpoly exact",
                f"at φ = {number(degrees(phi))}° the profile of cam {profile.link} has its centre of curvature on the "
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
                f"凸轮 {profile.link} 的廓线失真，从动件不能按运动规律运动；请减小滚子或加大 r0",
                f"the profile of cam {profile.link} is undercut, so that the follower cannot keep to its law; take a "
                "smaller roller or a larger r0",
            ),
            code="undercut",
        )
    return tuple(complex(spot) for edge in outlined(board, cam, EVERY) for spot in edge)


def _with(mech: Mechanism, profile: CamProfile, found: Osculating) -> Mechanism:
    contact = next(one for one in mech.contacts if one.point == profile.point)
    replaced = _contact(contact, profile, found)
    drawn = replace(profile, outline=_outline(replace(profile, outline=())))
    return replace(
        mech,
        links=tuple(_link(link, profile, contact, found) for link in mech.links),
        joints=tuple(_joint(joint, contact, found) for joint in mech.joints),
        contacts=tuple(replaced if one is contact else one for one in mech.contacts),
        branches=(*mech.branches, *_side(mech, profile, contact, found)),
        cams=tuple(drawn if one is profile else one for one in mech.cams),
    )


def _contact(contact: Contact, profile: CamProfile, found: Osculating) -> Contact:
    """The discs as they touch here: in a hollow of the cam the follower's lies inside."""
    ends = {end.link: end for end in (contact.disc, contact.on)}
    cam, other = ends[profile.link], ends[profile.follower]
    assert isinstance(cam, Circle)
    if isinstance(other, Rack):
        return replace(contact, disc=replace(cam, radius=found.radius))
    if found.radius > 0:
        disc = replace(cam, radius=found.radius - other.radius)
        return replace(contact, disc=disc) if contact.disc is cam else replace(contact, on=disc)
    return replace(contact, disc=other, on=replace(cam, radius=other.radius - found.radius), internal=True)


def _link(link: Link, profile: CamProfile, contact: Contact, found: Osculating) -> Link:
    if link.name == profile.link:
        return replace(link, points={**link.points, profile.centre: found.centre})
    if link.name == contact.substitute and len(link.points) > 1:
        first, second = link.points
        return replace(link, points={first: 0j, second: complex(abs(found.radius))})
    return link


def _joint(joint: Joint, contact: Contact, found: Osculating) -> Joint:
    """The guide thought parallel to a face, as far from it as the circle is large."""
    if not isinstance(contact.on, Rack) or not isinstance(joint, Prismatic) or joint.block != contact.substitute:
        return joint
    side = 1j if contact.side is Side.LEFT else -1j
    return replace(joint, origin=contact.on.origin + side * cmath.rect(found.radius, contact.on.direction))


def _side(mech: Mechanism, profile: CamProfile, contact: Contact, found: Osculating) -> tuple[SideOf, ...]:
    """Which of two meetings is the follower's: that on whose side the profile has it."""
    if isinstance(contact.on, Rack):
        return ()
    turned = cmath.exp(1j * mech.drive.position)
    pin = next(
        (letter for letter in mech.link(profile.follower).points if letter in mech.frame and letter != profile.end),
        None,
    )
    up = turned * (found.tip - found.centre)
    if pin is None:
        return (SideOf(point=profile.end, side=Side.ABOVE if up.imag > 0 else Side.BELOW, ref=(profile.centre,)),)
    ray = mech.frame[pin] - mech.frame[profile.pivot] - turned * found.centre
    left = (ray.conjugate() * up).imag > 0
    return (SideOf(point=profile.end, side=Side.LEFT if left else Side.RIGHT, ref=(profile.centre, pin)),)


def _told(profile: CamProfile, found: Osculating, turn: float) -> Words:
    k, t, link = profile.centre, profile.point, profile.link
    size = number(1e3 * abs(found.radius))
    hollow = Words("（内凹）", " (hollow)") if found.radius < 0 else Words("", "")
    return (
        Words(
            f"凸轮 {link} 的廓线用反转法作出，转到 $φ_{link}$ = {number(degrees(turn))}°；过接触点 ${t}$ 的公法线上，"
            "用哈特曼法作得曲率中心"
            f" ${k}$（从动件一侧曲线的曲率半径 $ρ$ = {size} mm",
            f"The profile of cam {link} is drawn by inversion and turned to $φ_{link}$ = {number(degrees(turn))}°. "
            f"Hartmann's construction gives the centre of curvature ${k}$ on the common normal through ${t}$ ($ρ$ = "
            f"{size} mm to the follower's tip",
        )
        + hollow
        + Words(
            "）。以密切圆代替廓线：此瞬时的位置、速度和加速度不变，换一个位置须另作。",
            "). The osculating circle takes the place of the profile: position, velocity and acceleration are the same "
            "at this instant; for another place it is found anew.",
        )
    )
