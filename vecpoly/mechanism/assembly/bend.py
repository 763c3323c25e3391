"""The side to which two links bend that a motor in their hinge holds at a given angle."""

from __future__ import annotations

from cmath import phase
from math import sin

from ..dimensions.placements import Side
from ..model import Drive, Link, Mechanism, Revolute
from ..rams import driven_joint
from .statements import SideOf

STRAIGHT = 1e-9  # sine of the angle below which the two links are in one line and bend to no side


def bend(mech: Mechanism, drive: Drive) -> tuple[SideOf, ...]:
    """The branch statement that the angle of a hinge between two moving links implies;
    none for a slide, or links in one line.

    The hinge C lies left of the ray from B (on link `on`) to D (on `link`)
    where the angle from CB to CD is between 0 and 180°.
    """
    hinge = driven_joint(mech, drive)
    if not isinstance(hinge, Revolute):
        return ()
    ends = [_end(mech, name, hinge.point) for name in (drive.on, drive.link)]
    if None in ends:
        return ()
    (b, first), (d, second) = (end for end in ends if end is not None)
    bent = sin(drive.position + second - first)
    side = Side.LEFT if bent > 0 else Side.RIGHT
    return (SideOf(point=hinge.point, side=side, ref=(b, d)),) if abs(bent) > STRAIGHT else ()


def _end(mech: Mechanism, name: str, pin: str) -> tuple[str, float] | None:
    """The first other letter of a link, and its direction from the pin in the link's own coordinates (rad)."""
    link: Link = next(one for one in mech.links if one.name == name)
    return next(((letter, phase(at - link.points[pin])) for letter, at in link.points.items() if letter != pin), None)
