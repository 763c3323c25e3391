"""The direction of a vector as it is printed: from 0° up to 360°, counter-clockwise from the x axis."""

from __future__ import annotations

WHOLE = 360.0  # degrees


def bearing_told(turn: float, places: int = 1) -> str:
    """A direction (degrees) to so many places: −150.04 is 210.0°, and 359.96 is 0.0°."""
    return f"{round(turn % WHOLE, places) % WHOLE:.{places}f}°"
