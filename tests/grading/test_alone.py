"""What somebody is told who checks his own answers: of one value, and of nobody who marks it."""

from __future__ import annotations

import pytest
from typer.testing import CliRunner

from tests.grading.cases import key_of, marked, mutants_of, problem_of
from tests.laws import few
from vecpoly.cli.app import app
from vecpoly.grading.reading.written import written
from vecpoly.grading.student import check_answers
from vecpoly.grading.told.named import Told
from vecpoly.grading.told.veiled import veiled


def sentences(problem: str, *answers: str) -> str:
    return " ".join(
        said.words.en for one in check_answers(problem_of(problem), answers).answers for said in one.messages
    )


@pytest.mark.parametrize(
    ("problem", "answer", "said"),
    few(
        [
            ("3-12", "ak_D5D4=1.156", "the 2 of $a^k_{D5D4}$"),
            ("3-12", "a_F=0.2395", "off by 10^-1"),
            ("3-12", "a_F=23.95", "off by 10^1"),
            ("3-12", "v_D=4.9", "off by 10^1"),
            ("D-1", "P_13=(-0.0319, 0)", "off by 10^-3"),
        ],
        2,
    ),
)
def test_a_single_value_is_explained_by_what_lies_nearest(problem: str, answer: str, said: str) -> None:
    """By a mistake made with the very quantity before another's value; by a power of ten that fits to the last digit
    before a factor that hardly does."""
    assert said in sentences(problem, answer)


def test_a_yes_or_no_alone_bears_out_no_mistake() -> None:
    assert sentences("5-5", "self_locking=no") == "Not correct"


def test_a_number_of_another_dimension_is_not_right() -> None:
    checked = check_answers(problem_of("3-12"), ["v_F=0.687 m/s²"])
    assert not checked.right and not checked.as_json()["answers"][0]["right"]
    assert checked.rows("en")[0][2] == "wrong unit" and checked.rows("zh")[0][2] == "单位错"
    assert "The number is right, its unit is not" in sentences("3-12", "v_F=0.687 m/s²")
    assert CliRunner().invoke(app, ["check", "3-12", "v_F=0.687 m/s²"]).exit_code == 1
    assert CliRunner().invoke(app, ["check", "3-12", "v_F=0.687 m/s"]).exit_code == 0


@pytest.mark.parametrize("answer", ["v_F=hello", "v_F=0.687 m/s²", "omega_2=-1.26 ccw", "v_D=1,234", "P_13=1"])
def test_nobody_is_told_of_manual_marking_or_of_points_who_is_alone(answer: str) -> None:
    problem = "D-1" if answer.startswith("P") else "3-12"
    said = sentences(problem, answer)
    assert said and "manual" not in said and "deducted" not in said and "penalised" not in said


@pytest.mark.parametrize(
    ("text", "truth"),
    [
        ("不平衡", False), ("动平衡", True), ("未平衡", False), ("unbalanced", False), ("statically balanced", True),
        ("不能自锁", False), ("会自锁", True), ("不失真", False), ("发生根切", True), ("不满足", False), ("是。", True),
        ("not self-locking", False), ("满足要求", None), ("平", None), ("3", None),
    ],
)  # fmt: skip
def test_yes_and_no_are_read_in_the_words_of_what_is_asked(text: str, truth: bool | None) -> None:
    assert written(text).yes is truth


def test_what_cannot_be_read_says_what_is_asked() -> None:
    assert "minutes and seconds of arc are below 60" in sentences("8-4", "theta=35°60′")
    assert "yes or no is asked" in sentences("6-4", "dynamic=perhaps")
    assert written("35°59′").value == pytest.approx(35 + 59 / 60, abs=1e-4)


@pytest.mark.parametrize("times", [1.28, 1.49, 1.75])
def test_what_a_mistake_would_spread_widely_is_an_error_by_itself_beside_what_is_right(times: float) -> None:
    """By the other side AD would be 419 ± 82 mm, and γ_min 32° instead of 44°: what is right speaks against it."""
    right = {"theta": "20", "gamma_min": "43.8"}
    sheet = marked("8-15", right | {"AD": f"{times * key_of('8-15')['AD'].exact:.0f}"})
    assert not sheet["AD"].is_right and not sheet.slips and sheet["gamma_min"].is_right


