"""The outcome of each answer, by the exact values and by the student's own."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from ...answer import bearing
from ...foundation.slotted import replace
from ...problem.problem import Problem
from ..compare.band import Target, target_of, weigh
from ..compare.measured import Measured, UnitFault, measured
from ..compare.of_length import contradicted
from ..compare.outcome import Basis, Outcome
from ..compare.own import Followed, Follower
from ..key import AnswerKey, Graded, Kind
from ..reading.written import State, Written
from ..rules import Rules
from ..sheet import Sheet

ROUNDS = 3  # in which far values are gone on from
_UNREAD = {
    State.BLANK: Outcome.BLANK,
    State.NONE: Outcome.NONE,
    State.UNREADABLE: Outcome.UNREADABLE,
    State.AMBIGUOUS: Outcome.AMBIGUOUS,
    State.READ: Outcome.UNREADABLE,  # a yes where a number is asked
}


@dataclass(slots=True, kw_only=True)
class Verdicts:
    """What is known of a sheet while it is marked. given: what can be compared; exact: outcome by the exact values.

    outcome, basis: the better of both; followed: what follows from own values, of what is not simply right.
    contradicted: what follows from the own length beside a value that does not agree with it, though T is as wide.
    """

    key: AnswerKey
    sheet: Sheet
    follower: Follower
    given: dict[str, Measured]
    exact: dict[str, Outcome]
    outcome: dict[str, Outcome]
    followed: Mapping[str, Followed]
    contradicted: Mapping[str, Target]
    basis: dict[str, Basis] = field(default_factory=dict)

    def roots(self) -> list[Graded]:
        """What is wrong and does not follow from anything else that is, in the order of the construction."""
        wrong = (Outcome.WRONG, Outcome.SENSE, Outcome.DIRECTION)
        return [
            one
            for one in self.key.quantities
            if self.outcome.get(one.key) in wrong and one.key not in self.contradicted
        ]


def verdicts(problem: Problem, key: AnswerKey, sheet: Sheet, rules: Rules) -> Verdicts:
    """Weigh every answer; what is not right by the exact value is held against what follows from own values."""
    given = {name: it for name, text in sheet.answers.items() if (it := _measured(text, key, name)) is not None}
    exact = {name: _UNREAD[text.state] for name, text in sheet.answers.items() if name not in given}
    for name, mine in given.items():
        exact[name] = weigh(mine, key[name], target_of(key[name]), key.allowance)
    follower = Follower(problem=problem, key=key, given=given, rules=rules)
    against = contradicted(key, given, exact, follower)
    exact |= dict.fromkeys(against, Outcome.WRONG)
    doubtful = [one for one in key.quantities if one.key in given and exact[one.key] is not Outcome.RIGHT]
    found = Verdicts(
        key=key, sheet=sheet, follower=follower, given=given, exact=exact, outcome=dict(exact),
        followed=follower.follow(doubtful), contradicted=against,
    )  # fmt: skip
    for one in doubtful:
        _better(found, one)
    return _trusting(found)


def _trusting(found: Verdicts) -> Verdicts:
    """Go on from own values that are right by own values, though far from the exact ones, until nothing more is
    right."""
    for _ in range(ROUNDS):
        trusted = frozenset(name for name, basis in found.basis.items() if basis is Basis.OWN)
        waiting = [one for one in found.roots() if found.follower.refused(one)]
        if not waiting or trusted <= found.follower.trusted:
            break
        found.follower = replace(found.follower, trusted=trusted)
        found.followed = {**found.followed, **found.follower.follow(waiting)}
        for one in waiting:
            _better(found, one)
    return found


def _measured(text: Written, key: AnswerKey, name: str) -> Measured | None:
    return measured(text, key[name], key.scales.get(key[name].mu))


def _as_drawn(found: Verdicts, one: Graded, mine: Measured) -> bool:
    """Whether what is not right is what stands on the own drawing, as anybody reads it off."""
    on_it = found.sheet.drawn.get(one.key)
    if on_it is None or found.exact[one.key].is_right:
        return False
    mu, read = found.key.scales.get(one.mu, 1.0), found.key.allowance.reading
    size = abs(on_it) / (mu if one.kind is Kind.READING else 1.0)
    room = read * (1.0 if one.kind is Kind.READING else mu)
    direction = bearing(on_it) if one.kind is Kind.VECTOR else None
    target = Target(value=size, allowed=room, degrees=direction, mm=abs(on_it) / mu)
    return weigh(mine, one, target, found.key.allowance) is Outcome.RIGHT


def _better(found: Verdicts, one: Graded) -> None:
    """By own values, where that is better; what has another dimension is not right by any."""
    followed, mine = found.followed.get(one.key), found.given[one.key]
    if mine.fault is not UnitFault.DIMENSION and _as_drawn(found, one, mine):
        found.outcome[one.key], found.basis[one.key] = Outcome.RIGHT, Basis.DRAWN
        return
    if followed is None or followed.target is None or mine.fault is UnitFault.DIMENSION:
        return
    was = found.exact[one.key]
    weighed = [weigh(mine, one, target, found.key.allowance) for target in _directed(found, one, followed)]
    right = next((own for own in weighed if own is Outcome.RIGHT), next((own for own in weighed if own.is_right), None))
    if right is not None and (not was.is_right or (was is Outcome.CLOSE and right is Outcome.RIGHT)):
        found.outcome[one.key], found.basis[one.key] = right, Basis.OWN
    elif right is None and was is Outcome.WRONG and (turned := [own for own in weighed if own is not Outcome.WRONG]):
        found.outcome[one.key] = turned[0]  # its size follows, its sense or direction does not


def _directed(found: Verdicts, one: Graded, followed: Followed) -> Iterator[Target]:
    """What follows from own values. Of a size that is computed alone the direction is the right one, where nothing that
    could turn it is wrong: it was drawn before its length was read."""
    steady = all(found.exact[name].is_right for name in followed.below if name != one.line)
    for target in (followed.target, followed.deep, followed.otherwise):
        if target is not None:
            yield replace(target, degrees=one.degrees) if steady and target.degrees is None else target
