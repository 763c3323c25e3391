"""Which links and points of a mechanism a course report tells of."""

from __future__ import annotations

import numpy as np

from ...cycle import Cycle
from ...mechanism.groups.assur import hinges
from ...mechanism.model import FRAME
from ...names import Rel
from ...problem.asked.asks import AskPoint
from ...problem.problem import Problem

MOST_POINTS = 2  # whose paths and curves are shown
STILL = 1e-9  # a rate, or a share of a column's size: below, it does not move


def links_told(problem: Problem, turn: Cycle) -> tuple[str, ...]:
    """Driven links that turn, and not as the drive does; of those that turn together the one asked for, or the last."""
    asked = {ask.rel.to.link for ask in problem.asks if isinstance(ask.rel, Rel) and not ask.rel.is_vector}
    rates = {name: turn.real(f"omega_{name}") for name in turn.mech.numbered}
    found: list[str] = []
    for name, rate in rates.items():
        if name == turn.mech.drive.link or not np.nanmax(np.abs(rate), initial=0.0) > STILL:
            continue
        alike = (other for other in found if np.allclose(rates[other], rate, rtol=1e-9, atol=1e-12, equal_nan=True))
        twin = next(alike, None)
        if twin is None:
            found.append(name)
        elif name in asked or twin not in asked:
            found[found.index(twin)] = name
    drive = turn.real(f"omega_{turn.mech.drive.link}")
    return tuple(name for name in found if not np.allclose(rates[name], drive, equal_nan=True))


def points_told(problem: Problem, whole: Cycle) -> tuple[str, ...]:
    """The letters asked for (else all that move), those before that are not bound to circles about a frame pivot;
    at most two."""
    mech = whole.mech
    pinned = {name for names in hinges(mech).values() if FRAME in names for name in names}
    circling = {letter for name in pinned for letter in mech.link(name).points}
    driven = set(mech.link(mech.drive.link).points)
    moving = [c.key[2:] for c in whole.columns if c.key.startswith("p_") and c.key[2:] not in driven]
    sought = [
        ask.rel.to.point + ask.rel.to.link
        for ask in problem.asks
        if isinstance(ask.rel, Rel) and not isinstance(ask, AskPoint) and ask.rel.is_vector and ask.rel.ref is None
    ]
    asked = [letter for letter in dict.fromkeys(sought) if letter in moving]
    free = [letter for letter in asked or moving[-1:] if letter not in circling]
    return tuple(free[-MOST_POINTS:] or asked[-1:] or moving[-1:] or sorted(driven - set(mech.frame))[-1:])
