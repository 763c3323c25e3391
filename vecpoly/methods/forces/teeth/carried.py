"""A planet on its arm (系杆) as its forces see it: two pairs of teeth, the pin on the arm, and the arm's own hinge."""

from __future__ import annotations

from dataclasses import dataclass

from ....mechanism.groups.assur import Group, ends
from ....mechanism.model import Circle, Revolute, Rolling
from ..lines.links_of_group import Held
from .mesh import Mesh


@dataclass(frozen=True, slots=True, kw_only=True)
class Carried:
    """A planet that meshes with two known gears about the arm's pivot: both pitch points lie on the line of the arm.

    pin: letter of the planet's centre; pivot: of the arm's hinge on `parent`.
    """

    planet: str
    arm: str
    pin: str
    pivot: str
    parent: str
    meshes: tuple[Mesh, Mesh]

    @property
    def links(self) -> tuple[str, str]:
        """Planet and arm."""
        return self.planet, self.arm


def carried_of(group: Group) -> Carried | None:
    """The planet and its arm; None where the group is anything else, or more."""
    teeth = [out for out in group.outer if isinstance(out.joint, Rolling)]
    hinges = [out for out in group.outer if isinstance(out.joint, Revolute)]
    if len(group.links) != 2 or len(group.inner) != 1 or (len(teeth), len(hinges)) != (2, 1):
        return None
    inner, hinge, planet = group.inner[0], hinges[0], teeth[0].link
    if not isinstance(inner, Revolute) or not isinstance(hinge.joint, Revolute):
        return None
    if teeth[1].link != planet or hinge.link == planet:
        return None
    pivot = hinge.joint.point
    if not all(_between(one.joint, planet, inner.point, pivot) for one in teeth):
        return None
    held = Held(link=planet, parent=hinge.link, joint=inner)
    one, two = (Mesh(held=held, by=out.parent, teeth=out.joint) for out in teeth if isinstance(out.joint, Rolling))
    return Carried(planet=planet, arm=hinge.link, pin=inner.point, pivot=pivot, parent=hinge.parent, meshes=(one, two))


def _between(joint: object, planet: str, pin: str, pivot: str) -> bool:
    """Whether these are teeth of the planet, about its pin, and of a gear about the arm's pivot."""
    if not isinstance(joint, Rolling) or not isinstance(joint.on, Circle) or planet not in ends(joint):
        return False
    own, other = (joint.gear, joint.on) if joint.gear.link == planet else (joint.on, joint.gear)
    return own.centre == pin and other.centre == pivot
