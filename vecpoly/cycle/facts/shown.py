"""How numbers, values and positions of a cycle are written."""

from __future__ import annotations

from math import isfinite

from ..cycle import Cycle
from ..extremes import Spot


def number(value: float, digits: int = 6) -> str:
    """A number for reading, with a real minus."""
    if not isfinite(value):
        return "∞" if value > 0 else "−∞"
    text = f"{round(value, 9) + 0.0:.{digits}g}"
    return (f"{float(text):.0f}" if "e+" in text and abs(value) < 1e9 else text).replace("-", "−")


def shown(cycle: Cycle, key: str, value: float, digits: int = 6) -> str:
    """A value of a column with its shown unit."""
    info = cycle.info(key)
    unit = info.shown_unit
    return number(info.told(value), digits) + (unit if unit == "°" else f" {unit}" if unit else "")


def where(cycle: Cycle, spot: Spot) -> str:
    """$φ_1$ = 37.5°."""
    return f"${cycle.drive.symbol}$ = {shown(cycle, cycle.drive.key, spot.phi, 5)}"
