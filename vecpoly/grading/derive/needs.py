"""What a graded quantity rests on directly: the nearest graded quantities below it, by the acts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...board.acts import Act
from ...board.chain import needed
from ...foundation.slotted import replace
from ..key import Graded, Kind
from .blocks import DIAGRAM


def needs(acts: Sequence[Act], act: Act, known: Mapping[int, str], key: str) -> tuple[str, ...]:
    """The keys of the graded acts that this one was found from; of those that only the figure leads to, the last ones.

    known: number of a graded act → its key; key: of this one, which may have been computed before it was written down.
    What stands in its own formula is a need even where another need rests on it too: l of ω²l.
    """
    computed = [n for n in needed(acts, (act.number,)) if known.get(n) == key == acts[n].key]
    found = acts[min(computed, default=act.number)]
    nearest = _nearest(acts, found, {number: name for number, name in known.items() if name != key})
    below = {lower for number in nearest for lower in needed(acts, (number,)) if lower != number}
    kept = (number for number in sorted(nearest) if number not in below or number in found.inputs)
    return tuple(dict.fromkeys(known[number] for number in kept))


def _nearest(acts: Sequence[Act], act: Act, known: Mapping[int, str]) -> set[int]:
    found, seen, todo = set[int](), set[int](), list(act.inputs)
    while todo:
        number = todo.pop()
        if number in seen:
            continue
        seen.add(number)
        if number in known:
            found.add(number)
        else:
            todo += acts[number].inputs
    return found


def with_lines(graded: Sequence[Graded]) -> list[Graded]:
    """Each value with the one reading that it is computed from;
    a reading of which a length (m) is computed has the diagram's scale.
    """
    read = {one.key for one in graded if one.kind is Kind.READING}
    metres = {one.needs[0] for one in graded if one.unit == "m" and len(one.needs) == 1}
    return [_of_diagram(one) if one.key in read & metres else replace(one, line=_line(one, read)) for one in graded]


def _line(one: Graded, read: set[str]) -> str:
    below = [key for key in one.needs if key in read]
    return below[0] if one.kind is not Kind.READING and len(below) == len(one.needs) == 1 else ""


def _of_diagram(one: Graded) -> Graded:
    return replace(one, mu="mu_l", block=DIAGRAM)
