"""One quantity over the cycle, and how it is shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

from ..names import Named, subscripted
from ..words import Words

Place = TypeVar("Place", float, Any)  # one, or an array of them
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
    zero: float = 0.0  # of the drive: its position (SI) where what is told of it is 0

    @property
    def shown_unit(self) -> str:
        """The unit in tables and on axes: ° for rad, mm for m, else the SI unit."""
        return _SHOWN.get(self.unit, (self.unit, 1.0))[0]

    @property
    def factor(self) -> float:
        """Shown value / SI value."""
        return _SHOWN.get(self.unit, (self.unit, 1.0))[1]

    def told(self, value: Place) -> Place:
        """What is shown of a value, or of values, in SI units."""
        return self.factor * (value - self.zero)

    @property
    def parts(self) -> tuple[str, ...]:
        """Keys of the real columns in which a vector is tabled: its x and y, or itself."""
        return (f"{self.key}.x", f"{self.key}.y") if self.is_vector else (self.key,)


def of_loads(named: Named) -> Column:
    """A load that balances, a reaction, an efficiency."""
    words = {"R": Words("运动副反力", "reaction"), "eta": Words("效率", "efficiency"), "M": Words("力矩", "moment")}
    stem = named.key.partition("_")[0]
    found = words.get(stem, Words("力", "force") if named.unit == "N" else Words.same(""))
    return Column(
        key=named.key,
        symbol=named.symbol,
        unit=named.unit,
        words=found + Words.same(f" ${named.symbol}$"),
        is_vector=named.is_vector,
    )


def of_reduced(named: Named) -> Column:
    """What stands for a whole machine on one link."""
    what = {
        "J": Words("等效转动惯量", "equivalent moment of inertia"),
        "M": Words("等效力矩", "equivalent moment"),
        "m": Words("等效质量", "equivalent mass"),
        "F": Words("等效力", "equivalent force"),
    }
    return Column(key=named.key, symbol=named.symbol, unit=named.unit, words=what[named.key[0]])


def part_words(whole: Column, part: str, point: str, symbol: str) -> Words:
    """Of the x or y part of a vector: 点 B 的坐标 y_B, 点 B 的速度的 y 分量."""
    if symbol.startswith(f"{part}_"):
        at = subscripted(point)
        return Words(f"点 ${at}$ 的坐标 ${symbol}$", f"coordinate ${symbol}$ of point ${at}$")
    return whole.words + Words(f"的 {part} 分量", f", {part} component")
