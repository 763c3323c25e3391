"""Links told from their fixed pivots: the angle of a rocker DC counts from D,
whichever letter the problem file names first."""

from __future__ import annotations

import cmath

from ...foundation.slotted import replace
from ...mechanism.groups.assur import hinges
from ...mechanism.model import FRAME, Joint, Link, Mechanism, Prismatic, Rack, Rolling


def from_pivots(mech: Mechanism) -> Mechanism:
    """The same mechanism with the axis of every driven link that hangs on
    the frame by one of its later letters turned to run from that letter.

    Only coordinates within the links change; places, velocities and the angular rates of all links are the same.
    """
    turned = {link.name: pivot for link in mech.links if link.name != mech.drive.link and (pivot := _pivot(mech, link))}
    for name, pivot in turned.items():
        mech = _from(mech, name, pivot)
    return mech


def _pivot(mech: Mechanism, link: Link) -> str:
    """The fixed hinge of a link that is not its first letter;
    nothing where the first is fixed, or where blocks slide on it, or it rolls."""
    pinned = [letter for letter, names in hinges(mech).items() if FRAME in names and link.name in names]
    rolls = any(isinstance(joint, Rolling) and link.name in (joint.gear.link, joint.on.link) for joint in mech.joints)
    guides = any(isinstance(joint, Prismatic) and link.name == joint.guide for joint in mech.joints)
    return (
        pinned[0]
        if pinned and len(link.points) > 1 and not rolls and not guides and next(iter(link.points)) not in pinned
        else ""
    )


def _from(mech: Mechanism, name: str, pivot: str) -> Mechanism:
    """The mechanism with this link's origin in its pivot and its axis towards what was its first letter."""
    link = mech.link(name)
    start = link.points[pivot]
    first, *rest = (letter for letter in link.points if letter != pivot)
    lean = cmath.phase(link.points[first] - start)
    points = {letter: (link.points[letter] - start) * cmath.rect(1.0, -lean) for letter in (pivot, first, *rest)}
    links = tuple(replace(one, points=points, placements=()) if one.name == name else one for one in mech.links)
    contacts = tuple(
        replace(c, on=_moved(c.on, start, lean)) if isinstance(c.on, Rack) and c.on.link == name else c
        for c in mech.contacts
    )
    return replace(
        mech, links=links, joints=tuple(_joint(joint, name, lean) for joint in mech.joints), contacts=contacts
    )


def _joint(joint: Joint, name: str, lean: float) -> Joint:
    return replace(joint, turn=joint.turn + lean) if isinstance(joint, Prismatic) and joint.block == name else joint


def _moved(line: Rack, start: complex, lean: float) -> Rack:
    return replace(line, origin=(line.origin - start) * cmath.rect(1.0, -lean), direction=line.direction - lean)


def by_x_axis(mech: Mechanism) -> Mechanism:
    """The same mechanism, the angle of its drive told by the x axis of its link, which stands in the equations,
    however the problem tells it."""
    if not mech.drives or mech.drive.ray is None:
        return mech
    return replace(mech, drives=(replace(mech.drive, ray=None), *mech.drives[1:]))
