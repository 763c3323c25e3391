"""A position of the drive as every sentence and table of a course report tells it."""

from __future__ import annotations

from ...cycle import Column

_NEAR = ((0, 1e-3), (2, 1e-7))  # decimals, and by how much of its unit a position may be off what is told so


def place_told(drive: Column, phi: float) -> str:
    """A position (rad, or m) to a tenth: 37.5°, 1714.9 mm; 90° of what is whole, 127.35° of what is given so."""
    size = drive.told(phi)
    places = next((n for n, near in _NEAR if abs(size - round(size, n)) < near), 1)
    text = f"{size:.{places}f}"
    text = text.lstrip("-") if not text.strip("-0.") else text.replace("-", "−")
    return f"{text}°" if drive.shown_unit == "°" else f"{text} {drive.shown_unit}"
