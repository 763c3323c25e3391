"""The scales of a run's figures: each as large as a page allows."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....board.construction import Scale, View
from ....board.place import view_named
from ....devices.dynamics.run_up import RunUp
from ....problem.problem import Scales
from ..cam.scales import fitting
from .course import Course, courses

CHARACTERISTIC, INVERSE, SPEED = (view_named(name) for name in ("characteristic", "inverse", "speed"))
WIDE, HIGH, LONG = 120.0, 80.0, 145.0  # mm: of a speed, to the right or upwards; of a moment; of a time


def run_scales(device: RunUp, given: Scales) -> Mapping[View, Scale]:
    """Of the first run; a second one has its own."""
    return scales_of(courses(device)[0], device, given)


def scales_of(course: Course, device: RunUp, given: Scales | None = None) -> dict[View, Scale]:
    """As given, or round ones that fit."""
    omega = np.linspace(0.0, course.last, 200)
    moments = np.concatenate([course.driving(omega), course.resisting(omega), [0.0]])
    highest, lowest = float(np.max(moments)), float(np.min(moments))
    along = np.linspace(course.low, course.high, 400)
    time = device.J.si * abs(_total(course))
    sizes = {
        CHARACTERISTIC: ((highest - lowest) / HIGH, course.last / WIDE),
        INVERSE: (float(np.max(course.inverse(along))) / HIGH, course.last / WIDE),
        SPEED: (course.last / WIDE, time / LONG),
    }
    return {view: _scale(view, up, across, given or Scales()) for view, (up, across) in sizes.items()}


def _total(course: Course) -> float:
    """∫ dω/|ΔM| over the run."""
    return sum(float(course.inverse(np.array(one.places)) @ np.array(one.weights)) for one in course.cut())


def _scale(view: View, up: float, across: float, given: Scales) -> Scale:
    assert view.across is not None
    return Scale.of(view, given.of(view.mu) or fitting(up), given.of(view.across) or fitting(across))
