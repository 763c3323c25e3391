"""The solution of a problem drawn anew by hands that each do something otherwise: every graded quantity by each of
them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..board.acts import Act, Compute, Measure
from ..board.acts import Answer as Wrote
from ..board.amended import Amended
from ..board.hand import steady
from ..methods.drawn import Drawn
from ..problem.problem import Problem, Scales
from ..solution import constructed
from .key import AnswerKey, Graded, Kind

ByHand = Mapping[
    str, NDArray[Any]
]  # key → value by each hand (of a vector x + iy where it is known), without the nominal one


def by_hands(problem: Problem, key: AnswerKey, amended: Amended) -> ByHand:
    """Every graded quantity by each of the hands that `amended` tells of, at the scales of the key; NaN where none was
    found.

    Raises what drawing the nominal sheet raises.
    """
    many = len(amended.each) + len(amended.own)
    drawn = constructed(replace(problem, scales=Scales(dict(key.scales))), steady(many), amended)
    found: dict[str, NDArray[Any]] = {}
    for one in key.quantities:
        act = _act(drawn, one)
        if act is not None:
            found[one.key] = np.broadcast_to(_values(drawn, act), (many + 1,))[1:]
    return found


def _act(drawn: Drawn, one: Graded) -> Act | None:
    """The act that gave a quantity."""
    sort = Measure if one.kind is Kind.READING else Wrote if one.asked else Compute
    return next((act for act in drawn.construction.acts if isinstance(act, sort) and one.letters in act.names), None)


def _values(drawn: Drawn, act: Act) -> Any:
    found: Any = drawn.hands.get(act.number)
    if found is not None:
        return found
    match act:
        case Measure(mm=mm):
            return mm
        case Compute(value=value) | Wrote(value=value):
            return value
    raise AssertionError(act)
