"""Other ways to a quantity than that of the drawing, which anybody may take from an own value: v = ω l about a fixed
pivot, K of θ."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from operator import mul

from ...errors import UnknownNameError
from ...mechanism.model import Mechanism
from ...names import Kind, omega, parse_rel
from ...problem.problem import Problem
from ..key import Graded


@dataclass(frozen=True, slots=True)
class Way:
    """What follows from the size of the quantity `source` alone."""

    source: str
    of: Callable[[float], float]


def ways(problem: Problem, one: Graded) -> Iterator[Way]:
    """Every other way to this quantity."""
    yield from _about_pivots(problem, one)
    if one.key == "K":
        yield Way("theta", lambda theta: (180.0 + theta) / (180.0 - theta) if theta != 180.0 else 0.0)


def _about_pivots(problem: Problem, one: Graded) -> Iterator[Way]:
    """v = ω l of a point on a link that turns about a fixed pivot."""
    try:
        rel = parse_rel(one.key)
    except UnknownNameError:
        return
    mech = problem.subject
    if not isinstance(mech, Mechanism) or rel.kind is not Kind.V or rel.key != f"v_{rel.to.point}":
        return
    for link in (link for link in mech.links if rel.to.point in link.points):
        for pivot in (letter for letter in link.points if letter in mech.frame and letter != rel.to.point):
            radius = abs(link.points[rel.to.point] - link.points[pivot])
            yield Way(omega(link.name).key, partial(mul, radius))
