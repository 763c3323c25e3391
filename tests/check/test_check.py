"""Printed answers get the verdict they deserve, and the slip behind a wrong one is named."""

from __future__ import annotations

from dataclasses import replace
from math import pi

import pytest

from vecpoly.check.printed.answers import check_problem
from vecpoly.check.printed.verdict import Verdict, check_printed
from vecpoly.names import Named, parse_rel
from vecpoly.problem.load import load
from vecpoly.problem.problem import Printed
from vecpoly.report.tables import printed_table


def printed(text: str, value: float, kind: str = "calculated", key: str = "v_E") -> Printed:
    return Printed(symbol=key, rel=parse_rel(key), value=value, text=text, kind=kind)  # type: ignore[arg-type]


def verdicts(name: str) -> dict[str, Verdict]:
    return {c.printed.symbol: c.verdict for c in check_problem(load(name)).answers}


@pytest.mark.parametrize(
    ("text", "exact", "verdict"),
    [
        ("3.14 m/s", 3.1449, Verdict.REPRODUCED),
        ("3.14 m/s", 3.1451, Verdict.ROUNDING),
        ("3.14 m/s", 3.1599, Verdict.ROUNDING),
        ("3.14 m/s", 3.1601, Verdict.WRONG),
    ],
)
def test_a_calculated_value_is_judged_by_its_last_printed_digit(text: str, exact: float, verdict: Verdict) -> None:
    assert check_printed(printed(text, 3.14), exact).verdict is verdict


@pytest.mark.parametrize(
    ("figures", "verdict"),
    [(None, Verdict.WRONG), (3, Verdict.REPRODUCED), (4, Verdict.REPRODUCED), (5, Verdict.WRONG)],
)
def test_a_book_is_held_to_no_more_figures_than_it_reckoned_with(figures: int | None, verdict: Verdict) -> None:
    """The balancing product of exercise 6-1: 10.904 kg·cm, where 10.9087 is exact."""
    told = replace(printed("10.904 kg*cm", 0.10904), figures=figures)
    assert check_printed(told, 0.1090874).verdict is verdict


@pytest.mark.parametrize(
    ("value", "verdict"),
    [
        (1.0299, Verdict.REPRODUCED),
        (1.0301, Verdict.OUTLIER),
        (1.0999, Verdict.OUTLIER),
        (1.1001, Verdict.WRONG),
        (0.9701, Verdict.REPRODUCED),
        (0.9699, Verdict.OUTLIER),
    ],
)
def test_a_value_read_off_a_drawing_may_be_three_per_cent_off(value: float, verdict: Verdict) -> None:
    assert check_printed(printed(f"{value} m/s", value, "graphical"), 1.0).verdict is verdict


@pytest.mark.parametrize(
    ("value", "verdict"),
    [(26.9, Verdict.REPRODUCED), (28.0, Verdict.OUTLIER), (30.0, Verdict.WRONG), (227.0, Verdict.WRONG)],
)
def test_an_angle_read_off_a_drawing_may_be_a_degree_off_whatever_its_size(value: float, verdict: Verdict) -> None:
    """3 % would be 0.8° of 26° and 7° of 227°."""
    told = replace(printed(f"{value} deg", value, "graphical"), rel=Named("theta", "θ", "deg"))
    assert check_printed(told, 222.0 if value > 200 else 26.0).verdict is verdict


def test_a_table_of_printed_answers_tells_angles_off_in_degrees() -> None:
    made = printed_table(check_problem(load("3-2")).answers, "zh")
    assert made is not None and made.header[-1] == "偏差"
    assert [row[-1] for row in made.rows if "φ" in row[0]] == ["+0.4°", "−0.4°"]
    assert [row[-1] for row in made.rows if "ω" in row[0]] == ["+0.4 %"]


def test_an_exact_value_stands_in_the_unit_of_the_printed_one() -> None:
    made = printed_table(check_problem(load("6-1")).answers, "en")
    assert made is not None and made.header[1] == "Unit"
    assert ("kg·cm", "7.65", "7.658") in [row[1:4] for row in made.rows], "not 0.076576 kg·m"


def test_that_all_printed_answers_agree_is_said_once_below_them() -> None:
    made = printed_table(check_problem(load("3-2")).answers, "en")
    wrong = printed_table(check_problem(load("8-15")).answers, "en")
    assert made is not None and "Verdict" not in made.header
    assert wrong is not None and wrong.header[-1] == "Verdict"


