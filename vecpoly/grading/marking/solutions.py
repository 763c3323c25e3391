"""Another solution of a synthesis satisfies its data as well: whoever answers with that one has it marked by it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ...foundation.slotted import replace
from ...problem.problem import Problem
from ...task import task_of
from ..compare.band import target_of, weigh
from ..compare.measured import measured
from ..key import AnswerKey, Graded, Kind
from ..reading.written import State
from ..sheet import Sheet
from ..told.message import Message, message
from ..told.named import Told


def as_answered(problem: Problem, key: AnswerKey, sheet: Sheet) -> tuple[AnswerKey, tuple[Message, ...]]:
    """The key of the solution that was answered, and what is said where that is not the one of the key.

    All that was answered must be of that one solution, and something of it wrong by the key's.
    """
    if _fits(key, sheet):
        return key, ()
    for number, other in other_keys(problem, key):
        if _fits(other, sheet):
            return other, (message(Told.OTHER_SOLUTION, n=str(number)),)
    return key, ()


def other_keys(problem: Problem, key: AnswerKey) -> Iterator[tuple[int, AnswerKey]]:
    """The other solutions that serve as well, each with its number and its key; none where a certain one is asked for,
    or solutions by their numbers."""
    if key.solutions:
        return
    for number, values in task_of(problem).others.items():
        yield number, replace(key, quantities=tuple(_of(each, values, number, key) for each in key.quantities))


def _of(one: Graded, values: Mapping[str, float], number: int, key: AnswerKey) -> Graded:
    """A quantity of the other solution: what is asked by its exact value, a length by the one that was drawn for it."""
    if one.asked:
        return _valued(one, values.get(one.key, one.exact))
    drawn = _lengths(number, key).get(one.key)
    return one if drawn is None else replace(one, exact=drawn.exact, mm=drawn.mm, allowed=drawn.allowed)


def _valued(one: Graded, exact: float) -> Graded:
    """The same quantity with another value, of which a hand tells as much as of the right one."""
    times = abs(exact / one.exact) if one.exact else 1.0
    mm = one.mm * times if one.mm else one.mm
    return replace(one, exact=exact, mm=mm, allowed=one.allowed * (times if one.unit != "deg" else 1.0))


def _lengths(number: int, key: AnswerKey) -> dict[str, Graded]:
    """Length on paper of the first solution → that of this one from which the same quantity is found."""
    found: dict[str, Graded] = {}
    for one in key.quantities:
        first, other = key.find(one.key.replace(f"({number})", "(1)")), one
        if first is None or first.key == one.key:
            continue
        pairs = zip(first.needs, other.needs, strict=False)
        found |= {mine: key[theirs] for mine, theirs in pairs if key[mine].kind is key[theirs].kind is Kind.READING}
    return found


def _fits(key: AnswerKey, sheet: Sheet) -> bool:
    """Whether all that was answered is right by this key."""
    read = {name: text for name, text in sheet.answers.items() if text.state is State.READ and key.find(name)}
    for name, text in read.items():
        one = key[name]
        mine = measured(text, one, key.scales.get(one.mu))
        if mine is None or not weigh(mine, one, target_of(one), key.allowance).is_right:
            return False
    return bool(read)
