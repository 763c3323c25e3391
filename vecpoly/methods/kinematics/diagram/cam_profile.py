"""Cams in the kinematic diagram: profile, base circle, follower with its tip, contact, common normal, and the
substitute, dashed."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Arc, Disc, Dot, LinkNumber, Mark, Point, Role, Segment
from ....mechanism.model import FRAME, Circle, Contact, Link, Prismatic, Revolute
from ....plane import nominal
from ...desk import Desk
from .bars import bar
from .cam import contacts_of
from .follower import face_marks, pressure_angle, stem_marks

NORMAL = 15.0  # mm the common normal runs on beyond the contact
BLOCK = (4.5, 2.5)  # mm, half the sides of the dashed block


def cam_body(desk: Desk, body: Link) -> Iterator[Mark]:
    """A link that takes part in a contact: its discs, and its bar; an eccentric has no bar but its centre line."""
    discs = _discs(desk, body.name)
    for centre, radius in discs.items():
        yield Disc(centre=_spot(desk, centre), radius=desk.mm(radius))
    pivot = fixed_pivot(desk, body.name)
    about = next((c for c, r in discs.items() if pivot and abs(body.points[c] - body.points[pivot]) < r), "")
    if about:
        yield from _eccentric(desk, body, pivot, about, discs[about])
    elif fixed_guide(desk, body.name) is None and discs:
        spots = [_spot(desk, p) for p in body.points]
        yield from bar(spots) if len(spots) > 1 else ()
        yield from _roller(desk, body, discs)
        yield LinkNumber(a=spots[0], b=spots[1 % len(spots)], number=body.name)


def _roller(desk: Desk, body: Link, discs: Mapping[str, float]) -> Iterator[Mark]:
    """The number of a roller that is taken as part of its link, inside its disc and off the link's line."""
    for roller, _ in (pair for pair in desk.mech.welded if pair[1] == body.name):
        centre, radius = next(iter(discs.items()))
        other = next((p for p in body.points if p != centre), centre)
        arm = _spot(desk, centre) - _spot(desk, other)
        spot = _spot(desk, centre) + (0.5 * desk.mm(radius) * arm / abs(arm) if arm else 0)
        yield LinkNumber(a=spot, b=spot, number=roller)


def draw_contacts(desk: Desk) -> None:
    """Every contact whose point has just been found: both links' meeting, its letter, the normal, the substitute."""
    done = {m.label for m in desk.board.marks(View.MECHANISM) if isinstance(m, Point)}
    for contact in desk.mech.contacts:
        if contact.point in desk.at and contact.point not in done:
            desk.board.mark(View.MECHANISM, *_contact(desk, contact), owner=f"joint {contact.point}")
            desk.board.plot(View.MECHANISM, desk.at[contact.point], contact.point, Dot.POINT)


def fixed_pivot(desk: Desk, link: str) -> str:
    """The letter by which a link is pinned to the frame, if it is."""
    return next((j.point for j in desk.mech.joints if isinstance(j, Revolute) and {j.a, j.b} == {link, FRAME}), "")


def fixed_guide(desk: Desk, link: str) -> Prismatic | None:
    """The fixed guide of a translating link, if it has one."""
    return next(
        (j for j in desk.mech.joints if isinstance(j, Prismatic) and j.guide == FRAME and j.block == link), None
    )


def guided_follower(desk: Desk, joint: Prismatic) -> bool:
    """Whether this is the guide of a cam's follower, which has symbols of its own."""
    return joint.guide == FRAME and bool(contacts_of(desk.mech, joint.block))


def _spot(desk: Desk, name: str) -> complex:
    return complex(nominal(desk.at[name]))


def _discs(desk: Desk, link: str) -> dict[str, float]:
    """Centre letter and radius (m) of every disc with which the link touches another."""
    ends = [end for contact in contacts_of(desk.mech, link) for end in (contact.disc, contact.on)]
    return {end.centre: end.radius for end in ends if isinstance(end, Circle) and end.link == link}


def _eccentric(desk: Desk, body: Link, pivot: str, centre: str, radius: float) -> Iterator[Mark]:
    """Centre line and base circle r_0 = R − e of a disc about its pivot; the number stands inside, off the centre
    line."""
    a, o, r = _spot(desk, pivot), _spot(desk, centre), desk.mm(radius)
    arm = o - a
    if abs(arm) > 0.5:
        yield Segment(a=a, b=o, role=Role.CENTRE)
        yield Arc(centre=a, radius=r - abs(arm), start=0.0, sweep=2 * np.pi, role=Role.CENTRE)
    across = 1j * arm / abs(arm) if abs(arm) > 0.5 else 1 + 0j
    spot = max((o + side * 0.6 * r * across for side in (1, -1)), key=lambda s: -(s - a).imag)
    yield LinkNumber(a=spot, b=spot, number=body.name)


def _contact(desk: Desk, contact: Contact) -> Iterator[Mark]:
    k, o = _spot(desk, contact.point), _spot(desk, contact.disc.centre)
    n = complex(nominal(desk.normal_of(contact)))
    if isinstance(contact.on, Circle):
        e = _spot(desk, contact.on.centre)
        ahead, behind = sorted((e, o), key=lambda s: (np.conj(n) * s).real, reverse=True)
        yield Segment(a=o, b=e, role=Role.HIDDEN)
    else:
        ahead, behind = k, o
        yield from face_marks(desk, contact)
        yield from _dashed_block(o, complex(nominal(desk.face_line(contact).along)))
        yield Segment(a=o, b=k, role=Role.CONSTRUCTION)
    for start, way in ((ahead, n), (behind, -n)):
        yield Segment(a=start, b=start + way * NORMAL, role=Role.CONSTRUCTION)
        yield Point(at=start + way * NORMAL, label="n", dot=Dot.NONE)
    for link in contact.links:
        guide = fixed_guide(desk, link)
        if guide is not None:
            yield from stem_marks(desk, contact, link, guide)
    if not desk.loaded:
        yield from pressure_angle(desk, contact)


def _dashed_block(at: complex, along: complex) -> Iterator[Mark]:
    """The block that stands for the contact with a face, and its guide, both only thought."""
    half, height = BLOCK
    yield Segment(a=at - along * 3.5 * half, b=at - along * half, role=Role.HIDDEN)
    yield Segment(a=at + along * half, b=at + along * 3.5 * half, role=Role.HIDDEN)
    corners = [at + along * complex(x * half, y * height) for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))]
    for a, b in zip(corners, (*corners[1:], corners[0]), strict=True):
        yield Segment(a=a, b=b, role=Role.HIDDEN)
