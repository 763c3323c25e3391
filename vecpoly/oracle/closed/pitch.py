"""The pitch point of two rolling bodies: where their pitch circles touch now."""

from __future__ import annotations

import numpy as np

from ...mechanism.model import Mechanism, Rack, Rolling, Side
from ..state import Bodies, Points


def pitch_point(joint: Rolling, mech: Mechanism, bodies: Bodies) -> Points:
    """Foot of the gear's centre on the rack's pitch line, or the point of contact on the line of centres (m)."""
    gear, base = bodies[joint.gear.link], bodies[joint.on.link]
    centre = gear.point(mech.link(joint.gear.link).points[joint.gear.centre])
    if isinstance(joint.on, Rack):
        side = 1 if joint.side is Side.LEFT else -1
        normal = base.unit * complex(np.exp(1j * joint.on.direction)) * 1j
        return centre - side * joint.gear.radius * normal
    other = base.point(mech.link(joint.on.link).points[joint.on.centre])
    ray = centre - other
    inward = joint.internal and joint.on.radius < joint.gear.radius
    return other + ray * ((-1 if inward else 1) * joint.on.radius / np.abs(ray))
