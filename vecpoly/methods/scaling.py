"""The scales of a construction: the same construction drawn first by an exact hand at provisional scales; the size of
its figures tells the round scales with which every figure fills its place on the sheet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import lru_cache

from ..board.acts.inkless import Measure
from ..board.board import Scratch
from ..board.construction import Figure, Reading, Scale, View
from ..board.hand import hand
from ..board.paper.extent import extent, lasting
from ..board.paper.marks import Vector
from ..board.paper.scales import round_scale
from ..board.place import Place
from ..foundation.slotted import dataclass, replace
from ..names import Rel
from ..problem.problem import Problem
from .answers import answered
from .desk import Desk
from .draw import draw
from .drawing import Paper
from .drawn import motion_of
from .passes import stages
from .registry import Stage

FAR = 2.0  # a scale that comes out so much finer than guessed is guessed again
ROUGH, LARGE = 1.6, 3.0  # so much smaller, or larger, a sketch does not tell well what stands round a figure
SPECK = 1e-6  # mm: a force polygon of less is rounding; nothing acts there
SLOT = (150.0, 100.0)  # mm, what a figure fills where no paper is known
AGAIN = {Stage.CENTRES, Stage.CURVATURE}  # by which the mechanism may be drawn once more, to a scale of its own
KEPT = 256  # problems whose scales are remembered, some KB each: more than the library has
Scales = dict[Place, Scale]


@dataclass(frozen=True, slots=True, kw_only=True)
class Scaled:
    """The scales of a problem, and what an exact hand read off the sketch by which they were chosen: the answers, and
    all motion of points and links (SI). No answers where all scales are given and nothing was sketched."""

    scales: Mapping[Place, Scale]
    ideal: Mapping[str, Reading] | None = None
    motion: Mapping[Rel, complex | float] = field(default_factory=dict)


@lru_cache(maxsize=KEPT)
def scaled(problem: Problem, paper: Paper | None = None) -> Scaled:
    """The scales that are given, else round ones with which the figures of a sketch fill the paper; what stands on it.

    One problem is drawn again and again, by other hands and with somebody's own readings: its scales stay what they
    are.
    """
    scales, last = _chosen(problem, paper)
    if last is None:
        return Scaled(scales=scales)
    return Scaled(scales=scales, ideal=answered(last, problem)[0], motion=motion_of(last))


def provisional(problem: Problem) -> dict[View, float]:
    """Scales of about the right size, as the data make likely: those of the first sketch."""
    mech, drive = problem.mechanism, problem.mechanism.drive
    size = mech.scale
    speed = abs(drive.rate) * (1.0 if drive.slide else size) or 1.0
    return {
        View.MECHANISM: size / 100,
        View.VELOCITY: speed / 100,
        View.ACCELERATION: (abs(drive.accel) + drive.rate**2) * (1.0 if drive.slide else size) / 100 or 1.0,
        View.FORCE: _typical_force(problem) / 60,
        View.BODY: size / 100,
    }


def _chosen(problem: Problem, paper: Paper | None) -> tuple[Scales, Desk | None]:
    """The scales, and the last sketch drawn to find them; none where all are given."""
    guess = provisional(problem)
    given = {view: problem.scales.of(view.mu) for view in guess}
    if all(given[view] for view in {View.MECHANISM, *(stage.view for stage in stages(problem))}):
        known = {view: given[view] or value for view, value in guess.items()}
        if paper is None or not _twice(problem):
            return {view: Scale.of(view, value) for view, value in known.items()}, None
        return _fitted(problem, known, paper)[0], None
    chosen, sketch = _fitted(problem, guess, paper)
    while chosen[View.FORCE].value < guess[View.FORCE] / FAR and not given[View.FORCE]:  # a sketch of specks
        guess |= {View.FORCE: chosen[View.FORCE].value}
        chosen, sketch = _fitted(problem, guess, paper)
    if paper is None:
        return chosen, sketch
    if _rough(guess, chosen):
        guess = {view: chosen[view].value for view in guess}
        chosen, sketch = _fitted(problem, guess, paper)
    return _exchanged(problem, guess, chosen, sketch, paper), sketch


def _rough(guess: Mapping[View, float], chosen: Mapping[Place, Scale]) -> bool:
    """Whether a sketch was so much smaller than the drawing, or its mechanism so much larger: guides, stems and discs
    do not tell then what stands round them."""
    times = {view: guess[view] / chosen[view].value for view in guess}
    return max(times.values()) > ROUGH or times[View.MECHANISM] < 1 / LARGE


def _twice(problem: Problem) -> bool:
    """Whether a drawing chose μ_l, and chose with it that of the mechanism as it is drawn once more."""
    return problem.scales.wished(View.MECHANISM.mu) is None and not AGAIN.isdisjoint(stages(problem))


def _typical_force(problem: Problem) -> float:
    """A force of the size of those to be drawn (N); of no matter where nothing acts."""
    if problem.loads is None:
        return 1.0
    from .forces.readings import largest_load

    return largest_load(problem)


def _fitted(problem: Problem, guess: Mapping[View, float], paper: Paper | None) -> tuple[Scales, Desk]:
    """Round scales with which the figures of a sketch at these scales would fill their places, and their sheet;
    and the sketch."""
    sketch = sketch_of(problem, {v: Scale.of(v, value) for v, value in guess.items()})
    given = {view: problem.scales.of(view.mu) for view in guess}
    figures, board = _lasting(sketch), sketch.board
    values = _filling(figures, guess) if paper is None else paper.compose(figures, _at(sketch, guess), _known(given))
    chosen: Scales = {view: Scale.of(view, given[view] or values.get(view, value)) for view, value in guess.items()}
    chosen |= {pane: replace(board.scales[pane], value=values[pane]) for pane in board.composed if pane in values}
    return chosen | {View.BODY: chosen[View.MECHANISM]}, sketch


def _exchanged(
    problem: Problem, guess: Mapping[View, float], chosen: Mapping[Place, Scale], sketch: Desk, paper: Paper
) -> Scales:
    """These scales, or others for as many sheets at which what is read off this sketch is larger."""
    given = _known({view: problem.scales.of(view.mu) for view in guess})
    told = {place: scale.value for place, scale in chosen.items()}
    measured = [(act.a, act.b) for act in sketch.board.acts if isinstance(act, Measure)]
    values = paper.exchange(_lasting(sketch), _at(sketch, guess), given, told, measured)
    made = {place: replace(scale, value=values.get(place, scale.value)) for place, scale in chosen.items()}
    return made | {View.BODY: replace(made[View.BODY], value=made[View.MECHANISM].value)}


def _lasting(sketch: Desk) -> list[Figure]:
    """The figures of a sketch for which scales are chosen."""
    shown = (one for one in sketch.board.figures() if one.view is not View.FORCE or _acts(one))
    return [replace(one, marks=lasting(one.marks)) for one in shown]


def _at(sketch: Desk, guess: Mapping[View, float]) -> dict[Place, float]:
    """The scales at which its figures are drawn."""
    return {pane: sketch.board.scales[pane].value for pane in sketch.board.composed} | dict(guess.items())


def _known(given: Mapping[View, float | None]) -> dict[View, float]:
    return {view: value for view, value in given.items() if value is not None}


def _filling(figures: Sequence[Figure], guess: Mapping[View, float]) -> Mapping[Place, float]:
    """Round scales with which the largest figure of each kind fills its place."""
    found: dict[Place, float] = {}
    for figure in figures:
        view = figure.view
        if view in guess and not figure.aside:
            scale = round_scale(guess[view], extent(figure.marks), SLOT)
            found[view] = max(scale, found.get(view, scale))
    return found


def _acts(figure: Figure) -> bool:
    """Whether a force polygon has a force."""
    return any(isinstance(mark, Vector) and abs(mark.b - mark.a) > SPECK for mark in figure.marks)


def sketch_of(problem: Problem, scales: Mapping[Place, Scale] | Mapping[View, Scale]) -> Desk:
    """The construction by an exact hand, of which only what stands on the paper is of use."""
    return draw(problem, Scratch(hand("exact"), scales))
