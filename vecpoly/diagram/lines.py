"""Guides, faces and contacts of a mechanism as it stands on a figure: by one hand, or by many at once."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np

from ..mechanism.model import Contact, Mechanism, Prismatic, Rack, Side
from ..plane import Line, Points, foot, unit


class Standing(Protocol):
    """Links and letters where they stand on a figure (mm)."""

    @property
    def mech(self) -> Mechanism: ...

    @property
    def at(self) -> Mapping[str, Points]: ...

    def mm(self, metres: float) -> float:
        """A length of the mechanism on paper."""
        ...

    def place(self, link: str, local: complex) -> Points:
        """A point given in link coordinates (m), on paper."""
        ...

    def axis(self, link: str) -> Points:
        """The direction of the link's x axis on paper."""
        ...

    def is_located(self, *links: str) -> bool:
        """Whether all of these have been found; the frame always is."""
        ...


def line_on(of: Standing, link: str, origin: complex, direction: float) -> Line:
    """A line that is fixed on a link, given in link coordinates (m, rad)."""
    return Line(of.place(link, origin), of.axis(link) * np.exp(1j * direction))


def guide_line(of: Standing, joint: Prismatic) -> Line:
    """The guide of a sliding pair, found from whichever of its two links is found."""
    if of.is_located(joint.guide):
        return line_on(of, joint.guide, joint.origin, joint.direction)
    along = of.axis(joint.block) * np.exp(-1j * joint.turn)
    pin = of.mech.link(joint.block).points[joint.pin]
    return Line(of.place(joint.block, pin) - 1j * along * of.mm(joint.offset), along)


def face_line(of: Standing, contact: Contact) -> Line:
    """The flat face of a contact."""
    assert isinstance(contact.on, Rack)
    return line_on(of, contact.on.link, contact.on.origin, contact.on.direction)


def normal_of(of: Standing, contact: Contact) -> Points:
    """The common normal of a contact: unit vector from the disc's centre through the point of contact, into the other
    link."""
    if isinstance(contact.on, Rack):
        return face_line(of, contact).along * (-1j if contact.side is Side.LEFT else 1j)
    way = unit(of.at[contact.on.centre] - of.at[contact.disc.centre])
    return -way if contact.internal else way


def contact_of(of: Standing, contact: Contact) -> Points:
    """Where the links of a contact touch: the foot of the disc's centre on the face, or on the line of centres."""
    centre = of.at[contact.disc.centre]
    if isinstance(contact.on, Rack):
        return foot(face_line(of, contact), centre)
    return centre + normal_of(of, contact) * of.mm(contact.disc.radius)
