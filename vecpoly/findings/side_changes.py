"""Where in the cycle a group passes to its other assembly: at a change point its sign σ is turned, and the motion goes
on."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..analytic.equations import GroupModel, Values
from ..cycle.sample import sample
from ..names import At
from .study.study import Study

SIGN = "σ"
NONE = 1e-6  # of the largest: a determinant that is none, and tells no side
HALVINGS = 40


def side_changes(study: Study, group: GroupModel) -> tuple[float, ...]:
    """The places of the drive at which the assembly that the cycle keeps turns its σ, in order; none for a group
    without a sign. By the places of the solver, which goes through change points: the formulas keep one σ."""
    if group.determinant is None or all(one.symbol != SIGN for one in group.constants):
        return ()
    phi = study.turn.phi
    phi = np.append(phi, phi[0] + study.whole.period) if study.whole.whole else phi
    found = _signed(study, group, phi)
    told = np.flatnonzero(np.abs(found) > NONE * np.nanmax(np.abs(found), initial=0.0))
    if study.whole.whole and told.size and told[-1] < len(phi) - 1:  # it begins with the change point: close the circle
        phi, found = np.append(phi, phi[told[0]] + study.whole.period), np.append(found, found[told[0]])
        told = np.append(told, len(phi) - 1)
    turned = np.flatnonzero(found[told[1:]] * found[told[:-1]] < 0)
    places = (_halved(study, group, phi[told[i]], phi[told[i + 1]]) for i in turned)
    return tuple(sorted(study.reduced(place) for place in places))


def _halved(study: Study, group: GroupModel, low: float, high: float) -> float:
    """Where the side changes between two places."""
    first = _signed(study, group, np.array([low]))[0]
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        if _signed(study, group, np.array([middle]))[0] * first > 0:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def _signed(study: Study, group: GroupModel, phi: NDArray[np.float64]) -> NDArray[np.float64]:
    """The determinant of the group with the places of the solver: it has the sign of the side."""
    assert group.determinant is not None
    motion = sample(study.mech, None, phi, order=0).motion
    env: Values = {study.model.drive: phi}
    for link in study.mech.links:
        env[f"φ_{{{study.model_name(link.name)}}}"] = np.asarray(motion.angle(link.name))
        for letter in link.points:
            at = np.asarray(motion.position(At(letter)))
            env |= {f"x_{{{letter}}}": at.real, f"y_{{{letter}}}": at.imag}
    return np.broadcast_to(np.asarray(group.determinant.value(env), np.float64), phi.shape)
