"""After how many turns of the drive the mechanism is back where it was: more than one where a gear turns what a gear
moves, or where a change point leads on into the other assembly."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ...errors import NoMethodError
from ...mechanism.model import Mechanism
from ...words import Words
from .following import Follower, follower

MOST = 6  # turns that are drawn
BEYOND = (0.0, 0.7)  # rad from the own position: no two assemblies meet at both
SAME = 1e-6  # of the mechanism's size


@lru_cache(maxsize=64)
def laps(mech: Mechanism) -> int:
    """As it is followed. Raises NoMethodError where it is never back in so many turns as are drawn, AssemblyError,
    DeadPointError where the way round ends."""
    one = follower(mech)
    for count in range(1, MOST + 1):
        if all(_gap(one, way, count) < SAME * mech.scale for way in BEYOND):
            return count
    raise NoMethodError(
        Words(
            f"原动件转 {MOST} 周以内机构没有回到原处，周期太长，不能逐点作图；请用 vecpoly exact",
            f"within {MOST} turns of the drive the mechanism is not back where it was: its period is too long to be "
            "drawn place by place; use 'vecpoly exact'",
        ),
        code="no-method",
    )


def _gap(one: Follower, way: float, count: int) -> float:
    """How far the letters are from where they were, so many turns before (m)."""
    own = one.mech.drive.position + way
    first, last = one.at(own).places, one.at(own + 2 * np.pi * count).places
    return max((abs(last[letter] - at) for letter, at in first.items()), default=0.0)
