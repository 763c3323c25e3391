"""Every quantity in another of its units."""

from __future__ import annotations

import re
from decimal import Decimal
from math import pi
from typing import Any

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from .original import Change, compared, original, told

_TEN = {  # unit → others, with the power of ten by which the number grows
    "mm": (("cm", -1), ("dm", -2), ("m", -3), ("km", -6), ("毫米", 0), ("厘米", -1), ("米", -3)),
    "deg": (("°", 0), ("度", 0)),
    "rad/s": (("弧度/秒", 0),),
    "rad/s^2": (("rad/s²", 0), ("弧度/秒²", 0)),
    "m/s": (("mm/s", 3), ("cm/s", 2), ("米/秒", 0), ("毫米/秒", 3)),
    "m/s^2": (("m/s²", 0), ("mm/s^2", 3), ("毫米/秒²", 3)),
    "N": (("kN", -3), ("牛", 0), ("kg*m/s^2", 0)),
    "N*m": (("N*mm", 3), ("N·m", 0), ("kN*m", -3), ("牛*米", 0)),
    "kg": (("g", 3), ("千克", 0)),
    "kg*m^2": (("kg*mm^2", 6), ("g*m^2", 3), ("kg·m²", 0)),
}
_OTHER = {
    "deg": (("rad", pi / 180), ("r", 1 / 360)),
    "rad/s": (("r/min", 30 / pi), ("rpm", 30 / pi), ("deg/s", 180 / pi), ("rad/min", 60.0)),
    "r/min": (("rpm", 1.0), ("rad/s", pi / 30), ("转/分", 1.0)),
    "rad/s^2": (("deg/s^2", 180 / pi),),
    "mm": (("in", 1 / 25.4),),
    "m/s": (("m/min", 60.0), ("km/h", 3.6)),
}
_QUANTITY = re.compile(
    r"(?<![\w.])(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) ("
    + "|".join(sorted(map(re.escape, _TEN | _OTHER), key=len, reverse=True))
    + r")(?![\w/*^])"
)


def rewritten(rng: np.random.Generator, value: Any) -> Any:
    """A tree of texts with its quantities in other units."""
    match value:
        case dict():
            return {key: rewritten(rng, inner) for key, inner in value.items()}
        case list():
            return [rewritten(rng, inner) for inner in value]
        case str():
            return _QUANTITY.sub(lambda m: _other(rng, m[1], m[2]), value)
        case _:
            return value


def _other(rng: np.random.Generator, number: str, unit: str) -> str:
    """The same quantity; powers of ten shift the point and lose nothing."""
    ten = _TEN.get(unit, ())
    i = int(rng.integers(-1, len(ten) + len(_OTHER.get(unit, ()))))
    if i < 0:
        return f"{number} {unit}"
    if i < len(ten):
        return f"{Decimal(number).scaleb(ten[i][1]):f} {ten[i][0]}"
    name, factor = _OTHER[unit][i - len(ten)]
    return f"{float(number) * factor!r} {name}"


def unchanged(solution: Solution) -> str:
    """The answers are the original's."""
    return compared(solution, Change())


@family("retold-units", also=unchanged)
def in_other_units(rng: np.random.Generator) -> str:
    """Any member of the other families, its quantities in mixed units."""
    mark, text = original(rng)
    return told(rewritten(rng, data_of(text)), mark)
