"""Where the figures of a run stand, and their places on paper."""

from __future__ import annotations

import numpy as np

from ....board.construction import Pane, View
from ....devices.dynamics.run_up import RunUp
from ....plane import Points
from ..bench import Bench
from .course import Course
from .scales import scales_of
from .words import titles

TICKS = 6  # of an axis


def ticks(most: float, mu: float) -> list[tuple[float, str]]:
    """Round values along an axis."""
    power = 10.0 ** np.floor(np.log10(most / TICKS))
    step = next(power * one for one in (1, 2, 5, 10) if power * one >= most / TICKS * 0.999)
    return [(step * n / mu, f"{step * n:.6g}") for n in range(1, int(most / step + 1e-9) + 1)]


def pane(bench: Bench, device: RunUp, course: Course, view: View) -> Pane:
    """The pane of this figure of the run; a second run has its own scales."""
    scale = None if course.name in ("run", "free") else scales_of(course, device)[view]
    return bench.board.open_pane(view, course.name, titles(view, course.name), scale)


def laid(bench: Bench, place: Pane, across: float, up: float) -> Points:
    """The point at these values, laid off on the axis and above it."""
    board = bench.board
    foot = board.lay_off(0j, 1 + 0j, board.to_paper_across(place, across))
    return board.lay_off(foot, 1j, board.to_paper(place, up))
