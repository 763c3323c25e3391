"""Quantities with written units: read by pint from our own small list, the commonest known by heart."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache
from typing import Any

from .errors import FaultError
from .limits import LEAST, MOST, MOST_ANGLE, MOST_LENGTH, POWER
from .words import Words

_DEFINITIONS = (
    "meter = [length] = m = metre = 米",
    "second = [time] = s = 秒",
    "radian = [angle] = rad = 弧度",
    "kilogram = [mass] = kg = 千克",
    "millimeter = 1e-3 * meter = mm = 毫米",
    "centimeter = 1e-2 * meter = cm = 厘米",
    "decimeter = 1e-1 * meter = dm = 分米",
    "kilometer = 1e3 * meter = km = 千米",
    "inch = 25.4e-3 * meter = in = 英寸",
    "minute = 60 * second = min = 分钟 = 分",
    "hour = 3600 * second = h = 小时",
    f"degree = {math.pi / 180!r} * radian = deg = 度",
    f"turn = {2 * math.pi!r} * radian = r = rev = 转",
    f"rpm = {math.pi / 30!r} * radian / second = rpm",
    "gram = 1e-3 * kilogram = g = 克",
    "newton = kilogram * meter / second ** 2 = N = 牛",
    "kilonewton = 1e3 * newton = kN = 千牛",
    "watt = newton * meter / second = W = 瓦",
    "kilowatt = 1e3 * watt = kW = 千瓦",
)

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
    "kg*m**2": (1.0, "length 2 mass 1"),
    "kg/m**3": (1.0, "length -3 mass 1"),
}  # spelling: SI factor and dimension


class Dim(Enum):
    """A kind of quantity: its name, its dimension, and how one is written."""

    LENGTH = ("a length", "length 1", "30 mm")
    ANGLE = ("an angle", "angle 1", "60 deg")
    OMEGA = ("an angular velocity", "angle 1 time -1", "10 rad/s ccw")
    ALPHA = ("an angular acceleration", "angle 1 time -2", "5 rad/s^2 ccw")
    SPEED = ("a velocity", "length 1 time -1", "0.5 m/s")
    ACCEL = ("an acceleration", "length 1 time -2", "2 m/s^2")
    MU_L = ("a length scale", "", "0.002 m/mm")
    MU_V = ("a velocity scale", "time -1", "0.01 (m/s)/mm")
    MU_A = ("an acceleration scale", "time -2", "0.1 (m/s^2)/mm")
    MU_F = ("a force scale", "mass 1 time -2", "10 N/mm")
    FORCE = ("a force", "length 1 mass 1 time -2", "1000 N")
    MOMENT = ("a moment", "length 2 mass 1 time -2", "20 N*m ccw")
    MASS = ("a mass", "mass 1", "3 kg")
    INERTIA = ("a moment of inertia", "length 2 mass 1", "0.02 kg*m^2")
    DENSITY = ("a density", "length -3 mass 1", "7800 kg/m^3")
    POWER = ("a power", "length 2 mass 1 time -3", "5 kW")

    @property
    def label(self) -> str:
        return str(self.value[0])

    @property
    def dimension(self) -> str:
        return str(self.value[1])

    @property
    def example(self) -> str:
        return str(self.value[2])


@dataclass(frozen=True, slots=True)
class Quantity:
    """A value in SI (a scale: SI per mm on paper) and as it was written."""

    si: float
    text: str


_GREATEST = {Dim.ANGLE: MOST_ANGLE, Dim.LENGTH: MOST_LENGTH}
_NUMBER = re.compile(
    r"\s*([+\-−]?(?:\d+\.?\d*|\.\d+)(?:[eE][+\-]?\d+)?|[+\-]?(?:nan|inf(?:inity)?)\b)\s*(.*?)\s*", re.I
)
_SENSE = re.compile(r"\s*(?:\b(ccw|cw|counter-?clockwise|clockwise)|(逆时针|顺时针)(?:方向)?)$")
_SPELLING = str.maketrans(
    {"²": "^2", "·": "*", "⋅": "*", "×": "*", "°": "deg", "−": "-", "（": "(", "）": ")"}
)


def read(text: object, dim: Dim) -> Quantity:
    """A written quantity of this dimension; raises FaultError with what is wrong and how to write it."""
    if not isinstance(text, str):
        raise FaultError(f"{dim.label} is expected here; write e.g. {dim.example}")
    bare, sign = _split_sense(text, dim)
    m = _NUMBER.fullmatch(bare)
    if m is None:
        raise FaultError(f"'{text}' is not {dim.label}; write e.g. {dim.example}")
    number, unit = float(m[1].replace("−", "-")), m[2].translate(_SPELLING).replace("^", "**")
    if not math.isfinite(number):
        raise FaultError(f"'{text}' is not a finite number; write e.g. {dim.example}")
    if not unit:
        if number == 0:
            return Quantity(0.0, text)
        raise FaultError(f"'{text}' has no unit; {dim.label} is needed: write e.g. {_advice(m[1], dim)}")
    factor, dimension = unit_of(unit)
    if dimension != dim.dimension:
        raise FaultError(
            f"'{text}' is not {dim.label}: its unit '{m[2]}' is {_named(dimension)}; write e.g. {dim.example}"
        )
    per_mm = 1e-3 if dim in (Dim.MU_L, Dim.MU_V, Dim.MU_A, Dim.MU_F) else 1.0
    return Quantity(sign * _sensible(_times(number, factor * per_mm), text, dim), text)


def _sensible(si: float, text: str, dim: Dim) -> float:
    """The value, unless no mechanism on earth has it: its square would overflow, or its angle be lost in rounding. Below LEAST it is zero."""
    if abs(si) > _GREATEST.get(dim, MOST):
        raise FaultError(f"'{text}' is too large for {dim.label}; check number and unit, and write e.g. {dim.example}")
    return 0.0 if abs(si) < LEAST else si


def _times(number: float, factor: float) -> float:
    """The product; a division where that is exact, so that 350 mm is 0.35 m to the last digit."""
    inverse = 1 / factor
    return (
        number / round(inverse) if inverse > 1 and abs(inverse - round(inverse)) < 1e-9 else number * factor
    )


def positive(text: object, dim: Dim = Dim.LENGTH) -> Quantity:
    """A quantity greater than zero, such as a link's length."""
    quantity = read(text, dim)
    if quantity.si <= 0:
        raise FaultError(f"'{quantity.text}' must be greater than zero; write e.g. {dim.example}")
    return quantity


