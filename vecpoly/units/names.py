"""Units by their names: read by pint from our own small list, the commonest known by heart."""

from __future__ import annotations

import math
import re
from difflib import get_close_matches
from functools import lru_cache
from typing import Any

from ..errors import FaultError
from ..limits import MOST, POWER
from ..words import Words

_DEFINITIONS = (
    "meter = [length] = m = metre = 米",
    "second = [time] = s = 秒",
    "radian = [angle] = rad = 弧度",
    "kilogram = [mass] = kg = 千克",
    "millimeter = 1e-3 * meter = mm = 毫米",
    "centimeter = 1e-2 * meter = cm = 厘米",
    "decimeter = 1e-1 * meter = dm = 分米",
    "micrometer = 1e-6 * meter = um = µm = μm = 微米",
    "mil = 25.4e-6 * meter = mil",
    "kilometer = 1e3 * meter = km = 千米",
    "inch = 25.4e-3 * meter = in = 英寸",
    "minute = 60 * second = min = 分钟 = 分",
    "hour = 3600 * second = h = 小时",
    f"degree = {math.pi / 180!r} * radian = deg = 度",
    f"turn = {2 * math.pi!r} * radian = r = rev = 转",
    f"rpm = {math.pi / 30!r} * radian / second = rpm",
    "gram = 1e-3 * kilogram = g = 克",
    "newton = kilogram * meter / second ** 2 = N = 牛",
    "decanewton = 10 * newton = daN",
    "kilonewton = 1e3 * newton = kN = 千牛",
    "watt = newton * meter / second = W = 瓦",
    "kilowatt = 1e3 * watt = kW = 千瓦",
    "joule = newton * meter = J = 焦",
    "kilojoule = 1e3 * joule = kJ = 千焦",
    "pascal = newton / meter ** 2 = Pa = 帕",
    "kilopascal = 1e3 * pascal = kPa = 千帕",
    "megapascal = 1e6 * pascal = MPa = 兆帕",
    "bar = 1e5 * pascal = bar = 巴",
)

# spelling: SI factor and dimension
_COMMON = {
    "mm": (1e-3, "length 1"),
    "m": (1.0, "length 1"),
    "cm": (1e-2, "length 1"),
    "deg": (math.pi / 180, "angle 1"),
    "rad": (1.0, "angle 1"),
    "rad/s": (1.0, "angle 1 time -1"),
    "r/min": (math.pi / 30, "angle 1 time -1"),
    "rad/s**2": (1.0, "angle 1 time -2"),
    "m/s": (1.0, "length 1 time -1"),
    "m/s**2": (1.0, "length 1 time -2"),
    "m/mm": (1e3, ""),
    "(m/s)/mm": (1e3, "time -1"),
    "(m/s**2)/mm": (1e3, "time -2"),
    "N": (1.0, "length 1 mass 1 time -2"),
    "N*m": (1.0, "length 2 mass 1 time -2"),
    "N*mm": (1e-3, "length 2 mass 1 time -2"),
    "N/mm": (1e3, "mass 1 time -2"),
    "kg": (1.0, "mass 1"),
    "kg*m": (1.0, "length 1 mass 1"),
    "g*mm": (1e-6, "length 1 mass 1"),
    "kg*m**2": (1.0, "length 2 mass 1"),
    "kg/m**3": (1.0, "length -3 mass 1"),
    "MPa": (1e6, "length -1 mass 1 time -2"),
    "N*s/m": (1.0, "mass 1 time -1"),
    "N*m/rad": (1.0, "angle -1 length 2 mass 1 time -2"),
    "N*m*s": (1.0, "length 2 mass 1 time -1"),
}
# units that are not read, each with the one to write in its place and how much of that it is
_FOREIGN = {
    "kgf": ("N", 9.80665),
    "kp": ("N", 9.80665),
    "公斤力": ("N", 9.80665),
    "lbf": ("N", 4.4482216152605),
    "dyn": ("N", 1e-5),
    "lb": ("kg", 0.45359237),
    "oz": ("kg", 0.028349523125),
    "t": ("kg", 1000.0),
    "吨": ("kg", 1000.0),
    "ft": ("mm", 304.8),
    "yd": ("mm", 914.4),
    "ms": ("s", 1e-3),
    "psi": ("MPa", 6.894757293168e-3),
    "atm": ("MPa", 0.101325),
    "hp": ("W", 745.69987158227),
    "PS": ("W", 735.49875),
    "马力": ("W", 735.49875),
    "kcal": ("J", 4186.8),
    "mph": ("m/s", 0.44704),
}
_USUAL = "mm cm m in s min rad deg r rad/s r/min m/s m/s^2 kg g N N*m kg*m kg*m^2 W MPa m/mm"


