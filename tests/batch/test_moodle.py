"""Questions for Moodle, of every problem on file: each blank can be answered rightly, and says what it shows."""

from __future__ import annotations

import re
import xml.etree.ElementTree as xml
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.batch.moodle_reader import cloze
from tests.drawn_library import DRAFTED
from tests.each import each
from tests.grading.cases import key_of, problem_of
from tests.laws import few
from tests.marked.classes import register
from vecpoly.batch.moodle.answers import asked_of, bands, worths
from vecpoly.batch.moodle.cloze import UNITS, choice, plain_number, row, unit_of
from vecpoly.batch.moodle.quiz import Quizzes, label, right_told
from vecpoly.errors import VecpolyError
from vecpoly.grading.key import Graded, Kind
from vecpoly.names import written_unit
from vecpoly.report.values import is_worded

FOUND_EMPTY = ("train-differential", "7-6", "5-5", "5-1", "7-1", "8-9", "D-1", "D-3", "2-8")
_NUMBER = re.compile(r"\{2:NUMERICAL:(.*?)\}")
_ANSWER = re.compile(r"%(\d+)%(-?[\d.]+):([\d.]+)(?:#.*)?")


def _asked(name: str) -> tuple[Graded, ...]:
    try:
        return asked_of(key_of(name))
    except VecpolyError:
        return ()  # drawn by no method on file: it has no key


def _answers(one: Graded) -> list[tuple[int, float, float]]:
    """Per cent, value and tolerance of each answer that a blank takes."""
    found = _NUMBER.search(row(one, tuple(bands(one)), "en"))
    parts = [] if found is None else [_ANSWER.fullmatch(part) for part in re.split(r"(?<!\\)~", found[1])]
    return [(int(part[1]), float(part[2]), float(part[3])) for part in parts if part is not None]


def shown_by_moodle(blank: str) -> list[tuple[str, str]]:
    """The answers of a blank with what is said of each, as Moodle shows them."""
    (part,) = cloze(blank)[1]
    return [(one.text, one.said) for one in part.answers]


@each(dict.fromkeys((*few(DRAFTED, 8), *FOUND_EMPTY)))
def test_every_number_that_is_asked_has_a_whole_answer_which_is_the_value_of_the_key(name: str) -> None:
    """Negative ones and zero too; what turns is asked by its size, its sense beside it."""
    asked = _asked(name)
    assert asked or name not in FOUND_EMPTY
    for one in asked:
        answers = _answers(one)
        if is_worded(one.key, one.unit):
            assert not answers
            continue
        percent, value, allowed = answers[0]
        right = abs(one.exact) if one.kind is Kind.SIGNED else one.exact
        assert percent == 100 and value == pytest.approx(right, rel=1e-5, abs=1e-9 * one.allowed)
        assert allowed == pytest.approx(one.allowed, rel=1e-5)
        assert len({answer[1:] for answer in answers}) == len(answers), "an answer stands twice"


@pytest.mark.parametrize("unit", [*UNITS, *(other for others in UNITS.values() for other in others)])
def test_a_unit_is_shown_as_it_is_printed(unit: str) -> None:
    assert shown_by_moodle(choice(1, (written_unit(unit), "x"))) == [(written_unit(unit), ""), ("x", "")]
    assert "\\" not in unit_of(unit)


@given(st.lists(st.text(alphabet='ab/\\}#~"{=·% ', min_size=1).map(lambda text: f"a{text}b"), min_size=2, max_size=4))
def test_whatever_is_said_in_a_blank_moodle_shows_without_a_backslash(texts: list[str]) -> None:
    """What Moodle cannot be told is written by a letter that looks like it."""
    like = [text.replace("~", "～").replace("\\", "＼") for text in texts]
    assert [said for said, _ in shown_by_moodle(choice(1, tuple(texts)))] == like
    assert shown_by_moodle(choice(1, ("right", "wrong"), texts[0]))[1][1] == like[0]


def test_a_place_is_asked_by_both_coordinates_in_mm_from_a_point_that_is_named() -> None:
    by_key = {one.key: one for one in _asked("D-1")}
    x = by_key["P_13 x"]
    assert label(x, "en") == "x(P_13) from A" and label(x, "zh") == "x(P_13)（以 A 为原点）" and x.unit == "mm"
    assert _answers(x)[0][1:] == pytest.approx((-31.9341, 1e3 * key_of("D-1")["P_13"].allowed), rel=1e-4)
    assert _answers(by_key["P_13 y"])[0][1] == 0.0


