"""The units in which reports print: lengths in mm, powers in kW."""

from __future__ import annotations

_PAPER = {"m": (1e3, "mm"), "W": (1e-3, "kW")}  # SI unit → factor and unit as printed


def printed_unit(unit: str) -> tuple[float, str]:
    """Factor from SI and name of the unit in which a report prints."""
    return _PAPER.get(unit, (1.0, unit))
