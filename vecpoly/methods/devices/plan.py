"""From a problem about a device to its construction; scales chosen from a sketch."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ...board.board import Board
from ...board.construction import Construction, Scale, View
from ...board.hand import Hand, hand
from ...board.otherwise.amended import AS_DRAWN, Amended
from ...board.paper.extent import extent
from ...board.paper.scales import round_scale
from ...board.yielded import evaluated
from ...devices.base import Device
from ...problem.problem import Problem
from ...words import Words
from ..drawn import Drawn
from .bench import NO_SCALE, Bench
from .registry import find_device

TITLES = {View.MECHANISM: Words("简图", "Sketch"), View.BODY: Words("受力图", "Free body")}  # not as of a mechanism
SLOT = (150.0, 90.0)  # mm, where the sheet names no place for a figure


def construct_device(
    problem: Problem, by: Hand, slots: Mapping[View, tuple[float, float]], amended: Amended = AS_DRAWN
) -> Drawn:
    """Solve a device on a board."""
    device = problem.device
    with np.errstate(invalid="ignore", divide="ignore", over="ignore"):
        scales, sketch = _scales(problem, slots)
        bench = _draw(device, by, scales, amended)
    called = find_device(device).called
    keys = [ask.rel.key for ask in problem.asks]
    steps, told = evaluated(bench.board.steps, bench.board.acts, {key: bench.board.readings[key] for key in keys})
    construction = Construction(
        problem=problem.id,
        hand=by.name,
        figures=bench.board.figures(TITLES if called is None else TITLES | {View.MECHANISM: called}),
        steps=steps,
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


def _scales(problem: Problem, slots: Mapping[View, tuple[float, float]]) -> tuple[dict[View, Scale], Bench]:
    """Round scales with which the largest figure of each kind of a sketch fills its place; and the sketch."""
    device = problem.device
    if (own := find_device(device).scales) is not None:
        scales = dict(own(device, problem.scales))
        return scales, _draw(device, hand("exact"), scales)
    guess = {View.MECHANISM: device.size / 80, View.BODY: device.size / 80, View.FORCE: device.force / 60}
    sketch = _draw(device, hand("exact"), {view: _scale(view, value) for view, value in guess.items()})
    chosen: dict[View, Scale] = {}
    for view, value in guess.items():
        drawn = [
            figure.marks
            for figure in sketch.board.figures(TITLES)
            if figure.view is view and figure.scale.value == value
        ]
        fitted = max(
            (round_scale(value, extent(marks), slots.get(view, SLOT)) for marks in drawn if value), default=value
        )
        chosen[view] = _scale(view, problem.scales.of(view.mu) or fitted)
    chosen[View.BODY] = (
        chosen[View.MECHANISM]
        if any(f.view is View.MECHANISM for f in sketch.board.figures(TITLES))
        else chosen[View.BODY]
    )
    return chosen, sketch


def _scale(view: View, value: float) -> Scale:
    """The scale of a view; value 0: a diagram without one."""
    return Scale.of(view, value) if value else NO_SCALE
