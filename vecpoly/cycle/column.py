"""One quantity over the cycle, and how it is shown."""

from __future__ import annotations

from dataclasses import dataclass

from ..words import Words

_SHOWN = {"rad": ("°", 57.29577951308232), "m": ("mm", 1000.0)}


@dataclass(frozen=True, slots=True, kw_only=True)
class Column:
    """One quantity over the cycle: key, symbol in the notation of `formula`,
    SI unit, what it is, key of its time derivative."""

    key: str
    symbol: str
    unit: str
    words: Words
    is_vector: bool = False
    rate: str = ""
    turns: bool = False  # an angle that is followed without jumps

    @property
    def shown_unit(self) -> str:
        """The unit in tables and on axes: ° for rad, mm for m, else the SI unit."""
        return _SHOWN.get(self.unit, (self.unit, 1.0))[0]

    @property
    def factor(self) -> float:
        """Shown value / SI value."""
        return _SHOWN.get(self.unit, (self.unit, 1.0))[1]

    @property
    def parts(self) -> tuple[str, ...]:
        """Keys of the real columns in which a vector is tabled: its x and y, or itself."""
        return (f"{self.key}.x", f"{self.key}.y") if self.is_vector else (self.key,)
