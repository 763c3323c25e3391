"""Questions of several kinds at once: motion, forces, centres, pressure angles, equivalents of one mechanism."""

from __future__ import annotations

from vecpoly import loads
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.asked.centres import centre_quantities
from vecpoly.mechanism.asked.forces import quantities
from vecpoly.mechanism.asked.machine import equivalents
from vecpoly.mechanism.asked.pressure import pressure_quantities
from vecpoly.problem.problem import Problem

from ..family import family
from .lawful import acted_upon
from .words import Random, bodies

AT_MOST = 3  # of each kind


def _motion(rng: Random, problem: Problem) -> list[str]:
    mech = problem.mechanism
    turned = [f"{kind}_{mech.number(name)}" for name in mech.numbered for kind in ("omega", "alpha")]
    letters = dict.fromkeys(p for name in bodies(mech) for p in mech.link(name).points if p not in mech.frame)
    return turned + [f"{kind}_{p}" for p in letters for kind in ("p", "v", "a")]


def _kinds(rng: Random, problem: Problem) -> list[list[str]]:
    mech = problem.mechanism
    assert problem.loads is not None
    reduced = [] if mech.drive.between or problem.loads.friction else [equivalents(mech)[0]]
    return [
        _motion(rng, problem),
        list(quantities(mech, problem.loads)),
        list(centre_quantities(mech)),
        list(pressure_quantities(mech)),
        [key for one in reduced for key in (one.inertia.key, one.load.key)],
    ]


@family("mixed-asked", often=1)
def several(rng: Random) -> str:
    """Up to three questions of each of two to four kinds, in any order; velocities by centres in some."""
    while True:
        text = acted_upon(rng)
        try:
            problem = loads(text)
        except VecpolyError:
            continue
        kinds = [kind for kind in _kinds(rng, problem) if kind]
        chosen = [kinds[i] for i in rng.permutation(len(kinds))[: int(rng.integers(2, 5))]]
        keys = [str(key) for kind in chosen for key in rng.permutation(kind)[: int(rng.integers(1, AT_MOST + 1))]]
        method = "method: centres\n" if rng.random() < 0.2 else ""
        return f"{text}{method}find: [{', '.join(map(str, rng.permutation(keys)))}]\n"
