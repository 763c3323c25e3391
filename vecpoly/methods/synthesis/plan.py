"""From a task of synthesis to its construction; scale and numbers of the candidates from a sketch."""

from __future__ import annotations

import numpy as np

from ...board.board import Board
from ...board.construction import Construction, Scale, View
from ...board.hand import Hand, hand
from ...board.otherwise.amended import AS_DRAWN, Amended
from ...board.paper.extent import extent
from ...board.paper.scales import round_scale
from ...designs.base import Design
from ...designs.verdict import Verdict
from ...problem.problem import Problem
from ...words import Words
from ..drawing import Paper
from ..drawn import Drawn
from .draft import SHEET, Draft
from .registry import find_design

TITLES = {View.MECHANISM: Words("机构的综合", "Synthesis of the linkage")}
SAME = 9  # digits to which two numbers that order candidates are one


def construct_design(problem: Problem, by: Hand, paper: Paper, amended: Amended = AS_DRAWN) -> Drawn:
    """Find the linkages on a board; the sketch's figure tells the scale, its candidates their numbers."""
    asked = frozenset(ask.rel.key for ask in problem.asks)
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        sketch = _draw(problem, hand("exact"), _guess(problem), (), asked)
        numbers = _numbers(sketch)
        ideal = _draw(problem, hand("exact"), _scale(problem, sketch, paper), numbers, asked)
        draft = _draw(problem, by, _scale(problem, sketch, paper), numbers, asked, amended)
    board, keys = draft.board, [ask.rel.key for ask in problem.asks]
    construction = Construction(
        problem=problem.id,
        hand=by.name,
        figures=board.figures(TITLES),
        steps=tuple(board.steps),
        acts=tuple(board.acts),
        readings={key: board.readings[key] for key in keys},
        candidates=draft.candidates(_design(problem)),
    )
    return Drawn(
        construction,
        {key: np.asarray(board.found[key], dtype=float) for key in keys},
        {key: ideal.board.readings[key] for key in keys},
        hands=board.hands,
    )


def _design(problem: Problem) -> Design:
    assert isinstance(problem.subject, Design), f"problem {problem.id} is about no synthesis"
    return problem.subject


def _draw(
    problem: Problem,
    by: Hand,
    scale: float,
    numbers: tuple[int, ...],
    asked: frozenset[str],
    amended: Amended = AS_DRAWN,
) -> Draft:
    design = _design(problem)
    draft = Draft(Board(by, {SHEET: Scale.of(SHEET, scale)}, amended), numbers=numbers, asked=asked)
    find_design(design).draw(draft, design)
    draft.settle(design)
    return draft


def _numbers(sketch: Draft) -> tuple[int, ...]:
    """The number of each candidate: the valid ones first, by AB, BC, AD, x of A."""
    keys = [(one.verdict is not Verdict.VALID, *(round(x, SAME - 3) + 0.0 for x in one.order)) for one in sketch.found]
    order = sorted(range(len(keys)), key=lambda i: keys[i])
    return tuple(order.index(i) + 1 for i in range(len(keys)))


def _guess(problem: Problem) -> float:
    return problem.scales.of(SHEET.mu) or _design(problem).size / 80


def _scale(problem: Problem, sketch: Draft, paper: Paper) -> float:
    """As given; else the round scale with which the largest figure fills its place on a sheet."""
    given = problem.scales.of(SHEET.mu)
    if given is not None:
        return given
    place = paper.slots(1)[0]
    guess = _guess(problem)
    return max(round_scale(guess, extent(figure.marks), place) for figure in sketch.board.figures(TITLES))
