"""Steps as a report sets them: results without a way to them stand in the sentence, like steps share a table, numbers
are printed once; the check ends with a verdict."""

from __future__ import annotations

import re

import pytest
from vecpoly.report.answers.checks import check_tables, checked

from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from vecpoly.algebra.formula import Row, plain
from vecpoly.algebra.rounding import read_back
from vecpoly.problem.load import load, loads
from vecpoly.report.answers.notes import stands_still
from vecpoly.report.answers.verdict import verdict_of
from vecpoly.report.content import Objects
from vecpoly.report.flow.blocks import Plate, SheetPage
from vecpoly.report.flow.style import BODY
from vecpoly.report.flow.table import DataTable
from vecpoly.report.plates.bound import pages
from vecpoly.report.steps.lines import displayed, with_results
from vecpoly.report.steps.sections import sections
from vecpoly.solution import solve
from vecpoly.typeset.layout import layout
from vecpoly.words import Lang, bare

LANGS: tuple[Lang, ...] = ("zh", "en")
_AMOUNT = re.compile(r"\$? ?[（(](?:[^（()）]*[，,] )?([\d.]+)( %|°| mm)[，,] (?:预期误差|expected) ([\d.]+)")


@each(DRAFTED)
def test_what_has_no_way_to_it_is_told_in_the_sentence_or_by_the_box_and_not_displayed_alone(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    asked = {id(one.reading.formula): one for one in solution.answers.values() if one.reading.formula is not None}
    for step in solution.construction.steps:
        shown = displayed(step, solution)
        if step.equation is None and step.listing is None and 0 < len(shown) <= 4:
            assert not all(
                isinstance(one, Row) and one.worked is None and plain(one).count(" = ") == 1 for one in shown
            )
        told = bare(with_results(step.words.en, step, solution, "en"))
        gone = [line for line in step.formulas if not any(plain(line).startswith(plain(one)) for one in shown)]
        for line in gone:
            answer = asked.get(id(line))
            by_box = answer is not None and (answer.is_place or stands_still(answer))
            said = plain(line) in told or plain(line).endswith(" —") or " = 0 " in f"{plain(line)} "
            assert by_box or said, (step.number, plain(line))


@each(DRAFTED)
def test_a_line_ends_with_one_number(name: str) -> None:
    solution = drafted(name)
    for step in solution.construction.steps if solution is not None else ():
        assert solution is not None
        for line in displayed(step, solution):
            exact, about, rounded = plain(line).rpartition(" = ")[2].partition(" ≈ ")
            units = {text.partition(" ")[2] for text in (exact, rounded)}
            assert not about or len(units) == 2, plain(line)


def test_like_steps_share_a_table_and_their_remarks_stand_over_it() -> None:
    solution, objects = solve(load("3-1d")), Objects()
    told = [step for part in sections(solution, "en", objects) for step in part["steps"]]
    (run,) = (step for step in told if step["table"])
    table = objects.named[run["table"]]
    assert isinstance(table, DataTable) and [row[0] for row in table.rows] == [str(n) for n in range(8, 15)]
    assert table.rows[0] == ("8", "$P_{26}$", "126", "$P_{12}P_{16}$", "236", "$P_{23}^{∞}P_{36}$")
    assert run["n"] == 8 and "$P_{46}$: these lines also meet at a small angle" in run["words"]
    assert [step["n"] for step in told] == list(range(1, 9)), "the numbers of the steps are in the table"


@each(DRAFTED)
def test_the_check_ends_with_what_it_comes_to(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    for lang in LANGS:
        told, tables = verdict_of(solution, lang), check_tables(solution, lang)
        rows = sum(len(table.rows) for table in tables)
        assert told or rows <= 1, "several values were read, and nothing is said of them"
        cells = {cell.lstrip("+−") for table in tables for row in table.rows for cell in row}
        for off, unit, error in _AMOUNT.findall(told):
            seen = all({text, text + unit.strip(), f"{text} {unit.strip()}"} & cells for text in (off, error))
            assert seen or not rows, (off, error)


def test_reactions_in_a_row_that_are_equal_have_one_line_and_one_row() -> None:
    solution, objects = solve(load("4-6")), Objects()
    told = [step for part in sections(solution, "en", objects) for step in part["steps"] if step["n"] == 14]
    set_lines = [objects.named[ref] for step in told for ref in step["formulas"]]
    lines = [plain(one) for one in set_lines if isinstance(one, Row)]
    assert sum(line.endswith("= 659 N") for line in lines) == 3, "measured twice, then one chain"
    assert lines[-1] == "R_21 = R_32 = R_12 = R_23 = R_43 = 659 N"
    (table,) = check_tables(solution, "en")
    assert [row[0] for row in table.rows if row[2] == "659"] == ["$R_{12}$, $R_{32}$, $R_{23}$, $R_{43}$"]


@each(DRAFTED)
def test_lines_that_reckon_the_same_of_many_bodies_stand_two_by_two(name: str) -> None:
    solution, objects = drafted(name), Objects()
    for part in sections(solution, "en", objects) if solution is not None else ():
        for step in part["steps"]:
            lines = [one for ref in step["formulas"] if isinstance(one := objects.named[ref], Row)]
            forms = {re.sub(r"_\w+|[\d.]+", "", plain(line)) for line in lines}
            wide = any(layout(line, BODY.em).width > 78.0 for line in lines)
            assert len(lines) < 4 or len(forms) > 2 or wide, plain(lines[0])


def test_the_largest_deviation_is_named_with_what_was_expected() -> None:
    solution = solve(load("klann-leg"))
    told = verdict_of(solution, "zh")
    assert (said := re.fullmatch(r"各偏差均不超过预期误差，最大的是 \$(.)_(\d)\$（(.*) %，预期误差 (.*) %）。", told))
    off = {key: abs(one.drawn / one.exact - 1) for key, one in solution.answers.items() if not one.is_place}
    assert {"α": "alpha", "ω": "omega"}[said[1]] + f"_{said[2]}" == max(off, key=lambda key: off[key])
    assert float(said[3]) == pytest.approx(100 * max(off.values()), abs=0.1) and float(said[4]) > float(said[3])


def test_what_is_ill_conditioned_is_named_and_to_be_computed() -> None:
    told = verdict_of(solve(load("3-1d")), "en")
    assert told.endswith(
        "$P_{24}$ (±21.9 mm) and $P_{46}$ (±12.7 mm) are ill-conditioned in the drawing: take the computed values."
    )
    assert "ill-conditioned" not in verdict_of(solve(load("3-9")), "en")


@pytest.mark.parametrize(("asked", "told"), [("P_24", True), ("P_13", False)])
def test_a_value_that_was_read_alone_has_a_verdict_where_it_is_ill_conditioned(asked: str, told: bool) -> None:
    said = verdict_of(solve(loads(f"id: one\nextends: 3-1d\nfind: [{asked}]\n")), "en")
    assert ("$P_{24}$ (±22 mm) is ill-conditioned" in said) is told and bool(said) is told


def test_a_deviation_that_is_larger_than_expected_is_told() -> None:
    pencil = next(s for seed in range(60) if "but" in verdict_of(s := solve(load("3-9"), by="pencil", seed=seed), "en"))
    assert "Every deviation but $" in verdict_of(pencil, "en") and "除" in verdict_of(pencil, "zh")


@each(DRAFTED)
def test_distances_have_no_more_decimals_than_the_coordinates(name: str) -> None:
    solution = drafted(name)
    for table in check_tables(solution, "en") if solution is not None else ():
        for row in table.rows if "Distance /mm" in table.header else ():
            off = row[table.header.index("Distance /mm")]
            assert off == "—" or len(off.partition(".")[2]) == 2


@each(DRAFTED)
def test_expected_errors_of_one_column_have_as_many_decimals(name: str) -> None:
    solution = drafted(name)
    for table in check_tables(solution, "en") if solution is not None else ():
        heads = [head for head in table.header if head.startswith("Expected error /")]  # else each has its unit
        for head in heads:
            cells = [row[table.header.index(head)] for row in table.rows]
            plain_ones = [cell for cell in cells if cell != "—" and "×" not in cell and read_back(cell)[0] < 100]
            decimals = {len(cell.partition(".")[2]) for cell in plain_ones}
            assert len(decimals) <= 1 or max(map(float, plain_ones)) > 100 * min(map(float, plain_ones)), cells


@each(DRAFTED)
def test_a_plate_stands_before_the_answer_and_behind_the_section_before_its_last_figure(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    objects = Objects()
    names, homes = pages(solution, "zh", objects)
    count = len({step.section.en for step in solution.construction.steps})
    assert homes == sorted(homes) and all(0 <= home < max(1, count) for home in homes)
    stand = [objects.named[one] for one in names]
    assert all(
        isinstance(one, Plate) or (isinstance(one, SheetPage) and one.behind == 1) for one in stand[: len(homes)]
    )
    assert not any(isinstance(one, Plate) for one in stand[len(homes) :])


@pytest.mark.parametrize("name", ["3-7d", "3-12"])
def test_what_is_computed_has_the_figures_of_what_is_read_beside_it(name: str) -> None:
    solution = solve(load(name))
    lines = [plain(line) for step in solution.construction.steps for line in step.formulas]
    assert any(line.endswith(" = 0.500 m/s") for line in lines) and any(
        line.endswith(" = 5.00 m/s^2") for line in lines
    )
    assert checked(solution)


def test_lines_that_reckon_the_same_of_equal_bodies_are_one_and_a_factor_of_zero_has_no_numbers() -> None:
    solution, objects = solve(load("6-6")), Objects()
    steps = [step for part in sections(solution, "en", objects) for step in part["steps"]]
    lines = [plain(one) for step in steps for ref in step["formulas"] if isinstance(one := objects.named[ref], Row)]
    assert "W_1 = W_2 = W_3 = m_1\u2009r_1 = 400 × 12.7 = 5080 g·mm" in lines
    (zero,) = (line for line in lines if line.startswith("W_S = "))
    assert zero.endswith(" = 0 g·mm") and "×" not in zero
