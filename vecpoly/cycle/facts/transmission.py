"""The transmission angle of a dyad: the angle at which its links hold the inner joint,
90° at best, 0° where it is folded."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...mechanism.groups.assur import Dyad
from ...mechanism.model import Joint, Mechanism, Prismatic, Revolute
from ...oracle import Motion

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]


def angle_of(motion: Motion, dyad: Dyad) -> Reals:
    """γ within 0..π (rad), not folded: 0 and π are both dead points, and γ passes 90° smoothly.

    RRR: between the two bars. RRP: between the bar and the normal of the guide (90° less the pressure angle).
    RPR: between the guide's line and the normal of the line of the outer pins. PRP, RPP: between the two guides.
    """
    a, b = _sides(motion, dyad)
    turned: Points = np.conj(a) * b
    return np.arctan2(np.abs(turned.imag), turned.real)


def folded(gamma: Reals) -> Reals:
    """γ or its supplement, whichever is the smaller (rad)."""
    return np.minimum(gamma, np.pi - gamma)


def arm_of(motion: Motion, dyad: Dyad) -> Reals:
    """Distance (m) of the dyad's outer pins: where a rotating slotted link has a short one, it turns fast."""
    return np.abs(_pin(motion, dyad.outer_k) - _pin(motion, dyad.outer_j))


def _sides(motion: Motion, dyad: Dyad) -> tuple[Points, Points]:
    """Two directions whose angle is the transmission angle."""
    match dyad.outer_j, dyad.inner, dyad.outer_k:
        case Revolute(), Revolute(), Revolute():
            here = _pin(motion, dyad.inner)
            return _pin(motion, dyad.outer_j) - here, _pin(motion, dyad.outer_k) - here
        case Revolute(), Revolute(), Prismatic() as guide:
            return _pin(motion, dyad.inner) - _pin(motion, dyad.outer_j), 1j * _along(motion, guide)
        case Revolute(), Prismatic() as guide, Revolute():
            return 1j * (_pin(motion, dyad.outer_k) - _pin(motion, dyad.outer_j)), _along(motion, guide)
        case Revolute(), Prismatic() as guide, Prismatic() as last:
            return _along(motion, guide), _along(motion, last)
        case Prismatic() as first, Revolute(), Prismatic() as last:
            return _along(motion, first), _along(motion, last)
    lost = np.full(1, complex(np.nan, np.nan))
    return lost, lost


def _pin(motion: Motion, joint: Joint) -> Points:
    assert isinstance(joint, Revolute)
    return motion.place(joint.point)


def _along(motion: Motion, joint: Prismatic) -> Points:
    """Direction of the guide."""
    line: Points = motion.bodies[joint.guide].unit * complex(np.exp(1j * joint.direction))
    return line


def is_told(mech: Mechanism, dyad: Dyad) -> bool:
    """Whether the dyad's transmission angle changes:
    not where gears roll, nor where the outer pins lie on one parallel to the slot."""
    if "G" in dyad.kind:
        return False
    if isinstance(dyad.inner, Prismatic) and dyad.kind == "RPR":
        return abs(_off_line(mech, dyad, dyad.inner)) > 1e-12 * mech.scale
    return True


def _off_line(mech: Mechanism, dyad: Dyad, slot: Prismatic) -> float:
    """How far the outer pin of the block lies to the left of the parallel to the slot through that of the guide (m)."""
    outer = {dyad.link_j: dyad.outer_j, dyad.link_k: dyad.outer_k}
    guided, sliding = (_local(mech, name, outer[name]) for name in (slot.guide, slot.block))
    along = (guided - slot.origin) * complex(np.exp(-1j * slot.direction))
    pin = mech.link(slot.block).points[slot.pin]
    return slot.offset + ((sliding - pin) * complex(np.exp(1j * slot.turn)) - along).imag


def _local(mech: Mechanism, link: str, joint: Joint) -> complex:
    assert isinstance(joint, Revolute)
    return mech.link(link).points[joint.point]
