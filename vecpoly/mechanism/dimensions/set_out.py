"""A link's points set out anew, and what is fixed to them: placed points, guide lines through its letters."""

from __future__ import annotations

import cmath
from collections.abc import Mapping

from ...foundation.slotted import replace
from ..model import FRAME, Joint, Link, Mechanism, Prismatic
from .placements import Placement, along, local

_NEAR = 1e-9  # m
Points = Mapping[str, complex]


def set_out(mech: Mechanism, link: Link, firm: Points, placements: tuple[Placement, ...]) -> Mechanism:
    """The mechanism with these first points of the link, and these placements; what does not close becomes NaN."""
    points = dict(firm)
    for old, new in zip(link.placements, placements, strict=True):
        points[new.point] = points[new.base[0]] + _ray(link, old, points) * local(new, points)
    return moved(mech, link.name, {letter: points[letter] for letter in link.points}, placements)


def firm(link: Link) -> dict[str, complex]:
    """The points of a link that no other point of it sets out."""
    placed = {one.point for one in link.placements}
    return {letter: at for letter, at in link.points.items() if letter not in placed}


def moved(mech: Mechanism, name: str, points: Points, placements: tuple[Placement, ...] | None = None) -> Mechanism:
    """The mechanism with the points of one link, or of the frame, elsewhere, and the guide lines through them."""
    old = mech.link(name).points
    joints = tuple(
        _led(joint, old, points) if isinstance(joint, Prismatic) and joint.guide == name else joint
        for joint in mech.joints
    )
    if name == FRAME:
        return replace(mech, frame=points, joints=joints)
    links = tuple(_with(one, points, placements) if one.name == name else one for one in mech.links)
    return replace(mech, links=links, joints=joints)


def stretched(link: Link, fixed: str, other: str, length: float) -> Link:
    """The link with `other` at this distance (m) from `fixed`, all other letters where they are.

    It has its own coordinates again: its origin is its first letter, its axis runs towards its second;
    nothing is left of how the points were set out.
    """
    points = dict(link.points)
    span = points[other] - points[fixed]
    points[other] = points[fixed] + span * length / abs(span)
    if points == dict(link.points):
        return link
    first, second, *_ = points.values()
    unit = (second - first) / abs(second - first)
    return replace(link, points={letter: (at - first) / unit for letter, at in points.items()}, placements=())


def _with(link: Link, points: Points, placements: tuple[Placement, ...] | None) -> Link:
    return replace(link, points=points, placements=link.placements if placements is None else placements)


def _ray(link: Link, placement: Placement, points: Points) -> complex:
    """Unit vector of the base's ray; that of a single letter, the guide's direction, stays as it was."""
    if len(placement.base) == 2:
        return along(points[placement.base[0]], points[placement.base[1]])
    seen = local(placement, link.points)
    return along(0j, (link.points[placement.point] - link.points[placement.base[0]]) / seen) if seen else 1 + 0j


def _led(guide: Prismatic, old: Points, new: Points) -> Joint:
    """The guide line through its letter, turned with it where a second letter gives its direction."""
    if guide.through not in old:
        return guide
    start = old[guide.through]
    other = guide.towards if guide.towards in old else _on_line(guide, old)
    turned = cmath.phase((new[other] - new[guide.through]) / (old[other] - start)) if other else 0.0
    origin = new[guide.through] + (guide.origin - start) * cmath.rect(1.0, turned)
    direction = along_of(guide, new) if guide.towards in old else guide.direction + turned
    return replace(guide, origin=origin, direction=direction)


def along_of(guide: Prismatic, points: Points) -> float:
    """The direction (rad) of a guide that two letters give."""
    return cmath.phase(points[guide.towards] - points[guide.through])


def _on_line(guide: Prismatic, old: Points) -> str:
    """A second letter of a moving guide link that lies on the line; a line of the frame is at a given angle."""
    if guide.guide == FRAME:
        return ""
    start, unit = old[guide.through], cmath.rect(1.0, guide.direction)
    return next(
        (letter for letter, at in old.items() if abs(at - start) > _NEAR and abs(((at - start) / unit).imag) < _NEAR),
        "",
    )
