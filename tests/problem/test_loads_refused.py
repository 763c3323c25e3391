"""Thrusts of cylinders that cannot be meant are refused at their line; friction circles are taken up to half a link."""

from __future__ import annotations

import pytest

from tests.problem.test_no_key_is_ignored import CYLINDER
from tests.texts import SLIDER_CRANK
from vecpoly.errors import ProblemFileError
from vecpoly.problem.load import loads

GOOD = '{cylinder: 2-3, size: "?"}'


@pytest.mark.parametrize(
    ("written", "zh", "en"),
    [
        (
            '{cylinder: two, size: "?"}',
            "不是两个构件号；请写 cylinder: 2-3",
            "is no pair of links; write cylinder: 2-3",
        ),
        (
            '{cylinder: "2", size: "?"}',
            "不是两个构件号；请写 cylinder: 2-3",
            "is no pair of links; write cylinder: 2-3",
        ),
        ("{cylinder: 2-3}", "缺少大小", "the size is missing"),
        ('{cylinder: 2-3, at: C, size: "?"}', "请删去 at", "acts along it; leave out at"),
        ('{cylinder: 2-3, direction: 0 deg, size: "?"}', "请删去 direction", "acts along it; leave out direction"),
    ],
)
def test_a_thrust_that_cannot_be_meant_is_refused_with_what_to_write(written: str, zh: str, en: str) -> None:
    assert GOOD in CYLINDER and loads(CYLINDER)
    with pytest.raises(ProblemFileError) as refused:
        loads(CYLINDER.replace(GOOD, written))
    (fault,) = refused.value.faults
    assert en in fault.words.en and zh in fault.words.zh
    assert fault.place is not None and fault.place.line == 8


@pytest.mark.parametrize("pin", ["A", "B"])
def test_a_friction_circle_may_fill_half_its_link_and_no_more(pin: str) -> None:
    text = SLIDER_CRANK + (
        "input: {link: 1, phi: 52 deg, omega: 10 rad/s ccw}\nbranch: [C right of B]\n"
        'loads: {F: {on: 3, at: C, size: 1000 N, direction: 180 deg}, M_1: {on: 1, size: "?"}}\n'
        f"friction: {{{pin}: {{rho: RHO mm}}}}\n"
    )
    half = loads(text.replace("RHO", "1")).mechanism.link("1").points
    most = 500 * abs(half["B"] - half["A"])
    loads(text.replace("RHO", f"{0.999 * most:.6g}"))
    with pytest.raises(ProblemFileError, match="more than half"):
        loads(text.replace("RHO", f"{1.001 * most:.6g}"))


def test_the_angle_of_a_groove_goes_with_a_coefficient_and_not_with_an_angle_of_friction() -> None:
    text = SLIDER_CRANK + "input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}\nbranch: [C right of A]\n"
    text += 'loads:\n  F: {on: 3, at: C, size: 10 N, direction: 0 deg}\n  M_1: {on: 1, size: "?"}\n'
    assert loads(text + "friction: {3-4: {f: 0.1, V: 40 deg}}\n")
    with pytest.raises(ProblemFileError, match="V goes with the f of the groove's faces"):
        loads(text + "friction: {3-4: {phi: 8 deg, V: 40 deg}}\n")
