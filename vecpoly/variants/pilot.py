"""A pilot before the class: what is graded, what is demoted, what can be told apart, how many draws pass."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import islice
from math import inf, prod
from typing import Self

import numpy as np
from numpy.typing import NDArray

from ..board.otherwise.slip import Slip
from ..foundation.slotted import replace
from ..grading.key import AnswerKey
from ..problem.problem import Problem
from ..solution import scales_of
from .apart import compared
from .conditions import Condition
from .draw import ATTEMPTS, Trial, draws_once, tried, variants
from .frames import scaled
from .judge import Standard, deviation, failing, long_enough, signs, told_apart, verdict, visible
from .keyed import key_for
from .look import Look, least_meeting, sketch_of, work
from .room import room
from .seeds import Seed
from .too_few import LEAST, nothing_left, too_few

SETS = 12  # of values that are tried
MORE = 48  # and more of them, until so many good ones are known that they tell how far students are apart
KNOWN = 6
MOST = 0.5  # a quantity that fails in more of the drawings than this is demoted
SHARES = (MOST, 0.2, 0.0)  # a slip that fails in more than this is let off, the next where too few draws pass else
ENOUGH = 0.1  # of the draws


@dataclass(frozen=True, slots=True, kw_only=True)
class Pilot:
    """The standard of a problem's variants; how many of the draws pass it, and how many fail on what (of one draw).

    room: how many students can be told apart, about. shown: the slips that some answer shows.
    """

    standard: Standard
    passed: float
    failed: Mapping[Condition, float]
    asked: tuple[str, ...]
    slips: int
    room: float = inf
    shown: frozenset[Slip] = frozenset()


def pilot(problem: Problem) -> Pilot:
    """Draw some variants that nobody gets, the same for every class: what is demoted depends on the file alone.

    Raises VecpolyError where too few draws pass, with what fails most and what to relax.
    """
    problem = replace(problem, printed=(), tables=())
    seed = Seed(assignment="pilot", problem=problem.id, student="")
    first, draws = _standard(problem), draws_once()
    trials = [_whole(tried(problem, seed, attempt, first, frozenset(), draws=draws)) for attempt in range(SETS)]
    looks = [look for trial in trials for _, look in trial.drawn if isinstance(look, Look)]
    asked = tuple(dict.fromkeys(ask.rel.key for ask in problem.asks))
    demoted = _with_demoted(first, looks, asked)
    counted = _Shown.of(looks)
    for most in SHARES:
        standard = replace(demoted, hidden=counted.hidden(most), twins=counted.twins(most))
        passed, failed = _weighed(trials, standard)
        if passed >= ENOUGH or not failed.get(Condition.SLIPS):
            break
    if looks and standard.demoted >= {one.key for look in looks for one in look.asked}:
        raise nothing_left(problem, looks)
    if passed < LEAST:
        raise too_few(problem.id, passed, failed)
    slips = max((len(look.slips) for look in looks), default=0)
    good = [key_for(look.key, standard) for look in looks if failing(look, standard) is None]
    found = _room(problem, seed, standard, good, passed) if problem.gate.apart else inf
    shown = frozenset(counted.slips) - standard.hidden
    return Pilot(standard=standard, passed=passed, failed=failed, asked=asked, slips=slips, room=found, shown=shown)


def _room(problem: Problem, seed: Seed, standard: Standard, good: Sequence[AnswerKey], passed: float) -> float:
    """How many students can be told apart: where few of the draws pass, by some more of them; never more than there are
    sets of values that pass."""
    others = variants(problem, seed, standard, start=SETS, attempts=MORE)
    some = islice((key_for(one.key, standard) for one in others), max(0, KNOWN - len(good)))
    keys = [*good, *some]
    found = room(keys, problem.gate.apart, ATTEMPTS)
    if any(map(compared, keys)):
        found = min(found, passed * prod(one.count for one in problem.ranges))
    return found


def _whole(trial: Trial) -> Trial:
    """With all that is to be drawn, drawn."""
    return replace(trial, drawn=tuple(trial.drawn))


def _standard(problem: Problem) -> Standard:
    """The problem as it stands: its work, and the senses of its answers. Vectors are looked at later, one by one."""
    sketch = sketch_of(problem)
    look = Look(scaled(problem, sketch) or problem, sketch)
    return Standard(
        work=work(sketch.acts),
        meeting=problem.gate.meeting(least_meeting(sketch.acts)),
        signs=signs(look),
        scales=scales_of(sketch),
        demoted=frozenset(one.key for one in look.key.quantities),
    )


def _with_demoted(standard: Standard, looks: Sequence[Look], asked: Sequence[str]) -> Standard:
    """What is too short, or scatters too much, in most drawings."""
    demoted = {key for key in asked if looks and sum(_good(look, key) for look in looks) < (1 - MOST) * len(looks)}
    return replace(standard, demoted=frozenset(demoted))


def _good(look: Look, key: str) -> bool:
    one = look.key.find(key)
    return one is None or (long_enough(one, look) and deviation(one) <= look.problem.gate.deviation)


@dataclass(frozen=True, slots=True)
class _Shown:
    """In how many drawings two slips can be made (on the diagonal: one), and do not show, or show alike."""

    slips: tuple[Slip, ...]
    made: NDArray[np.intp]
    alike: NDArray[np.intp]

    @classmethod
    def of(cls, looks: Sequence[Look]) -> Self:
        """Counted in these drawings."""
        number = {slip: n for n, slip in enumerate(dict.fromkeys(slip for look in looks for slip in look.slips))}
        made, alike = (np.zeros((len(number), len(number)), dtype=np.intp) for _ in range(2))
        for look in looks:
            some = np.array([number[slip] for slip in look.slips], dtype=np.intp)
            there, apart = np.ix_(some, some), told_apart(look.places)
            np.fill_diagonal(apart, visible(look.places))
            made[there] += 1
            alike[there] += apart <= look.problem.gate.slips
        return cls(tuple(number), made, alike)

    def hidden(self, most: float) -> frozenset[Slip]:
        """Those that do not show in more than this share of the drawings in which they can be made: they are let
        off."""
        return frozenset(slip for n, slip in enumerate(self.slips) if self.alike[n, n] > most * self.made[n, n])

    def twins(self, most: float) -> frozenset[frozenset[Slip]]:
        """Pairs that show alike in more of them."""
        pairs = np.argwhere(np.triu(self.alike > most * self.made, 1))
        return frozenset(frozenset((self.slips[i], self.slips[j])) for i, j in pairs.tolist())


def _weighed(trials: Sequence[Trial], standard: Standard) -> tuple[float, dict[Condition, float]]:
    """The share of draws that pass, and that fail on each condition: of places of the drive that passed the oracle, as
    those that were drawn."""
    passed, total, failed = 0.0, 0.0, defaultdict[Condition, float](float)
    for trial in trials:
        left = float(len(trial.swept.passed))
        total += left + sum(trial.swept.failed.values())
        for condition, count in trial.swept.failed.items():
            failed[condition] += count
        drawn = tuple(trial.drawn)
        weight = left / len(drawn) if drawn else 0.0
        for _, look in drawn:
            why = verdict(look, standard)
            if why is None:
                passed += weight
            else:
                failed[why] += weight
    shares = {condition: count / total for condition, count in failed.items() if count} if total else {}
    return passed / total if total else 0.0, shares
