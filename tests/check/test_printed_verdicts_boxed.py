"""What is said of printed answers stands in one box where it tells of one error."""

from __future__ import annotations

import pytest

from vecpoly.check.printed.answers import check_problem
from vecpoly.problem.load import load
from vecpoly.report.verdicts import concluded, verdicts
from vecpoly.solution import solve
from vecpoly.words import Lang


@pytest.mark.parametrize(
    ("lang", "parts"), [("zh", ("总评", "逐项说明", "关于原书")), ("en", ("Overall", "Item by item"))]
)
def test_one_error_of_a_whole_book_is_told_in_one_box(lang: Lang, parts: tuple[str, ...]) -> None:
    solution = solve(load("C-conveyor"), by="exact", repeats=0)
    ((kind, text),) = verdicts(solution, check_problem(solution.problem), lang)
    assert kind == "fail" and all(text.count(part) == 1 for part in parts)
    assert [text.index(part) for part in parts] == sorted(text.index(part) for part in parts)


def test_how_many_answers_agree_and_the_largest_deviation_are_told_with_numbers() -> None:
    told = {name: check_problem(load(name)) for name in ("3-9", "8-16", "3-14", "C-inertia", "C-conveyor")}
    assert concluded(told["3-9"], "en").startswith(
        "Of 15 textbook answers 13 agree (the largest deviation is that of $v_{E}$, 2.50 %); drafting error: "
    )
    (pair,) = (text for kind, text in verdicts(solve(load("8-16"), repeats=20), told["8-16"], "zh") if kind == "pass")
    assert pair == "原书答案与精确值相符（偏差最大的是 $l_{BC}$，0.21 %）。"
    assert concluded(told["3-14"], "zh") == "原书 2 个答案中 1 个与精确值相符；错误：$v_{C}$。"
    assert concluded(told["C-inertia"], "en") == "None of the 11 textbook answers agrees."
    assert not concluded(told["C-conveyor"], "en"), "one error of the whole is told in its box"


def test_answers_that_agree_and_a_note_on_the_book_keep_a_box_each() -> None:
    solution = solve(load("2-12"), by="exact", repeats=0)
    assert [kind for kind, _ in verdicts(solution, check_problem(solution.problem), "zh")] == ["pass", "note"]
