"""Values of a column, and the positions at which it has them, for prose."""

from __future__ import annotations

from collections.abc import Iterable
from math import isclose

import numpy as np

from ..algebra.columns import significant
from ..algebra.quantity import number
from ..algebra.rounding import read_back
from ..cycle import Extremes, Spot
from ..words import Words
from .study.study import Study

_LOADS, _LARGE = ("N", "N·m"), 1e5  # units of which a thousand is told by k, from which size on
_EXACT = 1e-9
_ALIKE = 1e-6  # of the greatest value: two extremes are one


def shown(study: Study, key: str, value: float, digits: int = 4) -> str:
    """A value of a column with its unit, for prose."""
    info = study.whole.info(key)
    unit = info.shown_unit.replace("^2", "²")
    if not np.isfinite(value):
        return "∞" if value > 0 else "−∞"
    size = info.factor * value
    if unit in _LOADS and abs(size) >= _LARGE:
        size, unit = 1e-3 * size, f"k{unit}"
    text = f"{size:.1f}".replace("-", "−") if unit == "°" else _figures(size, digits)
    return text + (unit if unit == "°" else f" {unit}" if unit else "")


def _figures(size: float, digits: int) -> str:
    """A number with all of its figures, as a table has it: 0.9880; one that is told exactly by fewer with these: 80."""
    short = number(size, digits)
    return short if "×" in short or isclose(read_back(short)[0], size, rel_tol=_EXACT) else significant(size, digits)


def span(study: Study) -> Words:
    """What is told of: a cycle of motion, or the working range of a drive that cannot turn right round."""
    return Words("一个运动循环", "cycle") if study.whole.whole else Words("工作范围", "working range")


def alike(study: Study, found: Extremes, spot: Spot) -> list[Spot]:
    """All the turning points that are as high (or low) as this one, in the order of the input link's positions."""
    ends = (found.highest, found.lowest, spot)
    near = _ALIKE * max((abs(s.value) for s in ends if s is not None and np.isfinite(s.value)), default=0.0)
    spots = [s for s in (*found.maxima, *found.minima) if abs(s.value - spot.value) <= near] or [spot]
    return sorted(spots, key=lambda s: study.reduced(s.phi))


def places(study: Study, found: Extremes, spot: Spot) -> Words:
    """All the positions of the input link in which a turning point is as high (or low) as this one."""
    return listed(study, [s.phi for s in alike(study, found, spot)])


def listed(study: Study, at: Iterable[float]) -> Words:
    """Positions of the input link, once each: $φ_1$ = 112.6° and 247.4°."""
    every = list(dict.fromkeys(study.where(phi) for phi in at))
    told = [every[0], *(place.split(" = ")[1] for place in every[1:])]
    return Words("、".join(told), " and ".join(told))


def dead_points(study: Study) -> Words:
    """Where the drive stands at its dead points, beyond the working range: $φ_1$ = −129.8° and 129.8°."""
    told = [study.where(spot.phi) for spot in study.facts.dead]
    listed = [*told[:1], *(place.split(" = ")[1] for place in told[1:])]
    return Words("、".join(listed), " and ".join(listed))
