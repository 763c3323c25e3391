"""What the steps use has the name under which it is given."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.devices.balancing.rotor import Rotor
from vecpoly.problem.load import load, loads


@pytest.mark.parametrize(
    ("name", "radius"), [("planetary-sun-drives", "$r_K$ = 90 mm"), ("planet-drive", "$r_H$ = 40 mm")]
)
def test_the_radius_of_a_fixed_wheel_is_a_datum(name: str, radius: str) -> None:
    told = [datum for datum in load(name).given.lengths if radius in datum.of("zh")]
    assert len(told) == 1 and radius in told[0].of("en")


def test_the_radii_of_two_fixed_wheels_have_two_names() -> None:
    told = " ".join(datum.of("en") for datum in load("two-trains-one-sun").given.lengths)
    assert "$r_K$ = 50 mm" in told and "$r_N$ = 66 mm" in told


@pytest.mark.parametrize(
    ("name", "told"), [("press-flywheel", "$n_1$ = 120 r/min"), ("planetary-sun-drives", "$ω_1$ = 20 rad/s")]
)
def test_a_speed_in_turns_a_minute_is_n_and_one_in_radians_omega(name: str, told: str) -> None:
    speeds = [datum.of("en") for datum in load(name).given.motion if datum.symbol == "ω_1"]
    assert [one.startswith(told) for one in speeds] == [True]


def test_a_datum_told_in_words_has_its_value_where_the_words_leave_a_gap() -> None:
    data = [datum for datum in load("cam-roller-load").given.data if datum.words is not None and datum.symbol]
    assert {datum.symbol for datum in data} >= {"r_3", "x_B", "Q"}
    for datum in data:
        told = datum.of("en"), datum.of("zh")
        assert all(f"= {datum.text}" in one and "{" not in one for one in told), told


def test_the_radius_of_an_osculating_circle_keeps_its_letter() -> None:
    steps = [step.words for step in drawn("cam-moves-flat-arm").solution.construction.steps]
    (found,) = [words for words in steps if "Hartmann" in words.en]
    (placed,) = [words for words in steps if "is always at the distance" in words.en]
    assert "$ρ$ = " in found.en and "at the distance $ρ$ from" in placed.en and "相距 $ρ$" in placed.zh


@pytest.mark.parametrize("name", ["6-5", "rotor-bolt-circle"])
def test_a_product_that_is_given_has_the_letter_with_which_it_is_gone_on(name: str) -> None:
    rotor = load(name).subject
    assert isinstance(rotor, Rotor)
    symbols = [symbol for symbol, _ in rotor.given()]
    assert "W_{1}" in symbols and not any(symbol.startswith("U") for symbol in symbols)


def test_a_point_so_far_to_the_left_less_than_nothing_is_told_on_the_right() -> None:
    text = load("curv-1").text.replace("id: curv-1", "id: other").replace("right: 20 mm", "left: -20 mm")
    told = [datum.words for datum in loads(text).given.lengths if datum.words is not None]
    assert any("and 20 mm to its right" in words.en and "右侧 20 mm" in words.zh for words in told)
