"""One stride of a path, kept on the assembly that it began with.

Newton may land on another assembly where the one that is followed ends within the stride, or bends sharply. A landing
far from where the path pointed is therefore not trusted: the stride is halved, the known links being led evenly from
its one end to the other, until every landing is near; where none of the smallest strides is, the assembly has ended.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..run import wrapped
from ..state import Bodies, Body, Reals
from .loops import Loops

State = NDArray[np.float64]  # (positions ×) links × (x, y, φ)
HALVINGS, FEW = 16, 5  # of a stride of the path; from it to a position beside its end, of which many are asked for
NEAR = 0.003  # of the mechanism's size, and rad: a landing this near to where the path pointed is trusted
BENT, FAR = 0.25, 0.05  # so is one no farther off than a part of the stride's own length, and than this


def stride(loops: Loops, start: State, seed: State, past: Bodies, here: Bodies, halvings: int = HALVINGS) -> State:
    """The assembly at the stride's end (m, rad); NaN where it ends before.

    start: the assembly at its beginning, where the known links stand as in `past`; seed: where the path points to, with
    the known links as in `here`.
    """
    found: State = loops.solve(seed[None], here, start[None], past)[0]
    if points_there(found, start, seed, loops.size):
        return found
    if halvings == 0:
        return found if _apart(found, seed, loops.size) <= FAR else np.full_like(found, np.nan)
    middle = {name: _between(past[name], body) for name, body in here.items()}
    half = stride(loops, start, (start + seed) / 2, past, middle, halvings - 1)
    return half if np.isnan(half).any() else stride(loops, half, 2 * half - start, middle, here, halvings - 1)


def points_there(found: State, start: State, seed: State, size: float) -> NDArray[np.bool_]:
    """Whether what was found lies near where the path pointed (never, where nothing was), for each position."""
    return np.asarray(_apart(found, seed, size) <= np.minimum(FAR, np.maximum(NEAR, BENT * _apart(seed, start, size))))


def _apart(one: State, other: State, size: float) -> Reals:
    """The largest difference of a place (over the mechanism's size) or an angle (rad)."""
    return np.asarray(np.abs((one - other) / np.array([size, size, 1.0])).max(axis=(-2, -1)))


def _between(past: Body, here: Body) -> Body:
    """A known link half-way."""
    turn = None if here.turn is None or past.turn is None else (past.turn + here.turn) / 2
    unit = past.unit * np.exp(0.5j * wrapped(np.angle(here.unit * past.unit.conj())))
    return Body(here.local, (past.at + here.at) / 2, unit, turn)
