"""One mistake behind many values: the solution of one who makes it, held against all that was written."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from math import inf, log, pi, sqrt

from ...foundation.slotted import replace
from ..allowance import Allowance
from ..compare.band import Target, distance, target_of, weigh
from ..compare.measured import Measured
from ..compare.outcome import Outcome
from ..key import AnswerKey, Graded, Kind
from .mutants import Mutant, Value, alike

LONE = 0.7  # of T: as near must a value be that alone bears a mistake out
BORNE_OUT = 2  # values, at least, that bear out one of several mistakes that give the same
MARGIN = 6.0  # by how much the sum of squares of the next best mistake must be larger
NO_MISTAKE = 3.0  # and of the sheet without any, whose wrong values are wrong by themselves
ANYWHERE = 8 / 3  # of the larger value: where one that is wrong by itself may lie, from a third to three times
CARELESS = 2.0  # times T: of whoever draws without care
ASTRAY = 6.0  # of a sense or direction that is wrong by itself: one of twenty is
AS_IT_SHOULD_BE = (Outcome.RIGHT, Outcome.CLOSE, Outcome.UNSAID)


@dataclass(frozen=True, slots=True, kw_only=True)
class Explained:
    """The mistake that alone explains what was written; None where several do, or none: `several` tells which."""

    mutant: Mutant | None
    several: bool = False


def explain(
    key: AnswerKey, given: Mapping[str, Measured], pool: Collection[str], mutants: Sequence[Mutant]
) -> Explained:
    """The one mistake whose solution agrees with all of these values.

    Each value must lie within what is not yet wrong of the mistake's; the sum of squares must be smaller by MARGIN than
    that of any other mistake that agrees, and by NO_MISTAKE than that of no mistake at all.
    """
    rule, written = key.allowance, [_held(key[name], given[name], key.allowance) for name in pool]
    wrong = [one for one in written if one.plain is None]
    could = (one for one in mutants if all(each.may_be_of(one) for each in wrong))
    scored = ((_score(written, one, rule), one) for one in could)
    fitting = [(score, one) for score, one in scored if score is not None and _borne_out(written, one, rule)]
    if not fitting:
        return Explained(mutant=None)
    fitting.sort(key=lambda each: each[0])
    if len(fitting) > 1 and fitting[1][0] - fitting[0][0] < MARGIN:
        near = [one for score, one in fitting if score - fitting[0][0] < MARGIN]
        return _either(key, {one.key: one.mine.direction is not None for one in written}, near)
    return Explained(mutant=fitting[0][1])


@dataclass(frozen=True, slots=True, kw_only=True)
class _Held:
    """A value held against the right one: plain: its square over σ, None where it is not right; by_itself: -2 ln of the
    density of a value that no mistake moved."""

    one: Graded
    mine: Measured
    plain: float | None
    by_itself: float

    @property
    def key(self) -> str:
        return self.one.key

    def may_be_of(self, mutant: Mutant) -> bool:
        """Whether the mistake moves it, or leads to a figure in which anything may be found for it."""
        return self.key in mutant.values or self.key in mutant.lost or self.left_out(mutant)

    def left_out(self, mutant: Mutant) -> bool:
        """Whether it is 0 because the mistake is to leave it out."""
        return not self.mine.value and mutant.leaves_out(self.key)


def _held(one: Graded, mine: Measured, rule: Allowance) -> _Held:
    target = target_of(one)
    outcome = weigh(mine, one, target, rule)
    off = distance(mine, one, target) / target.allowed if target.allowed and mine.yes is None else 0.0
    plain = (rule.k * off) ** 2 if outcome in AS_IT_SHOULD_BE else None
    return _Held(one=one, mine=mine, plain=plain, by_itself=_by_itself(one, mine, outcome, rule))


def _score(written: Sequence[_Held], mutant: Mutant, rule: Allowance) -> float | None:
    """Sum of squares over σ beside that of the right values, of what scatters widely with what its density is thinned
    by; None where a value does not agree, or where nothing but a yes or a no would bear the mistake out."""
    total, moved = 0.0, [one for one in written if one.key in mutant.values]
    if len(moved) == 1 and moved[0].mine.yes is not None:
        return None
    for each in moved:
        target = mutated(each.one, mutant, rule)
        if each.left_out(mutant):
            continue
        if weigh(each.mine, each.one, target, rule) not in AS_IT_SHOULD_BE:
            return None
        total -= each.plain or 0.0
        if target.allowed and each.mine.yes is None:
            off = distance(each.mine, each.one, target) / target.allowed
            if len(moved) == 1 and off > LONE:
                return None
            total += (rule.k * off) ** 2 + _thinned(each.one, mutant, target, rule)
    return total


def _borne_out(written: Sequence[_Held], mutant: Mutant, rule: Allowance) -> bool:
    """Whether what was written is likelier of one who makes the mistake than of one who has some values right, the
    others wrong by themselves: where it moves a value widely, or one that is right, little bears it out."""
    there = {one.key for one in written if one.key in mutant.values}
    read = [one for one in written if one.key in there and one.one.line not in there]  # a length bears out once
    moved = [one for one in read if one.mine.yes is None and not one.left_out(mutant)]
    if moved and not any(one.mine.value or one.mine.at for one in moved):
        return False  # a sheet of zeros is that of nobody's mistake
    by_it = sum(_surprise(one.one, one.mine, mutated(one.one, mutant, rule), rule) for one in moved)
    return by_it + NO_MISTAKE <= sum(one.by_itself for one in moved)


def _surprise(one: Graded, mine: Measured, target: Target, rule: Allowance) -> float:
    """-2 ln of the density of a value that should be this one."""
    if not target.allowed:
        return 0.0
    off, sigma = distance(mine, one, target), target.allowed / rule.k
    return (off / sigma) ** 2 + 2.0 * _ways(one) * log(sqrt(2 * pi) * sigma)


def _by_itself(one: Graded, mine: Measured, outcome: Outcome, rule: Allowance) -> float:
    """-2 ln of the density of a value that no mistake moved: right, drawn without care, or anywhere."""
    if outcome in AS_IT_SHOULD_BE:
        return _surprise(one, mine, target_of(one), rule)
    if outcome in (Outcome.SENSE, Outcome.DIRECTION):
        return _surprise(one, mine, target_of(one), rule) + ASTRAY
    widest = max(abs(mine.value), abs(one.exact), one.allowed)
    if not widest:
        return 0.0
    careless = replace(target_of(one), allowed=CARELESS * one.allowed)
    return min(2.0 * _ways(one) * log(ANYWHERE * widest), _surprise(one, mine, careless, rule) or inf)


def _ways(one: Graded) -> int:
    """In how many directions a value can be off."""
    return 2 if one.kind is Kind.PLACE else 1


def _either(key: AnswerKey, pool: Mapping[str, bool], near: Sequence[Mutant]) -> Explained:
    """Mistakes that agree as well: one, either of them, where each moves several of these values, and all move them
    alike; else several. pool: of each value whether its direction was written."""
    first, *others = near
    moved = [name for name in pool if name in first.values]
    if len(moved) < BORNE_OUT or not all(alike(key, first, one, pool) for one in others):
        return Explained(mutant=None, several=True)
    also = (slip for one in others for slip in (one.slip, *one.also))
    return Explained(mutant=replace(first, also=(*first.also, *also)))


def agrees(one: Graded, mine: Measured, mutant: Mutant, rule: Allowance) -> bool:
    """Whether a value is what follows from the mistake; of what is left out, also 0."""
    if not mine.value and mutant.leaves_out(one.key):
        return True
    return weigh(mine, one, mutated(one, mutant, rule), rule) in AS_IT_SHOULD_BE


def mutated(one: Graded, mutant: Mutant, rule: Allowance) -> Target:
    """The value by this mistake, with the T of whoever makes it: no larger than the value, or than the right one."""
    if (value := mutant.values.get(one.key)) is None:
        return target_of(one)
    scattered = min(rule.k * value.sigma, max(abs(value.value), abs(one.exact)))
    allowed = max(_stretched(one, value, rule), scattered)
    mm = one.mm * abs(value.value / one.exact) if one.mm and one.exact else None
    return Target(value=value.value, allowed=allowed, degrees=value.degrees, mm=mm, at=value.at)


def _thinned(one: Graded, mutant: Mutant, target: Target, rule: Allowance) -> float:
    """-2 ln of the density: what lies anywhere bears out less."""
    value = mutant.values.get(one.key)
    return 0.0 if value is None else 2.0 * log(target.allowed / _stretched(one, value, rule))


def _stretched(one: Graded, value: Value, rule: Allowance) -> float:
    """T as much larger as the value is, but no larger than a share of it."""
    larger = one.allowed * max(1.0, abs(value.value / one.exact)) if one.exact else one.allowed
    return max(min(larger, rule.share * abs(value.value)), one.allowed)
