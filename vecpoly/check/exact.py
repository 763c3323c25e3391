"""The oracle's answer to every question of a problem, under the same key as the reading."""

from __future__ import annotations

import numpy as np

from .. import oracle
from ..devices.base import Device
from ..mechanism.model import Mechanism
from ..names import Kind, Rel
from ..oracle.devices.registry import device_answers
from ..oracle.forces import forces
from ..problem.asks import AskNamed, AskPoint
from ..problem.problem import Problem


def exact_values(problem: Problem, mech: Mechanism | None = None) -> dict[str, complex | float]:
    """Key → exact value: complex for vectors and positions, float for ω, α, moments, efficiencies; all SI."""
    if isinstance(problem.subject, Device):
        found_by_key = device_answers(problem.subject)
        return {ask.rel.key: found_by_key[ask.rel.key] for ask in problem.asks}
    return _kinematic(problem, mech or problem.mechanism) | _static(problem, mech or problem.mechanism)


def _static(problem: Problem, mech: Mechanism) -> dict[str, complex | float]:
    """Reactions, balancing loads and the like."""
    asked = [ask.rel for ask in problem.asks if isinstance(ask, AskNamed)]
    if problem.loads is None or not asked:
        return {}
    result = forces(mech, problem.loads)
    return {named.key: complex(value) if named.is_vector else float(value.real)
            for named in asked for value in [result.value(named.key)]}


def _kinematic(problem: Problem, mech: Mechanism) -> dict[str, complex | float]:
    motion = oracle.solve(mech)
    found = {ask.at: (ask.link, _place(motion, ask)) for ask in problem.asks if isinstance(ask, AskPoint)}
    values: dict[str, complex | float] = {}
    for ask in problem.asks:
        if isinstance(ask, AskNamed):
            continue
        if isinstance(ask, AskPoint):
            values[ask.rel.key] = found[ask.at][1]
        elif ask.rel.to in found and ask.rel.kind in (Kind.V, Kind.A) and ask.rel.ref is None:
            link, place = found[ask.rel.to]
            values[ask.rel.key] = _vector(motion, link, place, ask.rel)
        else:
            value = motion.value(ask.rel)
            values[ask.rel.key] = complex(value) if ask.rel.is_vector else float(value.real)
    return values


def _place(motion: oracle.Motion, ask: AskPoint) -> complex:
    if ask.velocity is not None:
        return complex(motion.point_with(ask.link, velocity=ask.velocity))
    assert ask.acceleration is not None
    return complex(motion.point_with(ask.link, acceleration=ask.acceleration))


def _vector(motion: oracle.Motion, link: str, place: complex, rel: Rel) -> complex:
    """v or a of the point of this link that is at this place."""
    if rel.kind is Kind.V:
        return complex(motion.moving(link).velocity_at(np.array([place]))[0])
    return complex(motion.moving(link, 2).acceleration_at(np.array([place]))[0])