def pure(text: object, example: str) -> float:
    """A finite number without a unit; raises FaultError."""
    try:
        number = float(str(text).replace("−", "-"))
    except ValueError:
        raise FaultError(f"'{text}' is no pure number; write e.g. {example}") from None
    if not abs(number) <= MOST:
        raise FaultError(f"'{text}' is not a finite number; write e.g. {example}")
    return number


@lru_cache(maxsize=256)
def unit_of(unit: str) -> tuple[float, str]:
    """SI factor and dimension of a unit; raises FaultError where it is unknown."""
    return _COMMON.get(unit) or unit_by_pint(unit)


def unit_by_pint(unit: str) -> tuple[float, str]:
    """The same from pint, for spellings not known by heart."""
    _no_great_power(unit)
    try:
        quantity = _registry().Quantity(1.0, unit).to_base_units()
        if not 1 / MOST <= quantity.magnitude <= MOST:
            raise OverflowError(unit)
    except Exception:  # pint raises many kinds, all of them meaning that the unit cannot be read
        raise FaultError(
            f"unit '{unit}' is unknown; known: mm cm m s min rad deg r rad/s r/min m/s m/s^2 m/mm"
        ) from None
    powers = sorted((name.strip("[]"), power) for name, power in quantity.dimensionality.items())
    return float(quantity.magnitude), " ".join(f"{name} {power:g}" for name, power in powers)


def _no_great_power(unit: str) -> None:
    """Raise FaultError for m^999: no unit of mechanics has such a power, and reckoning with it takes for ever."""
    for power in re.findall(r"\d+", unit):
        if len(power) > 4 or (int(power) > POWER and "**" in unit):
            raise FaultError(Words(f"单位 '{unit}' 的幂次过高", f"unit '{unit}' has too great a power"))


@lru_cache(maxsize=1)
def _registry() -> Any:
    from pint import UnitRegistry

    registry = UnitRegistry(None)
    for line in _DEFINITIONS:
        registry.define(line)
    return registry


def _split_sense(text: str, dim: Dim) -> tuple[str, float]:
    m = _SENSE.search(text)
    if m is None:
        return text, 1.0
    if "angle" not in dim.dimension and dim is not Dim.MOMENT:
        raise FaultError(f"'{text}': {dim.label} has no sense of rotation; write e.g. {dim.example}")
    bare = text[: m.start()]
    if bare.lstrip().startswith(("-", "−")):
        raise FaultError(f"'{text}' has both a minus sign and a sense of rotation; leave out one of them")
    return bare, -1.0 if (m[1] or m[2]) in ("cw", "clockwise", "顺时针") else 1.0


def _advice(number: str, dim: Dim) -> str:
    return f"{number} {dim.example.split(' ', 1)[1]}"


def _named(dimension: str) -> str:
    return next((dim.label for dim in Dim if dim.dimension == dimension), "of another kind")
