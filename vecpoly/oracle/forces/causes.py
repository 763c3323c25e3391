"""Why there is no equilibrium at a position."""

from __future__ import annotations

from enum import IntEnum


class Cause(IntEnum):
    """What stands in the way at a position that has no answer; NONE where there is one."""

    NONE = 0
    IDLE = 1  # the balancing load does no work
    SENSELESS = 2  # a pair with friction has no relative motion: friction has no sense
    UNSOLVED = 3  # no single solution: a dead point, a link held twice, or nothing can be assembled
    LOCKED = 4  # self-locking: the driving loads do not overcome the friction
    BOUND = 5  # self-locking: the balancing load, however large, does not
    PARTING = 6  # a contact would have to pull
