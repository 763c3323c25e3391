"""What every slip that can be made with a problem makes of every graded quantity."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np
from pydantic import TypeAdapter

from ...answer import bearing
from ...board.otherwise.amended import Amended, Own
from ...board.otherwise.slip import Mistake, Slip
from ...errors import VecpolyError
from ...mistakes import slips
from ...problem.problem import Problem
from ..key import AnswerKey, Graded, Kind
from ..redraw import ByHand, by_hands

TURNING = (Mistake.REVERSED, Mistake.DROPPED, Mistake.TURNED, Mistake.OTHER_MEETING)  # by which a motion may turn round
FAR = 1e3  # times the exact value: no paper is so large
SAME = 0.25  # of T: two values nearer than this are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Value:
    """A value as it is compared: SI (a reading in mm), of a vector its size; degrees of a vector, where known."""

    value: float
    degrees: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Mutant:
    """The solution of one who makes this slip: the quantities that come out otherwise than they should."""

    slip: Slip
    values: Mapping[str, Value] = field(default_factory=dict)


def mutants(problem: Problem, key: AnswerKey, of: Sequence[Slip] | None = None) -> tuple[Mutant, ...]:
    """Every slip that changes something and leaves a drawing.

    All in one drawing, each made by a hand of its own; but where friction follows the senses of a motion that a slip
    changes, that slip is drawn by itself.
    """
    made = tuple(slips(problem) if of is None else of)
    alone = tuple(one for one in made if problem.loads is not None and one.mistake in TURNING)
    together = tuple(one for one in made if one not in alone)
    found: dict[Slip, dict[str, Value]] = {}
    if together:
        by_all = by_hands(problem, key, Amended(each=together))
        found |= {slip: _changed(key, by_all, i) for i, slip in enumerate(together)}
    for slip in alone:
        with suppress(VecpolyError):  # nothing can be drawn by this mistake
            found[slip] = _changed(key, by_hands(problem, key, Amended(slip=slip, own=(Own(),))), 0)
    return tuple(Mutant(slip=slip, values=found[slip]) for slip in made if found.get(slip))


def _changed(key: AnswerKey, found: ByHand, hand: int) -> dict[str, Value]:
    """What comes out otherwise, without what rests on a figure that does not close."""
    values: dict[str, Value] = {}
    open_ended = set[str]()
    for one in key.quantities:
        value = _value(one, found[one.key][hand]) if one.key in found else None
        if value is None or open_ended.intersection(one.needs):
            open_ended.add(one.key)
        elif _differs(one, value):
            values[one.key] = value
    return values


def _value(one: Graded, found: Any) -> Value | None:
    """What a hand found; None where its figure does not close."""
    if not np.isfinite(found) or abs(found) > FAR * max(abs(one.exact), one.allowed):
        return None
    if np.iscomplexobj(found) and one.kind is Kind.VECTOR:
        return Value(value=float(abs(found)), degrees=bearing(complex(found)))
    return Value(value=float(abs(found)) if np.iscomplexobj(found) else float(found))


def _differs(one: Graded, value: Value) -> bool:
    if abs(value.value - one.exact) > SAME * one.allowed:
        return True
    if value.degrees is None or one.degrees is None:
        return False
    return abs((value.degrees - one.degrees + 180) % 360 - 180) > 1.0


@cache
def adapter() -> TypeAdapter[tuple[Mutant, ...]]:
    """To JSON and back, for a register."""
    return TypeAdapter(tuple[Mutant, ...])
