"""The solution of a problem drawn anew by hands that each do something otherwise: every graded quantity by each of
them.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..board.acts import Act, Area, Compute, Measure
from ..board.acts import Answer as Wrote
from ..board.hand import Hand, steady
from ..board.otherwise.amended import AS_DRAWN, Amended
from ..drawing.sheets.paper import DrawingPaper
from ..foundation.slotted import replace
from ..mechanism.model import Mechanism
from ..methods.drawn import Drawn
from ..methods.plan import drawn_otherwise
from ..problem.problem import Problem
from ..solution import constructed
from .key import AnswerKey, Graded, Kind

ByHand = Mapping[
    str, NDArray[Any]
]  # key → value by each hand (of a vector x + iy where it is known), without the nominal one


def by_hands(
    problem: Problem, key: AnswerKey, amended: Amended, *, unsteady: bool = False, nominal: bool = False
) -> ByHand:
    """Every graded quantity by each of the hands that `amended` tells of, at the scales of the key; NaN where none was
    found.

    unsteady: they scatter as students' hands do; else they are exact. nominal: before them by the exact hand of the
    sheet itself. Raises what drawing the nominal sheet raises.
    """
    many = len(amended.each) + len(amended.own)
    by = key.allowance.hand(many) if unsteady else steady(many)
    drawn = drawn_by(as_keyed(problem, key), by, amended)
    found: dict[str, NDArray[Any]] = {}
    for one in key.quantities:
        act = act_of(drawn, one)
        if act is not None:
            found[one.key] = np.broadcast_to(values_of(drawn, act), (many + 1,))[0 if nominal else 1 :]
    return found


def as_keyed(problem: Problem, key: AnswerKey) -> Problem:
    """The problem, to be drawn on the sheet of its key: at its scales, which a second figure shares where it did."""
    return replace(problem, scales=problem.scales.kept(key.scales))


def drawn_by(problem: Problem, by: Hand, amended: Amended = AS_DRAWN) -> Drawn:
    """The construction by these hands, for what each of them found; a linkage's without an ideal hand's beside it."""
    if isinstance(problem.subject, Mechanism):
        return drawn_otherwise(problem, by, amended, DrawingPaper(problem.paper))
    return constructed(problem, by, amended)


def act_of(drawn: Drawn, one: Graded) -> Act | None:
    """The act that gave a quantity."""
    sorts = (Measure,) if one.kind is Kind.READING else (Wrote,) if one.asked else (Compute, Area, Wrote)
    named = [act for act in drawn.construction.acts if isinstance(act, sorts) and one.letters in act.names]
    return min(named, key=lambda act: (isinstance(act, Wrote), act.number), default=None)


def values_of(drawn: Drawn, act: Act) -> Any:
    found: Any = drawn.hands.get(act.number)
    if found is not None:
        return found
    match act:
        case Measure(mm=mm):
            return mm
        case Area(mm2=mm2):
            return mm2
        case Compute(value=value) | Wrote(value=value):
            return value
    raise AssertionError(act)
