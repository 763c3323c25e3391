"""A cam's follower: a flat face, a stem in its fixed guide, the pressure angle."""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import copysign, pi

from ...board.paper.marks import AngleMark, Arc, FixedGuide, LinkNumber, Mark, Role, Segment
from ...mechanism.model import FRAME, Circle, Contact, Prismatic, Revolute
from ..bars import weld
from ..posed import Posed, Way

BEYOND = 12.0  # mm a face runs on beyond what stands on it
STEM, SHOE = 10.0, 14.0  # mm from the tip to its guide, length of the guide
NUMBERED, LEAST = 15.5, 4.0  # mm: the guide begins so near to the tip that the number stands beside it; off a roller
PLAY = 1.5  # mm from the stem's line to the guide
SWING, SMALL = 13.0, 0.05  # mm radius of the pressure angle's mark; rad below which it is not shown
ON_LINE = 0.3  # mm: nearer to a line a point stands on it


def face_marks(posed: Posed, contact: Contact) -> Iterator[Mark]:
    """A flat face with its lever: the link's points stand on the face, or beside it on short welded arms."""
    line, name = posed.face(contact), contact.on.link
    own = posed.spots(name)
    t = line.travel(posed.at[contact.point])
    guided = posed.fixed_guide(name) is not None
    travels = [line.travel(spot) for spot in own]
    low, high = min(*travels, t - BEYOND, t), max(*travels, t + BEYOND)
    yield Segment(a=line.spot(low), b=line.spot(high), role=Role.LINK)
    for spot in own:
        if abs(line.off(spot)) > ON_LINE and not guided:
            foot, up = line.foot(spot), 1j * line.along * line.off(spot)
            yield Segment(a=foot, b=foot + up, role=Role.LINK)
            yield weld(foot, up, line.spot(t) - foot)
    if not guided:
        yield LinkNumber(a=line.spot(low), b=line.spot(t), number=posed.name(name))


def stem(posed: Posed, contact: Contact, link: str, guide: Prismatic) -> Segment:
    """The stem of a translating follower."""
    tip, _, _, end = _along_stem(posed, contact, link, guide)
    return Segment(a=tip, b=end, role=Role.LINK)


def stem_guided(posed: Posed, contact: Contact, link: str, guide: Prismatic) -> Iterator[Mark]:
    """The stem in its fixed guide, with the link's number."""
    _, start, away, end = _along_stem(posed, contact, link, guide)
    yield stem(posed, contact, link, guide)
    for side in (1, -1):
        a, b = (start, start + away * SHOE)[::side]
        yield FixedGuide(a=a - 1j * side * away * PLAY, b=b - 1j * side * away * PLAY)
    yield LinkNumber(a=start + away * SHOE, b=end, number=posed.name(link))


def offset_marks(posed: Posed, contact: Contact, link: str, guide: Prismatic) -> Iterator[Mark]:
    """The centre line of a stem, and the offset circle about the cam's pivot."""
    line, (tip, *_) = posed.guide(guide), _along_stem(posed, contact, link, guide)
    pivot = posed.fixed_pivot(next(name for name in contact.links if name != link))
    if pivot:
        centre = posed.at[pivot]
        foot = line.foot(centre)
        yield Segment(a=foot, b=tip, role=Role.CENTRE)
        if abs(foot - centre) > 1.0:
            yield Arc(centre=centre, radius=abs(foot - centre), start=0.0, sweep=2 * pi, role=Role.CENTRE)


def _along_stem(
    posed: Posed, contact: Contact, link: str, guide: Prismatic
) -> tuple[complex, complex, complex, complex]:
    """The stem's tip, where its guide begins, the way there, and its end."""
    line = posed.guide(guide)
    away = line.along * _sign((line.along.conjugate() * _push(posed, contact, link)).real)
    tip, reach = _tip(posed, contact, link, line)
    start = tip + away * (reach + max(min(STEM, NUMBERED - reach), LEAST))
    return tip, start, away, start + away * (SHOE + STEM)


def pressure_angle(posed: Posed, contact: Contact) -> Iterator[Mark]:
    """The angle between the common normal and the way in which the follower's tip (or the point of its face) can go."""
    link = next((name for name in contact.links if name != posed.mech.drive.link), "")
    push = _push(posed, contact, link)
    round_tip = next((end for end in (contact.disc, contact.on) if isinstance(end, Circle) and end.link == link), None)
    at = posed.at[round_tip.centre if round_tip else contact.point]
    way = _free_way(posed, link, at)
    if way is None:
        return
    way *= _sign((push.conjugate() * way).real)
    angle = cmath.phase(way / push)
    if abs(angle) > SMALL:
        yield Segment(a=at, b=at + way * (SWING + 3), role=Role.CONSTRUCTION)
        yield AngleMark(at=at, radius=SWING, start=cmath.phase(push), sweep=angle, label="α", key="alpha")


def _sign(size: float) -> float:
    """±1; where there is no size, 1."""
    return copysign(1.0, size) if size else 1.0


def _push(posed: Posed, contact: Contact, link: str) -> complex:
    """Unit vector of the way in which the other link presses on this one."""
    normal = posed.normal(contact)
    return normal if link == contact.on.link else -normal


def _free_way(posed: Posed, link: str, at: complex) -> complex | None:
    """Direction in which a point of a link on a fixed pivot or in a fixed guide can move; None for other links."""
    for joint in posed.mech.joints:
        if isinstance(joint, Prismatic) and joint.guide == FRAME and joint.block == link:
            return posed.guide(joint).along
        if isinstance(joint, Revolute) and {joint.a, joint.b} == {link, FRAME}:
            arm = at - posed.at[joint.point]
            return 1j * arm / abs(arm)
    return None


def _tip(posed: Posed, contact: Contact, link: str, line: Way) -> tuple[complex, float]:
    """Where the stem begins, and how far its tip reaches (mm): a round tip's centre, or the guide's line."""
    for end in (contact.disc, contact.on):
        if isinstance(end, Circle) and end.link == link:
            return posed.at[end.centre], posed.mm(end.radius)
    face = posed.face(contact)
    across = (1j * face.along).conjugate()
    return line.spot((across * (face.at - line.at)).real / (across * line.along).real), 0.0
