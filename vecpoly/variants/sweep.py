"""Cheap questions first: the oracle over all places of the drive at once, before anything is drawn."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import oracle
from ..errors import VecpolyError
from ..mechanism.model import Mechanism
from ..names import Rel, omega
from ..problem.meaning import meant_by
from ..problem.problem import Problem
from ..problem.ranges import Range
from ..units.reading import read
from .conditions import Condition
from .frames import HEIGHT, WIDTH
from .lengths import POLYGONS, drawn_on, surely_short

Values = NDArray[Any]
PLACES = 72  # of the drive that are looked at, at most
STEPS = 5  # on the way from one end of the forbidden stretch to the other
ZERO = 1e-9  # of the largest of its kind: less has no sense
_PLACE = ("phi", "s", "length")


@dataclass(frozen=True, slots=True)
class Swept:
    """The values of the drive's range that pass, by number, and how many of the others failed on which condition; the
    answers there. short: those of which it is sure that they fail on a short vector when they are drawn."""

    passed: tuple[int, ...]
    failed: Counter[Condition]
    told: Mapping[int, Mapping[str, float]]
    short: frozenset[int] = frozenset()

    def answers(self, number: int) -> Mapping[str, float]:
        """What is asked, as far as the oracle told it: sizes of vectors, signed values of the rest (SI)."""
        return self.told.get(number, {})


def drive_range(problem: Problem) -> Range | None:
    """The range over which the drive's place varies; None where it stands still."""
    if not isinstance(problem.subject, Mechanism) or problem.written is None or len(problem.mechanism.drives) != 1:
        return None
    for one in problem.ranges:
        slot = meant_by(one.name, problem.written.tree().data)[0]
        if slot.path[0] == "input" and slot.path[-1] in _PLACE:
            return one
    return None


def sweep(problem: Problem, along: Range | None, signs: Mapping[str, float], graded: Collection[str]) -> Swept:
    """Which places of the drive, of this range or the problem's own, may be worth drawing; problem: at the range's
    first."""
    mech, numbers = problem.mechanism, range(1) if along is None else _numbers(along)
    q = mech.drive.position + _travels(problem, along, numbers)
    near = np.linspace(-1.0, 1.0, STEPS) * (0.0 if mech.drive.slide or mech.drive.between else problem.gate.dead_point)
    motion = oracle.solve(mech, (q[:, None] + near[None, :]).ravel(), strict=False)
    whole = np.ones((len(q), STEPS), bool)
    for link in mech.numbered:
        whole &= np.isfinite(_table(motion.value(omega(link)), len(q)))
    asked = {key: values[:, STEPS // 2] for key, values in _asked(problem, motion, len(q))}
    everywhere = np.ones(len(q), bool)
    tests: list[tuple[Condition, NDArray[np.bool_]]] = [
        (Condition.ASSEMBLED, whole[:, STEPS // 2]),
        (Condition.DEAD_POINT, np.asarray(whole.all(axis=1))),
        (Condition.SENSES, everywhere & _alike(asked, signs) if problem.gate.alike else everywhere),
        (Condition.SHORT, everywhere & _even(problem, asked, graded)),
    ]
    return _judged(numbers, tests, asked, surely_short(problem, asked, graded))


def _asked(problem: Problem, motion: oracle.Motion, count: int) -> Iterator[tuple[str, Values]]:
    """What is asked and the oracle tells at once: no places that the question itself defines, no forces."""
    for ask in problem.asks:
        if isinstance(ask.rel, Rel):
            with suppress(VecpolyError):
                yield ask.rel.key, _table(motion.value(ask.rel), count)


def _table(values: Values, count: int) -> Values:
    """A row for every place of the drive, a column for every step round it."""
    return np.broadcast_to(values, (count * STEPS,)).reshape(count, STEPS)


def _judged(
    numbers: Sequence[int],
    tests: Iterable[tuple[Condition, NDArray[np.bool_]]],
    asked: Mapping[str, Values],
    short: NDArray[np.bool_],
) -> Swept:
    left, failed = np.ones(len(numbers), bool), Counter[Condition]()
    for condition, good in tests:
        failed[condition] += int((left & ~good).sum())
        left &= good
    sizes = {key: np.abs(values) if np.iscomplexobj(values) else values for key, values in asked.items()}
    told = {numbers[int(i)]: {key: float(values[i]) for key, values in sizes.items()} for i in np.flatnonzero(left)}
    return Swept(tuple(told), failed, told, frozenset(numbers[int(i)] for i in np.flatnonzero(short)))


def _numbers(along: Range) -> range:
    """The numbers on the grid that are looked at: all, or every so manieth."""
    return range(0, along.count, max(1, along.count // PLACES))


def _travels(problem: Problem, along: Range | None, numbers: Sequence[int]) -> Values:
    """How far the drive is (rad or m) from the range's first value."""
    if along is None or problem.written is None:
        return np.zeros(1)
    dim = meant_by(along.name, problem.written.tree().data)[0].dim
    assert dim is not None
    return np.array([read(along.at(number), dim).si for number in numbers]) - read(along.at(0), dim).si


def _alike(asked: Mapping[str, Values], signs: Mapping[str, float]) -> NDArray[np.bool_]:
    """Where every asked ω and α has the sense that it has in the problem itself."""
    good = np.ones(1, bool)
    for key, values in asked.items():
        if key in signs:
            size = np.nanmax(np.abs(values), initial=0.0) or 1.0
            good = good & (np.where(np.abs(values) < ZERO * size, 0.0, np.sign(values.real)) == signs[key])
    return good


def _even(problem: Problem, asked: Mapping[str, Values], graded: Collection[str]) -> NDArray[np.bool_]:
    """Where the shortest graded vector is not too short even where the longest fills the frame."""
    good = np.ones(1, bool)
    for view in POLYGONS:
        sizes = drawn_on(problem, view, asked)
        shown = [size for key, size in sizes.items() if key in graded]
        if shown:
            longest = np.max(list(sizes.values()), axis=0)
            good = good & (np.min(shown, axis=0) * max(WIDTH, HEIGHT) >= problem.gate.vectors * longest)
    return good
