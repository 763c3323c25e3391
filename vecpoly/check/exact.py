"""The oracle's answer to every question of a problem, under the same key as the reading."""

from __future__ import annotations

import numpy as np

from .. import oracle
from ..devices.base import Device
from ..mechanism.assur import hinges
from ..mechanism.centre_quantities import KEYS, centre_quantities
from ..mechanism.model import Mechanism
from ..mechanism.quantities import given_value, pairs
from ..names import Kind, Rel, reaction
from ..oracle.centres import Centres, slowest
from ..oracle.devices.registry import device_answers
from ..oracle.forces import forces
from ..problem.asks import AskNamed, AskPoint
from ..problem.problem import Problem
from .roles import refuse_wrong_roles


def exact_values(problem: Problem, mech: Mechanism | None = None) -> dict[str, complex | float]:
    """Key → exact value: complex for vectors and positions, float for ω, α, moments, efficiencies; all SI."""
    if isinstance(problem.subject, Device):
        found_by_key = device_answers(problem.subject)
        return {ask.rel.key: found_by_key[ask.rel.key] for ask in problem.asks}
    mech = mech or problem.mechanism
    return _kinematic(problem, mech) | _central(problem, mech) | _static(problem, mech)


def _central(problem: Problem, mech: Mechanism) -> dict[str, complex | float]:
    """Places, velocities, ratios, limit positions of instant centres; a centre at infinity by its direction (deg)."""
    keys = [ask.rel.key for ask in problem.asks if isinstance(ask, AskNamed)]
    known = centre_quantities(mech) if any(key.startswith(KEYS) for key in keys) else {}
    centres = Centres(mech)
    return {key: centres.value(key) for key in keys if key in known}


def _static(problem: Problem, mech: Mechanism) -> dict[str, complex | float]:
    """Reactions, balancing loads and the like."""
    asked = [ask.rel for ask in problem.asks if isinstance(ask, AskNamed) and not ask.rel.key.startswith(KEYS)]
    if problem.loads is None or not asked:
        return {}
    data = {named.key: value for named in asked if (value := given_value(problem.loads, named.key)) is not None}
    sought = [named for named in asked if named.key not in data]
    result = forces(mech, problem.loads) if sought else None
    if result is not None:
        refuse_wrong_roles(mech, problem.loads, result)
    return data | {named.key: complex(value) if named.is_vector else float(value.real)
                   for named in sought if result for value in [result.value(named.key)]}


def exact_lines(problem: Problem) -> dict[str, tuple[complex, str]]:
    """Key of every reaction asked for → a point of its line (m), and the sense of its moment about the pin, "" where it has none."""
    asked = {ask.rel.key for ask in problem.asks if isinstance(ask, AskNamed)}
    if problem.loads is None or isinstance(problem.subject, Device) or not any(key.startswith("R_") for key in asked):
        return {}
    mech, result, motion = problem.subject, forces(problem.subject, problem.loads), oracle.solve(problem.subject)
    found: dict[str, tuple[complex, str]] = {}
    for by, on in ((by, on) for a, b in pairs(mech) for by, on in ((a, b), (b, a))):
        numbers = mech.number(by), mech.number(on)
        key = reaction(*numbers).key
        if key in asked:
            point, pin = complex(result.line(*numbers)), pin_of(mech, by, on)
            force = complex(result.value(key))
            found[key] = (point, _tangent(point - complex(motion.position(pin)), force) if pin else "")
    return found


def pin_of(mech: Mechanism, a: str, b: str) -> str:
    """The letter of the hinge between two links; "" where they slide or touch."""
    return next((point for point, names in hinges(mech).items() if a in names and b in names), "")


def _tangent(arm: complex, force: complex) -> str:
    """ccw or cw by the sign of the moment; "" where the force passes through the pin but for rounding."""
    moment = (arm.conjugate() * force).imag
    if abs(moment) <= 1e-9 * abs(force):
        return ""
    return "ccw" if moment > 0 else "cw"


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
    if ask.slowest is not None:
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
