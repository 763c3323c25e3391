"""Letters under which points of several links coincide, and are told apart by their links' numbers."""

from __future__ import annotations

from collections.abc import Iterable

from ..mechanism.assur import Group
from ..mechanism.model import FRAME, Mechanism, Prismatic, Revolute


def coincident(mech: Mechanism, groups: Iterable[Group]) -> dict[str, str]:
    """The letter -> the link whose point is meant first: the block's.

    P always carries a number, since p is the pole. A pin in a slot, which has no block, is told by the link that carries it.
    """
    letters = {"P": next(li.name for li in mech.links if "P" in li.points)} if any("P" in li.points for li in mech.links) else {}
    for group in groups:
        letters |= _letters(group)
    unseen = {j.block for j in mech.joints if isinstance(j, Prismatic) and j.pin_in_slot}
    return {letter: next(n for n in mech.links_at(letter) if n not in unseen) if link in unseen else link for letter, link in letters.items()}


def _letters(group: Group) -> dict[str, str]:
    d = group.dyad
    if group.ram is not None:
        return {group.ram.inner.point: group.ram.far}
    if d is None:
        return {}
    if isinstance(d.inner, Prismatic):
        pins = {d.link_j: d.outer_j, d.link_k: d.outer_k}
        pin = d.outer_j if d.kind == "RPP" else pins[d.inner.block]
        return {pin.point: d.link_j if d.kind == "RPP" else d.inner.block} if isinstance(pin, Revolute) else {}
    if isinstance(d.inner, Revolute):
        moving = [link for joint, link, parent in ((d.outer_j, d.link_j, d.parent_j), (d.outer_k, d.link_k, d.parent_k))
                  if isinstance(joint, Prismatic) and parent != FRAME]
        return {d.inner.point: moving[0]} if moving else {}
    return {}
