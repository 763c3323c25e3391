"""A unit of another system is named with ours and the conversion; inches are read."""

from __future__ import annotations

import pytest

from vecpoly.errors import FaultError
from vecpoly.units.names import unit_of
from vecpoly.units.reading import Dim, read


@pytest.mark.parametrize(
    ("unit", "ours", "told"),
    [
        ("kgf", "N", "1 kgf = 9.80665 N"),
        ("kgf*cm", "N", "1 kgf = 9.80665 N"),
        ("lbf", "N", "1 lbf = 4.448222 N"),
        ("lb", "kg", "1 lb = 0.4535924 kg"),
        ("ft", "mm", "1 ft = 304.8 mm"),
        ("ft/s", "mm", "1 ft = 304.8 mm"),
        ("psi", "MPa", "1 psi = 0.006894757 MPa"),
        ("公斤力", "N", "1 公斤力 = 9.80665 N"),
        ("ms", "s", "1 ms = 0.001 s"),
    ],
)
def test_a_unit_of_another_system_is_answered_with_ours_and_the_conversion(unit: str, ours: str, told: str) -> None:
    with pytest.raises(FaultError) as refused:
        unit_of(unit)
    assert f"did you mean '{ours}'? {told}" in refused.value.words.en
    assert f"是否指“{ours}”？换算：{told}" in refused.value.words.zh


def test_inches_are_read() -> None:
    assert unit_of("in")[0] == pytest.approx(0.0254)


def test_one_over_a_second_is_told_to_lack_its_angle() -> None:
    with pytest.raises(FaultError, match=r"its unit '1/s' is without an angle; write e\.g\. 10 rad/s ccw"):
        read("5 1/s", Dim.OMEGA)


@pytest.mark.parametrize("unit", ["rad/s**2", "kg*m**2"])
@pytest.mark.parametrize("letter", ["q", "x"])
def test_a_unit_with_a_wrong_letter_is_answered_with_the_right_one_with_its_power(unit: str, letter: str) -> None:
    with pytest.raises(FaultError) as refused:
        unit_of(letter + unit[1:])
    assert f"did you mean '{unit.replace('**', '^')}'?" in refused.value.words.en
