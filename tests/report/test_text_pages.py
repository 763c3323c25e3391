"""What is said once, where it is found, and how long it is on paper."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from tests.framed_answers import rows_in
from vecpoly.algebra.formula import plain
from vecpoly.board.paper.marks import AngleMark, Point
from vecpoly.problem.load import load
from vecpoly.report.answers.alike import lines_of_twins, twins
from vecpoly.report.answers.box import answer_box
from vecpoly.report.heads import unit_column, united
from vecpoly.report.on_paper import on_paper
from vecpoly.report.picture import picture
from vecpoly.solution import solve
from vecpoly.words import plural


def test_points_of_a_link_that_only_translates_have_one_line_one_answer_and_one_row() -> None:
    solution = solve(load("3-14"), repeats=20)
    assert {key: first.key for key, first in twins(solution.answers.values()).items()} == {"v_C": "v_B3", "a_C": "a_B3"}
    lines = [plain(node) for node in lines_of_twins(solution, "en").values()]
    assert lines == ["v_C = v_B3 = 11.96 m/s", "a_C = a_B3 = 4464 m/s^2"]
    (row,) = (one for one in rows_in(answer_box(solution, "en")) if "v_B3" in one.keys)
    assert (
        row.keys == ("v_B3", "v_C") and row.name == "$v_{B3}$ = $v_{C}$" and (row.value, row.unit) == ("11.96", "m/s")
    )


def test_what_an_image_gives_is_evaluated_in_the_step_of_the_image() -> None:
    for step in drawn("3-5").construction.steps:
        told = [plain(line) for line in step.formulas]
        assert any(line.startswith("v_E =") for line in told) == ("$e$ lies on" in step.words.en)


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("8-16", "C_{1}C_{2} = H/μ_l$ = 62.5 mm"),
        ("8-16", "$e/μ_l$ = 25.0 mm above"),
        ("3-9", "$AB = l_AB/μ_l$ = 15.0 mm"),
    ],
)
def test_a_step_tells_how_long_a_given_length_is_on_paper(name: str, told: str) -> None:
    solution = drawn(name).solution
    assert any(told in on_paper(step.words.en, solution) for step in solution.construction.steps)


def test_a_centre_at_infinity_is_told_by_its_direction_drawn_and_exactly() -> None:
    rows = {row.keys[0]: row for row in rows_in(answer_box(solve(load("3-1e"), repeats=20), "en"))}
    (endless,) = (row for row in rows.values() if "133.0" in row.value)
    assert endless.value == "∞, ∠133.0°" and endless.exact == "∞, ∠133.0°" and endless.off == "0.0°"
    assert endless.error.endswith("°")


def test_a_lone_value_has_its_row() -> None:
    (row,) = (one for one in rows_in(answer_box(solve(load("curv-10"), repeats=20), "en")) if one.value == "83.8")
    assert row.exact == "83.91" and row.in_unit("value") == ("83.8", "mm")


def test_a_unit_of_a_whole_column_stands_in_its_head_and_those_of_rows_in_a_column() -> None:
    assert united(["a", "b"], [("1.5°", "2 mm"), ("2.5°", "3 N")]) == (["a /°", "b"], [("1.5", "2 mm"), ("2.5", "3 N")])
    assert united(["a"], [("1 m/s",), ("—",), ("< 2 m/s",)]) == (["a /(m/s)"], [("1",), ("—",), ("< 2",)])
    rows = [("v", "62 mm ≙ 0.124 m", "0.12 m"), ("ω", "2 rad/s (clockwise)", "1.99 rad/s")]
    assert unit_column(rows, (1, 2)) == [("v", "m", "62 mm ≙ 0.124", "0.12"), ("ω", "rad/s", "2 (clockwise)", "1.99")]
    assert unit_column([("v", "1 m", "1 mm")], (1, 2)) is None


@pytest.mark.parametrize(
    ("one", "several"),
    [
        ("balancing mass", "balancing masses"),
        ("angular position of the hole", "angular positions of the holes"),
        ("the radius of curvature", "the radii of curvature"),
        ("degree of freedom", "degrees of freedom"),
    ],
)
def test_several_of_one_name_are_asked_for_in_the_plural(one: str, several: str) -> None:
    assert plural(one) == several


def test_the_sketch_shows_the_offset_of_a_rod_and_the_angle_of_a_bar_to_its_guide() -> None:
    problem = load("swinging-block-offset-rod")
    figure = picture(problem, solve(problem, repeats=0).construction, 125.0, 62.0)
    assert figure is not None
    assert "e" in [mark.label for mark in figure.marks if isinstance(mark, Point)]
    assert "60°" in [mark.label for mark in figure.marks if isinstance(mark, AngleMark)]
