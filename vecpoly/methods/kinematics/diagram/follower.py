"""A cam's follower in the kinematic diagram: a flat face, a stem in its fixed guide, the pressure angle."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from ....board.paper.marks import AngleMark, Arc, FixedGuide, LinkNumber, Mark, Role, Segment
from ....mechanism.model import FRAME, Circle, Contact, Prismatic, Revolute
from ....plane import nominal
from ...desk import Desk
from .bars import weld

BEYOND = 12.0  # mm a face runs on beyond what stands on it
STEM, SHOE = 10.0, 14.0  # mm from the tip to its guide, length of the guide
PLAY = 1.5  # mm from the stem's line to the guide
SWING, SMALL = 13.0, 0.05  # mm radius of the pressure angle's mark; rad below which it is not shown


def face_marks(desk: Desk, contact: Contact) -> Iterator[Mark]:
    """A flat face with its lever: the link's points stand on the face, or beside it on short welded arms."""
    line, link = desk.face_line(contact), desk.mech.link(contact.on.link)
    at, along = complex(nominal(line.at)), complex(nominal(line.along))
    own = [_spot(desk, p) for p in link.points]
    travels = [float((np.conj(along) * (s - at)).real) for s in own]
    offs = [float((np.conj(along) * (s - at)).imag) for s in own]
    t = float((np.conj(along) * (_spot(desk, contact.point) - at)).real)
    guided = any(isinstance(j, Prismatic) and j.guide == FRAME and j.block == link.name for j in desk.mech.joints)
    low, high = min(*travels, t - BEYOND, t), max(*travels, t + BEYOND)
    yield Segment(a=at + along * low, b=at + along * high, role=Role.LINK)
    for travel, off in zip(travels, offs, strict=True):
        if abs(off) > 0.3 and not guided:
            foot, middle = at + along * travel, at + along * t
            yield Segment(a=foot, b=foot + 1j * along * off, role=Role.LINK)
            yield weld(foot, 1j * along * off, middle - foot)
    if not guided:
        yield LinkNumber(a=at + along * low, b=at + along * t, number=link.name)


def stem_marks(desk: Desk, contact: Contact, link: str, guide: Prismatic) -> Iterator[Mark]:
    """A translating follower: its stem in a fixed guide, the guide's centre line, and the offset circle about the cam's
    pivot."""
    line = desk.guide_line(guide)
    at, along = complex(nominal(line.at)), complex(nominal(line.along))
    away = along * (np.sign((np.conj(along) * _push(desk, contact, link)).real) or 1.0)
    tip, reach = _tip(desk, contact, link, at, along)
    start = tip + away * (reach + STEM)
    end = start + away * (SHOE + STEM)
    yield Segment(a=tip, b=end, role=Role.LINK)
    for side in (1, -1):
        a, b = (start, start + away * SHOE)[::side]
        yield FixedGuide(a=a - 1j * side * away * PLAY, b=b - 1j * side * away * PLAY)
    yield LinkNumber(a=start + away * SHOE, b=end, number=link)
    other = next(name for name in contact.links if name != link)
    pivot = next((j.point for j in desk.mech.joints if isinstance(j, Revolute) and {j.a, j.b} == {other, FRAME}), "")
    if pivot:
        foot = at + along * float((np.conj(along) * (_spot(desk, pivot) - at)).real)
        yield Segment(a=foot, b=tip, role=Role.CENTRE)
        if abs(foot - _spot(desk, pivot)) > 1.0:
            yield Arc(
                centre=_spot(desk, pivot),
                radius=abs(foot - _spot(desk, pivot)),
                start=0.0,
                sweep=2 * np.pi,
                role=Role.CENTRE,
            )


def pressure_angle(desk: Desk, contact: Contact) -> Iterator[Mark]:
    """The angle between the common normal and the way in which the follower's tip (or the point of its face) can go."""
    link = next((name for name in contact.links if name != desk.mech.drive.link), "")
    push = _push(desk, contact, link)
    round_tip = next((end for end in (contact.disc, contact.on) if isinstance(end, Circle) and end.link == link), None)
    at = _spot(desk, round_tip.centre if round_tip else contact.point)
    way = _free_way(desk, link, at)
    if way is None:
        return
    way *= np.sign((np.conj(push) * way).real) or 1.0
    angle = float(np.angle(way / push))
    if abs(angle) > SMALL:
        yield Segment(a=at, b=at + way * (SWING + 3), role=Role.CONSTRUCTION)
        yield AngleMark(at=at, radius=SWING, start=float(np.angle(push)), sweep=angle, label="α")


def _push(desk: Desk, contact: Contact, link: str) -> complex:
    """Unit vector of the way in which the other link presses on this one."""
    normal = complex(nominal(desk.normal_of(contact)))
    return normal if link == contact.on.link else -normal


def _free_way(desk: Desk, link: str, at: complex) -> complex | None:
    """Direction in which a point of a link on a fixed pivot or in a fixed guide can move; None for other links."""
    for joint in desk.mech.joints:
        if isinstance(joint, Prismatic) and joint.guide == FRAME and joint.block == link:
            return complex(nominal(desk.guide_line(joint).along))
        if isinstance(joint, Revolute) and {joint.a, joint.b} == {link, FRAME}:
            arm = at - _spot(desk, joint.point)
            return 1j * arm / abs(arm)
    return None


def _tip(desk: Desk, contact: Contact, link: str, at: complex, along: complex) -> tuple[complex, float]:
    """Where the stem begins, and how far the tip reaches (mm): the centre of a round tip, or the face on the guide's
    line."""
    for end in (contact.disc, contact.on):
        if isinstance(end, Circle) and end.link == link:
            return _spot(desk, end.centre), desk.mm(end.radius)
    face = desk.face_line(contact)
    on, way = complex(nominal(face.at)), complex(nominal(face.along))
    travel = (np.conj(1j * way) * (on - at)).real / (np.conj(1j * way) * along).real
    return at + along * float(travel), 0.0


def _spot(desk: Desk, name: str) -> complex:
    return complex(nominal(desk.at[name]))
