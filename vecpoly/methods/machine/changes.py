"""Where on the drive's way a load begins or ends to act, and where its table turns a corner: tried on scratch paper.

Between two places that differ the way is parted, in halves or, where many places are drawn at once, in as many parts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from itertools import pairwise

import numpy as np

from ...board.hand import hand
from ...mechanism.laws.acting import acts, stretch
from ...mechanism.laws.sizes import Table
from ...mechanism.loads import Loads
from ...mechanism.model import Mechanism
from ...plane import Reals
from ..desk import Desk
from ..forces.laws.off_paper import OffPaper
from .turn import at_once, desk_at

JUMP = 1e-12  # rad: how closely the place of a change is found
MOST = 8  # changes between two places that are looked at
PARTS = 16  # of the way between two places, drawn at once
TOGETHER = 6  # even places that are drawn at once
State = tuple[float, ...]
Seen = Callable[[Desk, Loads], tuple[Reals, ...]]
States = Callable[[Sequence[float]], list[State]]


def jumps(mech: Mechanism, loads: Loads, places: Sequence[float]) -> tuple[float, ...]:
    """Where a load begins or ends to act between these places."""
    windows = any(load.law is not None and load.law.windows for load in loads.all)
    return _changes(partial(_states, mech, loads, _acting), places, _parts(mech)) if windows else ()


def bends(mech: Mechanism, loads: Loads, places: Sequence[float]) -> tuple[float, ...]:
    """Where the table of a load over a travel turns a corner, likewise."""
    sizes = (load.law.size for load in loads.all if load.law is not None)
    travels = any(isinstance(size, Table) and size.over is not None for size in sizes)
    return _changes(partial(_states, mech, loads, _stretches), places, _parts(mech)) if travels else ()


def _parts(mech: Mechanism) -> int:
    """In how many the way between two places is parted: in halves where each is drawn alone."""
    return 2 if mech.starts or mech.cams else PARTS


def _acting(desk: Desk, loads: Loads) -> tuple[Reals, ...]:
    at = OffPaper(desk)
    return tuple(acts(load, at) for load in loads.all if load.law is not None)


def _stretches(desk: Desk, loads: Loads) -> tuple[Reals, ...]:
    at, tables = OffPaper(desk), [load.law.size for load in loads.all if load.law is not None]
    return tuple(one for table in tables if isinstance(table, Table) for one in stretch(table, at))


def _states(mech: Mechanism, loads: Loads, seen: Seen, places: Sequence[float]) -> list[State]:
    """What is seen in each of these places."""
    parted = [places[k : k + TOGETHER] for k in range(0, len(places), TOGETHER)]
    return [state for part in parted for state in _seen(mech, loads, seen, part)]


def _seen(mech: Mechanism, loads: Loads, seen: Seen, places: Sequence[float]) -> list[State]:
    desk = at_once(mech, places) if len(places) > 1 else None
    if desk is None:
        return [tuple(map(float, seen(desk_at(mech, phi, hand("exact")), loads))) for phi in places]
    found = [np.broadcast_to(one, len(places)) for one in seen(desk, loads)]
    return [tuple(map(float, state)) for state in zip(*found, strict=True)]


def _changes(states: States, places: Sequence[float], parts: int) -> tuple[float, ...]:
    """Where something changes between the first and the last of these places."""
    found = []
    for (low, here), (high, end) in pairwise(zip(places, states(places), strict=True)):
        for _ in range(MOST):  # of several changes one at a time
            if here == end:
                break
            low, here = _narrowed(partial(_within, states, parts), low, high, here, end)
            found.append(low)
    return tuple(one for one in found if places[0] < one < places[-1])


def _within(states: States, parts: int, a: float, b: float) -> list[tuple[float, State]]:
    """Places between two others, and what is seen there."""
    inner = [float(x) for x in np.linspace(a, b, parts + 1)[1:-1]]
    return list(zip(inner, states(inner), strict=True))


def _narrowed(
    within: Callable[[float, float], list[tuple[float, State]]], a: float, b: float, here: State, there: State
) -> tuple[float, State]:
    """The first place behind a change, and what is seen there."""
    while b - a > JUMP:
        along = [(a, here), *within(a, b), (b, there)]
        k = next(k for k, (_, state) in enumerate(along) if state != here)
        (a, _), (b, there) = along[k - 1], along[k]
    return b, there
