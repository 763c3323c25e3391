"""One stride of a path, kept on the assembly that it began with.

Newton may land on another assembly where the one that is followed ends within the stride, or bends sharply. A landing
far from where the path pointed is therefore not trusted: the stride is halved, the known links being led evenly from
its one end to the other, until every landing is near; where none of the smallest strides is, the assembly has ended.
"""

from __future__ import annotations

from bisect import bisect

import numpy as np
from numpy.typing import NDArray

from ...foundation.slotted import dataclass
from ..run import wrapped
from ..state import Bodies, Body, Reals
from .loops import Loops

State = NDArray[np.float64]  # (positions ×) links × (x, y, φ)
HALVINGS = 16
NEAR = 0.003  # of the mechanism's size, and rad: a landing this near to where the path pointed is trusted
BENT, FAR = 0.25, 0.05  # so is one no farther off than a part of the stride's own length, and than this


@dataclass(frozen=True, slots=True)
class Strode:
    """Where smaller and smaller strides led within one of the path: shares of it (0 to 1), and the states there; the
    last share is 1 where the assembly does not end within."""

    shares: tuple[float, ...]
    states: tuple[State, ...]

    @property
    def end(self) -> State:
        """At the end of the whole stride; NaN where the assembly ends before."""
        return self.states[-1] if self.shares[-1] == 1.0 else np.full_like(self.states[-1], np.nan)

    def before(self, share: float) -> tuple[float, State, State]:
        """The share reached before this one, the state there, and where the path points to from there."""
        at = bisect(self.shares, share) - 1
        if at + 1 == len(self.shares):
            return self.shares[at], self.states[at], self.states[at]
        along = (share - self.shares[at]) / (self.shares[at + 1] - self.shares[at])
        return self.shares[at], self.states[at], self.states[at] + along * (self.states[at + 1] - self.states[at])


def stride(loops: Loops, start: State, seed: State, past: Bodies, here: Bodies) -> Strode:
    """The strides from `start`, where the known links stand as in `past`, to where they stand as in `here`; seed: where
    the path points to."""
    shares, states, aims = [0.0], [start], [(1.0, seed)]
    while aims:
        share, aim = aims[-1]
        ago, now = (between(past, here, at) for at in (shares[-1], share))
        found: State = loops.solve(aim[None], now, states[-1][None], ago)[0]
        if points_there(found, states[-1], aim, loops.size):
            aims.pop()
            if aims:
                onward = (aims[-1][0] - share) / (share - shares[-1])
                aims[-1] = aims[-1][0], found + onward * (found - states[-1])
            shares.append(share)
            states.append(found)
        elif share - shares[-1] > 0.5**HALVINGS:
            aims.append(((shares[-1] + share) / 2, (states[-1] + aim) / 2))
        else:
            break
    return Strode(tuple(shares), tuple(states))


def reached(loops: Loops, strode: Strode, share: float, ends: tuple[Bodies, Bodies], here: Bodies) -> State:
    """The assembly within such a stride, where the known links stand as in `here`; NaN where it has ended before.
    ends: the known links where the stride begins and where it ends."""
    before, start, aim = strode.before(share)
    found: State = loops.solve(aim[None], here, start[None], between(*ends, before))[0]
    return found if _apart(found, aim, loops.size) <= FAR else np.full_like(found, np.nan)


def points_there(found: State, start: State, seed: State, size: float) -> NDArray[np.bool_]:
    """Whether what was found lies near where the path pointed (never, where nothing was), for each position."""
    return np.asarray(_apart(found, seed, size) <= np.minimum(FAR, np.maximum(NEAR, BENT * _apart(seed, start, size))))


def _apart(one: State, other: State, size: float) -> Reals:
    """The largest difference of a place (over the mechanism's size) or an angle (rad)."""
    return np.asarray(np.abs((one - other) / np.array([size, size, 1.0])).max(axis=(-2, -1)))


def between(past: Bodies, here: Bodies, share: float) -> Bodies:
    """The known links, led evenly by this share of the way."""
    if share in (0.0, 1.0):
        return here if share else past
    return {name: _between(past[name], body, share) for name, body in here.items()}


def _between(past: Body, here: Body, share: float) -> Body:
    turn = None if here.turn is None or past.turn is None else past.turn + share * (here.turn - past.turn)
    unit = past.unit * np.exp(1j * share * wrapped(np.angle(here.unit * past.unit.conj())))
    return Body(here.local, past.at + share * (here.at - past.at), unit, turn)
