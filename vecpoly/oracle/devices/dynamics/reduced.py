"""Exact trains on one shaft: every body by itself, Newton and Euler with the forces at the pitch points as unknowns."""

from __future__ import annotations

from math import sqrt, tau

import numpy as np
import numpy.typing as npt

from ....devices.dynamics import reduced as asked
from ....devices.dynamics.reduced import ReducedTrain
from ....devices.dynamics.shafts import G
from ..registry import Values, answers

Reals = npt.NDArray[np.float64]


@answers(ReducedTrain)
def reduced_train(train: ReducedTrain) -> Values:
    """Speeds by rolling, accelerations by the equations of all shafts, equivalents by energy and power."""
    turns = _speeds(train)
    names = list(train.shafts)
    own, moments = np.array([_inertia(train, name) for name in names]), np.array([_moments(train, n) for n in names])
    speeds = np.array([turns[name] for name in names])
    energy = 2 * float(np.sum(own * speeds**2) / 2)  # at ω = 1
    power = moments.T @ speeds
    alphas = _accelerations(train, own, moments[:, 0] - moments[:, 1])
    found: dict[str, complex | float] = {
        asked.ratio_of(name, train.main).key: turns[name] for name in names if name != train.main
    }
    found |= {asked.J_E.key: energy, asked.M_D.key: float(power[0]), asked.M_R.key: float(power[1])}
    found[asked.M_E.key] = float(power[0] - power[1])
    found |= {asked.alpha_of(name).key: alpha for name, alpha in alphas.items()}
    if train.hoist is not None:
        name, shaft = train.hoist
        assert shaft.lifts is not None and shaft.drum is not None
        found[asked.ROPE.key] = shaft.lifts.si * (G + alphas[name] * shaft.drum.si / 2)
    return found | _run(train, alphas[train.main], turns)


def _speeds(train: ReducedTrain) -> dict[str, float]:
    """ω of every shaft at ω = 1: sizes times speeds are equal at every pair, one linear system."""
    names = list(train.shafts)
    rows, right = np.zeros((len(names), len(names))), np.zeros(len(names))
    for row, pair in enumerate(train.pairs):
        rows[row, names.index(pair.first)] = pair.sizes[0]
        rows[row, names.index(pair.second)] = -pair.sizes[1]
    rows[-1, names.index(train.main)] = right[-1] = 1.0
    return dict(zip(names, np.linalg.solve(rows, right).tolist(), strict=True))


def _accelerations(train: ReducedTrain, own: Reals, moments: Reals) -> dict[str, float]:
    """J_i α_i = M_i − Σ ± F r, with r_1 α_1 = r_2 α_2 at every pair."""
    names = list(train.shafts)
    n, m = len(names), len(train.pairs)
    rows, right = np.zeros((n + m, n + m)), np.concatenate([moments, np.zeros(m)])
    rows[:n, :n] = np.diag(own)
    for k, pair in enumerate(train.pairs):
        for name, size, sign in ((pair.first, pair.sizes[0], 1.0), (pair.second, pair.sizes[1], -1.0)):
            rows[names.index(name), n + k] = sign * size
            rows[n + k, names.index(name)] = sign * size
    return dict(zip(names, np.linalg.solve(rows, right)[:n].tolist(), strict=True))


def _inertia(train: ReducedTrain, name: str) -> float:
    shaft = train.shafts[name]
    lifted = shaft.lifts.si * (shaft.drum.si / 2) ** 2 if shaft.lifts and shaft.drum else 0.0
    return float(sum(one.si for one in shaft.J)) + lifted


def _moments(train: ReducedTrain, name: str) -> tuple[float, float]:
    """What drives, and what resists."""
    shaft = train.shafts[name]
    weight = shaft.lifts.si * G * shaft.drum.si / 2 if shaft.lifts and shaft.drum else 0.0
    return (shaft.drives.si if shaft.drives else 0.0), (shaft.resists.si if shaft.resists else 0.0) + weight


def _run(train: ReducedTrain, alpha: float, turns: dict[str, float]) -> dict[str, complex | float]:
    """By work and energy: ω² = ω_0² + 2 α φ."""
    if not train.moves:
        return {}
    first = train.start.si
    if train.after is not None:
        time = train.after.si
        angle = first * time + alpha * time**2 / 2
        last = first + alpha * time
    else:
        assert train.until is not None
        last = train.until.si
        angle = (last**2 - first**2) / (2 * alpha)
        time = (sqrt(first**2 + 2 * alpha * angle) * (1 if last >= 0 else -1) - first) / alpha
    found: dict[str, complex | float] = {asked.TIME.key: time, asked.TURNS.key: angle / tau}
    found |= {asked.omega_of(name).key: ratio * last for name, ratio in turns.items()}
    if train.hoist is not None:
        name, shaft = train.hoist
        assert shaft.drum is not None
        found[asked.LIFT.key] = angle * turns[name] * shaft.drum.si / 2
    return found
