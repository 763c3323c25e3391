"""Every problem ends with a box that evaluates what was asked; each quantity is evaluated where it is found."""

from __future__ import annotations

import re
from itertools import groupby

import pytest

from tests.drawn_library import IDS, drafted
from tests.each import each
from vecpoly.algebra.formula import plain
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.line import answer_line
from vecpoly.report.answers.rounded import COARSE, coarse, rounded
from vecpoly.report.answers.tables import counted, readings_tables
from vecpoly.report.statement.groups import parted
from vecpoly.report.values import called, printed_unit
from vecpoly.solution import YES_NO, Answer, Solution, solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

LANGS: tuple[Lang, ...] = ("zh", "en")
_NUMBER = re.compile(r"[−]?\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")


def line_of(solution: Solution, key: str, lang: Lang = "zh") -> str:
    """The line of one quantity as plain text."""
    return plain(answer_line(solution.answers[key], solution.problem, lang).node)


def number(text: str) -> float:
    """The first number of a text."""
    found = _NUMBER.search(text)
    assert found, text
    return float(found[0].replace("−", "-").replace("×10^{", "e").replace("}", ""))


def rows_of(solution: Solution, lang: Lang) -> dict[str, tuple[str, ...]]:
    """The rows of the tables by what they begin with."""
    return {row[0]: row for table in readings_tables(solution, lang) for row in table.rows}


@each(IDS)
def test_every_quantity_asked_stands_in_the_box_once_with_the_number_of_the_table(name: str) -> None:
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        lines, rows = answer_box(solution, lang).lines, rows_of(solution, lang)
        assert sorted(line.key for line in lines) == sorted(solution.answers)
        assert rows or all(map(counted, solution.answers.values()))
        for line in lines:
            answer = solution.answers[line.key]
            text = plain(line.node)
            assert text == line.result or re.search(rf"{re.escape(line.result)}(?:（.*）| \(.*\))?$", text), text
            if rows:
                row = rows.get(called(answer.reading.symbol, answer.key, lang)) or rows[f"${answer.reading.symbol}$"]
                said = line.result.replace("(", "").replace(")", "").replace(",", "").split(" ")
                assert said[0].rstrip("°") in [cell.rstrip("°").split(",")[0] for cell in row], (text, row)


@each(IDS)
def test_the_box_keeps_the_order_of_the_questions_within_each_kind(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    lines = answer_box(solution, "zh").lines
    runs = [[line.key for line in some] for _, some in groupby(lines, key=lambda line: line.group)]
    order = list(solution.answers)
    assert all(sorted(run, key=order.index) == run for run in runs)
    assert len(runs) == len({line.group for line in lines}), "a kind stands in two places"
    assert (len(runs) > 1) is parted(order)


@each(IDS)
def test_what_was_asked_is_evaluated_in_a_step_and_not_twice_there(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    steps = solution.construction.steps  # two linkages that are found may share a length: each has it in its step
    for answer in solution.answers.values():
        if (line := answer.reading.formula) is not None:
            assert {step.formulas.count(line) for step in steps} - {0} == {1}, (answer.key, plain(line))


@each(IDS)
def test_no_answer_is_rounded_by_more_than_a_quarter_of_what_its_reading_leaves_open(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        if answer.is_place or answer.undefined or answer.reading.unit == YES_NO:
            continue
        assert solution is not None
        line = answer_line(answer, solution.problem, "en")
        drawn = printed_unit(answer.reading.unit)[0] * answer.drawn
        open_ = printed_unit(answer.reading.unit)[0] * answer.expected_error
        assert abs(abs(number(line.result)) - abs(drawn)) <= max(5.1e-4 * abs(drawn), 0.25 * open_), line.result


def test_a_vector_is_told_with_scale_length_number_unit_and_direction() -> None:
    solution = solve(load("3-9"))
    assert line_of(solution, "v_E") == "v_E = μ_v\u2009pe = 0.006 × 28.8 = 0.1728 m/s（∠−47.7°）"
    assert line_of(solution, "v_E", "en") == "v_E = μ_v\u2009pe = 0.006 × 28.8 = 0.1728 m/s (∠−47.7°)"


def test_what_turns_is_told_with_its_sense_and_never_with_a_sign() -> None:
    solution = solve(load("3-9"))
    assert line_of(solution, "omega_2").endswith("= 1.995 rad/s（顺时针）")
    assert line_of(solution, "omega_3", "en") == "ω_3 = ω_2 = 1.995 rad/s (clockwise)"


def test_a_vector_along_an_axis_is_told_with_an_arrow() -> None:
    told = [line_of(solve(load("3-5")), key) for key in ("v_F", "a_F")]
    assert all(text.endswith(("（←）", "（→）")) for text in told), told


def test_a_length_ends_with_millimetres_as_in_the_table() -> None:
    solution = solve(load("5-3"))
    assert line_of(solution, "h") == "h = μ_l′\u2009AC = 0.0008 × 2.4 = 0.00192 m = 1.92 mm"
    assert rows_of(solution, "zh")["$h$"][:5] == ("$h$", "mm", "2.4（过短）", "$μ_l′$", "1.92")


def test_a_coarse_reading_is_told_to_be_so_and_no_other() -> None:
    solution = solve(load("5-3"))
    told = {line.key: line.after for line in answer_box(solution, "en").lines}
    assert "±17 %" in told["F"] and "±" not in told["R_21"] + told["R_31"]
    assert {key for key, text in told.items() if "±" in text} == {
        key for key, one in solution.answers.items() if (coarse(one) or 0.0) >= COARSE
    }


def test_counts_that_agree_are_told_by_a_sentence_and_not_by_a_table() -> None:
    solution = solve(load("2-6"))
    assert readings_tables(solution, "zh") == ()
    (wrong,) = (one for one in solution.answers.values() if one.key == "n")
    assert not counted(_otherwise(wrong)), "a count that the oracle does not confirm must be seen"


def _otherwise(answer: Answer) -> Answer:
    from dataclasses import replace

    return replace(answer, exact=answer.exact + 1)


@pytest.mark.parametrize(
    ("value", "places", "text"),
    [
        (0.3, 4, "0.3000"),
        (441.5, 1, "441.5"),
        (39.0, 0, "39"),
        (3264.4, 0, "3264"),
        (-0.04, 1, "0"),
        (12.0, None, "12"),
    ],
)
def test_zeros_that_were_read_are_kept_and_no_others_made(value: float, places: int | None, text: str) -> None:
    assert rounded(value, places, 4) == text


def test_a_box_is_parted_between_rows_and_no_part_is_higher_than_its_room() -> None:
    box = answer_box(solve(load("3-12")), "en")
    width = 170.0 * MM
    whole = box.wrap(width, 1e4)[1]
    for height in (0.4 * whole, 0.6 * whole, 0.9 * whole):
        head, tail = answer_box(solve(load("3-12")), "en").split(width, height)
        assert head.wrap(width, height)[1] + head.getSpaceBefore() <= height
        assert head.wrap(width, 1e4)[1] + tail.wrap(width, 1e4)[1] >= whole - 3.0 * MM
    assert box.split(width, 0.1 * whole) == [], "a part of less than three rows is none"


def test_lines_stand_side_by_side_where_there_is_room() -> None:
    box = answer_box(solve(load("3-9")), "zh")
    box.wrap(170.0 * MM, 1e4)
    assert len(box.lines) == 16 and len({line.group for line in box.lines}) == 4 and len(box._rows) <= 11
    assert all(x + one.width <= 170.0 for row in box._rows for x, one, _ in row)
