"""Where a disc touches another disc or a flat face, and the common normal there."""

from __future__ import annotations

import numpy as np

from ...mechanism.model import Contact, Mechanism, Rack, Side
from ..state import Bodies, Points
from .cammed import profile_at, touched


def touching(mech: Mechanism, bodies: Bodies, contact: Contact) -> tuple[Points, Points]:
    """The touching point K (m), and the unit normal along which the disc is pressed:
    from K towards the disc's centre."""
    if (profile := profile_at(mech, contact.point)) is not None:
        return touched(contact, profile, bodies)
    disc, on, radius = contact.disc, contact.on, contact.disc.radius
    centre = bodies[disc.link].point(mech.link(disc.link).points[disc.centre])
    if isinstance(on, Rack):
        side = 1j if contact.side is Side.LEFT else -1j
        normal = bodies[on.link].unit * complex(side * np.exp(1j * on.direction))
        return centre - radius * normal, normal
    ray = centre - bodies[on.link].point(mech.link(on.link).points[on.centre])
    ray = ray / np.abs(ray)
    if not contact.internal:
        return centre - radius * ray, ray
    return centre + radius * ray * (1 if radius < on.radius else -1), -ray
