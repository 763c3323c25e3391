"""Expressions of quantities: laws of arithmetic, units, and what is refused."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.errors import FaultError
from vecpoly.units.reckoning import Amount, reckon

NUMBERS = st.integers(1, 999)


@given(NUMBERS, NUMBERS, NUMBERS, st.sampled_from("+-*/"), st.sampled_from("+-*/"))
def test_products_bind_closer_than_sums_and_all_goes_from_the_left(a: int, b: int, c: int, one: str, two: str) -> None:
    text = f"{a} {one} {b} {two} {c}"
    assert reckon(text, {}).si == pytest.approx(float(_exactly(a, b, c, one, two)), rel=1e-12, abs=1e-12)


def _exactly(a: int, b: int, c: int, one: str, two: str) -> Fraction:
    x, y, z = Fraction(a), Fraction(b), Fraction(c)
    do = {"+": Fraction.__add__, "-": Fraction.__sub__, "*": Fraction.__mul__, "/": Fraction.__truediv__}
    if two in "*/" and one in "+-":
        return do[one](x, do[two](y, z))
    return do[two](do[one](x, y), z)


@given(NUMBERS, NUMBERS)
def test_lengths_divide_to_a_pure_number(a: int, b: int) -> None:
    ratio = reckon(f"linkage.AB / {b} mm", {"linkage.AB": Amount.of(a, "mm")})
    assert ratio.powers == () and ratio.si == pytest.approx(a / b)


@given(NUMBERS)
def test_what_is_shown_is_read_back(a: int) -> None:
    for unit in ("mm", "deg", "rad/s", "N", "N*m", "kg*m^2"):
        value = Amount.of(a, unit)
        again = reckon(value.shown(9), {})
        assert again.powers == value.powers and again.si == pytest.approx(value.si)


@pytest.mark.parametrize(
    "text", ["", "()", "1 +", "2 ** 3", "open('x')", "a", "1 deg + 1 mm", "1 / 0", "(" * 99, "1 kgg"]
)
def test_what_is_no_expression_is_refused(text: str) -> None:
    with pytest.raises(FaultError):
        reckon(text, {})


def test_a_name_that_is_not_known_is_told_with_those_of_its_part_or_with_the_parts() -> None:
    known = {"linkage.AB": Amount.of(30, "mm"), "linkage.CD": Amount.of(60, "mm"), "gears.z": Amount(20)}
    with pytest.raises(FaultError, match=r"no quantity 'linkage\.BA'; known here: linkage\.AB, linkage\.CD$"):
        reckon("2 * linkage.BA", known)
    with pytest.raises(FaultError, match=r"no quantity 'cam\.h'; known here: gears, linkage$"):
        reckon("cam.h", known)
    with pytest.raises(FaultError, match="only earlier parts"):
        reckon("cam.h", {})