def test_the_same_mistake_is_named_where_all_that_rests_on_it_follows() -> None:
    """On the other side lies the second solution: who gives it twice has drawn the first wrong, and who gives no other
    has called it the first."""
    (one,) = (each for each in mutants_of("8-15") if str(each.slip) == "C1P other side")
    cells = {name: f"{one.values[name].value:.1f}" for name in ("AD", "gamma_min")}
    both = {each.key: f"{each.exact:.5g}" for each in key_of("8-15").quantities if each.asked}
    assert set(marked("8-15", both | cells).slips.values()) == {one.slip}
    alone = marked("8-15", cells | {"theta": "20"})
    assert not alone.slips and not alone.roots and [said.id for said in alone.messages] == [Told.RENUMBERED]


@pytest.mark.parametrize(("problem", "answer"), [("3-9", "v_E=0.18"), ("golden", "omega_2=2.7 cw")])
def test_what_is_right_only_by_the_rounding_of_its_last_digit_is_told_so(problem: str, answer: str) -> None:
    """v_E is 0.1727 ± 0.0065 m/s: 0.18 lies farther off, and is right for what its last digit may hide."""
    checked = check_answers(problem_of(problem), [answer])
    (said,) = (one for one in checked.answers[0].messages if one.id is Told.OK_ROUNDED)
    e, t, w = (float(str(said.numbers[key]).partition(" ")[0]) for key in ("e", "t", "w"))
    assert checked.right and t < e <= w and "with the rounding" in said.words.en
    assert [one.id for one in veiled([said])] == [Told.RIGHT]


def test_a_wrong_size_of_the_wrong_sense_is_off_by_both_and_told_of_both() -> None:
    exact = key_of("3-9")["omega_2"].exact
    sense, other = ("ccw", "cw") if exact > 0 else ("cw", "ccw")
    (wrong,) = check_answers(problem_of("3-9"), [f"omega_2={3.3 * abs(exact):.3g} {other}"]).answers
    assert wrong.off == pytest.approx(4.3 * abs(exact), rel=0.01)
    assert f"off by {4.3 * abs(exact):.2g}" in wrong.messages[0].words.en
    assert [one.id for one in wrong.messages] == [Told.WRONG, Told.SENSE_TOO]
    (wrong,) = check_answers(problem_of("3-9"), [f"omega_2={3.3 * abs(exact):.3g} {sense}"]).answers
    assert [one.id for one in wrong.messages] == [Told.WRONG]


def test_a_direction_near_east_is_judged_as_finely_as_any_other() -> None:
    """359.9° and 0.1° are neighbours: T was 185°, and every direction right."""
    assert key_of("engine-four")["theta_II"].exact == 0 and key_of("engine-four")["theta_II"].allowed < 3
    assert check_answers(problem_of("engine-four"), ["theta_II=359.5"]).right
    assert not check_answers(problem_of("engine-four"), ["theta_II=180"]).right


def test_a_value_that_is_close_is_no_right_one_because_its_sense_is_not_said() -> None:
    one = key_of("3-9")["omega_2"]
    size = abs(one.exact) + 1.3 * one.allowed
    for answer in (f"omega_2={size:.5g}", f"omega_2={size:.5g} cw"):
        (checked,) = check_answers(problem_of("3-9"), [answer]).answers
        assert checked.outcome.value == "close"
    assert "Its sense is not stated" in sentences("3-9", f"omega_2={size:.5g}")


def test_what_follows_from_a_wrong_power_is_drawn_anew() -> None:
    assert sentences("5-6", "P_out=6.864", "P=8.347").endswith("Right when continued from your $P_r$ = 6.864 kW")


def test_a_number_without_a_unit_and_a_count_are_told_as_such() -> None:
    assert sentences("2-3", "n=3", "class_1=2 N") == "Correct Correct This quantity has no unit, and 'N' is written"
    assert sentences("2-3", "n=7") == "Not correct"


def test_a_power_of_ten_in_an_angle_does_not_excuse_one_in_lengths() -> None:
    answers = [f"{name}={1e3 * key_of('8-16')[name].exact:.5g}" for name in ("theta", "AB", "BC")]
    said = [checked.outcome.value for checked in check_answers(problem_of("8-16"), answers).answers]
    assert said.count("right") == 1  # BC, after AB


def test_what_is_zero_is_wrong_by_itself_beside_another_that_is_zero() -> None:
    """That two quantities are zero is no mistake with which the second is right."""
    checked = check_answers(problem_of("engine-four"), ["W_I=1", "C_I=50", "C_II=1"])
    assert [one.outcome.is_right for one in checked.answers] == [False, False, False]
    assert all(one.messages[0].id is Told.ZERO for one in checked.answers)


def test_a_direction_of_0_degrees_is_no_quantity_that_is_zero() -> None:
    assert "zero" not in (said := sentences("engine-four", "theta_II=30")) and "Not correct" in said
