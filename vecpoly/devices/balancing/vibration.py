"""What a vibrometer shows: 8.6 um at 63 deg, or without a phase 10 mm/s."""

from __future__ import annotations

import re
from math import degrees
from typing import Annotated, Any

from pydantic import BeforeValidator, WithJsonSchema

from ...errors import FaultError
from ...foundation.slotted import dataclass
from ...units.reading import Dim, positive, read
from ...words import Words

MICRON, PER_SECOND = ("μm", 1e6), ("mm/s", 1e3)
_PHASED = re.compile(r"(.*?)(?:\s+at\s+|\s*∠\s*)(.+)")
_DIGITS = re.compile(r"\d*\.?(\d*)")


@dataclass(frozen=True, slots=True, kw_only=True)
class Vibration:
    """An amplitude, in μm or mm/s, and its phase (rad) where one was read.

    step: one unit of the last digit that is written, what the instrument tells apart. text: as it is printed.
    """

    size: float
    unit: str
    step: float
    phase: float | None
    text: str

    @property
    def degrees(self) -> float:
        """The phase in degrees; 0 where there is none."""
        return 0.0 if self.phase is None else degrees(self.phase)


def _vibration(value: Any) -> Vibration:
    if isinstance(value, Vibration):
        return value
    text = str(value).strip()
    phased = _PHASED.fullmatch(text)
    size, unit = _amplitude((phased[1] if phased else text).strip())
    phase = read(phased[2], Dim.ANGLE) if phased else None
    told = f"{phased[1].strip()} ∠ {phased[2]}" if phased else text
    return Vibration(
        size=size,
        unit=unit,
        step=_last_digit(text, size),
        phase=None if phase is None else phase.si,
        text=re.sub(r"\b[uµ]m\b", "μm", told),
    )


def _amplitude(text: str) -> tuple[float, str]:
    """Displacements in μm, velocities in mm/s; FaultError for anything else."""
    try:
        found, (unit, factor) = positive(text, Dim.LENGTH), MICRON
    except FaultError as fault:
        if fault.code not in ("wrong-unit", "no-unit"):
            raise
        try:
            found, (unit, factor) = positive(text, Dim.SPEED), PER_SECOND
        except FaultError:
            raise FaultError(
                Words(
                    f"“{text}”不是振幅；应写位移或速度，如 8.6 um at 63 deg，或 4.5 mm/s",
                    f"'{text}' is no vibration: write a displacement or a velocity, e.g. 8.6 um at 63 deg, or 4.5 mm/s",
                ),
                code="spelling",
            ) from None
    return found.si * factor, unit


def _last_digit(text: str, size: float) -> float:
    """One unit of the last digit written, in the unit of the amplitude."""
    found = _DIGITS.match(text)
    number = float(text[: found.end()] or 0.0) if found and found.end() else 0.0
    return size / number * 10.0 ** -len(found[1]) if found and number else 0.0


Reading = Annotated[Vibration, BeforeValidator(_vibration), WithJsonSchema({"type": ["string", "number"]})]
