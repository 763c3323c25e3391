"""What rests on what: queries on the acts of a sheet."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from ..errors import UnknownNameError
from ..words import Words
from .acts import Act


def numbers(acts: Sequence[Act], key: str) -> frozenset[int]:
    """The acts that stand for this key, alone (``bc``) or with its figure (``velocity:bc``);
    raises UnknownNameError where there is none."""
    found = frozenset(act.number for act in acts if key in act.names)
    if not found:
        raise UnknownNameError(Words(f"图上没有 {key}", f"there is no {key} on the sheet"), code="unknown-act")
    return found


def needed(acts: Sequence[Act], of: Collection[int]) -> frozenset[int]:
    """These acts, and all acts that they needed; what was drawn by none (-1) needs none."""
    found, todo = set(of), [number for number in of if number >= 0]
    while todo:
        below = [one for one in acts[todo.pop()].inputs if one not in found]
        found.update(below)
        todo += below
    return frozenset(found)


def following(acts: Sequence[Act], of: Collection[int]) -> frozenset[int]:
    """These acts, and all acts that needed them."""
    found = set(of)
    for act in acts:
        if not found.isdisjoint(act.inputs):
            found.add(act.number)
    return frozenset(found)


def keys_of(acts: Sequence[Act], which: Collection[int], but: str) -> tuple[str, ...]:
    """The keys of these acts, each once, in order, without this one."""
    return tuple(
        key
        for key in dict.fromkeys(act.key for act in acts if act.number in which and act.key)
        if key != but.rpartition(":")[2]
    )
