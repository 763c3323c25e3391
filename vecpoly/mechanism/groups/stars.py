"""The shape of a class III group of the textbook: a central link, and three legs by which it hangs on known links."""

from __future__ import annotations

from .assur import ends
from .group import Group


def plate_of(group: Group) -> str | None:
    """The central link; None where the group is no central link on three legs of two joints each."""
    if group.kind != "class III" or len(group.links) != 4 or len(group.outer) != 3:
        return None
    inner = {name: sum(name in ends(joint) for joint in group.inner) for name in group.links}
    plates = [name for name, count in inner.items() if count == 3]
    legs = {out.link for out in group.outer}
    single = all(count == 1 for name, count in inner.items() if name not in plates)
    return plates[0] if len(plates) == 1 and single and legs == set(group.links) - set(plates) else None


def has_plate(group: Group) -> bool:
    """Whether the group is a central link on three legs: the reactions of such a one are drawn."""
    return plate_of(group) is not None
