"""Statements drawn at random among those that are true at the given position, and tell both assemblies apart there.

Elsewhere many of them do not hold: a statement is read at the given position only.
"""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import permutations

import numpy as np

from vecpoly import loads, oracle
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.assembly.branch import margin, opposite
from vecpoly.mechanism.model import Mechanism, Side, SideOf
from vecpoly.problem.problem import Problem

SURE = 2e-3  # m


class Untold(Exception):
    """Nothing tells both assemblies apart at this position: take another mechanism."""


def restated(rng: np.random.Generator, text: str) -> str:
    """The same problem, each of its statements about a hinge replaced by another that means the same here.

    Raises Untold.
    """
    try:
        problem = loads(text + "find: [omega_2]\n")
        assert isinstance(problem, Problem)
        mech = problem.mechanism
        here = _places(mech)
        told = [_another(rng, mech, here, k) for k in range(len(mech.branches))]
    except VecpolyError:
        raise Untold from None
    return re.sub(r"^branch:.*$", f"branch: [{', '.join(map(str, told))}]", text, flags=re.MULTILINE)


def _another(rng: np.random.Generator, mech: Mechanism, here: dict[str, complex], k: int) -> SideOf:
    one = mech.branches[k]
    assert isinstance(one, SideOf)
    flipped = tuple(opposite(b) if b is one else b for b in mech.branches[: k + 1])
    there = _places(replace(mech, branches=(*flipped, *mech.branches[k + 1 :])))
    known = [p for p in here if abs(here[p] - there[p]) < 1e-9]
    found = [s for s in _said(one.point, known) if margin(s, here) > SURE and margin(s, there) < -SURE]
    if not found:
        raise Untold
    return found[int(rng.integers(len(found)))]


def _said(point: str, known: list[str]) -> list[SideOf]:
    single = [SideOf(point=point, side=side, ref=(ref,)) for ref in known for side in Side]
    pairs = list(permutations(known, 2))
    sides = [SideOf(point=point, side=side, ref=ref) for ref in pairs for side in Side]
    return [*single, *sides]


def _places(mech: Mechanism) -> dict[str, complex]:
    motion = oracle.solve(mech, order=0)
    letters = {letter for link in mech.links for letter in link.points}
    return dict(mech.frame) | {letter: complex(motion.position(letter)) for letter in sorted(letters)}
