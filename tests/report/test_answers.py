"""Every problem ends with a box that evaluates what was asked; each quantity is evaluated where it is found."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import groupby
from math import isfinite

import pytest

from tests.drawn_library import DRAFTED, drafted, drawn
from tests.each import each
from tests.framed_answers import rows_in
from vecpoly.algebra.formula import plain
from vecpoly.algebra.rounding import places_of, read_back
from vecpoly.printed.digits import COARSE, coarse, drawn_number, on_paper, rounded
from vecpoly.printed.units import printed_unit
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.line import AnswerLine, answer_line, result_of
from vecpoly.report.answers.notes import remark_of, stands_still
from vecpoly.report.answers.order import arranged
from vecpoly.report.answers.tables import counted, readings_tables
from vecpoly.report.flow.results.box import AnswerBox
from vecpoly.report.flow.results.grid import in_reading_order
from vecpoly.report.values import is_class
from vecpoly.solution import YES_NO, Answer, Solution, solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

WIDTH = 170.0 * MM
LANGS: tuple[Lang, ...] = ("zh", "en")
_NUMBER = re.compile(r"[−]?\d+(?:\.\d+)?(?:×10\^\{−?\d+\})?")


def line_of(solution: Solution, key: str, lang: Lang = "zh") -> str:
    """The line of one quantity as plain text."""
    return plain(answer_line(solution.answers[key], solution, lang).node)


def lines_of(solution: Solution, lang: Lang) -> list[AnswerLine]:
    """All answers as lines, each under the number of its solution."""
    parts = arranged(solution.answers.values())
    return [
        answer_line(one, solution, lang, heading=part.heading(lang), read=False)
        for part in parts
        for one in part.answers
    ]


def number(text: str) -> float:
    """The first number of a text."""
    found = _NUMBER.search(text)
    assert found, text
    return float(found[0].replace("−", "-").replace("×10^{", "e").replace("}", ""))


def rows_of(solution: Solution, lang: Lang) -> dict[str, tuple[str, ...]]:
    """The rows of the tables by what they begin with; one of equal quantities, v_B3 = v_C, by each of them."""
    rows = [row for table in readings_tables(solution, lang) for row in table.rows]
    return {symbol: row for row in rows for symbol in row[0].replace("$ = $", "$|$").split("|")}


@each(DRAFTED)
def test_what_was_asked_is_evaluated_in_a_step_and_not_twice_there(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    steps = solution.construction.steps  # two linkages that are found may share a length: each has it in its step
    for answer in solution.answers.values():
        if (line := answer.reading.formula) is not None:
            assert {step.formulas.count(line) for step in steps} - {0} == {1}, (answer.key, plain(line))


@each(DRAFTED)
def test_a_step_ends_with_the_number_of_the_box_the_table_and_the_sheet(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        assert solution is not None
        if (line := answer.reading.formula) is None or answer.undefined or answer.reading.unit == YES_NO:
            continue
        told = re.split(" = | → | ≈ ", plain(line))[-1]  # 3.126 rad/s ≈ 3.13 rad/s: later steps go on with more
        ends = result_of(answer, "en")
        if answer.is_place and answer.drawn_vector is None:  # at infinity: P^∞_14 (∠90.0°)
            assert told.partition(" (")[2] == ends.partition(" (")[2], answer.key
            continue
        assert told.lstrip("−") == (ends if answer.is_place else ends.split(" (")[0]).lstrip("−"), answer.key


@each(DRAFTED)
def test_no_answer_is_rounded_by_more_than_a_quarter_of_what_its_reading_leaves_open(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        if answer.is_place or answer.undefined or answer.reading.unit == YES_NO or is_class(answer.key):
            continue
        assert solution is not None
        line = answer_line(answer, solution, "en")
        drawn = printed_unit(answer.reading.unit)[0] * answer.drawn
        open_ = printed_unit(answer.reading.unit)[0] * answer.expected_error
        assert abs(abs(number(line.result)) - abs(drawn)) <= max(2.6e-3 * abs(drawn), 0.25 * open_), line.result


@each(DRAFTED)
def test_the_last_digit_of_an_answer_is_worth_what_was_read_and_zeros_are_kept(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        deg = answer.reading.unit == "deg"
        if answer.is_place or answer.computed or answer.undefined or answer.reading.unit == YES_NO or deg:
            continue
        told, error = drawn_number(answer), printed_unit(answer.reading.unit)[0] * answer.expected_error
        size, half = read_back(told)
        if answer.reading.mm is None and size and isfinite(error) and abs(size) < 1e3:
            ones = half == 0.5  # a whole number is told to its ones, whatever was read: no one writes 4.4·10²
            as_read = len(told.strip("−0.").replace(".", "")) <= 3 and places_of(told) <= answer.least  # of its length
            assert ones or as_read or 2 * half >= 0.03 * error, (
                f"{answer.key}: {told} has digits past what was read: ±{error:.2g}"
            )
            figures = len(told.strip("−0.").replace(".", ""))  # three, however little it may be off
            assert half <= error or "." not in told or "×" in told or figures >= 3, f"{answer.key}: {told} ±{error:.2g}"


def test_a_line_goes_on_with_the_numbers_that_are_printed_before_it() -> None:
    steps = solve(load("3-5")).construction.steps
    lines = [plain(line).replace("\u2009", " ") for step in steps for line in step.formulas]
    assert "a^n_FE = ω_4^2 l_EF = 1.127^2 × 0.6 = 0.762 m/s^2" in lines
    assert "e^′n^′_4 = (a^n_FE)/(μ_a) = (0.762)/(0.06) = 12.7 mm" in lines
    assert any(line.endswith(" = 5.30 rad/s^2") for line in lines), "a zero that was read is told"


def test_a_vector_is_told_with_scale_length_number_unit_and_direction() -> None:
    solution = solve(load("3-9"))
    assert line_of(solution, "v_E") == "v_E = μ_v·28.8 mm = 0.1728 m/s（∠312.3°）"
    assert line_of(solution, "v_E", "en") == "v_E = μ_v·28.8 mm = 0.1728 m/s (∠312.3°)"


def test_what_turns_is_told_with_its_sense_and_never_with_a_sign() -> None:
    solution = solve(load("3-9"))
    assert line_of(solution, "omega_2").endswith("= 1.995 rad/s（顺时针）")
    assert line_of(solution, "omega_3", "en") == "ω_3 = 1.995 rad/s (clockwise)"


def test_a_vector_along_an_axis_is_told_with_an_arrow() -> None:
    told = [line_of(solve(load("3-5")), key) for key in ("v_F", "a_F")]
    assert all(text.endswith(("（←）", "（→）")) for text in told), told


def test_a_length_ends_with_millimetres_as_in_the_table() -> None:
    solution = solve(load("5-3"))
    assert line_of(solution, "h") == "h = μ_l′·2.4 mm = 1.92 mm"
    assert rows_of(solution, "zh")["$h$"][:5] == ("$h$", "mm", "2.4（过短）", "$μ_l′$", "1.92")


def test_a_coarse_reading_is_told_to_be_so_and_no_other() -> None:
    solution = solve(load("5-3"))
    told = {line.key: line.after for line in lines_of(solution, "en")}
    force = solution.answers["F"]
    of_the_exact = f"±{100 * force.expected_error / abs(force.exact):.0f} %"  # as the check beside it tells
    assert of_the_exact in told["F"] and "±" not in told["R_21"] + told["R_31"]
    assert {key for key, text in told.items() if "±" in text} == {
        key for key, one in solution.answers.items() if (coarse(one) or 0.0) >= COARSE
    }
    starred = {key for row in rows_in(answer_box(solution, "en")) for key in row.keys if row.error.endswith("*")}
    assert starred == {key for key, text in told.items() if "±" in text}, "and marked in the table"


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
    lines = lines_of(solve(load("3-5")), "en") * 2
    box, width = AnswerBox(lines, lang="en"), 170.0 * MM
    whole = box.wrap(width, 1e4)[1]
    for height in (0.4 * whole, 0.6 * whole, 0.9 * whole):
        head, tail = AnswerBox(lines, lang="en").split(width, height)
        assert head.wrap(width, height)[1] + head.getSpaceBefore() <= height
        assert head.wrap(width, 1e4)[1] + tail.wrap(width, 1e4)[1] >= whole - 3.0 * MM
    assert box.split(width, 0.1 * whole) == [], "a part of less than three rows is none"


def boxes(name: str) -> Iterator[AnswerBox]:
    """The box of the problem in either language, laid out."""
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        box = answer_box(solution, lang)
        box.wrap(170.0 * MM, 1e4)
        yield box


@each(DRAFTED)
def test_the_cells_of_a_box_begin_at_the_edges_of_two_or_three_columns_and_keep_within_them(name: str) -> None:
    for box in boxes(name):
        rows = [row for row in box._rows if row[0][2].node is not None]
        if not rows:
            continue
        edges = sorted({x for row in rows for x, _, _ in row})
        assert len(edges) == len(max(rows, key=len)) <= 3, "one grid in all rows"
        ends = [*edges[1:], 170.0]
        assert all(x + cell.width <= end + 1e-6 for row in rows for (x, cell, _), end in zip(row, ends, strict=False))
        assert all(x == edge for row in rows for (x, _, _), edge in zip(row, edges, strict=False))


@each(DRAFTED)
def test_the_rows_of_a_box_have_one_height_and_its_quantities_run_down_columns_without_a_hole(name: str) -> None:
    for box in boxes(name):
        heights = {round(max(cell.ascent + cell.descent for _, cell, _ in row), 6) for row in box._rows}
        assert len(heights) <= 1 or max(map(len, box._rows)) == 1, "one column may have a broken line"
        told = [told.node for _, _, _, told in in_reading_order(box._rows) if told.node is not None]
        assert told == [line.node for line in box.lines]
        for _, some in groupby(box._rows, key=lambda row: row[0][2].node is not None):
            lengths = [len(row) for row in some]
            assert lengths == sorted(lengths, reverse=True), "nothing is left out but at the foot of the last columns"


def test_a_page_that_ends_within_a_box_parts_its_quantities_as_they_are_read() -> None:
    lines = lines_of(solve(load("3-5")), "en") * 2
    box, width = AnswerBox(lines, lang="en"), 170.0 * MM
    parts = box.split(width, 0.6 * box.wrap(width, 1e4)[1])
    told = [one[3].node for part in parts for one in in_reading_order(part._rows) if one[3].node is not None]
    assert told == [line.node for line in lines]


@each(DRAFTED)
def test_notes_stand_under_the_columns_each_once(name: str) -> None:
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        box = answer_box(solution, lang)
        assert len(set(box.notes)) == len(box.notes)
        for answer in solution.answers.values():
            if stands_still(answer):
                beside = " ".join(f"{plain(line.node)}{line.after}" for line in box.lines)
                beside += " ".join("".join(row.way.split("$")) for row in rows_in(box))
                assert "".join(remark_of(answer, lang).split("$")) in beside, "said once, beside its 0"
            elif answer.short or remark_of(answer, lang):
                text = remark_of(answer, lang) or f"${answer.reading.symbol}$"
                assert any(text.lower() in note.lower() for note in box.notes), answer.key
        box.wrap(170.0 * MM, 1e4)
        told = [row[0][2] for row in box._rows if row[0][2] is not box._named]
        last = max((n for n, one in enumerate(told) if one.node is not None), default=-1)
        assert all(one.node is not None or one.after.startswith(("解 ", "Solution ")) for one in told[: max(last, 0)])
        assert {one.after for one in told[last + 1 :]} == {*box.notes, *box.said}


def test_as_many_rows_of_two_columns_are_more_even_than_of_three() -> None:
    box = AnswerBox(lines_of(solve(load("8-4")), "zh"), lang="zh")
    box.wrap(170.0 * MM, 1e4)
    assert max(len(row) for row in box._rows) == 2


@each(DRAFTED)
def test_no_cell_of_the_box_has_a_fraction_or_a_chain_of_substitutions(name: str) -> None:
    solution = drafted(name)
    for line in answer_box(solution, "en").lines if solution is not None else ():
        text = plain(line.node)
        assert (
            ")/(" not in text and " × " not in text.replace("×10^", "") and text.count(" = ") <= 2 + len(line.also)
        ), text


@each(DRAFTED)
def test_a_length_on_paper_times_its_scale_is_the_value_that_is_told(name: str) -> None:
    solution = drafted(name)
    for answer in solution.answers.values() if solution is not None else ():
        assert solution is not None
        told = re.match(r".* = μ\S*·([\d.]+) mm = ([\d.]+)", line_of(solution, answer.key, "en"))
        if told is None or "×10" in told.string[told.end() :]:
            continue
        assert told[1] == on_paper(answer)
        scales = [f.scale.value for f in solution.construction.figures if f.scale.symbol == answer.reading.scale]
        unit = 1e3 if printed_unit(answer.reading.unit)[1] == "mm" else 1.0
        half = 0.5001 * 10.0 ** -len(told[2].partition(".")[2])
        assert any(abs(float(told[1]) * scale * unit - float(told[2])) <= half for scale in scales), told[0]


@pytest.mark.parametrize("name", ["8-4", "field-two-runs"])
def test_a_line_of_the_box_stands_under_its_solution_where_there_are_two(name: str) -> None:
    box = answer_box(drawn(name).solution, "en")
    assert {"Solution 1", "Solution 2"} <= {line.heading for line in box.lines}
    for line in box.lines:
        number = line.key.rpartition("_")[2]
        assert line.heading == (f"Solution {number}" if number in ("1", "2") else ""), line.key
