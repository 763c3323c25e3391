"""From a problem to its construction: the groups in order, each with its textbook methods; scales chosen from a sketch.

The sketch is the same construction by an exact hand at provisional scales; only the size of its figures is used, to
choose round scales with which every figure fills its place on the sheet.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..board.board import Board, Scratch
from ..board.construction import Construction, Figure, Reading, Scale, View
from ..board.hand import Hand, hand
from ..board.otherwise.amended import AS_DRAWN, Amended
from ..board.paper.extent import extent, lasting
from ..board.paper.marks import Vector
from ..board.paper.scales import round_scale
from ..board.place import Place, views
from ..board.said.yielded import evaluated
from ..problem.asked.asks import AskNamed
from ..problem.problem import Problem
from ..words import Words
from .answers import Repeats, answer, named_answer
from .desk import Desk
from .draw import draw
from .drawn import Drawn, motion_of
from .exchange.exchange import exchanged
from .passes import stages
from .registry import Stage

FAR = 2.0  # a scale that comes out so much finer than guessed is guessed again
ROUGH = 1.6  # so much smaller a sketch does not tell well what stands round a figure
SPECK = 1e-6  # mm: a force polygon of less is rounding; nothing acts there
Compose = Callable[[Sequence[Figure], Mapping[Place, float], Mapping[View, float]], Mapping[Place, float]]
Scales = dict[Place, Scale]
SLOT = (150.0, 100.0)  # mm, where the sheet names no place for a figure


def construct(
    problem: Problem,
    by: Hand,
    slots: Mapping[View, tuple[float, float]],
    compose: Compose | None = None,
    amended: Amended = AS_DRAWN,
    sketch: Desk | None = None,
) -> Drawn:
    """Solve the problem on a board.

    slots: width and height in mm that each figure should fill. compose: chooses scales for the figures of a sketch, and
    knows the sheets. amended: what is done otherwise than this hand would; the ideal hand, and the choice of
    scales, know nothing of it.
    sketch: of this problem, where there is one (`sketched`). Raises AssemblyError, DeadPointError, NoMethodError.
    """
    with _quietly():
        problem, said = _driven(problem)
        scales, last = _choose_scales(problem, slots, compose)
        desk = draw(problem, Board(by, scales, amended), said)
        readings, repeats = _answers(desk, problem)
        plain = last or sketch or _sketch(problem, scales)
        ideal, _ = _answers(plain, problem)
    return Drawn(_finished(problem, by, desk, readings), repeats, ideal, motion_of(plain), desk.board.hands)


def drawn_alone(problem: Problem, by: Hand) -> Construction:
    """The construction as this hand draws it at the scales of the problem, with no ideal hand's beside it: nothing is
    weighed."""
    return drawn_otherwise(problem, by, AS_DRAWN).construction


def drawn_otherwise(problem: Problem, by: Hand, amended: Amended) -> Drawn:
    """The same with amendments: what is done otherwise is meant to be off."""
    with _quietly():
        problem, said = _driven(problem)
        desk = draw(problem, Board(by, _choose_scales(problem, {}, None)[0], amended), said)
        readings, repeats = _answers(desk, problem)
    return Drawn(_finished(problem, by, desk, readings), repeats, {}, {}, desk.board.hands)


def sketched(problem: Problem) -> tuple[Desk, Construction]:
    """The problem drawn by an exact hand at its own scales: the desk, and what lies on it."""
    by = hand("exact")
    with _quietly():
        problem, _ = _driven(problem)
        desk = _sketch(problem, _choose_scales(problem, {}, None)[0])
    return desk, _finished(problem, by, desk, {})


def _quietly() -> np.errstate:
    """A repeated hand may miss a grazing meeting: NaN."""
    return np.errstate(invalid="ignore", divide="ignore", over="ignore")


def _driven(problem: Problem) -> tuple[Problem, Mapping[Stage, Words]]:
    """The problem with the driver that the drawing goes out from, and what is said of it."""
    exchange = exchanged(problem.mechanism, stages(problem))
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
        _answers(desk, problem)
    return desk


def scale_symbols() -> dict[View, Scale]:
    """A scale of one for every kind of figure."""
    return {view: Scale.of(view, 1.0) for view in views()}


def _choose_scales(
    problem: Problem, slots: Mapping[View, tuple[float, float]], compose: Compose | None
) -> tuple[Scales, Desk | None]:
    """The scales, and the last sketch drawn to find them; none where all are given."""
    mech, drive = problem.mechanism, problem.mechanism.drive
    size = mech.scale
    speed = abs(drive.rate) * (1.0 if drive.slide else size) or 1.0
    guess = {
        View.MECHANISM: size / 100,
        View.VELOCITY: speed / 100,
        View.ACCELERATION: (abs(drive.accel) + drive.rate**2) * (1.0 if drive.slide else size) / 100 or 1.0,
        View.FORCE: _typical_force(problem) / 60,
        View.BODY: size / 100,
    }
    given = {view: problem.scales.of(view.mu) for view in guess}
    if all(given[view] for view in {View.MECHANISM, *(stage.view for stage in stages(problem))}):
        return {view: Scale.of(view, given[view] or value) for view, value in guess.items()}, None
    chosen, sketch = _fitted(problem, slots, guess, compose)
    while chosen[View.FORCE].value < guess[View.FORCE] / FAR and not given[View.FORCE]:  # a sketch of specks
        guess |= {View.FORCE: chosen[View.FORCE].value}
        chosen, sketch = _fitted(problem, slots, guess, compose)
    if compose is not None and any(guess[view] / chosen[view].value > ROUGH for view in guess):
        chosen, sketch = _fitted(problem, slots, {view: chosen[view].value for view in guess}, compose)
    return chosen, sketch


def _typical_force(problem: Problem) -> float:
    """A force of the size of those to be drawn (N); of no matter where nothing acts."""
    if problem.loads is None:
        return 1.0
    from .forces.readings import largest_load

    return largest_load(problem)


def _fitted(
    problem: Problem, slots: Mapping[View, tuple[float, float]], guess: Mapping[View, float], compose: Compose | None
) -> tuple[Scales, Desk]:
    """Round scales with which the figures of a sketch at these scales would fill their slots, and their sheet;
    and the sketch."""
    sketch = _sketch(problem, {v: Scale.of(v, value) for v, value in guess.items()})
    given = {view: problem.scales.of(view.mu) for view in guess}
    figures = [
        replace(f, marks=lasting(f.marks)) for f in sketch.board.figures() if f.view is not View.FORCE or _acts(f)
    ]
    board, values = sketch.board, _filling(figures, slots, guess)
    if compose is not None:
        sketched: dict[Place, float] = {pane: board.scales[pane].value for pane in board.composed}
        values = compose(figures, sketched | dict(guess.items()), _known(given))
    chosen: Scales = {view: Scale.of(view, given[view] or values.get(view, value)) for view, value in guess.items()}
    chosen |= {pane: replace(board.scales[pane], value=values[pane]) for pane in board.composed if pane in values}
    return chosen | {View.BODY: chosen[View.MECHANISM]}, sketch


def _known(given: Mapping[View, float | None]) -> dict[View, float]:
    return {view: value for view, value in given.items() if value is not None}


def _filling(
    figures: Sequence[Figure], slots: Mapping[View, tuple[float, float]], guess: Mapping[View, float]
) -> Mapping[Place, float]:
    """Round scales with which the largest figure of each kind fills its slot."""
    found: dict[Place, float] = {}
    for figure in figures:
        view = figure.view
        if view in guess and not figure.aside:
            scale = round_scale(guess[view], extent(figure.marks), slots.get(view, SLOT))
            found[view] = max(scale, found.get(view, scale))
    return found


def _acts(figure: Figure) -> bool:
    """Whether a force polygon has a force."""
    return any(isinstance(mark, Vector) and abs(mark.b - mark.a) > SPECK for mark in figure.marks)


def _sketch(problem: Problem, scales: Mapping[Place, Scale] | Mapping[View, Scale]) -> Desk:
    """The construction by an exact hand, of which only what stands on the paper is of use."""
    return draw(problem, Scratch(hand("exact"), scales))


def _answers(desk: Desk, problem: Problem) -> tuple[dict[str, Reading], Repeats]:
    readings: dict[str, Reading] = {}
    repeats: Repeats = {}
    for ask in problem.asks:
        if isinstance(ask, AskNamed) or ask.rel.key in desk.board.readings:
            reading, scalars = named_answer(desk, ask.rel)
        else:
            reading, scalars = answer(desk, ask.rel)
        readings[reading.key] = reading
        repeats[reading.key] = np.asarray(scalars, dtype=float)
    return readings, repeats
