"""Mistakes in formulas that are worked, not read: a term left out, a ratio upside down, a compound hinge counted as
one."""

from __future__ import annotations

from functools import cache

import pytest
from typer.testing import CliRunner

import vecpoly
from tests.drawn_library import IDS, drawn, given, ids
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.acts import Area, Measure
from vecpoly.board.otherwise.amended import Amended
from vecpoly.board.otherwise.possible import slips_of
from vecpoly.board.otherwise.slip import TOLD_OF, Mistake, Slip
from vecpoly.cli.app import app
from vecpoly.grading.derive.keyed import answer_key
from vecpoly.grading.redraw import by_hands
from vecpoly.solution import solve

WORKED = ("2-6", "5-6", "5-7", "7-2a", "hoist")  # nothing is read on paper


@cache
def offered(name: str) -> tuple[Slip, ...]:
    """The mistakes that can be made."""
    return vecpoly.slips(given(name))


def made(name: str, slip: Slip) -> dict[str, float]:
    """What one who makes this mistake answers; it is among those that can be made."""
    assert slip in offered(name)
    found = solve(given(name), by="exact", repeats=0, precise=False, slip=slip).answers
    return {key: answer.drawn for key, answer in found.items()}


def test_a_ratio_upside_down_goes_into_all_that_follows() -> None:
    right = {key: answer.drawn for key, answer in drawn("7-2a").solution.answers.items()}
    wrong = made("7-2a", Slip(Mistake.INVERTED, "i_III,I", "(z_I z_II,III)/(z_II,I z_III)"))
    assert wrong["i_III_I"] == pytest.approx(1 / right["i_III_I"])
    assert wrong["M_r"] == pytest.approx(right["M_r"] / right["i_III_I"] ** 2)
    assert wrong["i_II_I"] == right["i_II_I"]


def test_a_ratio_that_is_not_squared_counts_simply() -> None:
    right, wrong = drawn("7-3").solution.answers, made("7-3", Slip(Mistake.UNSQUARED, "J_e", "i_31"))
    third, i = 0.4, 20 / 40  # as given: kg·m² of gear 3, and z_1/z_3
    assert wrong["J_e"] - right["J_e"].drawn == pytest.approx(third * (i - i**2))


def test_an_efficiency_is_multiplied_by_where_it_should_divide() -> None:
    right, wrong = drawn("5-6").solution.answers, made("5-6", Slip(Mistake.INVERTED, "P", "η"))
    assert wrong["P"] == pytest.approx(right["P_out"].drawn * right["eta"].drawn)


@pytest.mark.parametrize(
    ("slip", "more"),
    few(
        [
            (Slip(Mistake.WITH_FRAME, "n"), 3),
            (Slip(Mistake.AS_ONE, "p_L", "C"), 4),
            (Slip(Mistake.AS_ONE, "p_L", "F"), 2),
            (Slip(Mistake.OMITTED, "F", "F′"), 1),
            (Slip(Mistake.OMITTED, "F", "p′"), -1),
            (Slip(Mistake.OMITTED, "F", "p_H"), 1),
        ],
        3,
    ),
)
def test_what_is_forgotten_in_counting_makes_the_mobility_wrong_by_so_much(slip: Slip, more: int) -> None:
    assert made("2-6", slip)["F"] == drawn("2-6").solution.answers["F"].drawn + more


@pytest.mark.parametrize("name", few(WORKED, 3))
def test_every_such_mistake_changes_what_is_asked_or_is_worked_on_the_way(name: str) -> None:
    right = {key: answer.drawn for key, answer in drawn(name).solution.answers.items()}
    for slip in (one for one in offered(name) if one.mistake in TOLD_OF):
        wrong = made(name, slip)
        assert any(abs(wrong[key] - value) > 1e-9 * abs(value) for key, value in right.items()), slip


def test_where_nothing_is_read_on_paper_mistakes_can_be_made_all_the_same() -> None:
    for name in IDS:
        acts = drawn(name).construction.acts
        assert slips_of(acts) or any(isinstance(act, Measure | Area) for act in acts), name


@pytest.mark.parametrize("name", ["3-9", "4-3a"])
def test_polygons_have_the_mistakes_of_drawing_alone(name: str) -> None:
    assert not any(one.mistake in TOLD_OF for one in slips_of(drawn(name).construction.acts))


@pytest.mark.parametrize("name", few(["4-1", "5-6", "5-7", "hoist"], 2))
def test_all_hands_at_once_make_each_its_own(name: str) -> None:
    slips = offered(name)
    found = by_hands(given(name), answer_key(given(name)), Amended(each=slips))
    for i, slip in enumerate(slips):
        alone = made(name, slip)
        assert {key: found[key][i] for key in alone} == pytest.approx(alone), slip


@each(Later(lambda: few(ids(mechanisms=False), 6)))
def test_every_device_is_drawn_by_all_who_mistake_a_formula_of_it(name: str) -> None:
    slips = tuple(one for one in slips_of(drawn(name).construction.acts) if one.mistake in TOLD_OF)
    found = by_hands(given(name), answer_key(given(name)), Amended(each=slips))
    assert all(len(values) == len(slips) for values in found.values())


@pytest.mark.parametrize(("lang", "said"), [("en", "worked with i_31, not squared"), ("zh", "的算式中 i_31 漏了平方")])
def test_a_student_is_told_of_it_in_either_language(lang: str, said: str) -> None:
    wrong = made("7-3", Slip(Mistake.UNSQUARED, "J_e", "i_31"))["J_e"]
    told = CliRunner().invoke(app, ["check", "7-3", f"J_e={wrong:.5g}", "--lang", lang], env={"COLUMNS": "300"})
    assert told.exit_code != 0 and said in told.output.replace("₃₁", "_31")


def test_a_count_is_not_asked_for_more_figures() -> None:
    told = CliRunner().invoke(app, ["check", "2-6", "F=3", "--lang", "en"], env={"COLUMNS": "300"})
    assert "multiple joint" in told.output and "digits" not in told.output
