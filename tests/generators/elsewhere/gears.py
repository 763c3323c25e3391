"""Mechanisms whose gears, arms, racks or profiles are told in their own position: on paper gears roll on from there,
and another disc takes the place of a profile."""

from __future__ import annotations

import numpy as np

from vecpoly.errors import VecpolyError
from vecpoly.methods.exchange.profile import osculated
from vecpoly.methods.positions.following import follower
from vecpoly.oracle import solve
from vecpoly.solution import Solution

from ..family import families, family
from ..plate_cams import followed, hung_on

SAME = 1e-8  # of the mechanism's size
TURN, TRAVEL = 2.6 * np.pi, 0.3  # to both sides: rad, or of the mechanism's size


def as_rolled(solution: Solution) -> str:
    """Every letter lies where the oracle has it, as far as the mechanism can be followed to either side."""
    mech = solution.problem.mechanism
    far = TRAVEL * mech.scale if mech.drive.slide else TURN
    places = mech.drive.position + np.linspace(-far, far, 13)
    motion, one = solve(mech, places, order=0, strict=False), follower(osculated(mech)[0])
    centres = {profile.centre for profile in mech.cams}  # each of another disc
    letters = [p for link in mech.links for p in link.points if p not in centres]
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


@family("elsewhere-gears", also=as_rolled, often=1, first=7)
def gears(rng: np.random.Generator) -> str:
    """Any of the mechanisms with gears and racks."""
    return _of_any(rng, "gears-")


@family("elsewhere-plate-cams", also=as_rolled, often=1)
def cams(rng: np.random.Generator) -> str:
    """A plate cam, alone or with a rocker on its follower's tip."""
    return _of_any(rng, "plate cam")


def _of_any(rng: np.random.Generator, name: str) -> str:
    made = [one for one in families() if one.name.startswith(name)]
    return made[int(rng.integers(len(made)))].make(rng)


@family("elsewhere-plate-cam-machine", often=1, first=2)
def cam_machine(rng: np.random.Generator) -> str:
    """The period of a machine that a plate cam drives: a load on what hangs on the follower, in part of its motion."""
    text = hung_on(*followed(rng), side=float(rng.choice([-1, 1])))
    acts = str(rng.choice(["", ", while: B moves along 90 deg", f", during: [{rng.integers(0, 170)} deg, 200 deg]"]))
    loads = (
        "masses: {7: {mass: 1 kg, inertia: 0.002 kg*m^2, centre: B}}\n"
        f"loads:\n  Q: {{on: 7, at: C, size: {rng.integers(90, 900)} N, direction: {rng.integers(0, 360)} deg{acts}}}\n"
        "  M_c: {on: 1, size: constant}\nmachine: {n: 100 r/min, delta: 0.05}\n"
    )
    return f"{text.split('find:')[0]}{loads}find: [M_c, dW_max, J_F]\n"
