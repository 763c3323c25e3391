"""The gate: which condition a drawing fails first, if any."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from math import inf

import numpy as np
from numpy.typing import NDArray

from ..board.otherwise.slip import Slip
from ..errors import VecpolyError
from ..grading.key import Graded, Kind
from ..problem.problem import Problem, Scales
from .conditions import Condition
from .frames import scaled
from .look import Look, least_meeting, sizes_mm, sketch_of, work

ZERO = 1e-9
Table = NDArray[np.float64]
Places = NDArray[np.complex128]


@dataclass(frozen=True, slots=True, kw_only=True)
class Standard:
    """What all variants of a problem are held to.

    work: the acts of the problem as it stands; meeting: the least angle (rad) at which lines may meet; signs: the
    senses of its answers; scales: those it was drawn at. demoted: what is asked and too badly conditioned in most
    variants, graded by follow-through only. hidden, twins: slips, and pairs of slips, that do not show in most
    variants, and so are asked of none.
    """

    work: tuple[tuple[str, str], ...]
    meeting: float
    signs: Mapping[str, float]
    scales: Scales = field(default_factory=Scales)
    demoted: frozenset[str] = frozenset()
    hidden: frozenset[Slip] = frozenset()
    twins: frozenset[frozenset[Slip]] = field(default_factory=frozenset)

    def graded(self, problem: Problem) -> frozenset[str]:
        """What is asked of the problem and not demoted."""
        return frozenset(ask.rel.key for ask in problem.asks) - self.demoted


def looked_at(problem: Problem, standard: Standard, *, good: bool = False) -> Look | Condition:
    """The drawing at round scales that fit the frames, or what it fails on before it is weighed. good: only one that
    passes is of interest; of another that would be weighed it may be told what it fails on."""
    try:
        sketch = sketch_of(problem, standard.scales)
        if problem.gate.alike and work(sketch.acts) != standard.work:
            return Condition.ACTS
        framed = scaled(problem, sketch)
        if framed is None:
            return Condition.FRAME
        if least_meeting(sketch.acts) < standard.meeting:
            return Condition.MEETINGS
        lengths = sizes_mm(framed, sketch)
        if any(mm < problem.gate.vectors for key, mm in lengths.items() if key not in standard.demoted and mm > ZERO):
            return Condition.VECTORS
        look = Look(framed, sketch)
        if good and not slips_show(look, standard, look.finest):
            return Condition.SLIPS
        _ = look.key
        return look
    except VecpolyError:
        return Condition.REFUSED


def failing(look: Look, standard: Standard) -> Condition | None:
    """What a drawing fails on; None: it is good."""
    tests: tuple[tuple[Condition, Callable[[], bool]], ...] = (
        (Condition.SENSES, lambda: not look.problem.gate.alike or signs(look) == standard.signs),
        (Condition.VECTORS, lambda: all(long_enough(one, look) for one in _kept(look, standard))),
        (
            Condition.DEVIATION,
            lambda: all(deviation(one) <= look.problem.gate.deviation for one in _kept(look, standard)),
        ),
        (Condition.SLIPS, lambda: slips_show(look, standard, look.places)),
    )
    return next((condition for condition, holds in tests if not holds()), None)


def verdict(look: Look | Condition, standard: Standard) -> Condition | None:
    """What a draw fails on, before or after it is weighed; None: it is good."""
    return failing(look, standard) if isinstance(look, Look) else look


def signs(look: Look) -> dict[str, float]:
    """+1, −1 or 0 for every asked quantity that has a sense."""
    signed = [one for one in look.asked if one.kind not in (Kind.VECTOR, Kind.PLACE, Kind.LINE)]
    largest: dict[str, float] = {}
    for one in signed:
        largest[one.unit] = max(abs(one.exact), largest.get(one.unit, 0.0))
    return {one.key: 0.0 if abs(one.exact) <= ZERO * largest[one.unit] else float(np.sign(one.exact)) for one in signed}


def long_enough(one: Graded, look: Look) -> bool:
    """Whether a vector can be measured; one that vanishes has nothing to be measured."""
    return one.mm is None or one.kind is not Kind.VECTOR or one.mm <= ZERO or one.mm >= look.problem.gate.vectors


def deviation(one: Graded) -> float:
    """2σ over the size; a place has none."""
    none = not one.sigma or abs(one.exact) <= ZERO or one.kind is Kind.PLACE
    return 0.0 if none else 2.0 * one.sigma / abs(one.exact)


def _kept(look: Look, standard: Standard) -> list[Graded]:
    return [one for one in look.asked if one.key not in standard.demoted]


def slips_show(look: Look, standard: Standard, places: Places) -> bool:
    """Whether every slip that can show does, and no two that can be told apart look the same."""
    least = look.problem.gate.slips
    if not least:
        return True
    shown, apart = visible(places), told_apart(places)
    rows = [n for n, slip in enumerate(look.slips) if slip not in standard.hidden]
    if any(shown[n] <= least for n in rows):
        return False
    return not any(
        apart[i, j] <= least and frozenset((look.slips[i], look.slips[j])) not in standard.twins
        for i in rows
        for j in rows
        if i < j
    )


def visible(places: Places) -> Table:
    """By how many tolerances each slip shows where it shows most; one that cannot close is told by the drawing."""
    with np.errstate(invalid="ignore"):
        return _most(np.abs(places[1:] - places[0]))


def told_apart(places: Places) -> Table:
    """By how many tolerances any two slips differ where they differ most."""
    rows = places[1:]
    with np.errstate(invalid="ignore"):  # what does not close differs from all
        return _most(np.abs(rows[:, None, :] - rows[None, :, :]))


def _most(shifts: Table) -> Table:
    """The largest along the last axis; infinite where one has no value."""
    most: Table = np.where(np.isfinite(shifts), shifts, inf).max(axis=-1, initial=0.0)
    return most
