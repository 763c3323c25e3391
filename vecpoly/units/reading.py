"""Quantities with written units, each of the kind that is expected."""

from __future__ import annotations

import math
import re
from enum import Enum
from functools import lru_cache

from ..errors import FaultError
from ..foundation.patterns import pattern
from ..foundation.slotted import dataclass
from ..limits import LEAST, MOST, MOST_ANGLE, MOST_LENGTH
from ..words import Words
from .comma import refuse_comma
from .names import plain, unit_of


class Dim(Enum):
    """A kind of quantity: its name in both languages, its dimension, and how one is written."""

    LENGTH = (Words("长度", "a length"), "length 1", "30 mm")
    ANGLE = (Words("角度", "an angle"), "angle 1", "60 deg")
    OMEGA = (Words("角速度", "an angular velocity"), "angle 1 time -1", "10 rad/s ccw")
    ALPHA = (Words("角加速度", "an angular acceleration"), "angle 1 time -2", "5 rad/s^2 ccw")
    SPEED = (Words("速度", "a velocity"), "length 1 time -1", "0.5 m/s")
    ACCEL = (Words("加速度", "an acceleration"), "length 1 time -2", "2 m/s^2")
    MU_L = (Words("长度比例尺", "a length scale"), "", "0.002 m/mm")
    MU_V = (Words("速度比例尺", "a velocity scale"), "time -1", "0.01 (m/s)/mm")
    MU_A = (Words("加速度比例尺", "an acceleration scale"), "time -2", "0.1 (m/s^2)/mm")
    MU_F = (Words("力比例尺", "a force scale"), "mass 1 time -2", "10 N/mm")
    FORCE = (Words("力", "a force"), "length 1 mass 1 time -2", "1000 N")
    MOMENT = (Words("力矩", "a moment"), "length 2 mass 1 time -2", "20 N*m ccw")
    MASS = (Words("质量", "a mass"), "mass 1", "3 kg")
    PRODUCT = (Words("质径积", "a product of mass and radius"), "length 1 mass 1", "0.2 kg*m")
    INERTIA = (Words("转动惯量", "a moment of inertia"), "length 2 mass 1", "0.02 kg*m^2")
    DENSITY = (Words("密度", "a density"), "length -3 mass 1", "7800 kg/m^3")
    AREA = (Words("面积", "an area"), "length 2", "400 mm^2")
    WORK = (Words("功", "a work"), "length 2 mass 1 time -2", "600 J")
    MU_WORK = (Words("面积比例尺", "a scale of areas"), "mass 1 time -2", "12 J/mm^2")
    TIME = (Words("时间", "a time"), "time 1", "0.5 s")
    DRAG = (Words("转动阻尼系数", "a torsional drag"), "length 2 mass 1 time -1", "0.05 N*m*s")
    POWER = (Words("功率", "a power"), "length 2 mass 1 time -3", "5 kW")
    PRESSURE = (Words("压强", "a pressure"), "length -1 mass 1 time -2", "2 MPa")
    STIFFNESS = (Words("弹簧刚度", "a stiffness"), "mass 1 time -2", "5 N/mm")
    TWIST = (Words("扭转刚度", "a torsional stiffness"), "angle -1 length 2 mass 1 time -2", "2 N*m/rad")
    DAMPING = (Words("阻尼系数", "a coefficient of damping"), "mass 1 time -1", "50 N*s/m")

    @property
    def label(self) -> Words:
        label = self.value[0]
        assert isinstance(label, Words)
        return label

    @property
    def dimension(self) -> str:
        return str(self.value[1])

    @property
    def example(self) -> str:
        return str(self.value[2])


@dataclass(frozen=True, slots=True)
class PerMm:
    """A scale of drawings as it is written: so much of a unit for a millimetre on paper."""

    label: Words
    unit: str
    example: str

    @property
    def dimension(self) -> str:
        """Of the unit over a length."""
        unit = plain(self.unit)
        return unit_of(f"({unit})/mm" if "/" in unit else f"{unit}/mm")[1]


@dataclass(frozen=True, slots=True)
class Quantity:
    """A value in SI (a scale: SI per mm on paper) and as it was written."""

    si: float
    text: str


_GREATEST: dict[Dim | PerMm, float] = {Dim.ANGLE: MOST_ANGLE, Dim.LENGTH: MOST_LENGTH}
_NUMBER = pattern(r"\s*([+\-−]?(?:\d+\.?\d*|\.\d+)(?:[eE][+\-]?\d+)?|[+\-]?(?:nan|inf(?:inity)?)\b)\s*(.*?)\s*", re.I)
_FRACTION = pattern(r"\s*([+\-−]?\d+(?:\.\d+)?)\s*/\s*(\d+(?:\.\d+)?)\s*")
_SENSE = pattern(r"\s*(?:\b(ccw|acw|cw|(?:counter|anti)-?clockwise|clockwise)|(逆时针|顺时针)(?:方向)?)$", re.I)


def read(text: object, dim: Dim | PerMm) -> Quantity:
    """A written quantity of this dimension; raises FaultError with what is wrong and how to write it."""
    if not isinstance(text, str):
        raise _refused(Words(f"此处应为{dim.label.zh}", f"{dim.label.en} is expected here"), dim)
    return _read(text, dim)


