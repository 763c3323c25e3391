"""Whole-cycle dynamics of a six-bar: J_e, dJ_e/dφ and M_e at 3,601 positions, beside the kinematics alone."""

from __future__ import annotations

import numpy as np

from vecpoly.mechanism.loads import Loads
from vecpoly.mechanism.machine import known_of
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import Motion, solve
from vecpoly.oracle.machine import Reduced, reduce
from vecpoly.problem.load import load

from .timing import best

POSITIONS = np.linspace(0.0, 2 * np.pi, 3601)


def dynamics(mech: Mechanism, acting: Loads) -> Reduced:
    """The equivalent link at every position, with all its answers."""
    found = reduce(mech, acting, POSITIONS)
    for answer in (found.energy, found.rate, found.power):
        assert np.isfinite(answer).all()
    return found


def kinematics(mech: Mechanism) -> Motion:
    """Places, velocities and accelerations of all links."""
    return solve(mech, POSITIONS)


def run() -> str:
    """Time both in turn: one line of the report."""
    problem = load("six-bar-dynamic")
    assert problem.loads is not None
    mech, acting = problem.mechanism, known_of(problem.loads)
    whole, motion = best(lambda: dynamics(mech, acting), lambda: kinematics(mech), runs=60)
    return (
        f"equivalent link of a six-bar, {len(POSITIONS)} positions: {1e3 * whole:.2f} ms = {whole / motion:.2f} × its "
        f"kinematics ({1e3 * motion:.2f} ms), aim ≤ 3"
    )


if __name__ == "__main__":
    print(run())
