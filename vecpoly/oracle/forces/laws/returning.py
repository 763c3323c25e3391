"""After how many turns of the drive all is as it was: more than one where a wheel turns what a wheel moves, or where a
change point leads on into the other assembly."""

from __future__ import annotations

from functools import lru_cache
from math import lcm

import numpy as np

from ....errors import EquilibriumError
from ....mechanism.loads import Loads
from ....mechanism.model import Mechanism
from ....words import Words
from ...state import Points, Reals

MOST = 60  # turns of the drive among which the period is sought
WITHIN = 2 * np.pi * np.modf(np.sqrt([2.0, 3.0, 5.0, 7.0]))[0]  # rad behind the beginning: no round angles
SAME = 1e-6  # of the mechanism's scale


def turns_of(mech: Mechanism, loads: Loads, low: float) -> int:
    """Turns of a drive that goes right round (from `low`, rad) after which mechanism and loads are what they were.

    Raises EquilibriumError where there are none.
    """
    return lcm(loads.turns, laps(mech, low))


@lru_cache(maxsize=64)
def laps(mech: Mechanism, low: float) -> int:
    """After how many turns every letter is where it was; raises EquilibriumError where it is never."""
    first = _places(mech, low + WITHIN)
    for count in range(1, MOST + 1):  # one after the other: far turns are dear
        off = np.abs(_places(mech, low + WITHIN + 2 * np.pi * count) - first)
        if np.nanmax(off, initial=0.0) <= SAME * mech.scale:
            return count
    raise EquilibriumError(_elsewhere(mech), code="no-period")


def _places(mech: Mechanism, q: Reals) -> Points:
    """Where every letter of the moving links is: letters × positions."""
    from ... import solve

    bodies = solve(mech, q, order=0, strict=False).bodies
    rows = [bodies[name].point(local) for name in mech.bodies for local in mech.link(name).points.values()]
    return np.array([np.broadcast_to(row, q.shape) for row in rows], np.complex128).reshape(len(rows), len(q))


def _elsewhere(mech: Mechanism) -> Words:
    link = mech.drive.link
    return Words(
        f"原动件 {link} 转 {MOST} 周以内机构都没有回到原处（齿轮传动比不是小整数之比），没有周期；"
        "请以转一周即复原的构件为 input，如曲柄所在的齿轮",
        f"within {MOST} turns of the drive {link} the mechanism is never back where it was (a ratio of gears that is "
        "none of small whole numbers), and there is no period; take as input a link after whose turn all is as it was, "
        "such as the wheel that bears the crank",
    )