@pytest.mark.parametrize(
    ("factor", "slip"),
    [(10.0, "10 times"), (0.001, "0.001 times"), (2 * pi / 60, "r/min"), (1 / (2 * pi), "2π left out")],
)
def test_the_usual_slips_are_recognised(factor: float, slip: str) -> None:
    checked = check_printed(printed("x", 0.173 * factor, "graphical"), 0.173)
    assert checked.verdict is Verdict.WRONG
    assert checked.slip is not None and slip in checked.slip.en


def test_a_wrong_sense_is_recognised() -> None:
    checked = check_printed(printed("-2 rad/s", -2.0, key="omega_2"), 2.0)
    assert checked.verdict is Verdict.WRONG
    assert checked.slip is not None and "sense" in checked.slip.en


def test_an_unsigned_angular_velocity_is_compared_by_magnitude() -> None:
    assert check_printed(printed("2 rad/s", 2.0, key="omega_2"), -2.0).verdict is Verdict.REPRODUCED


def test_3_14_is_printed_ten_times_too_large() -> None:
    answers = {c.printed.symbol: c for c in check_problem(load("3-14")).answers}
    assert answers["v_C"].verdict is Verdict.WRONG
    assert answers["v_C"].slip is not None and "10 times" in answers["v_C"].slip.en
    assert answers["omega_2"].verdict is Verdict.REPRODUCED


def test_3_9_has_a_drawing_slip_in_alpha_only() -> None:
    found = verdicts("3-9")
    assert found.pop("alpha_2") is found.pop("at_C2B") is Verdict.OUTLIER
    assert set(found.values()) == {Verdict.REPRODUCED}
    alpha = next(c for c in check_problem(load("3-9")).answers if c.printed.symbol == "alpha_2")
    assert alpha.deviation == pytest.approx(-0.0474, abs=1e-4)


def test_3_5_as_printed_is_impossible() -> None:
    result = check_problem(load("3-5"))
    assert result.whole is not None and "impossible" in result.whole.en and "不可能" in result.whole.zh
    assert result.fit is not None and result.fit.misfit > 0.2


def test_3_5_with_the_emended_length_is_possible() -> None:
    result = check_problem(load("3-5-xD400"))
    assert result.whole is None
    assert verdicts("3-5-xD400")["omega_3"] is Verdict.REPRODUCED


def test_the_conveyor_lost_two_pi() -> None:
    result = check_problem(load("C-conveyor"))
    assert result.whole is not None and "2π" in result.whole.en
    assert {c.printed.symbol for c in result.answers if c.verdict is Verdict.WRONG} >= {
        "v_B",
        "v_E",
        "a_B",
        "a_C",
        "a_E",
    }


@pytest.mark.parametrize(
    ("key", "ratio", "slip"), [("ak_B3B2", 0.5, "the 2 of"), ("v_E", 0.5, None), ("v_E", 2.0, None), ("a_E", 2.0, None)]
)
def test_a_factor_2_is_a_slip_only_where_a_formula_has_it(key: str, ratio: float, slip: str | None) -> None:
    checked = check_printed(printed("x", 0.173 * ratio, "graphical", key=key), 0.173)
    assert checked.verdict is Verdict.WRONG
    assert (checked.slip is None) if slip is None else (checked.slip is not None and slip in checked.slip.en)


def test_the_rate_of_a_link_that_translates_is_wrong_with_the_reason() -> None:
    checked = check_printed(printed("2 rad/s", 2.0, key="omega_4"), 1e-17)
    assert checked.verdict is Verdict.WRONG and checked.exact == 0.0
    assert checked.slip is not None and "link 4 does not turn here" in checked.slip.en and "构件 4" in checked.slip.zh


@pytest.mark.parametrize(
    ("text", "value", "exact", "verdict"),
    [
        ("3 rad/s", 3.0, 1.2575, Verdict.WRONG),
        ("2 rad/s", 2.0, 1.2575, Verdict.ROUNDING),
        ("1.27 rad/s", 1.27, 1.2575, Verdict.ROUNDING),
    ],
)
def test_two_units_of_the_last_digit_are_rounding_only_where_they_are_little(
    text: str, value: float, exact: float, verdict: Verdict
) -> None:
    assert check_printed(printed(text, value, key="omega_2"), exact).verdict is verdict
