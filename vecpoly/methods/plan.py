"""From a problem to its construction: the groups in order, each with its textbook methods, at round scales."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from ..board.board import Board, Unwritten
from ..board.construction import Construction, Reading, Scale, View
from ..board.hand import Hand, hand
from ..board.otherwise.amended import AS_DRAWN, Amended
from ..board.place import Place, views
from ..board.said.yielded import evaluated
from ..foundation.slotted import replace
from ..problem.problem import Problem
from ..words import Words
from .answers import answered
from .desk import Desk
from .draw import draw
from .drawing import Paper
from .drawn import Drawn, motion_of
from .exchange.exchange import exchanged
from .passes import stages
from .registry import Stage
from .scaling import scaled, sketch_of


def construct(
    problem: Problem, by: Hand, paper: Paper | None = None, amended: Amended = AS_DRAWN, sketch: Desk | None = None
) -> Drawn:
    """Solve the problem on a board.

    paper: chooses scales for the figures of a sketch, and knows the sheets; without one each figure fills a place of
    usual size. amended: what is done otherwise than this hand would; the ideal hand, and the choice of scales, know
    nothing of it.
    sketch: of this problem, where there is one (`sketched`). Raises AssemblyError, DeadPointError, NoMethodError.
    """
    with _quietly():
        problem, said = driven(problem)
        found = scaled(problem, paper)
        desk = draw(problem, Board(by, found.scales, amended), said)
        readings, repeats = answered(desk, problem)
        ideal, motion = found.ideal, found.motion
        if ideal is None and by.is_ideal and amended == AS_DRAWN:
            ideal, motion = readings, motion_of(desk)  # what would be sketched is what was drawn
        elif ideal is None:  # all scales are given, and nothing was sketched
            plain = sketch or sketch_of(problem, found.scales)
            ideal, motion = answered(plain, problem)[0], motion_of(plain)
    return Drawn(_finished(problem, by, desk, readings), repeats, ideal, motion, desk.board.hands)


def drawn_roughly(problem: Problem, by: Hand) -> Construction:
    """The construction as this hand draws it at the scales of the problem, with no ideal hand's beside it: nothing is
    weighed, and nobody reads the lines that are worked out."""
    return _drawn(problem, partial(Unwritten, by))[0].construction


def drawn_otherwise(problem: Problem, by: Hand, amended: Amended, paper: Paper | None = None) -> Drawn:
    """The same with amendments: what is done otherwise is meant to be off."""
    return _drawn(problem, partial(Board, by, amended=amended), paper)[0]


def drawn_beside(problem: Problem, by: Hand, paper: Paper | None = None) -> Drawn:
    """The construction by an exact hand, with others beside it: what it reads is what an ideal hand reads. Nobody reads
    the lines that are worked out."""
    drawn, desk, readings = _drawn(problem, partial(Unwritten, by), paper)
    return drawn._replace(ideal=readings, motion=motion_of(desk))


def _drawn(
    problem: Problem, laid: Callable[[Mapping[Place, Scale]], Board], paper: Paper | None = None
) -> tuple[Drawn, Desk, Mapping[str, Reading]]:
    """With nothing beside it; laid: the board for these scales."""
    with _quietly():
        problem, said = driven(problem)
        desk = draw(problem, laid(scaled(problem, paper).scales), said)
        readings, repeats = answered(desk, problem)
    board = desk.board
    return Drawn(_finished(problem, board.hand, desk, readings), repeats, {}, {}, board.hands), desk, readings


def sketched(problem: Problem) -> tuple[Desk, Construction]:
    """The problem drawn by an exact hand at its own scales: the desk, and what lies on it."""
    by = hand("exact")
    with _quietly():
        problem, _ = driven(problem)
        desk = sketch_of(problem, scaled(problem).scales)
    return desk, _finished(problem, by, desk, {})


def _quietly() -> np.errstate:
    """A repeated hand may miss a grazing meeting: NaN."""
    return np.errstate(invalid="ignore", divide="ignore", over="ignore")


def driven(problem: Problem) -> tuple[Problem, Mapping[Stage, Words]]:
    """The problem with the driver that the drawing goes out from, and what is said of it."""
    exchange = exchanged(problem.mechanism, stages(problem))
    if exchange.mech is problem.subject:
        return problem, exchange.said
    return replace(problem, subject=exchange.mech), exchange.said


def _finished(problem: Problem, by: Hand, desk: Desk, readings: Mapping[str, Reading]) -> Construction:
    steps, told = evaluated(desk.board.steps, desk.board.acts, readings)
    return Construction(
        problem=problem.id,
        hand=by.name,
        figures=desk.board.figures(),
        steps=desk.board.told(steps),
        acts=tuple(desk.board.acts),
        readings=told,
        forces={key: desk.board.readings[key] for key in desk.forces},
    )


def drawn_exactly(problem: Problem, scales: Mapping[View, Scale], *, recorded: bool = False) -> Desk:
    """The drawing by an exact hand at these scales; recorded:
    the numbers of its acts know how they follow from the position of the driving link."""
    with _quietly():
        desk = draw(problem, Board(hand("exact"), scales, recorded=recorded))
        answered(desk, problem)
    return desk


def scale_symbols() -> dict[View, Scale]:
    """A scale of one for every kind of figure."""
    return {view: Scale.of(view, 1.0) for view in views()}
