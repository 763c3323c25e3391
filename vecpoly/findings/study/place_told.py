"""A position of the drive as every sentence and table of a course report tells it."""

from __future__ import annotations

from ...cycle import Column

_WHOLE = 1e-3  # of its unit, by which a position may be off a whole number and is told as that


def place_told(drive: Column, phi: float) -> str:
    """A position (rad, or m) to a tenth: 37.5°, 1714.9 mm; 90° of what is whole."""
    size = drive.told(phi)
    text = f"{size:.0f}" if abs(size - round(size)) < _WHOLE else f"{size:.1f}"
    text = text.lstrip("-") if not text.strip("-0.") else text.replace("-", "−")
    return f"{text}°" if drive.shown_unit == "°" else f"{text} {drive.shown_unit}"
