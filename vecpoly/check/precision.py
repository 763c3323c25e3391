"""How many digits an exact value still has: near a change point rounding is magnified until nothing is left of it.

The oracle is asked again with every length, every fixed point and the input, or with all data of a design, moved by a
few units in the last place, at random: no one can tell these data from the given ones. What its answers then scatter
by is what they may be off by.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import floor, inf, isnan, log10
from typing import overload

from ..errors import DeadPointError
from ..mechanism.asked.machine import PHI_MAX, PHI_MIN, equally
from ..mechanism.model import Mechanism
from ..problem.problem import Problem
from ..words import Words
from .truth import Truth, Values

FEWEST = 3  # digits with which a value is still an answer
PLENTY = 7  # digits of which nothing need be said
WHOLE = 360.0  # deg
ROUNDED = 4.0  # times the scatter: within it a value cannot be told from zero
LAST = 2.0**-52  # of the size of such quantities: the last place of a number
NOTHING = 1e-9  # of the size of such quantities: what may be taken for zero at all
_PLACES, _PLACE = (PHI_MAX.key, PHI_MIN.key), 4  # decimals of a degree: places that are one

ELSEWHERE = Words("；请改取原动件的其他位置", "; choose another position of the input")
OTHERWISE = Words("；请改用其他数据", "; choose other data")


def sizes(problem: Problem, truth: Truth) -> dict[str, float]:
    """Key → how large such quantities are here: the largest of its unit, or what the data alone make likely."""
    units = {ask.rel.key: ask.rel.unit for ask in problem.asks}
    values, likely = truth.values, truth.likely
    largest: dict[str, float] = {}
    for key, value in values.items():
        if isnan(abs(value)):
            continue  # 0/0
        largest[units[key]] = max(abs(value), largest.get(units[key], likely.get(units[key], 0.0)))
    return {key: largest.get(units[key]) or 1.0 for key in values}


def noise(problem: Problem, truth: Truth, size: Mapping[str, float]) -> dict[str, float]:
    """Key → what the exact value may be off by; 359.9° and 0.1° are neighbours.

    Raises DeadPointError where a value keeps fewer than FEWEST digits, EquilibriumError where a machine is fastest, or
    slowest, at two places alike.
    """
    turns = {ask.rel.key for ask in problem.asks if ask.rel.unit == "deg"}
    found = {
        key: 0.0 if isnan(abs(value)) else _scatter(key, value, truth.nearby, WHOLE if key in turns else inf)
        for key, value in truth.values.items()
    }
    for key, off in found.items():
        if off > size[key] * 10.0**-FEWEST:
            if key in _PLACES and len(places := _places(key, (truth.values, *truth.nearby))) == 2:
                raise equally(key, *places)
            raise _lost(key, off, size[key], of_motion=isinstance(problem.subject, Mechanism))
    return found


def digits(noise: float, size: float) -> int:
    """How many digits a value of this size keeps."""
    return 15 if noise == 0 else max(0, min(15, floor(-log10(noise / size))))


@overload
def settled(value: float, noise: float, size: float) -> float: ...
@overload
def settled(value: complex, noise: float, size: float) -> complex: ...
def settled(value: complex | float, noise: float, size: float) -> complex | float:
    """The value, and 0 in the place of what is no more than its own rounding: of a complex number each part alone.

    noise: what the data moved in their last places make of it, so that a small value that is true stays: it scatters
    by far less than itself. size: of such quantities; nothing that is worth telling beside it is taken for zero, and
    what is less than the last place of it is none where no data were moved.
    """
    if isinstance(value, complex):
        return complex(settled(value.real, noise, size), settled(value.imag, noise, size))
    return 0.0 if abs(value) <= min(ROUNDED * (noise or LAST * size), NOTHING * size) else value


def _scatter(key: str, value: complex | float, near: tuple[Values, ...], whole: float) -> float:
    """The farthest from the exact value that the nudged data bring it; whole: after which it comes round."""
    gaps = [abs(values[key] - value) for values in near if key in values]
    return max((min(gap, abs(whole - gap)) for gap in gaps), default=0.0)


def _places(key: str, near: tuple[Values, ...]) -> list[float]:
    """The places (deg) at which the nudged data have it, each told once."""
    return sorted({round(abs(values[key]), _PLACE) for values in near})


def _lost(key: str, off: float, size: float, *, of_motion: bool) -> DeadPointError:
    left = digits(off, size)
    where = (
        Words(f"{key}：机构离死点（或变点）太近", f"{key}: the mechanism is so near to a dead point (or change point)")
        if of_motion
        else Words(f"{key}：所给数据离极限情形太近", f"{key}: the data are so near to a limiting case")
    )
    if left == 0:
        told = Words(
            "，舍入误差与该量本身一样大，一位有效数字也不剩（准确值趋于无穷或不定）",
            " that the error of rounding is as large as the quantity itself, which is infinite or undetermined there: "
            "no digit of it is left",
        )
    else:
        told = Words(
            f"，舍入误差被放大到 ±{off:.2g}，而此类量的大小为 {size:.2g}，只剩 {left} 位有效数字",
            f" that rounding alone makes ±{off:.2g} of a quantity of about {size:.2g}: "
            f"{left} digit{'s are' if left > 1 else ' is'} left",
        )
    return DeadPointError(
        where + told + (ELSEWHERE if of_motion else OTHERWISE),
        code="precision.lost",
        numbers={"noise": off, "size": size, "digits": left},
    )
