"""Cams: profile, base circle, follower with its tip, contact, common normal, and the substitute, dashed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi

from ...board.paper.marks import Arc, Disc, Dot, LinkNumber, Mark, Point, Role, Segment
from ...board.paper.symbols import Symbol
from ...mechanism.model import FRAME, Circle, Contact, Link, Mechanism, Prismatic, Rack
from ..bars import bar
from ..owners import joint, link, owned
from ..posed import Posed
from .follower import face_marks, offset_marks, pressure_angle, stem_guided
from .profile import profile_marks

NORMAL = 15.0  # mm the common normal runs on beyond the contact
BLOCK = (4.5, 2.5)  # mm, half the sides of the dashed block
EDGE = 0.5  # mm: a pivot nearer to the disc's centre is its centre


def contact_replaced(mech: Mechanism, substitute: str) -> Contact | None:
    """The contact for which this link stands, if it is such a link."""
    return next((contact for contact in mech.contacts if contact.substitute == substitute), None)


def contacts_of(mech: Mechanism, link: str) -> tuple[Contact, ...]:
    """The contacts in which a real link takes part."""
    return tuple(contact for contact in mech.contacts if link in contact.links)


def guided_follower(posed: Posed, joint: Prismatic) -> bool:
    """Whether this is the guide of a cam's follower, which has symbols of its own."""
    return joint.guide == FRAME and bool(contacts_of(posed.mech, joint.block))


def cam_body(posed: Posed, body: Link) -> Iterator[Mark]:
    """A link that takes part in a contact: its discs, and its bar; an eccentric has no bar but its centre line."""
    discs = _discs(posed, body.name)
    profile = next((one for one in posed.mech.cams if one.link == body.name), None)
    if profile is not None:
        yield from profile_marks(posed, profile, discs[profile.centre])
        return
    for centre, radius in discs.items():
        yield Disc(centre=posed.at[centre], radius=posed.mm(radius))
    pivot = posed.fixed_pivot(body.name)
    about = next((c for c, r in discs.items() if pivot and abs(body.points[c] - body.points[pivot]) < r), "")
    if about:
        yield from _eccentric(posed, body, pivot, about, discs[about])
        return
    yield from _roller(posed, body, discs) if discs else ()
    if posed.fixed_guide(body.name) is None and discs:
        spots = posed.spots(body.name)
        yield from bar(spots) if len(spots) > 1 else ()
        yield LinkNumber(a=spots[0], b=spots[1 % len(spots)], number=posed.name(body.name))


def contact_drawn(posed: Posed, contact: Contact) -> Iterator[Symbol]:
    """The meeting of two links: the normal, the substitute, the follower's face and stem, the pressure angle."""
    own = joint(contact.point)
    if isinstance(contact.on, Rack):
        yield from owned(link(contact.on.link), face_marks(posed, contact))
    yield Symbol.of(own, _replaced(posed, contact))
    yield Symbol.of(own, _normal(posed, contact))
    for name in contact.links:
        guide = posed.fixed_guide(name)
        if guide is not None:
            yield from owned(link(name), stem_guided(posed, contact, name, guide))
            yield Symbol.of(own, offset_marks(posed, contact, name, guide))
    if not posed.loaded:
        yield Symbol.of(own, pressure_angle(posed, contact))


def _replaced(posed: Posed, contact: Contact) -> Iterator[Mark]:
    """What stands for the contact: a bar between the centres, or a block led parallel to the face."""
    o = posed.at[contact.disc.centre]
    if isinstance(contact.on, Circle):
        yield Segment(a=o, b=posed.at[contact.on.centre], role=Role.HIDDEN)
    else:
        yield from thought_guide(posed, contact)
        yield from _dashed_block(o, posed.face(contact).along)


def _normal(posed: Posed, contact: Contact) -> Iterator[Mark]:
    """The common normal, beyond both centres of curvature."""
    o, n = posed.at[contact.disc.centre], posed.normal(contact)
    other = posed.at[contact.on.centre if isinstance(contact.on, Circle) else contact.point]
    ahead, behind = sorted((other, o), key=lambda s: (n.conjugate() * s).real, reverse=True)
    for start, way in ((ahead, n), (behind, -n)):
        yield Segment(a=start, b=start + way * NORMAL, role=Role.CONSTRUCTION)
        yield Point(at=start + way * NORMAL, label="n", dot=Dot.NONE)


def thought_guide(posed: Posed, contact: Contact) -> Iterator[Mark]:
    """The guide of the block that stands for the contact with a face: parallel to it, through the disc's centre."""
    o, along, half = posed.at[contact.disc.centre], posed.face(contact).along, BLOCK[0]
    for way in (-along, along):
        yield Segment(a=o + way * half, b=o + way * 3.5 * half, role=Role.HIDDEN)
    yield Segment(a=o, b=posed.at[contact.point], role=Role.CONSTRUCTION)


def _discs(posed: Posed, link: str) -> dict[str, float]:
    """Centre letter and radius (m) of every disc with which the link touches another."""
    ends = [end for contact in contacts_of(posed.mech, link) for end in (contact.disc, contact.on)]
    return {end.centre: end.radius for end in ends if isinstance(end, Circle) and end.link == link}


def _roller(posed: Posed, body: Link, discs: Mapping[str, float]) -> Iterator[Mark]:
    """The number of a roller that is taken as part of its link, beside its rim."""
    for roller, _ in (pair for pair in posed.mech.welded if pair[1] == body.name):
        spot = posed.at[next(iter(discs))]
        yield LinkNumber(a=spot, b=spot, number=roller)


def _eccentric(posed: Posed, body: Link, pivot: str, centre: str, radius: float) -> Iterator[Mark]:
    """Centre line and base circle r_0 = R − e of a disc about its pivot; the number inside, off the centre line."""
    a, o, r = posed.at[pivot], posed.at[centre], posed.mm(radius)
    arm = o - a
    if abs(arm) > EDGE:
        yield Segment(a=a, b=o, role=Role.CENTRE)
        yield Arc(centre=a, radius=r - abs(arm), start=0.0, sweep=2 * pi, role=Role.CENTRE)
    across = 1j * arm / abs(arm) if abs(arm) > EDGE else 1 + 0j
    spot = max((o + side * 0.6 * r * across for side in (1, -1)), key=lambda s: -(s - a).imag)
    yield LinkNumber(a=spot, b=spot, number=posed.name(body.name))


def _dashed_block(at: complex, along: complex) -> Iterator[Mark]:
    """The block that stands for the contact with a face."""
    half, height = BLOCK
    corners = [at + along * complex(x * half, y * height) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        yield Segment(a=a, b=b, role=Role.HIDDEN)
