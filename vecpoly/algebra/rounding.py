"""How numbers are rounded to be printed: what lies midway goes to the even figure (GB/T 8170), in metres as in mm.

Floats do not lie midway where their decimals do: 0.11025 would go up and 110.25 down.
"""

from __future__ import annotations

from collections.abc import Callable
from decimal import ROUND_HALF_EVEN, Context, Decimal
from functools import lru_cache
from math import floor, isfinite, log10

MOST = 10  # figures of a number in a line, at most
_MIDWAY = 1e-6  # of half a unit
WHOLE = 6  # numbers of no more figures before the point are told whole
_CLEAN = 12  # figures of a float that are not rubbish
_CONTEXTS = {digits: Context(prec=digits, rounding=ROUND_HALF_EVEN) for digits in range(1, _CLEAN + 1)}


def to_figures(value: float, digits: int) -> float:
    """The number to so many significant figures."""
    if not value or not isfinite(value) or digits >= _CLEAN:
        return value
    return _rounded(value, digits)


@lru_cache(maxsize=4096)
def _rounded(value: float, digits: int) -> float:
    """The same number is tried again and again: with more figures, in another line."""
    return float(_CONTEXTS[digits].create_decimal(f"{value:.{_CLEAN}g}"))


def to_places(value: float, places: int) -> float:
    """The number to so many decimals."""
    if not value or not isfinite(value):
        return value
    if floor(log10(abs(value))) + 1 + places >= _CLEAN:
        return value
    return float(Decimal(f"{value:.{_CLEAN}g}").quantize(Decimal(1).scaleb(-places), rounding=ROUND_HALF_EVEN))


def in_tenths(value: float) -> str:
    """The number to a tenth: 17.55 mm is 17.6 mm, however a float may lie there."""
    return f"{to_places(value, 1):.1f}"


def as_printed(value: float, digits: int) -> float:
    """The number to so many figures; larger ones that are told whole, to all of theirs."""
    return to_places(value, 0) if 10.0**digits <= abs(value) < 10.0**WHOLE else to_figures(value, digits)


def half_unit(value: float, digits: int) -> float:
    """Half a unit of the last of so many figures of a number."""
    return 0.5 * 10.0 ** (floor(log10(abs(value))) + 1 - digits)


def rounds_to(value: float, result: float, half: float) -> bool:
    """Whether a number rounds to a result of which half the last unit is told; what lies midway, to the even one, or up
    as everybody would: 9.45/0.2 = 47.25 is 47.3 where further figures lie above it."""
    gap = abs(value - result)
    if abs(gap - half) <= _MIDWAY * half:
        return not half or round(result / (2 * half)) % 2 == 0 or abs(result) > abs(value)
    return gap < half


def read_back(text: str) -> tuple[float, float]:
    """A number as it is printed (−3.2×10^{−5}), and half a unit of the last place that is printed."""
    mantissa, _, exponent = text.replace("−", "-").rstrip("}").partition("×10^{")
    tens = int(exponent or 0)
    return float(f"{mantissa}e{tens}"), 0.5 * 10.0 ** (tens - places_of(mantissa))


def places_of(text: str) -> int:
    """The decimals of a number that is printed so."""
    return len(text.partition("×")[0].partition(".")[2])


def guarded(least: int, holds: Callable[[int], bool]) -> int:
    """The fewest figures, no fewer than these, that do; these where none do."""
    return next((digits for digits in range(least, MOST + 1) if holds(digits)), least)


def braced(unit: str) -> str:
    """A unit as it stands behind a letter and a stroke, in a head or on an axis: v/(m/s), l/mm."""
    return f"({unit})" if "/" in unit or "·" in unit else unit
