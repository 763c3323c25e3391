"""A mechanism with a disc in the place of a profile: contact, links, guide, on which side the follower lies."""

from __future__ import annotations

import cmath

from ...foundation.slotted import dataclass, replace
from ...mechanism.model import CamProfile, Circle, Contact, Joint, Link, Mechanism, Prismatic, Rack, Side, SideOf


@dataclass(frozen=True, slots=True, kw_only=True)
class Osculating:
    """The circle of the profile at the contact: centre in the cam's coordinates (m), radius (m) of the pitch curve,
    or of the profile under a face, negative where it is hollow; the follower's tip in the same coordinates."""

    centre: complex
    radius: float
    tip: complex


def with_disc(mech: Mechanism, profile: CamProfile, found: Osculating, outline: tuple[complex, ...]) -> Mechanism:
    """The mechanism with this disc for a profile, in the place of whatever disc it had; outline: of the profile."""
    contact = next(one for one in mech.contacts if one.point == profile.point)
    replaced = _contact(contact, profile, found)
    drawn = replace(profile, outline=outline)
    return replace(
        mech,
        links=tuple(_link(link, profile, contact, found) for link in mech.links),
        joints=tuple(_joint(joint, contact, found) for joint in mech.joints),
        contacts=tuple(replaced if one is contact else one for one in mech.contacts),
        branches=(*(one for one in mech.branches if not _is_ours(one, profile)), *_side(mech, profile, contact, found)),
        cams=tuple(drawn if one is profile else one for one in mech.cams),
    )


def _contact(contact: Contact, profile: CamProfile, found: Osculating) -> Contact:
    """The discs as they touch here: in a hollow of the cam the follower's lies inside, as it may have done before."""
    contact = replace(contact, internal=False)
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


def _is_ours(statement: object, profile: CamProfile) -> bool:
    """Whether it was said of another disc of this profile."""
    return isinstance(statement, SideOf) and statement.point == profile.end and profile.centre in statement.ref
