"""From a problem about a device to its construction; scales chosen from a sketch."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import lru_cache

import numpy as np

from ...board.board import Board
from ...board.construction import Construction, Scale, View
from ...board.hand import Hand, hand
from ...board.otherwise.amended import AS_DRAWN, Amended
from ...board.place import Place, view_of
from ...board.said.yielded import evaluated
from ...devices.base import Device
from ...problem.problem import Problem, Scales
from ...words import Words
from ..drawing import Paper
from ..drawn import Drawn
from .bench import NO_SCALE, Bench
from .registry import find_device

KEPT = 4  # sketches that are remembered, of problems drawn lately
TITLES = {View.MECHANISM: Words("简图", "Sketch"), View.BODY: Words("受力图", "Free body")}  # not as of a mechanism


def construct_device(problem: Problem, by: Hand, paper: Paper, amended: Amended = AS_DRAWN) -> Drawn:
    """Solve a device on a board."""
    device = problem.device
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        scales, sketch = _scales(problem, paper)
        same = by.is_ideal and amended == AS_DRAWN and scales.items() <= dict(sketch.board.scales).items()
        bench = sketch if same else _draw(device, by, scales, amended)
    called = find_device(device).called
    keys = [ask.rel.key for ask in problem.asks]
    steps, told = evaluated(bench.board.steps, bench.board.acts, {key: bench.board.readings[key] for key in keys})
    construction = Construction(
        problem=problem.id,
        hand=by.name,
        figures=bench.board.figures(TITLES if called is None else TITLES | {View.MECHANISM: called}),
        steps=bench.board.told(steps),
        acts=tuple(bench.board.acts),
        readings=told,
    )
    return Drawn(
        construction,
        {key: np.asarray(bench.board.found[key], dtype=float) for key in keys},
        {key: sketch.board.readings[key] for key in keys},
        hands=bench.board.hands,
    )


def _draw(device: Device, by: Hand, scales: Mapping[View, Scale], amended: Amended = AS_DRAWN) -> Bench:
    bench = Bench(Board(by, scales, amended))
    find_device(device).draw(bench, device)
    return bench


@lru_cache(maxsize=KEPT)  # whoever tries slips draws one problem a hundred times
def _scales(problem: Problem, paper: Paper) -> tuple[dict[View, Scale], Bench]:
    """Round scales with which the figures of a sketch fill their sheets; and the sketch."""
    device = problem.device
    if (own := find_device(device).scales) is not None:
        return _filling(device, problem.scales, own, paper)
    guess = {View.MECHANISM: device.size / 80, View.BODY: device.size / 80, View.FORCE: device.force / 60}
    sketch = _draw(device, hand("exact"), {view: _scale(view, value) for view, value in guess.items()})
    figures = sketch.board.figures(TITLES)
    given = {view: value for view in guess if (value := problem.scales.of(view.mu)) is not None}
    found = guess | dict(paper.compose(figures, {view: value for view, value in guess.items() if value}, given)) | given
    return {view: _scale(view, found[_followed(view)]) for view in guess}, sketch


Own = Callable[[Device, Scales], Mapping[View, Scale]]


def _filling(device: Device, given: Scales, own: Own, paper: Paper) -> tuple[dict[View, Scale], Bench]:
    """A device's own scales; those not given are such that the figures fill their sheets."""
    scales = own(device, given)
    sketch = _draw(device, hand("exact"), scales)
    if any(scale.across is not None for scale in scales.values()):  # a curve's two scales go with the others
        return dict(scales), sketch
    told = {view: value for view in scales if (value := given.of(view.mu)) is not None}
    if told.keys() == scales.keys():
        return dict(scales), sketch
    alone: dict[Place, float] = {view: scale.value for view, scale in scales.items() if scale.value}
    for view, value in paper.compose(sketch.board.figures(TITLES), alone, told).items():
        given = given.changed(view_of(view).mu, value)
    return dict(own(device, given)), sketch


def _followed(view: View) -> View:
    """The kind whose scale it has: bodies that of the sketch."""
    return View.MECHANISM if view is View.BODY else view


def _scale(view: View, value: float) -> Scale:
    """The scale of a view; value 0: a diagram without one."""
    return Scale.of(view, value) if value else NO_SCALE
