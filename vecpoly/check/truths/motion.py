"""What the oracle's motion has of the positions, velocities and accelerations that are asked for."""

from __future__ import annotations

import numpy as np

from ... import oracle
from ...names import Kind, Rel
from ...problem.asked.asks import AskNamed, AskPoint
from ...problem.problem import Problem
from ..truth import Values


def kinematic(problem: Problem, motion: oracle.Motion) -> Values:
    """Key → exact value of each of them."""
    found = {ask.at: (ask.link, _place(motion, ask)) for ask in problem.asks if isinstance(ask, AskPoint)}
    values: Values = {}
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
    if ask.slowest is not None:
        from ...oracle.centres import slowest

        return slowest(motion.mech, ask.link, *ask.slowest)
    if ask.velocity is not None:
        return complex(motion.point_with(ask.link, velocity=ask.velocity))
    assert ask.acceleration is not None
    return complex(motion.point_with(ask.link, acceleration=ask.acceleration))


def _vector(motion: oracle.Motion, link: str, place: complex, rel: Rel) -> complex:
    """v or a of the point of this link that is at this place."""
    if rel.kind is Kind.V:
        return complex(motion.moving(link).velocity_at(np.array([place]))[0])
    return complex(motion.moving(link, 2).acceleration_at(np.array([place]))[0])
