"""Problems drawn once, at scales that are given: what the exact hand draws is right at any,
and to choose them takes two more drawings."""

from __future__ import annotations

from dataclasses import replace

from vecpoly.board.construction import View
from vecpoly.designs.base import Design
from vecpoly.devices.base import Device
from vecpoly.mechanism.model import Mechanism
from vecpoly.methods.devices.registry import find_device
from vecpoly.methods.scaling import provisional
from vecpoly.problem.problem import Problem, Scales
from vecpoly.solution import Solution, solve


def scaled(problem: Problem) -> Problem:
    """The same problem with scales of about the right size, but for those that it gives itself."""
    return replace(problem, scales=Scales(_likely(problem) | dict(problem.scales.given)))


def _likely(problem: Problem) -> dict[str, float]:
    match problem.subject:
        case Mechanism():
            return {view.mu.key: value for view, value in provisional(problem).items()}
        case Design() as design:
            return {View.MECHANISM.mu.key: design.size / 80}
        case Device() as device if (own := find_device(device).scales) is not None:
            return {view.mu.key: scale.value for view, scale in own(device, problem.scales).items() if scale.value}
    return {}


def exactly(problem: Problem) -> Solution:
    """Its solution by the exact hand."""
    return solve(scaled(problem), by="exact", repeats=0, precise=False)
