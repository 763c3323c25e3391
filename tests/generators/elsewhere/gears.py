"""Mechanisms whose gears, arms and racks are told in their own position: followed on paper, they roll on."""

from __future__ import annotations

import numpy as np

from vecpoly.errors import VecpolyError
from vecpoly.methods.positions.following import follower
from vecpoly.oracle import solve
from vecpoly.solution import Solution

from ..family import families, family

SAME = 1e-8  # of the mechanism's size
TURN, TRAVEL = 2.6 * np.pi, 0.3  # to both sides: rad, or of the mechanism's size


def as_rolled(solution: Solution) -> str:
    """Every letter lies where the oracle has it, as far as the mechanism can be followed to either side."""
    mech = solution.problem.mechanism
    far = TRAVEL * mech.scale if mech.drive.slide else TURN
    places = mech.drive.position + np.linspace(-far, far, 13)
    motion, one = solve(mech, places, order=0, strict=False), follower(mech)
    letters = [p for link in mech.links for p in link.points]
    exact = {p: np.broadcast_to(motion.position(p), places.shape) for p in letters}
    for k, place in enumerate(places):
        try:
            drawn = one.at(place).places
        except VecpolyError:
            continue
        off = max(abs(drawn[p] - exact[p][k]) for p in letters)
        if off > SAME * mech.scale:
            return f"at {place:.4g} a letter is followed {1e3 * off:.3g} mm off"
    return ""


@family("elsewhere-gears", also=as_rolled, often=2)
def gears(rng: np.random.Generator) -> str:
    """Any of the mechanisms with gears and racks."""
    made = [one for one in families() if one.name.startswith("gears-")]
    return made[int(rng.integers(len(made)))].make(rng)
