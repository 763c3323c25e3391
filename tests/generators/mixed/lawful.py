"""Loads that depend on place and speed in every form of joint and drive, with masses and friction in every wording."""

from __future__ import annotations

from dataclasses import replace

from vecpoly.errors import VecpolyError
from vecpoly.solution import Solution

from ..acting.laws import Unsure, _plain
from ..crossed import balancing, moving, told
from ..family import family
from ..moving import Moving
from ..powers import loaded
from .words import Random, lawful, masses, otherwise, rubbing


def by_hand(solution: Solution) -> str:
    """Equilibrium, or the sum of all powers, with sizes found from central differences of positions."""
    problem = solution.problem
    assert problem.loads is not None
    try:
        plain = _plain(Moving.of(problem.mechanism), problem.loads)
    except (VecpolyError, Unsure):
        return ""
    return told(replace(solution, problem=replace(problem, loads=plain)))


def acted_upon(rng: Random) -> str:
    """Any member of the families of motion, with one or two loads by laws, masses in half, friction in a third."""
    text, mech = moving(rng)
    free = balancing(rng, mech, piston="piston" in text)
    laws = "".join(lawful(rng, mech, f"w{i}") for i in range(int(rng.integers(1, 3))))
    whole = loaded(rng, otherwise(rng, text), laws + free, find="")
    whole += masses(rng, mech, text) if rng.random() < 0.5 else ""
    return whole + (rubbing(rng, mech) if rng.random() < 0.35 else "")


@family("mixed-laws", also=by_hand, often=1)
def under_laws(rng: Random) -> str:
    """Nothing is asked by name: the balancing load, and one reaction of each pair."""
    return acted_upon(rng)
