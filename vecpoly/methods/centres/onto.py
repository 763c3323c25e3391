"""On which figure a construction is drawn: on the diagram itself, or on the mechanism drawn once more, to the diagram's
scale or to one of its own."""

from __future__ import annotations

from math import inf

from ...board.board import Board
from ...board.construction import View
from ...board.place import Place
from ...problem.problem import Problem
from ...words import Words
from ..passes import stages
from ..registry import Stage
from .copy import FEW
from .size import Paper

ONE = {Stage.POSITION, Stage.CENTRES, Stage.CURVATURE}
ENOUGH = 60.0  # mm: a diagram beside other figures is drawn no smaller for the sake of one μ_l


def is_once(problem: Problem) -> bool:
    """Whether the diagram is wanted for nothing else, and has room for more letters."""
    return set(stages(problem)) <= ONE and len(problem.mechanism.bodies) < FEW


def sharing(problem: Problem, least: float) -> float:
    """The least size of the mechanism (mm), where all is on paper, at which both figures have one μ_l; least: at which
    its links are told apart. A scale that is given stays."""
    if problem.scales.wished(View.MECHANISM.mu) is not None:
        return inf
    return least if is_once(problem) else ENOUGH


def opened(board: Board, name: str, title: Words, paper: Paper, *, once: bool) -> Place:
    """The diagram, which is called so from now on, or a figure of that name."""
    if once and paper.shared:
        board.entitle(View.MECHANISM, title)
        return View.MECHANISM
    own = None if paper.shared else paper.scale
    return board.open_pane(View.MECHANISM, name, title, own, aside=True, composed=not paper.shared)
