"""From a task of synthesis to its construction; scale and numbers of the candidates from a sketch."""

from __future__ import annotations

from functools import lru_cache
from itertools import chain

import numpy as np

from ...board.board import Board
from ...board.construction import Construction, Scale
from ...board.hand import Hand, hand
from ...board.otherwise.amended import AS_DRAWN, Amended
from ...board.place import Pane
from ...board.said.yielded import evaluated
from ...designs.base import Design
from ...designs.verdict import Verdict
from ...problem.problem import Problem
from ..drawing import Paper
from ..drawn import Drawn
from .draft import SHEET, Draft
from .registry import find_design
from .transmission import NAME

LARGER = 3  # round scales by which a figure of angles is drawn larger at most
KEPT = 4  # sketches that are remembered, of problems drawn lately
SAME = 9  # digits to which two numbers that order candidates are one


def construct_design(problem: Problem, by: Hand, paper: Paper, amended: Amended = AS_DRAWN) -> Drawn:
    """Find the linkages on a board; the sketch's figures tell the scale, its candidates their numbers."""
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        scale, ideal = _ideal(problem, paper)
        same = by.is_ideal and amended == AS_DRAWN and ideal.numbers == _numbers(ideal)
        draft = ideal if same else _draw(problem, by, scale, ideal, amended)
    board, keys = draft.board, [ask.rel.key for ask in problem.asks]
    steps, told = evaluated(board.steps, board.acts, {key: board.readings[key] for key in keys})
    construction = Construction(
        problem=problem.id,
        hand=by.name,
        figures=draft.figures({SHEET: find_design(_design(problem)).sheet}),
        steps=board.told(steps),
        acts=tuple(board.acts),
        readings=told,
        candidates=draft.candidates(_design(problem)),
    )
    return Drawn(
        construction,
        {key: np.asarray(board.found[key], dtype=float) for key in keys},
        {key: ideal.board.readings[key] for key in keys},
        hands=board.hands,
    )


@lru_cache(maxsize=KEPT)  # whoever tries slips draws one problem a hundred times
def _ideal(problem: Problem, paper: Paper) -> tuple[float, Draft]:
    """The scale that a sketch tells, and what an ideal hand draws at it; figures on which angles alone are read are
    drawn larger as far as those on which lengths are read are no smaller for it."""
    found = _sized(problem, paper, LARGER)
    of_angles = any(isinstance(at, Pane) and at.name.startswith(NAME) for at in found[1].board.scales)
    if not of_angles or _given(problem):
        return found
    plain = _sized(problem, paper, 0)
    fewer = (_sized(problem, paper, steps) for steps in range(LARGER - 1, 0, -1))
    return next((one for one in chain((found,), fewer) if one[0] <= plain[0]), plain)


def _sized(problem: Problem, paper: Paper, steps: int) -> tuple[float, Draft]:
    """The same with figures of angles so many round scales larger."""
    sketch = _draw(problem, hand("exact"), _guess(problem), None, steps=steps)
    scale = _scale(problem, sketch, _guess(problem), paper)
    ideal = _draw(problem, hand("exact"), scale, sketch)
    if (better := _scale(problem, ideal, scale, paper)) != scale:  # seen at its size, it may fill the sheet otherwise
        return better, _draw(problem, hand("exact"), better, sketch)
    return scale, ideal


def _design(problem: Problem) -> Design:
    assert isinstance(problem.subject, Design), f"problem {problem.id} is about no synthesis"
    return problem.subject


def _draw(
    problem: Problem, by: Hand, scale: float, sketch: Draft | None, amended: Amended = AS_DRAWN, steps: int = 0
) -> Draft:
    """The construction; its candidates have the numbers that a sketch tells."""
    design = _design(problem)
    draft = Draft(
        Board(by, {SHEET: Scale.of(SHEET, scale)}, amended),
        numbers=() if sketch is None else _numbers(sketch),
        sketched=() if sketch is None else tuple(sketch.found),
        valid=0 if sketch is None else sum(one.verdict is Verdict.VALID for one in sketch.found),
        take=design.take,
        steps=steps if sketch is None else sketch.steps,
        asked=frozenset(ask.rel.key for ask in problem.asks),
    )
    find_design(design).draw(draft, design)
    draft.settle(design)
    return draft


def _numbers(sketch: Draft) -> tuple[int, ...]:
    """The number of each candidate: the valid ones first, by AB, BC, AD, x of A."""
    keys = [(one.verdict is not Verdict.VALID, *(round(x, SAME - 3) + 0.0 for x in one.order)) for one in sketch.found]
    order = sorted(range(len(keys)), key=lambda i: keys[i])
    return tuple(order.index(i) + 1 for i in range(len(keys)))


def _given(problem: Problem) -> float | None:
    return problem.scales.of(SHEET.mu)


def _guess(problem: Problem) -> float:
    return _given(problem) or _design(problem).size / 80


def _scale(problem: Problem, sketch: Draft, at: float, paper: Paper) -> float:
    """As given; else the round scale with which the figures of a sketch at some scale fill their sheets."""
    given = _given(problem)
    if given is not None:
        return given
    return paper.compose(sketch.figures({}), {SHEET: at}, {}).get(SHEET, at)
