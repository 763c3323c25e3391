"""Several solutions of a synthesis have no order: what somebody calls the first may be the second of the key."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import permutations

from ...foundation.slotted import replace
from ..compare.band import distance, target_of, weigh
from ..compare.measured import measured
from ..key import AnswerKey
from ..reading.written import State
from ..sheet import Sheet
from ..told.message import Message, message
from ..told.named import Told

_NUMBERED = re.compile(r"(.+?)(_?)(\(?)(\d+)(\)?)")  # AB_1, l_AB(1)
SAME = 1e-9  # nearer than that are two solutions that have a length in common
MOST = 5  # solutions of which every order is tried


def in_order(key: AnswerKey, sheet: Sheet) -> tuple[Sheet, tuple[Message, ...]]:
    """The sheet with its solutions in the order of the key in which most is right, and what is said where that is
    another than its own."""
    if not 1 < len(key.solutions) <= MOST:
        return sheet, ()
    best, most = sheet, _right(key, sheet)
    order: Mapping[str, str] = {}
    for numbers in permutations(key.solutions):
        meant = {str(theirs): str(ours) for theirs, ours in zip(key.solutions, numbers, strict=True)}
        other = _renumbered(key, sheet, meant)
        if (right := _right(key, other)) > most:
            best, most, order = other, right, meant
    if not order:
        return sheet, ()
    pairs = ", ".join(f"{theirs} → {ours}" for theirs, ours in order.items() if theirs != ours)
    return best, (message(Told.RENUMBERED, pairs=pairs),)


def same_of_others(key: AnswerKey, name: str) -> tuple[str, ...]:
    """The same quantity of the other solutions: of AB_2 there is AB_1, or AB where one has no number."""
    names = {one.key for one in key.quantities if one.asked}
    base = name.rpartition("_")[0] if name.rpartition("_")[2] in map(str, key.solutions) else name
    same = (base, *(f"{base}_{n}" for n in key.solutions))
    return tuple(one for one in same if one in names and one != name) if key.solutions else ()


def _renumbered(key: AnswerKey, sheet: Sheet, meant: Mapping[str, str]) -> Sheet:
    names = {one.key for one in key.quantities}
    bare = next((n for n in meant if not any(name.endswith(f"_{n}") for name in names)), "")
    answers = {}
    for name, text in sheet.answers.items():
        answers[next((other for other in _others(name, meant, bare) if other in names), name)] = text
    return replace(sheet, answers=answers) if len(answers) == len(sheet.answers) else sheet


def _others(name: str, meant: Mapping[str, str], bare: str) -> Iterator[str]:
    """The same quantity of the solution that is meant; that of the number `bare` has none: AB, AB_2."""
    found = _NUMBERED.fullmatch(name)
    if found is not None and found[4] in meant and (found[2] or found[3]):
        yield f"{found[1]}{found[2]}{found[3]}{meant[found[4]]}{found[5]}"
        if found[2] and meant[found[4]] == bare:
            yield found[1]
    elif bare:
        yield f"{name}_{meant[bare]}"


def _right(key: AnswerKey, sheet: Sheet) -> int:
    """How much is right by the exact values, and as near to them as to those of the other solutions: one that scatters
    widely may be right by two."""
    right = 0
    for name, text in sheet.answers.items():
        one = key[name]
        mine = measured(text, one, key.scales.get(one.mu)) if text.state is State.READ else None
        if mine is not None and weigh(mine, one, target_of(one), key.allowance).is_right:
            others = [key[other] for other in same_of_others(key, name)]
            off = distance(mine, one, target_of(one))
            right += all(off <= distance(mine, other, target_of(other)) + SAME for other in others)
    return right