def test_what_is_right_is_told_as_it_is_printed() -> None:
    """It was "omega_3 = -2.179 rad/s", in full-width brackets in English too."""
    assert right_told(key_of("3-9")["omega_3"], "en").startswith("ω_3 = 1.995 rad/s clockwise (tolerance ")
    assert right_told(key_of("5-5")["M1_over_Q"], "zh") == "M_1/Q = 1.167 mm（允许误差 0.012 mm）"
    assert right_told(key_of("2-3")["n"], "en") == "n = 3"


def test_close_is_as_close_for_moodle_as_for_a_marker() -> None:
    """Moodle gave half the mark up to 2 T, a marker up to 1.5 T."""
    key = key_of("3-9")
    right, close = list(bands(key["v_E"], rule=key.allowance))[:2]
    assert (right.percent, close.percent) == (100, 50)
    assert close.allowed == pytest.approx(key.allowance.wrong * right.allowed, rel=1e-5)


def test_a_count_is_not_nearly_right() -> None:
    assert [worth.percent for worth in bands(key_of("2-3")["n"])] == [100]


def test_what_is_told_in_words_is_a_choice() -> None:
    by_key = {one.key: one for name in ("5-5", "2-8", "rotor-grade") for one in _asked(name)}
    assert row(by_key["self_locking"], (), "en") == "{2:MULTICHOICE_S:=yes~no}"
    assert row(by_key["within_II"], (), "zh") == "{2:MULTICHOICE_S:=否~是}"
    assert row(by_key["class_1+3"], (), "en") == "{2:MULTICHOICE_S:=class III~class II~class IV~none}"


def test_what_only_checks_another_quantity_is_not_asked_again() -> None:
    """F by the sine rule stands beside F in the report; on no sheet, form or question twice under one letter."""
    assert {"F", "F_sine"} <= {one.key for one in key_of("5-1").quantities}
    asked = [one.key for one in key_of("5-1").quantities if one.asked]
    assert "F" in asked and "F_sine" not in asked


def test_a_force_that_vanishes_is_nothing_in_the_key_and_not_the_rounding_of_its_formula() -> None:
    assert key_of("5-1")["F_r"].exact == 0.0 == key_of("5-1")["eta_r"].exact


def test_a_negative_value_of_the_wrong_sign_is_worth_what_a_wrong_sense_is() -> None:
    (turned,) = [answer for answer in _answers(key_of("7-6")["E_e"]) if answer[0] == 25]
    assert turned[1] == 1500.0


@pytest.mark.parametrize(
    ("value", "text"), [(1.23456e-12, "0.00000000000123456"), (-0.0, "0"), (2500.0, "2500"), (-1e16, "-1" + 16 * "0")]
)
def test_a_number_is_written_with_all_its_digits_and_no_exponent(value: float, text: str) -> None:
    assert plain_number(value) == text


def test_a_yes_or_no_by_itself_is_a_question_of_two_choices() -> None:
    """In the file of single quantities: a number for none of them."""
    whole = register()
    first = whole.sheets[0]
    part = replace(first.parts[0], key=replace(first.parts[0].key, quantities=(key_of("5-5")["self_locking"],)))
    few = replace(whole, sheets=(replace(first, parts=(part,)),))
    root = xml.fromstring(Quizzes(few).numerical())
    (question,) = [one for one in root if one.get("type") == "multichoice"]
    answers = [(one.get("fraction"), one.findtext("text")) for one in question.findall("answer")]
    assert [fraction for fraction, _ in answers] == ["100", "0"] and {text for _, text in answers} == {"是", "否"}


@pytest.mark.parametrize("name", ["K-crank-rocker-gamma", "8-4"])
def test_of_several_solutions_each_is_right_in_the_blank_of_any(name: str) -> None:
    """AB and AB_2, or AB_1 and AB_2: Moodle cannot exchange them, and which is which nobody is told."""
    key = key_of(name)
    found = worths(problem_of(name), key)
    first = "AB" if "AB" in found else "AB_1"
    for mine, other in ((first, "AB_2"), ("AB_2", first)):
        right = [one.value for one in found[mine] if one.percent == 100]
        assert right == pytest.approx([key[mine].exact, key[other].exact], rel=1e-5)
    assert len([one for one in found["theta"] if one.percent == 100]) == 1
