"""What a course report draws beyond what its exercise asks:
the rates of the output, where only centres or forces are asked for."""

from __future__ import annotations

import numpy as np

from ...cycle.columns import moving_points
from ...cycle.sample import sample
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.groups.assur import decompose
from ...mechanism.model import Mechanism
from ...names import Kind, Rel, parse_rel
from ...problem.asked.asks import AskPoint, AskRel
from ...problem.problem import Problem
from ...solution import Solution, solve

_RATES = (Kind.V, Kind.A, Kind.OMEGA, Kind.ALPHA)
_MOST = 4  # links


def widened(solution: Solution) -> Solution:
    """The solution with ω, α of the driven links and v, a of the last point,
    where no rate is asked for; as it is where these cannot be drawn.

    With loads only the velocities: the accelerations are drawn where masses need them.
    """
    problem = solution.problem
    if not solution.answers:  # nothing can be drawn
        return solution
    if any(
        isinstance(ask.rel, Rel) and not isinstance(ask, AskPoint) and ask.rel.kind in _RATES for ask in problem.asks
    ):
        return solution
    stems = ("omega", "v", "alpha", "a") if problem.loads is None else ("omega", "v")
    more = tuple(AskRel(rel=parse_rel(key)) for stem in stems for key in _keys(problem, stem))
    try:
        return solve(replace(problem, asks=(*problem.asks, *more)), by=solution.construction.hand)
    except VecpolyError:
        return solution


def _keys(problem: Problem, stem: str) -> list[str]:
    mech = problem.mechanism
    if stem in ("omega", "alpha"):
        return [f"{stem}_{link}" for link in _turning(mech)]
    last = [
        letter
        for group in decompose(mech)[-1:]
        for link in group.links
        for letter in mech.link(link).points
        if letter in moving_points(mech)
    ]
    return [f"{stem}_{letter}" for letter in last[-1:]]


def _turning(mech: Mechanism) -> list[str]:
    """Driven links that turn, each rate once."""
    at = mech.drive.position + np.array([0.0, 1e-3 * (mech.scale if mech.drive.slide else 1.0)])
    motion = sample(mech, None, at).motion
    rates: dict[float, str] = {}
    for name in mech.numbered:
        rate = np.asarray(motion.omega(name))
        if name != mech.drive.link and np.isfinite(rate).all() and np.abs(rate).max() > 1e-9:
            rates[round(float(rate[0]), 9)] = name
    return list(rates.values())[-_MOST:]
