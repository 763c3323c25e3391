"""A resisting moment, the ratio of two shafts: magnitudes, of which everybody may choose the sign."""

from __future__ import annotations

import pytest

from tests.grading.cases import key_of, problem_of
from vecpoly.batch.moodle.answers import bands
from vecpoly.grading.student import check_answers
from vecpoly.grading.told.named import Told

ONES = {"7-2a": ("i_0_I", "i_II_I", "i_III_I", "M_r"), "7-5": ("M_r",), "train-differential": ("v_O2", "v_C")}
EACH = [(problem, name) for problem, names in ONES.items() for name in names]


@pytest.mark.parametrize(("problem", "name"), EACH)
@pytest.mark.parametrize("sign", [1, -1])
def test_either_sign_of_a_magnitude_is_right_and_the_convention_is_told(problem: str, name: str, sign: int) -> None:
    value = sign * key_of(problem)[name].exact
    (found,) = check_answers(problem_of(problem), [f"{name}={value:.4g}"]).answers
    assert found.is_right and (Told.SIGN_FREE in {said.id for said in found.messages}) is (value < 0)


def test_all_signs_turned_cost_nothing_and_what_rests_on_them_follows() -> None:
    key = key_of("7-2a")
    written = [f"{one.key}={-one.exact if one.unsigned else one.exact:.4g}" for one in key.quantities if one.asked]
    checked = check_answers(problem_of("7-2a"), written)
    assert checked.right and checked.marked.exactly == pytest.approx(key.worth)


@pytest.mark.parametrize(("problem", "name"), [("7-1", "F_e5"), ("7-2a", "J_e"), ("7-3", "M_e")])
def test_the_sign_of_what_is_no_magnitude_still_counts(problem: str, name: str) -> None:
    (found,) = check_answers(problem_of(problem), [f"{name}={-key_of(problem)[name].exact:.4g}"]).answers
    assert not found.is_right


def test_moodle_takes_either_sign_too() -> None:
    one = key_of("7-2a")["M_r"]
    assert [worth.value for worth in bands(one) if worth.percent == 100] == [15.0, -15.0]
    assert not any(worth.percent == 25 for worth in bands(one))
