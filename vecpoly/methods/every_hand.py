"""One drawing by many hands at once, each of which may do one thing otherwise: what every one of them reads."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..board.board import Unwritten
from ..board.construction import Construction, Figure, Scale
from ..board.hand import Hand
from ..board.otherwise.amended import Amended
from ..board.place import View
from ..names import Key, Kind, Rel
from ..plane import Points, Reals, nominal
from ..plane.traced import bare
from ..problem.problem import Problem
from .answers import answer, named_answer
from .desk import Desk
from .draw import draw
from .plan import driven, scale_symbols
from .standing import computed, standing

FAR = 1e6  # times the nominal length


def by_every_hand(problem: Problem, by: Hand, like: Construction, amended: Amended) -> Mapping[str, Points | Reals]:
    """Asked quantity -> its value by every hand (SI; of a velocity or acceleration the vector), at the given scales, or
    else those of a drawing.

    A hand whose polygon does not close has NaN. Raises what drawing the nominal sheet raises.
    """
    scales: dict[View, Scale] = scale_symbols() | {
        figure.view: _scale(problem, figure) for figure in like.figures if not figure.aside
    }
    drawn, said = driven(problem)
    with np.errstate(all="ignore"):
        desk = draw(drawn, Unwritten(by, scales, amended), said)
        return {ask.rel.key: np.asarray(bare(_drawn(_value(desk, ask.rel)))) for ask in problem.asks}


def _scale(problem: Problem, figure: Figure) -> Scale:
    """The scale that the problem gives, or else that of the figure."""
    return Scale.of(figure.view, problem.scales.of(figure.view.mu) or figure.scale.value)


def _value(desk: Desk, key: Key) -> Points | Reals:
    if not isinstance(key, Rel) or key.key in desk.board.readings:
        return named_answer(desk, key)[1]
    if not key.is_vector:
        return answer(desk, key)[1]
    if key.kind is Kind.P:
        place: Points = desk.at[str(key.to)] if str(key.to) in desk.at else desk.at[key.to.point]
        return place * desk.board.scale_of(View.MECHANISM).value
    view, start, end, _ = standing(desk, key)
    vector, known = (end - start) * desk.board.scale_of(view).value, computed(desk, key)
    if known is None:
        return vector
    return np.where(vector == 0, 0.0, known.value * np.exp(1j * np.angle(vector)))


def _drawn(value: Points | Reals) -> Points | Reals:
    """NaN where parallel lines met very far away: on paper they do not."""
    return np.where(np.abs(value) < np.abs(nominal(value)) * FAR, value, np.nan) if nominal(value) else value
