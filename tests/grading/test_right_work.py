"""Who draws rightly has it right, with any problem of the library; and what is otherwise than right says so."""

from __future__ import annotations

import numpy as np

from tests.drawn_library import LIBRARY
from tests.each import each
from tests.grader_proof.students import drawn_class
from tests.grading.cases import key_of, marked, mutants_of, problem_of, told
from tests.laws import few
from vecpoly.grading.key import AnswerKey, come_round

STUDENTS = 8


@each(few(LIBRARY, 16))
def test_students_who_draw_rightly_are_right_and_accused_of_nothing(name: str) -> None:
    group, rng = drawn_class(problem_of(name), key_of(name), "pencil", STUDENTS, 11), np.random.default_rng(11)
    sheets = [marked(name, group.sheet(student, rng)) for student in range(STUDENTS)]
    wrong = [one.key for sheet in sheets for one in sheet.findings if one.written.raw and not one.is_right]
    assert len(wrong) <= 0.02 * sum(bool(one.written.raw) for sheet in sheets for one in sheet.findings), set(wrong)
    assert not any(sheet.slips for sheet in sheets)


def test_a_length_of_nothing_in_another_figure_is_no_length_of_this_one() -> None:
    (length,) = [one for one in key_of("engine-four").quantities if one.letters == "Oq"]
    assert length.exact == 108.0


@each(("4-3a", "rotor-grade", "engine-single", "3-2"))
def test_of_a_force_the_direction_by_a_mistake_is_known_too(name: str) -> None:
    key = key_of(name)
    values = [value for one in mutants_of(name) for at, value in one.values.items() if _is_drawn(key, at)]
    assert values and all(value.degrees is not None for value in values if value.value)


def _is_drawn(key: AnswerKey, name: str) -> bool:
    return key[name].degrees is not None and key[name].kind == "vector"


def test_a_direction_that_no_mistake_gives_is_none_of_a_mistake() -> None:
    cells = {"W_S": f"486 ∠ {key_of('rotor-grade')['W_S'].degrees + 110:.0f}°"}  # type: ignore[operator]
    sheet = marked("rotor-grade", cells)
    assert "dir" in told(sheet, "W_S") and not sheet.slips


def test_yes_and_no_follow_from_own_values() -> None:
    assert set(key_of("rotor-bolt-circle")["within"].needs) >= {"m_b,1", "U_per"}
    followed = marked("rotor-bolt-circle", {"ab": "66.6", "m_b_1": "5.61", "within": "no"})
    assert not followed["ab"].is_right and followed["within"].is_right


def test_nothing_is_no_rounding_of_something() -> None:
    assert not marked("jansen-leg", {"omega_7": "0 ccw"})["omega_7"].is_right


def test_beyond_a_turn_an_angle_is_another_than_a_turn_before() -> None:
    assert come_round(1.0, 361.0) == 1.0
    assert come_round(361.0, 359.0) == 361.0 and come_round(-1.0, 359.0) == 359.0
