"""The greatest and the least value of a curve, beside their dots with the place where they occur: 44.2 (219.4°)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from math import floor, isfinite, log10
from typing import Any

import numpy as np

from ..cycle import Column, Extremes
from ..cycle import Spot as Turned
from ..drawing.style import Hue
from . import style
from .place import Placer, Points

Spot = tuple[float, float]
Known = Callable[[str], Extremes]
SIZE = 2.7  # em of the lettering, mm
_DIGITS = 4  # as in the columns of tables
_LEVEL = 1e-5  # of the range: spots that differ by less, read off samples, are equally high
_WHOLE = 1e-3  # degrees or mm: nearer to a whole number a place is one
_NEAR = 1e-2  # of the range: how far a sampled extreme may be from the true one
_NOTHING = 1e-9  # of the greatest value: zero
_TURN = 360.0  # degrees
_BOTH = 2  # places that are told beside a value, at most
_COVERED = 0.5  # what stands under a text: with more than that it is left out, so that none stands on a curve


def label_peaks(
    at: Any,
    lines: Iterable[Points],
    spots: Iterable[Sequence[Spot]],
    hues: Iterable[Hue],
    drive: Column,
    unit: str = "",
) -> None:
    """A dot at the highest and the lowest spot of each curve, and beside it value and place in the curve's ink; none
    where these would cover something. What stands farthest out has its number first.

    lines: all curves, in shown units; spots: the turning points of each; hues: the ink of each; unit: of the values.
    """
    (low, high), ends = at.get_ylim(), at.get_xlim()
    placer = Placer(at, [*lines, np.array([complex(x, 0.0) for x in ends])] if low < 0 < high else [*lines])
    every = [(alike, up, hue) for of_one, hue in zip(spots, hues, strict=True) for alike, up in extremes(of_one)]
    marked = [complex(*spot) for alike, _, _ in every for spot in alike]
    if marked:
        placer.keep_clear(np.array(marked), 0.7)
    for alike, up, hue in sorted(every, key=lambda one: -abs(one[0][0][1] - (low + high) / 2)):
        if placer.put(complex(*alike[0]), told(alike, drive, unit), 1j * up, SIZE, most=_COVERED, hue=hue):
            dotted = alike if len(_places(alike)) <= _BOTH else alike[:1]
            style.dots(at, [x for x, _ in dotted], [y for _, y in dotted], hue)


def extremes(spots: Sequence[Spot]) -> list[tuple[list[Spot], int]]:
    """The highest of the spots with 1, and the lowest with −1, all that are equally high, in their order."""
    if not spots:
        return []
    values = [value for _, value in spots]
    level = _LEVEL * ((max(values) - min(values)) or abs(values[0]))
    high = sorted(spot for spot in spots if spot[1] >= max(values) - level)
    low = lowest(spots)
    return [(high, 1)] if high == low else [(high, 1), (low, -1)]


def lowest(spots: Sequence[Spot]) -> list[Spot]:
    """Those of the spots that are as low as the lowest."""
    values = [value for _, value in spots] or [0.0]
    level = _LEVEL * ((max(values) - min(values)) or abs(values[0]))
    return sorted(spot for spot in spots if spot[1] <= min(values) + level)


def exact(spots: Sequence[Spot], known: Extremes, drive: Column, column: Column, step: float) -> Sequence[Spot]:
    """Those of the sampled spots that are the column's extremes, to full accuracy; else all. step: between samples."""
    tops = [top for end in (known.highest, known.lowest) if end is not None for top in _alike(known, end)]
    true = [(drive.told(top.phi), column.told(top.value)) for top in tops]
    room = _NEAR * (max((value for _, value in true), default=0.0) - min((value for _, value in true), default=0.0))
    found = [top for top in true if any(abs(x - top[0]) <= 2 * step and abs(y - top[1]) <= room for x, y in spots)]
    size = max((abs(value) for _, value in (*true, *spots)), default=0.0)
    return [(x, 0.0 if abs(value) <= _NOTHING * size else value) for x, value in found or spots]


def _alike(known: Extremes, end: Turned) -> list[Turned]:
    """All turning points that are as high (or low) as this one; beside the greatest value rounding is nothing."""
    size = max(abs(one.value) for one in (end, known.highest, known.lowest) if one is not None)
    near = max(_LEVEL * abs(end.value), _NOTHING * size if isfinite(size) else 0.0)
    return [one for one in (*known.maxima, *known.minima) if abs(one.value - end.value) <= near] or [end]


def told(alike: Sequence[Spot], drive: Column, of: str = "") -> str:
    """The value to four figures, of an angle to 0.1° as in the text, and the drive's places to 0.1° or 0.1 mm: of two
    that are equally high both."""
    unit = "°" if drive.shown_unit == "°" else f" {drive.shown_unit}"
    places = [f"{_place(place)}{unit}" for place in _places(alike)]
    value = f"{alike[0][1]:.1f}".replace("-", "−") if of == "°" else figures(alike[0][1])
    return f"{value} ({', '.join(places) if len(places) <= _BOTH else places[0]})"


def _places(alike: Sequence[Spot]) -> list[float]:
    """The places of spots that are alike, once each: where a turn ends, the next begins."""
    turned = {round(place, 1): place for place, _ in alike}
    return [turned[one] for one in sorted(turned) if one != _TURN or 0.0 not in turned]


def _place(place: float) -> str:
    """To a tenth, 344.0, as the tables have it; of what is whole no tenths: 180."""
    return style.number(round(place)) if abs(place - round(place)) < _WHOLE else style.number(place, 1)


def figures(value: float) -> str:
    """A number to four figures, whole numbers as they are."""
    if not value:
        return "0"
    places = _DIGITS - 1 - floor(log10(abs(float(f"{value:.{_DIGITS - 1}e}"))))  # 9.9996 is 10.00, not 10.000
    return f"{value:.{max(0, places)}f}".replace("-", "−")
