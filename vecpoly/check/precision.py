"""How many digits an exact value still has: near a change point rounding is magnified until nothing is left of it.

The oracle is asked again with every length, every fixed point and the input moved by a few units in the last place, at random:
no one can tell these data from the given ones. What its answers then scatter by is what they may be off by.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from math import floor, isnan, log10

import numpy as np

from ..devices.base import Device
from ..errors import DeadPointError, VecpolyError
from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..words import Words
from .exact import Exact, Values

LAST_PLACES = 1e-15  # relative: a few units in the last place of a double
TRIALS = 4
FEWEST = 3  # digits with which a value is still an answer
PLENTY = 7  # digits of which nothing need be said


def sizes(problem: Problem, values: Values) -> dict[str, float]:
    """Key → how large such quantities are here: the largest of its unit, or what the data alone make likely."""
    units = {ask.rel.key: ask.rel.unit for ask in problem.asks}
    likely = {} if isinstance(problem.subject, Device) else natural(problem)
    largest: dict[str, float] = {}
    for key, value in values.items():
        if isnan(abs(value)):
            continue  # 0/0
        largest[units[key]] = max(abs(value), largest.get(units[key], likely.get(units[key], 0.0)))
    return {key: largest.get(units[key]) or 1.0 for key in values}


def natural(problem: Problem) -> dict[str, float]:
    """Unit → size that the data make likely, whatever the position."""
    drive, long = problem.mechanism.drive, problem.mechanism.scale
    rate = abs(drive.rate) / (long if drive.slide else 1.0)
    accel = rate**2 + abs(drive.accel) / (long if drive.slide else 1.0)
    force = _largest_force(problem.loads, long) if problem.loads else 0.0
    return {"m": long, "m/s": rate * long, "m/s^2": accel * long, "rad/s": rate, "rad/s^2": accel, "N": force, "N·m": force * long}


def _largest_force(loads: Loads, long: float) -> float:
    """The largest given force; a moment as the force that it makes with the mechanism's size as its arm (N)."""
    return max((*(abs(one.size or 0.0) for one in loads.forces), *(abs(one.size or 0.0) / long for one in loads.moments)), default=0.0)


def noise(problem: Problem, truth: Exact, size: Mapping[str, float]) -> dict[str, float]:
    """Key → what the exact value may be off by.

    Raises DeadPointError where a value keeps fewer than FEWEST digits.
    """
    if isinstance(problem.subject, Device):
        return dict.fromkeys(truth.values, 0.0)
    found = {key: _scatter(key, value, _nearby(problem)) for key, value in truth.values.items()}
    for key, off in found.items():
        if off > size[key] * 10.0**-FEWEST:
            raise _lost(key, off, size[key])
    return found


def digits(noise: float, size: float) -> int:
    """How many digits a value of this size keeps."""
    return 15 if noise == 0 else max(0, min(15, floor(-log10(noise / size))))


def _scatter(key: str, value: complex | float, near: tuple[Values, ...]) -> float:
    """The farthest from the exact value that the nudged data bring it; nothing where it is 0/0."""
    return 0.0 if isnan(abs(value)) else max((abs(values[key] - value) for values in near if key in values), default=0.0)


@lru_cache(maxsize=512)
def _nearby(problem: Problem) -> tuple[Values, ...]:
    """The exact values with nudged data: the same whatever hand draws the problem, so they are found once."""
    rng = np.random.default_rng(0)
    nudges = [replace(problem, subject=nudged(problem.mechanism, rng)) for _ in range(TRIALS)]
    return tuple(values for one in nudges if (values := _values(one)) is not None)


def nudged(mech: Mechanism, rng: np.random.Generator) -> Mechanism:
    """The mechanism with lengths, fixed points and input moved by a few units in the last place."""
    def moved(number: complex) -> complex:
        return complex(number.real * _near_one(rng), number.imag * _near_one(rng))

    links = tuple(replace(link, points={letter: at * _near_one(rng) for letter, at in link.points.items()}) for link in mech.links)
    drives = tuple(replace(drive, position=drive.position * _near_one(rng)) for drive in mech.drives)
    starts = tuple(replace(start, value=start.value * _near_one(rng)) for start in mech.starts)
    return replace(mech, links=links, drives=drives, starts=starts, frame={letter: moved(at) for letter, at in mech.frame.items()})


def _near_one(rng: np.random.Generator) -> float:
    return 1.0 + LAST_PLACES * rng.uniform(-1.0, 1.0)


def _values(problem: Problem) -> Values | None:
    """The exact values; None where the end of a range lies within the nudge."""
    try:
        return Exact(problem).values
    except VecpolyError:
        return None


def _lost(key: str, off: float, size: float) -> DeadPointError:
    left = digits(off, size)
    return DeadPointError(Words(
        f"{key}：机构离死点（或变点）太近，舍入误差被放大到 ±{off:.2g}，而此类量的大小为 {size:.2g}，只剩 {left} 位有效数字；请改取原动件的其他位置",
        f"{key}: the mechanism is so near to a dead point (or change point) that rounding alone makes ±{off:.2g} of a quantity of about {size:.2g}: "
        f"{left} digits are left; choose another position of the input",
    ), code="precision.lost", numbers={"noise": off, "size": size, "digits": left})
