"""Printed lengths of linkages: a misprinted digit is told, lengths whose data are lost are held against each other, and
what the library says of the book's own answers is so."""

from __future__ import annotations

from math import acos, cos, degrees, isclose, radians, sin, sqrt

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import vecpoly
from vecpoly.check.printed.answers import PrintedCheck, check_problem

LENGTHS = {"AB": 11.4, "BC": 42.5, "CD": 32.1, "AD": 23.3}


def limit_lines(lengths: dict[str, float], alpha: float) -> PrintedCheck:
    """8-5 with other lengths in print."""
    printed = [
        {"symbol": bar, "value": f"{size:.5g} mm", "kind": "graphical", "lost": "yes"} for bar, size in lengths.items()
    ]
    data = vecpoly.load("8-5").data
    return check_problem(
        vecpoly.problem(data | {"data": data["data"] | {"alpha_1": f"{alpha} deg"}, "printed": printed})
    )


def angle(opposite: float, one: float, other: float) -> float:
    """In a triangle, by the law of cosines (deg)."""
    return degrees(acos((one * one + other * other - opposite * opposite) / (2 * one * other)))


def test_the_printed_lengths_of_8_5_contradict_its_pressure_angle_and_the_frame_alone_can_be_to_blame() -> None:
    told = check_problem(vecpoly.load("8-5"))
    assert not told.answers and told.whole is not None
    a, b, c, d = LENGTHS.values()
    for way in (-1, 1):
        alpha = abs(90 - angle(d, b + way * a, c))
        assert f"{alpha:.1f}°" in told.whole.en and f"{alpha:.1f}°" in told.whole.zh
    meant = sqrt((b - a) ** 2 + c * c - 2 * (b - a) * c * cos(radians(90 - 40)))
    assert f"$l_{{AD}}$: {meant:.3g} mm" in told.whole.en and f"$l_{{AD}}$，应为 {meant:.3g} mm" in told.whole.zh


@given(st.floats(10, 25), st.floats(40, 90), st.floats(40, 90), st.floats(40, 90), st.sampled_from([-1, 1]))
def test_lengths_of_a_linkage_that_has_the_angle_contradict_nothing(
    a: float, b: float, c: float, d: float, way: int
) -> None:
    assume(a + max(b, c, d) < sum((b, c, d)) - max(b, c, d))
    alpha = abs(90 - angle(d, b + way * a, c))
    assume(alpha < 89)
    assert limit_lines({"AB": a, "BC": b, "CD": c, "AD": d}, alpha).whole is None


def crank_rocker(key: str, value: str) -> PrintedCheck:
    """8-15 with another answer in print."""
    data = vecpoly.load("8-15").data
    return check_problem(vecpoly.problem(data | {"printed": [{"symbol": key, "value": value, "kind": "graphical"}]}))


@given(st.sampled_from(["BC", "AD"]), st.integers(0, 1), st.sampled_from("123456789"))
def test_one_digit_that_is_misprinted_is_told_with_the_number_that_was_meant(key: str, at: int, digit: str) -> None:
    right = {"BC": "214.12", "AD": "282.53"}[key]
    wrong = right[:at] + digit + right[at + 1 :]
    assume(abs(float(wrong) / float(right) - 1) > 0.05)
    (one,) = crank_rocker(key, f"{wrong} mm").answers
    assert one.slip is not None and right[: at + 1] in one.slip.en and "疑有一位数字误排" in one.slip.zh


@pytest.mark.parametrize("value", ["399.33 mm", "151.87 mm", "272 mm", "27.2 mm"])
def test_a_value_that_no_single_digit_puts_right_or_of_few_digits_is_not_explained_so(value: str) -> None:
    (one,) = crank_rocker("BC", value).answers
    assert one.slip is None or "digit misprinted" not in one.slip.en


def test_of_8_13_and_of_the_frame_of_8_15_no_digit_is_to_blame() -> None:
    wrong = [
        one for name in ("8-13", "8-15") for one in check_problem(vecpoly.load(name)).answers if one.verdict == "wrong"
    ]
    assert [(one.printed.symbol, one.slip is not None) for one in wrong] == [("AB", False), ("BC", True), ("AD", False)]


def test_what_is_said_of_the_printed_lengths_of_8_15_and_8_13_is_so() -> None:
    a, c, theta, chord = 75.0, 300.0, radians(20), 600 * sin(radians(16))

    def coupler(span: float) -> float:
        return sqrt((span**2 - 2 * a * a * (1 + cos(theta))) / (2 * (1 - cos(theta))))

    def span(b: float) -> float:
        return sqrt(2 * a * a * (1 + cos(theta)) + 2 * b * b * (1 - cos(theta)))

    assert abs(span(212.24) / chord - 1) < 0.002 < abs(span(272.24) / chord - 1)
    per_degree = coupler(600 * sin(radians(16.25))) - coupler(600 * sin(radians(15.75)))
    assert isclose(per_degree, 32, abs_tol=1)
    b, d = 272.24, 269.1
    swing = angle(b + a, c, d) - angle(b - a, c, d)
    seen = abs(angle(c, b - a, d) - angle(c, b + a, d))
    assert f"{swing:.1f}" == "34.9" and f"{(180 + seen) / (180 - seen):.3f}" == "1.276"
    crank, rocker = 11.1, 36.8
    places = [(crank, 90, 45), (crank, 30, 0)]
    one, other = (
        abs(
            30
            + rocker * complex(cos(radians(psi)), sin(radians(psi)))
            - r * complex(cos(radians(phi)), sin(radians(phi)))
        )
        for r, phi, psi in places
    )
    assert f"{abs(one - other):.2f}" == "0.52"
