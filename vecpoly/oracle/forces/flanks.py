"""Which flank of the teeth works at each position: the one on which the gear is pressed as it must be.

Teeth press along the line of action, which leans by α to one side or the other of the common tangent: F_t across the
line of centres, and |F_t| tan α along it. The sign of F_t is found without α, which changes no F_t where nothing rubs;
with friction it is tried until it reproduces itself.
"""

from __future__ import annotations

import numpy as np

from ..state import Reals
from .elimination import Flags
from .system import ROUNDING, Balance, System

ROUNDS = 8
Found = tuple[Balance, Balance, Reals]


def solved(system: System, skip: Flags) -> Found:
    """Without friction, with it, and the share of the friction that could be borne: 0 where no flank settles."""
    dry, wet, reached = system.solve(skip)
    if all(pair.apart is None for pair in system.pairs):
        return dry, wet, reached
    signs = _signs(system, dry, {})
    dry, wet, reached = system.solve(skip, signs)
    changed: Flags = np.zeros(system.count, bool)
    for _ in range(ROUNDS):
        pressed = _signs(system, wet, signs)
        changed = np.any([signs[n] != pressed[n] for n in signs], axis=0)
        if not changed.any():
            break
        signs = pressed
        _, wet, reached = system.solve(skip, signs)
    return dry, wet, np.where(changed, 0.0, reached)


def _signs(system: System, found: Balance, before: dict[int, Reals]) -> dict[int, Reals]:
    """The sign of F_t of every pair of teeth; where a force is nothing but rounding, as it was before."""
    least = ROUNDING * found.largest
    return {
        n: np.where(np.abs(found.units[n][0]) <= least, before.get(n, 1.0), np.where(found.units[n][0] < 0, -1.0, 1.0))
        for n, pair in enumerate(system.pairs)
        if pair.apart is not None
    }