@lru_cache(maxsize=4096)
def _read(text: str, dim: Dim | PerMm) -> Quantity:
    """The same of a text; variants of a problem say most quantities again."""
    bare, sign = _split_sense(text, dim)
    m = _NUMBER.fullmatch(bare)
    if m is None:
        raise _refused(Words(f"“{text}”不是{dim.label.zh}", f"'{text}' is not {dim.label.en}"), dim, "spelling")
    refuse_comma(text)
    number, unit = float(m[1].replace("−", "-")), plain(m[2])
    if not math.isfinite(number):
        raise _refused(Words(f"“{text}”不是有限的数", f"'{text}' is not a finite number"), dim)
    if not unit:
        if number == 0:
            return Quantity(0.0, text)
        advice = _advice(m[1], dim)
        raise FaultError(
            Words(
                f"“{text}”没有单位，此处应为{dim.label.zh}；如写 {advice}",
                f"'{text}' has no unit; {dim.label.en} is needed: write e.g. {advice}",
            ),
            code="no-unit",
            numbers={"written": text},
        )
    factor, dimension = unit_of(unit)
    if dimension != dim.dimension:
        other = _named(dimension, unit)
        raise _refused(
            Words(
                f"“{text}”不是{dim.label.zh}：单位“{m[2]}”属于{other.zh}",
                f"'{text}' is not {dim.label.en}: its unit '{m[2]}' is {other.en}",
            ),
            dim,
            "wrong-unit",
            text,
        )
    per_mm = 1e-3 if isinstance(dim, PerMm) or dim in (Dim.MU_L, Dim.MU_V, Dim.MU_A, Dim.MU_F) else 1.0
    per_mm = 1e-6 if dim is Dim.MU_WORK else per_mm
    return Quantity(sign * _sensible(_times(number, factor * per_mm), text, dim), text)


def _sensible(si: float, text: str, dim: Dim | PerMm) -> float:
    """The value, unless no mechanism on earth has it:
    its square would overflow, or its angle be lost in rounding. Below LEAST it is zero."""
    if abs(si) > _GREATEST.get(dim, MOST):
        raise FaultError(
            Words(
                f"“{text}”作为{dim.label.zh}过大；请检查数值和单位，如写 {dim.example}",
                f"'{text}' is too large for {dim.label.en}; check number and unit, and write e.g. {dim.example}",
            ),
            code="out-of-range",
        )
    return 0.0 if abs(si) < LEAST else si


def _times(number: float, factor: float) -> float:
    """The product; a division where that is exact, so that 350 mm is 0.35 m to the last digit."""
    inverse = 1 / factor
    return number / round(inverse) if inverse > 1 and abs(inverse - round(inverse)) < 1e-9 else number * factor


def positive(text: object, dim: Dim = Dim.LENGTH) -> Quantity:
    """A quantity greater than zero, such as a link's length."""
    quantity = read(text, dim)
    if quantity.si <= 0:
        raise FaultError(
            Words(
                f"“{quantity.text}”应大于零；如写 {dim.example}",
                f"'{quantity.text}' must be greater than zero; write e.g. {dim.example}",
            ),
            code="out-of-range",
        )
    return quantity


def not_negative(text: object, dim: Dim = Dim.LENGTH) -> Quantity:
    """A quantity that may be zero, such as an offset."""
    quantity = read(text, dim)
    if quantity.si < 0:
        text, without = quantity.text, quantity.text.strip(" -−")
        why = Words(f"“{text}”不应为负；请写 {without}", f"'{text}' must not be negative; write {without}")
        raise FaultError(why, code="out-of-range")
    return quantity


def pure(text: object, example: str) -> float:
    """A finite number without a unit, a fraction of two, 1/50, or so many per cent, 5 %; raises FaultError."""
    bare = str(text).strip()
    whole, below = (bare[:-1], "100") if bare.endswith(("%", "％")) else (bare, "1")
    above, below = m.groups() if (m := _FRACTION.fullmatch(bare)) else (whole, below)
    try:
        number = float(above.replace("−", "-")) / float(below)
    except (ValueError, ZeroDivisionError):
        refuse_comma(str(text))
        raise FaultError(
            Words(f"“{text}”不是纯数；如写 {example}", f"'{text}' is no pure number; write e.g. {example}"),
            code="spelling",
        ) from None
    if not abs(number) <= MOST:
        raise FaultError(
            Words(f"“{text}”不是有限的数；如写 {example}", f"'{text}' is not a finite number; write e.g. {example}"),
            code="out-of-range",
        )
    return number


def _split_sense(text: str, dim: Dim | PerMm) -> tuple[str, float]:
    m = _SENSE.search(text)
    if m is None:
        return text, 1.0
    if "angle" not in dim.dimension and dim is not Dim.MOMENT:
        raise _refused(
            Words(f"“{text}”：{dim.label.zh}没有转向", f"'{text}': {dim.label.en} has no sense of rotation"), dim
        )
    bare = text[: m.start()]
    if bare.lstrip().startswith(("-", "−")):
        raise FaultError(
            Words(
                f"“{text}”既有负号又有转向；请去掉其一",
                f"'{text}' has both a minus sign and a sense of rotation; leave out one of them",
            ),
            code="contradiction",
        )
    return bare, -1.0 if (m[1] or m[2]).lower() in ("cw", "clockwise", "顺时针") else 1.0


def _refused(cause: Words, dim: Dim | PerMm, code: str = "value", written: str = "") -> FaultError:
    """What is wrong, and how a quantity of this kind is written."""
    numbers = {"written": written} if written else {}
    return FaultError(cause + Words(f"；如写 {dim.example}", f"; write e.g. {dim.example}"), code=code, numbers=numbers)


def _advice(number: str, dim: Dim | PerMm) -> str:
    return f"{number} {dim.example.split(' ', 1)[1]}"


def _named(dimension: str, unit: str) -> Words:
    if dimension.startswith("time -") and "mm" not in unit:  # 1/s is no scale
        return Words("不含角度的量", "without an angle")
    return next((dim.label for dim in Dim if dim.dimension == dimension), Words("其他量", "of another kind"))
