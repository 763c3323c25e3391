"""The figure of both characteristics over the speed: each as smooth as it is, with the corners that it has."""

from __future__ import annotations

import itertools

import numpy as np

from ....board.construction import Pane
from ....board.paper.marks import Dot, Role
from ....devices.dynamics.run_up import RunUp
from ...diagrams.axes import Axes, draw_axes
from ...diagrams.strip import strips
from ..bench import Bench
from .course import Array, Course, Moment, corners_of
from .places import laid, pane, ticks
from .scales import CHARACTERISTIC
from .words import drawn, resisting

NAMED = {"M_d": 1 / 12, "M_r": 11 / 12}  # of the last speed: where the letter of a curve stands


def characteristics(bench: Bench, device: RunUp, course: Course) -> Pane:
    """Both curves over the speed."""
    board = bench.board
    place = pane(bench, device, course, CHARACTERISTIC)
    board.step(drawn(course), place)
    scale, last = board.scale_of(place), course.last
    curves = {"M_d": (course.driving, device.motor), "M_r": (course.resisting, device.load)}
    if device.motor is None:
        del curves["M_d"]
    runs = {symbol: _runs(moment, corners_of(given), last) for symbol, (moment, given) in curves.items()}
    sizes = [0.0, *(m for symbol, (moment, _) in curves.items() for run in runs[symbol] for m in moment(run).tolist())]
    axes = Axes(
        wide=last / scale.right.value, low=min(sizes) / scale.value, high=max(sizes) / scale.value, across="ω", up="M"
    )
    draw_axes(board, place, axes, ticks(last, scale.right.value))
    named = {"M_d": "M_d", "M_r": resisting(course)}
    for symbol, (moment, _) in curves.items():
        for run in runs[symbol]:
            points = [laid(bench, place, w, m) for w, m in zip(run.tolist(), moment(run).tolist(), strict=True)]
            board.curve(place, points, Role.RESULT)
        speeds = np.unique(np.concatenate(runs[symbol]))
        at = speeds[np.argmin(np.abs(speeds - NAMED[symbol] * last))]
        board.plot(place, laid(bench, place, float(at), float(moment(at[None])[0])), named[symbol], Dot.NONE)
    return place


def _runs(moment: Moment, corners: tuple[float, ...], last: float) -> list[Array]:
    """From corner to corner the speeds through which the curve is led: the more of them, the more it bends."""
    stops = [0.0, *(w for w in corners if 0.0 < w < last), last]
    return [
        np.unique([a, *(w for strip in strips(moment, (a, b)) for w in (*strip.places, strip.end)), b])
        for a, b in itertools.pairwise(stops)
    ]
