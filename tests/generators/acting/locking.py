"""Friction up to near self-locking: all radii and angles of a random problem are raised together to a share of what
locks it.

What locks it is found by bisection with the exact equilibrium; from 40 % to 99.5 % of that the mechanism moves, and the
drawing has to find the same forces.
"""

from __future__ import annotations

import re
from math import atan, degrees, radians, tan

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import Check, Make, family
from ..forces import with_friction as of_any_groups
from ..higher_groups import by_special_points_with_friction
from ..higher_groups import with_friction as of_class_iii
from ..judge import moves
from ..owners import rubbing as of_owners
from ..powers import every_reaction
from ..slots import rubbing as of_slots
from ..toothed import teeth_press
from ..toothed import with_friction as of_gears

HALVINGS = 12
MOST = 60.0  # times the friction that the generator gives


def times(text: str, factor: float) -> str:
    """The problem with all its friction raised: ρ and tan φ."""
    head, found, tail = text.partition("friction:\n")
    steeper = re.sub(r"phi: ([\d.]+) deg", lambda m: f"phi: {_steeper(float(m[1]), factor):.7g} deg", tail)
    return head + found + re.sub(r"rho: ([\d.]+) mm", lambda m: f"rho: {float(m[1]) * factor:.7g} mm", steeper)


def _steeper(phi: float, factor: float) -> float:
    return degrees(atan(factor * tan(radians(phi))))


def nearly_locked(rng: np.random.Generator, text: str) -> str:
    """The friction at a share of the least at which nothing moves any more, or the file is refused."""
    share = 1 - 10 ** float(rng.uniform(-2.3, -0.22))
    if "friction:" not in text or not moves(text):
        return text
    low, high = 1.0, MOST
    for _ in range(HALVINGS):
        middle = float(np.sqrt(low * high))
        low, high = (middle, high) if moves(times(text, middle)) else (low, middle)
    return times(text, share * low)


def _registered(name: str, make: Make, also: Check = in_equilibrium, first: int = 0) -> None:
    @family(f"near-locking-{name}", also=also, often=1, first=first)
    def one(rng: np.random.Generator) -> str:
        return nearly_locked(rng, make(rng))


_registered("groups", of_any_groups)
_registered("owners", of_owners)
_registered("slots", of_slots)
_registered("gears", of_gears, teeth_press)
_registered("class-iii", of_class_iii, every_reaction, first=2)  # those before it are dear, or refused
_registered("special-points", by_special_points_with_friction, every_reaction)
