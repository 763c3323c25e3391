"""Values of a Python program as the texts of a problem file: '120 mm' as it is, a number in SI with its unit."""

from __future__ import annotations

from collections.abc import Sequence
from numbers import Real

from ...errors import ArgumentError
from ...units.reading import Dim
from ...words import Words
from .pairs import pair_of

Quantity = str | float
SI = {
    Dim.LENGTH: "m",
    Dim.ANGLE: "rad",
    Dim.OMEGA: "rad/s",
    Dim.ALPHA: "rad/s^2",
    Dim.SPEED: "m/s",
    Dim.ACCEL: "m/s^2",
    Dim.MU_L: "m/mm",
    Dim.MU_V: "(m/s)/mm",
    Dim.MU_A: "(m/s^2)/mm",
    Dim.MU_F: "N/mm",
    Dim.FORCE: "N",
    Dim.MOMENT: "N*m",
    Dim.MASS: "kg",
    Dim.INERTIA: "kg*m^2",
    Dim.DENSITY: "kg/m^3",
}


def is_number(value: object) -> bool:
    """A number that is no truth value."""
    return isinstance(value, Real) and not isinstance(value, bool)


def as_text(name: str, value: object, dim: Dim | None) -> str:
    """The text of one quantity: a number is in SI (m, rad, s, kg, N; a scale SI per mm), counter-clockwise positive."""
    if isinstance(value, str):
        return value.strip()
    if not is_number(value):
        raise ArgumentError(
            Words(
                f"{name} 应为带单位的文本（如 '120 mm'）或 SI 数值，而不是 {value!r}",
                f"{name} must be a text with its unit, such as '120 mm', or a number in SI, not {value!r}",
            ),
            code="kind",
        )
    number = float(value)  # type: ignore[arg-type]
    if dim is not None:
        return f"{number!r} {SI[dim]}"
    return f"{number:.0f}" if number.is_integer() else repr(number)  # 20 teeth, driver 1, not 20.0


def as_pair(name: str, value: object) -> list[str]:
    """The two texts of a point: two quantities, one text with a comma, or x + iy in m."""
    if isinstance(value, complex):
        value = (value.real, value.imag)
    parts = pair_of(value)
    if isinstance(parts, str) or not isinstance(parts, Sequence) or len(parts) != 2:
        raise ArgumentError(
            Words(
                f"点 {name} 需要两个坐标，如 ('120 mm', '0 mm')，而不是 {value!r}",
                f"the point {name} needs two coordinates such as ('120 mm', '0 mm'), not {value!r}",
            ),
            code="point",
        )
    return [as_text(name, part, Dim.LENGTH) for part in parts]