_SPELLING = str.maketrans({"²": "^2", "·": "*", "⋅": "*", "×": "*", "°": "deg", "−": "-", "（": "(", "）": ")"})


_STRANGE = re.compile(r"[^\w\s*/().^·°-]")


def plain(unit: str) -> str:
    """A unit as `unit_of` knows it: m/s² is m/s**2, N·m is N*m, ° is deg."""
    return unit.translate(_SPELLING).replace("^", "**")


@lru_cache(maxsize=256)
def unit_of(unit: str) -> tuple[float, str]:
    """SI factor and dimension of a unit; raises FaultError where it is unknown."""
    return _COMMON.get(unit) or unit_by_pint(unit)


def unit_by_pint(unit: str) -> tuple[float, str]:
    """The same from pint, for spellings not known by heart."""
    _no_great_power(unit)
    try:
        if _STRANGE.search(unit):  # pint passes over what it cannot read: m/s? would be m/s
            raise ValueError(unit)
        quantity = _registry().Quantity(1.0, unit).to_base_units()
        if not 1 / MOST <= quantity.magnitude <= MOST:
            raise OverflowError(unit)
    except Exception:  # pint raises many kinds, all of them meaning that the unit cannot be read
        raise FaultError(
            Words(f"单位“{unit}”不可识别", f"unit '{unit}' is unknown") + _near(unit), code="unknown-unit"
        ) from None
    powers = sorted((name.strip("[]"), power) for name, power in quantity.dimensionality.items())
    return float(quantity.magnitude), " ".join(f"{name} {power:g}" for name, power in powers)


def _no_great_power(unit: str) -> None:
    """Raise FaultError for m^999: no unit of mechanics has such a power, and reckoning with it takes for ever."""
    for power in re.findall(r"\d+", unit):
        if len(power) > 4 or (int(power) > POWER and "**" in unit):
            raise FaultError(
                Words(f"单位“{unit}”的幂次过高；请改正", f"unit '{unit}' has too great a power; correct it"),
                code="unknown-unit",
            )


def _near(unit: str) -> Words:
    """'; did you mean rad/s?' of a unit written in other capitals or misspelt; else the units there are."""
    if (foreign := _foreign(unit)) is not None:
        return foreign
    known = {spelling.replace("**", "^"): spelling for spelling in _COMMON}
    by_small = {spelling.lower(): spelling for spelling in known}
    close = get_close_matches(unit.replace("**", "^").lower(), by_small, n=1, cutoff=0.7)
    if close:
        return Words(f"；是否指“{by_small[close[0]]}”？", f"; did you mean '{by_small[close[0]]}'?")
    return Words(f"；可用：{_USUAL}", f"; known: {_USUAL}")


def _foreign(unit: str) -> Words | None:
    """'; did you mean N? 1 kgf = 9.80665 N' where a unit of another system stands in it."""
    names = [name for name in re.split(r"[^A-Za-z一-鿿]+", unit) if name]
    found = next((name for name in names if name in _FOREIGN), None)
    if found is None:
        return None
    ours, factor = _FOREIGN[found]
    told = f"1 {found} = {factor:.7g} {ours}"
    return Words(f"；是否指“{ours}”？换算：{told}", f"; did you mean '{ours}'? {told}")


@lru_cache(maxsize=1)
def _registry() -> Any:
    from pint import UnitRegistry

    registry = UnitRegistry(None)
    for line in _DEFINITIONS:
        registry.define(line)
    return registry
