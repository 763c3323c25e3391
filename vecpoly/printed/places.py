"""Coordinates of points as they are printed."""

from __future__ import annotations

from ..algebra.rounding import to_places


def place_parts(at: complex, places: int) -> tuple[str, str]:
    """Both coordinates of a point (m) in mm, with so many decimals; no sign on zero."""
    x, y = (f"{to_places(1e3 * part, places):.{places}f}" for part in (at.real, at.imag))
    return _signed(x), _signed(y)


def _signed(text: str) -> str:
    return text.lstrip("-") if float(text) == 0 else text.replace("-", "−")
