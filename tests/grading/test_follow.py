"""Follow-through: what follows from one's own values is right; no loophole, no mark lowered, one cause paid once."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.grading.cases import key_of, marked, mutants_of, problem_of, told
from vecpoly.grading.compare import own
from vecpoly.grading.compare.measured import Measured
from vecpoly.grading.compare.outcome import Basis, Outcome
from vecpoly.grading.key import AnswerKey, Points
from vecpoly.grading.marking.marked import Marked
from vecpoly.grading.marking.marker import mark
from vecpoly.grading.rules import Rules
from vecpoly.grading.sheet import sheet_of

MISREAD = {
    "pc": "29.0", "bc": "38.0", "v_CB": "0.76", "omega_2": "3.04 cw", "an_CB": "2.31",
    "n3'c'": "53.4", "a_C": "10.8", "alpha_3": "53.4 ccw",
}  # fmt: skip


def golden_key() -> AnswerKey:
    """The key of the golden example: one point for each of its eight rows."""
    key = key_of("golden")
    rows = tuple(replace(one, points=Points(accuracy=float(one.key in MISREAD))) for one in key.quantities)
    return replace(key, quantities=rows, stated={})


def golden(cells: dict[str, str], rules: Rules | None = None) -> Marked:
    sheet = sheet_of(golden_key(), cells)
    return mark(problem_of("golden"), golden_key(), lambda: mutants_of("golden"), sheet, rules or Rules())


def test_in_the_golden_example_the_misread_length_is_the_only_loss() -> None:
    sheet = golden(MISREAD)
    assert (sheet.total, sheet.worth) == (7.0, 8.0)
    assert sheet.roots == ("bc",)
    assert sheet["bc"].outcome is Outcome.WRONG and sheet["pc"].basis is Basis.EXACT
    for key in ("v_CB", "omega_2", "an_CB", "n3'c'", "a_C", "alpha_3"):
        assert (sheet[key].outcome, sheet[key].basis) == (Outcome.RIGHT, Basis.OWN), key


@pytest.mark.parametrize(
    ("key", "value"),
    [("v_CB", 0.76), ("omega_2", 3.04), ("an_CB", 2.31), ("n3'c'", 53.4), ("a_C", 10.82), ("alpha_3", 53.43)],
)
def test_the_own_value_key_of_the_golden_example_is_found_by_drawing(key: str, value: float) -> None:
    follower = own.Follower(
        problem=problem_of("golden"), key=key_of("golden"), rules=Rules(),
        given={name: Measured(value=float(text.split()[0]), sense=-1 if "cw" in text and "ccw" not in text else 1)
               for name, text in MISREAD.items() if name != key},
    )  # fmt: skip
    target = follower.follow([key_of("golden")[key]])[key].target
    assert target is not None and abs(target.value) == pytest.approx(value, rel=2e-3)


def test_feedback_names_the_value_that_was_continued_from() -> None:
    said = golden(MISREAD)["omega_2"].messages[0]
    assert said.id == "ok_own" and (said.numbers["src"], said.numbers["v"]) == ("bc", "38 mm")
    assert "bc$ = 38 mm" in said.words.zh and "不重复扣分" in said.words.zh


@pytest.mark.parametrize("bad", ["", "0", "38 m/s", "400", "5", "—", "abc"])
def test_nothing_is_continued_from_what_is_missing_zero_of_another_dimension_or_far_off(bad: str) -> None:
    sheet = golden(
        {
            "bc": bad,
            "omega_2": f"{0.08 * float(bad.split()[0]):.3g} cw" if bad[:1].isdigit() and bad != "0" else "3.04 cw",
        }
    )
    assert sheet["omega_2"].basis is Basis.EXACT and not sheet["omega_2"].is_right


def test_what_may_not_be_continued_from_is_told() -> None:
    assert "not_followed" in told(golden({"bc": "400", "omega_2": "32 cw"}), "omega_2")


def test_an_independent_step_is_not_continued_from() -> None:
    free = golden(MISREAD, Rules(independent=("bc",)))
    assert free["omega_2"].outcome is Outcome.WRONG and golden(MISREAD)["omega_2"].is_right


def test_a_step_that_must_go_first_opens_the_others() -> None:
    rules = Rules(first=("pc",))
    assert golden(MISREAD, rules)["omega_2"].is_right
    without = {key: text for key, text in MISREAD.items() if key != "pc"}
    assert not golden(without, rules)["omega_2"].is_right


def test_the_length_of_a_chain_of_own_values_is_reported() -> None:
    sheet = golden(MISREAD)
    assert [sheet[key].chain for key in ("pc", "omega_2", "an_CB", "n3'c'", "alpha_3")] == [0, 1, 2, 3, 4]


def test_a_figure_that_does_not_close_with_own_values_goes_to_a_person(monkeypatch: pytest.MonkeyPatch) -> None:
    def nowhere(problem: object, key: AnswerKey, amended: Any) -> dict[str, Any]:
        return {one.key: np.full(len(amended.own), np.nan) for one in key.quantities}

    monkeypatch.setattr(own, "by_hands", nowhere)
    sheet = golden(MISREAD)
    assert sheet["n3'c'"].for_a_person and "undrawable" in told(sheet, "n3'c'") and sheet["n3'c'"].earned.total == 0
    assert sheet["n3'c'"] in sheet.queue


def test_a_reading_that_was_left_out_is_stood_for_by_the_value_found_from_it() -> None:
    sheet = golden({"v_CB": "0.76", "omega_2": "3.04 cw"})
    assert sheet["omega_2"].basis is Basis.OWN and sheet["omega_2"].messages[0].numbers["src"] == "v_{CB}"


def test_own_values_below_a_step_that_was_left_out_are_gone_through() -> None:
    sheet = golden({"omega_2": "3.04 cw", "alpha_3": "53.4 ccw"})
    assert sheet["alpha_3"].basis is Basis.OWN and sheet["alpha_3"].messages[0].numbers["src"] == "ω_2"


FACTORS = st.dictionaries(
    st.sampled_from(list(MISREAD)), st.sampled_from([0.0, 0.3, 0.5, 0.9, 1.06, 1.2, 2.0, 10.0, 200.0]), max_size=4
)


def spoilt(factors: dict[str, float]) -> dict[str, str]:
    """The right sheet with some values times a factor."""
    key = key_of("golden")
    values = {name: abs(key[name].exact) * factors.get(name, 1.0) for name in MISREAD}
    return {name: f"{value:.4g}" + (" cw" if key[name].exact < 0 else "") for name, value in values.items()}


@given(FACTORS)
def test_follow_through_never_lowers_a_mark(factors: dict[str, float]) -> None:
    cells = spoilt(factors)
    followed, alone = golden(cells), golden(cells, Rules(following=False))
    assert followed.exactly >= alone.exactly - 1e-9
    for one in followed.findings:
        assert one.earned.total >= 0


@given(FACTORS, st.randoms(use_true_random=False))
def test_the_order_of_cells_and_a_second_marking_change_nothing(factors: dict[str, float], random: Any) -> None:
    cells = list(spoilt(factors).items())
    first = golden(dict(cells)).as_json()
    random.shuffle(cells)
    assert golden(dict(cells)).as_json() == first


def test_one_misreading_costs_once_however_much_rests_on_it() -> None:
    right = marked(
        "3-9",
        {"bc2": "40.9", "omega_2": "2.0 cw", "omega_3": "2.0 cw", "an_C2B": "0.49", "ak_C2C3": "0.688", "pc2": "28.7"},
    )
    wrong = marked(
        "3-9",
        {
            "bc2": "46.0",
            "omega_2": "2.243 cw",
            "omega_3": "2.243 cw",
            "an_C2B": "0.619",
            "ak_C2C3": "0.773",
            "pc2": "28.7",
        },
    )
    lost = right.exactly - wrong.exactly
    assert lost == pytest.approx(wrong["bc2"].earned.total + right["bc2"].earned.total)
    assert wrong.roots == ("bc2",)
