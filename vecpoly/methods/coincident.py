"""Letters under which points of several links lie on each other: they are told apart by the numbers of the links."""

from __future__ import annotations

from ..mechanism.groups.assur import Group
from ..mechanism.model import FRAME, Mechanism, Prismatic, Revolute
from .kinematics.class_iii.star import letters_on_legs


def coincident_letters(mech: Mechanism, groups: tuple[Group, ...]) -> dict[str, str]:
    """Letters under which points of several links are told apart by their numbers,
    and the block whose point is meant first.

    P always carries a number, since p is the pole.
    A pin in a slot, which has no block, is told by the link that carries it.
    """
    unseen = mech.slot_pins
    carriers = [name for name in mech.bodies if name not in unseen and "P" in mech.link(name).points]
    letters = {"P": carriers[0]} if carriers else {}
    for d in (group.dyad for group in groups if group.dyad is not None):
        if isinstance(d.inner, Prismatic):
            pins = {d.link_j: d.outer_j, d.link_k: d.outer_k}
            pin = d.outer_j if d.kind == "RPP" else pins[d.inner.block]
            letters |= {pin.point: d.link_j if d.kind == "RPP" else d.inner.block} if isinstance(pin, Revolute) else {}
        elif isinstance(d.inner, Revolute):
            moving = [
                link
                for joint, link, parent in ((d.outer_j, d.link_j, d.parent_j), (d.outer_k, d.link_k, d.parent_k))
                if isinstance(joint, Prismatic) and parent != FRAME
            ]
            if moving:
                letters[d.inner.point] = moving[0]
    for group in groups:
        letters |= letters_on_legs(group) if group.ram is None else {group.ram.inner.point: group.ram.far}
    substitutes = {j.block for j in mech.joints if isinstance(j, Prismatic) and j.pin_in_slot}
    return {
        letter: mech.number(next(n for n in mech.links_at(letter) if n not in substitutes))
        if link in substitutes
        else link
        for letter, link in letters.items()
    }
