"""One mistake behind many values: the solution of one who makes it, held against all that was written."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from math import log

from ..allowance import Allowance
from ..compare.band import Target, distance, target_of, weigh
from ..compare.measured import Measured
from ..compare.outcome import Outcome
from ..key import AnswerKey, Graded
from .mutants import Mutant, Value, alike

LONE = 0.7  # of T: as near must a value be that alone bears a mistake out
BORNE_OUT = 2  # values, at least, that bear out one of several mistakes that give the same
MARGIN = 6.0  # by how much the sum of squares of the next best mistake must be larger


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
    that of any other mistake that agrees.
    """
    fitting = [(score, one) for one in mutants if (score := _score(key, given, pool, one)) is not None]
    if not fitting:
        return Explained(mutant=None)
    fitting.sort(key=lambda each: each[0])
    if len(fitting) > 1 and fitting[1][0] - fitting[0][0] < MARGIN:
        return _either(key, pool, [one for score, one in fitting if score - fitting[0][0] < MARGIN])
    return Explained(mutant=fitting[0][1])


def _either(key: AnswerKey, pool: Collection[str], near: Sequence[Mutant]) -> Explained:
    """Mistakes that agree as well: one, either of them, where each moves several of these values, and all move them
    alike; else several."""
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
    return weigh(mine, one, mutated(one, mutant, rule), rule) in (Outcome.RIGHT, Outcome.CLOSE, Outcome.UNSAID)


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


def _score(key: AnswerKey, given: Mapping[str, Measured], pool: Collection[str], mutant: Mutant) -> float | None:
    """Sum of squares over σ, of what scatters widely with what its density is thinned by; None where a value does not
    agree, or where nothing but a yes or a no would bear the mistake out."""
    total, moved = 0.0, [name for name in pool if name in mutant.values]
    if len(moved) == 1 and given[moved[0]].yes is not None:
        return None
    for name in pool:
        one, mine = key[name], given[name]
        if not agrees(one, mine, mutant, key.allowance):
            return None
        target = mutated(one, mutant, key.allowance)
        if target.allowed and mine.yes is None and not (not mine.value and mutant.leaves_out(name)):
            off = distance(mine, one, target) / target.allowed
            if moved == [name] and off > LONE:
                return None
            total += (key.allowance.k * off) ** 2 + _thinned(one, mutant, target, key.allowance)
    return total
