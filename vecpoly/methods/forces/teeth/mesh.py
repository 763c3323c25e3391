"""What gears do to each other as it is known to the drawing:
the pair in which a gear or a rack meshes, and what else holds it."""

from __future__ import annotations

from dataclasses import dataclass

from ....mechanism.groups.assur import Dyad, Group, Outer, dyad_of
from ....mechanism.model import Joint, Revolute, Rolling
from ..lines.links_of_group import Held


@dataclass(frozen=True, slots=True, kw_only=True)
class Mesh:
    """A gear or a rack, held by its parent, whose teeth alone transmit: those of link `by` press on it."""

    held: Held
    by: str
    teeth: Rolling


def as_pin(joint: Joint) -> Joint:
    """The joint; a pitch point that no link holds at its distance presses in any direction, as a pin there would."""
    if not isinstance(joint, Rolling):
        return joint
    return Revolute(point=joint.point, a=joint.gear.link, b=joint.on.link)


def pinned(dyad: Dyad) -> Dyad:
    """The dyad with pins in the place of its pitch points: in a dyad of two links nothing else holds gears together."""
    outer = (
        Outer(joint=as_pin(dyad.outer_j), link=dyad.link_j, parent=dyad.parent_j),
        Outer(joint=as_pin(dyad.outer_k), link=dyad.link_k, parent=dyad.parent_k),
    )
    return dyad_of(as_pin(dyad.inner), *outer)


def mesh_of(group: Group) -> Mesh | None:
    """The gear or rack of a group of one link, which its bearing or guide holds; None for any other group."""
    meshing = [out for out in group.outer if isinstance(out.joint, Rolling)]
    rest = [out for out in group.outer if not isinstance(out.joint, Rolling)]
    if len(group.links) != 1 or len(meshing) != 1 or len(rest) != 1:
        return None
    teeth = meshing[0].joint
    assert isinstance(teeth, Rolling)
    held = Held(link=rest[0].link, parent=rest[0].parent, joint=rest[0].joint)
    return Mesh(held=held, by=meshing[0].parent, teeth=teeth)
