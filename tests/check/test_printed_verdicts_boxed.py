"""What is said of printed answers stands in one box where it tells of one error."""

from __future__ import annotations

import pytest

from vecpoly.check.printed.answers import check_problem
from vecpoly.problem.load import load
from vecpoly.report.verdicts import verdicts
from vecpoly.solution import solve
from vecpoly.words import Lang


@pytest.mark.parametrize(
    ("lang", "parts"), [("zh", ("总评", "逐项说明", "关于原书")), ("en", ("On the whole", "Item by item"))]
)
def test_one_error_of_a_whole_book_is_told_in_one_box(lang: Lang, parts: tuple[str, ...]) -> None:
    solution = solve(load("C-conveyor"), by="exact", repeats=0)
    ((kind, text),) = verdicts(solution, check_problem(solution.problem), lang)
    assert kind == "fail" and all(text.count(part) == 1 for part in parts)
    assert [text.index(part) for part in parts] == sorted(text.index(part) for part in parts)


def test_answers_that_agree_and_a_note_on_the_book_keep_a_box_each() -> None:
    solution = solve(load("2-12"), by="exact", repeats=0)
    assert [kind for kind, _ in verdicts(solution, check_problem(solution.problem), "zh")] == ["pass", "note"]
