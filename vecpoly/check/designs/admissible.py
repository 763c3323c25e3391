"""Where one of the data of a synthesis had to lie for a linkage to serve, all others being as they are given."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import groupby, pairwise
from math import atan, degrees, inf, pi

import numpy as np
from numpy.typing import NDArray

from ...designs.base import Design
from ...designs.ranged.admitted import between
from ...designs.ranged.datum import Datum
from ...designs.verdict import Verdict
from ...errors import VecpolyError
from ...oracle.synthesis.registry import candidates
from ...words import Words

TRIED = 240  # places of a datum that are looked at
HALVINGS = 30  # between one that serves and one that does not
LONGEST = 30.0  # sizes of the task: a length that is tried; the shortest is as much smaller, and one figure more
GREATEST = 6.0  # a time ratio that is tried
SAME = 1e-4  # of the size of the task, or rad: so near the given value others serve where it alone does not
ANY = Words("任何值", "any")
Places = NDArray[np.float64]


def admissible(design: Design) -> Words | None:
    """A sentence: the range of the first datum that may be told (`varied`) with which there is a solution, of an angle
    that of its own sign first; None where no such datum has one."""
    for datum in design.varied():
        serves = _serves(datum)
        rows = ([*_ranges(serves, *tried, datum.value)] for tried in _tried(design, datum))
        if ranges := next(filter(None, rows), None):
            whole, left_out = _merged(ranges, design, datum)
            told = between([(_told(low, datum.unit), _told(high, datum.unit)) for low, high in whole], datum.unit)
            told = ANY if whole == [(-inf, inf)] else told
            zh = f"{datum.name.zh}{' ' * datum.name.zh[-1].isascii()}可取{told.zh.rstrip()}{left_out.zh}"
            return Words(
                f"其余数据不变时，{zh}。", f" With all else as it is, {datum.name.en} may be {told.en}{left_out.en}."
            )
    return None


def _merged(
    ranges: list[tuple[float, float]], design: Design, datum: Datum[Design]
) -> tuple[list[tuple[float, float]], Words]:
    """The same where two of them lie on both sides of what is given, which alone does not serve, as one, and that it
    does not."""
    gap = SAME * (design.size if datum.unit == "mm" else 1.0)
    for n, ((_, low), (high, _)) in enumerate(pairwise(ranges)):
        if low <= datum.value <= high <= low + gap:
            given = f"{_told(datum.value, datum.unit):.6g} {datum.unit}".rstrip()
            joined = [*ranges[:n], (ranges[n][0], ranges[n + 1][1]), *ranges[n + 2 :]]
            return joined, Words(f"，但不得为 {given}", f", but not {given}")
    return ranges, Words("", "")


def _told(end: float, unit: str) -> float:
    return degrees(end) if unit == "deg" else 1e3 * end if unit == "mm" else end


def _tried(design: Design, datum: Datum[Design]) -> Iterator[tuple[Places, tuple[float, float]]]:
    """The places of a datum to look at (SI), in order; the ends of a row that goes on as far as they do."""
    most = LONGEST * design.size
    if datum.signed:
        yield design.size * np.tan(np.linspace(-atan(LONGEST), atan(LONGEST), 2 * TRIED + 1)), (-inf, inf)
    elif datum.unit == "mm":
        yield np.geomspace(most / LONGEST**2 / 10, most, TRIED), (-inf, inf)
    elif datum.unit == "deg":
        for whole in (2 * pi, -2 * pi) if datum.value >= 0 else (-2 * pi, 2 * pi):
            yield np.sort(np.linspace(0.0, whole, TRIED + 1)), (min(0.0, whole), max(0.0, whole))
    else:
        yield np.geomspace(1.0, GREATEST, TRIED), (-inf, inf)


def _serves(datum: Datum[Design]) -> Callable[[float], bool]:
    """Whether there is a solution with another value of a datum."""

    def serves(value: float) -> bool:
        try:
            return any(one.verdict is Verdict.VALID for one in candidates(datum.put(value)))
        except (VecpolyError, ValueError):  # pydantic's is one
            return False

    return serves


def _ranges(
    serves: Callable[[float], bool], places: Places, ends: tuple[float, float], given: float
) -> Iterator[tuple[float, float]]:
    """From the first to the last place of each row that serves, and what serves between it and its neighbour; what is
    given serves not, though all about it may."""
    tried = sorted({*map(float, places), given})
    seen = [serves(place) for place in tried]
    for good, some in groupby(range(len(tried)), key=seen.__getitem__):
        if good:
            row = list(some)
            low = _edge(serves, tried[row[0]], tried[row[0] - 1]) if row[0] > 0 else ends[0]
            high = _edge(serves, tried[row[-1]], tried[row[-1] + 1]) if row[-1] + 1 < len(tried) else ends[1]
            yield low, high


def _edge(serves: Callable[[float], bool], good: float, bad: float) -> float:
    """The last place that serves, between one that does and one that does not."""
    for _ in range(HALVINGS):
        middle = (good + bad) / 2
        good, bad = (middle, bad) if serves(middle) else (good, middle)
    return good
