"""Answers: what was read off a drawing beside what is exact, and what the hand may be off by."""

from __future__ import annotations

from collections.abc import Mapping
from math import inf, isinf, nan
from typing import Any

import numpy as np

from .answer import Answer
from .board.construction import LineOfAction, Reading
from .board.hand import scatter, seldom
from .board.ruler import READABLE
from .check.alarm import Weighed, alarm_at
from .check.precision import NOTHING, settled
from .check.truth import ActsAt, size_of
from .found import answered
from .methods.centres.compare import comparable
from .methods.drawn import Drawn
from .names import Key, is_place
from .task import Task

FEW, SHARE = 3.0, 0.05  # deg; of the likely size: what is less is as good as nothing
ROUNDING = 1e-9  # of the expected error: an exact value that is less is none


def answers_of(
    task: Task, drawn: Drawn, off: Mapping[str, float], size: Mapping[str, float], *, scatters: bool, judged: bool
) -> dict[str, Answer]:
    """What was read beside what is exact; `judged`: by the scatter of repeated hands too."""
    asked, answers, readings = task.asked, {}, answered(task.problem, drawn.construction, task.truth.values)
    places = {key for key, rel in asked.items() if is_place(rel)}
    read, exact, spread = comparable(readings, task.truth.values, drawn.repeats, places)
    ideal, true, _ = comparable({key: drawn.ideal[key] for key in readings}, task.truth.values, {}, places)
    for key, reading in read.items():
        reached = max(_expected(spread[key]), _rounded(drawn.ideal[key], drawn.construction.hand))
        limit = alarm_at(reached, spread[key], scatters=scatters)
        weighed = _weighed(
            reading,
            exact[key],
            ideal[key],
            true[key],
            reach=limit if judged else nan,
            expected=reached if judged else nan,
            noise=off[key],
            size=max(size[key], 0.0 if is_told(size_of(exact[key]), reached) else reached),
            own=measure_of(reading, size_of(exact[key]), reached, likely=task.truth.likely, size=size[key]),
            steady=not scatters,
        )
        line, turns = task.truth.lines.get(key), task.turns(asked[key])
        answers[key] = _answer(asked[key], reading, exact[key], reached, line, turns, weighed)
    return answers


def measure_of(reading: Reading, exact: float, expected: float, *, likely: Mapping[str, float], size: float) -> float:
    """What a value is measured by, by itself: its own size, or what can just be told from nothing where that is less.

    That is READABLE on paper, but of a length that is sought, which no position makes vanish; of an angle FEW, of what
    the data make likely a SHARE. What vanishes but for rounding is measured by the size of such quantities, and by
    nothing (infinity) where there are no others.
    """
    on_paper = abs(reading.scalar / reading.mm) * READABLE if reading.mm and reading.unit != "mm" else 0.0
    least = max(on_paper, FEW if reading.unit == "deg" else SHARE * likely.get(reading.unit, 0.0))
    if is_told(exact, expected):
        return max(abs(exact), least)
    return max(least, size) if size > abs(exact) else least or inf


def is_told(exact: float, expected: float) -> bool:
    """Whether an exact value is more than rounding beside what a hand may be off by."""
    return abs(exact) > ROUNDING * expected or isinf(expected)


def _expected(scalars: Any) -> float:
    """3σ of the repeated hands; of none 0."""
    repeated = np.asarray(scalars)
    found = repeated[1:] if repeated.ndim else repeated[None]  # all hands find the same
    found = found[np.isfinite(found)]
    return 3.0 * scatter(found) if found.size else inf  # no repeated hand closes the polygon: nothing can be promised


def _rounded(ideal: Reading, hand: str) -> float:
    """3σ of the rounding alone, where the repeated hands may all have read the same line of the rule."""
    return 3.0 * seldom(hand, ideal.mm) * abs(ideal.scalar / ideal.mm) if ideal.mm else 0.0


def vanishes(weighed: Weighed) -> bool:
    """Whether a value is 0 but for the rounding of numbers, by the oracle and by the drawing: it is told as 0."""
    none = settled(weighed.exact, weighed.noise, weighed.size) == 0
    return none and abs(weighed.drawn) <= NOTHING * weighed.size


def _answer(
    rel: Key, reading: Reading, exact: complex | float, error: float, line: ActsAt | None, turns: bool, weighed: Weighed
) -> Answer:
    kept = 0.0 if vanishes(weighed) else 1.0
    return Answer(
        rel=rel,
        reading=reading,
        drawn=kept and reading.scalar,
        exact=kept and size_of(exact),
        expected_error=error if error > NOTHING * weighed.size else kept and error,
        drawn_vector=reading.vector and kept * reading.vector,
        exact_vector=kept * exact if isinstance(exact, complex) else None,
        exact_acts=None if line is None else LineOfAction(point=line.point, tangent=line.tangent, couple=line.couple),
        turns=turns,
        weighed=weighed,
    )


def _weighed(
    reading: Reading,
    exact: complex | float,
    ideal: Reading,
    true: complex | float,
    *,
    reach: float,
    expected: float,
    noise: float,
    size: float,
    own: float,
    steady: bool,
) -> Weighed:
    as_vector = ideal.vector is not None and isinstance(true, complex)
    return Weighed(
        drawn=reading.scalar,
        exact=size_of(exact),
        ideal=ideal.vector if as_vector and ideal.vector is not None else ideal.scalar,
        true=true if as_vector else size_of(true),
        reach=reach,
        expected=expected,
        noise=noise,
        size=size,
        own=own,
        steady=steady,
    )
