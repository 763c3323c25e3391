"""After how many turns of the drive all is as it was: more than one where a wheel turns what a wheel moves, or where a
change point leads on into the other assembly."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import combinations
from math import lcm

import numpy as np

from ....errors import EquilibriumError
from ....mechanism.loads import Loads
from ....mechanism.model import FRAME, Circle, Link, Mechanism, Rolling
from ....words import Words
from ...state import Points, Reals
from .drives import drive_range

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
    likely = list(filter(_wheels_are_back(mech), range(1, MOST + 1)))
    first = _places(mech, low + WITHIN) if likely else np.zeros(0)
    for count in likely:  # one after the other: far turns are dear
        off = np.abs(_places(mech, low + WITHIN + 2 * np.pi * count) - first)
        if np.nanmax(off, initial=0.0) <= SAME * mech.scale:
            return count
    raise EquilibriumError(_elsewhere(mech), code="no-period")


def over_a_period(mech: Mechanism, steps: int) -> Reals:
    """The drive's range (rad, or m) in so many steps; one that goes right round, over as many turns as the letters need
    to come back, each in so many."""
    low, high, whole = drive_range(mech)
    count = laps(mech, low) if whole else 1
    return np.linspace(low, low + count * (high - low), count * steps + 1)


def _wheels_are_back(mech: Mechanism) -> Callable[[int], bool]:
    """Whether, after so many turns of the drive, every wheel is as it was whose turns the ratios alone tell."""
    reaches = [(_reach(mech.link(name)), turns) for name, turns in _turns(mech).items() if name != FRAME]
    return lambda count: all(
        reach * abs(np.exp(2j * np.pi * count * turns) - 1) <= SAME * mech.scale for reach, turns in reaches
    )


def _reach(wheel: Link) -> float:
    """How far apart two of its points are at most (m)."""
    return max((abs(one - other) for one, other in combinations(wheel.points.values(), 2)), default=0.0)


def _turns(mech: Mechanism) -> dict[str, float]:
    """Turns per turn of the drive, of the links to which they pass from gear to gear: on an arm that is known
    i = (n_2 − n_H)/(n_1 − n_H) = ∓r_1/r_2."""
    if mech.drive.between or mech.drive.slide:
        return {}
    turns, pairs = {FRAME: 0.0, mech.drive.link: 1.0}, list(_pairs_on_arms(mech))
    for _ in pairs:
        for one, other, arm, ratio in pairs:
            if one in turns and arm in turns:
                turns.setdefault(other, turns[arm] + (turns[one] - turns[arm]) * ratio)
    return turns


def _pairs_on_arms(mech: Mechanism) -> Iterator[tuple[str, str, str, float]]:
    """Two gears, either way round, the link or the frame that holds both centres, and the turns of the second beside
    it per turn of the first."""
    held = {FRAME: set(mech.frame)} | {link.name: set(link.points) for link in mech.links}
    for pair in mech.joints:
        if isinstance(pair, Rolling) and isinstance(pair.on, Circle):
            ratio = pair.gear.radius / pair.on.radius * (1 if pair.internal else -1)
            for arm in (name for name, letters in held.items() if {pair.gear.centre, pair.on.centre} <= letters):
                yield pair.gear.link, pair.on.link, arm, ratio
                yield pair.on.link, pair.gear.link, arm, 1 / ratio


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
