"""Steps as a report sets them: results without a way to them stand in the sentence, like steps share a table, numbers
are printed once; the answer marks what is hardly found by drawing."""

from __future__ import annotations

import re

import pytest

from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from tests.framed_answers import rows_in, tables_of
from vecpoly.algebra.formula import Node, Row, plain
from vecpoly.algebra.rounding import read_back
from vecpoly.board.construction import View
from vecpoly.board.place import Pane, view_of
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.problem.load import load, loads
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.notes import stands_still
from vecpoly.report.answers.verdict import exceeds
from vecpoly.report.content import Objects
from vecpoly.report.flow.blocks import Plate, SheetPage
from vecpoly.report.flow.style import BODY
from vecpoly.report.flow.table import DataTable
from vecpoly.report.plates.bound import pages
from vecpoly.report.steps.lines import displayed, with_results
from vecpoly.report.steps.sections import sections
from vecpoly.solution import Solution, solve
from vecpoly.typeset.layout import layout
from vecpoly.words import Lang, bare

LANGS: tuple[Lang, ...] = ("zh", "en")


@each(DRAFTED)
def test_what_has_no_way_to_it_is_told_in_the_sentence_or_by_the_box_and_not_displayed_alone(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    asked = {id(one.reading.formula): one for one in solution.answers.values() if one.reading.formula is not None}
    rejected = [f"^({one.number})" for one in solution.construction.candidates if one.reason is not None]
    before, sentences = set[str](), list[str]()
    for step in solution.construction.steps:
        shown = displayed(step, solution)
        if step.equation is None and step.listing is None and 0 < len(shown) <= 4:
            assert not all(
                isinstance(one, Row) and one.worked is None and plain(one).count(" = ") == 1 for one in shown
            )
        told = bare(with_results(step.words.en, step, solution, "en"))
        gone = [line for line in step.formulas if not any(_begins(line, one) for one in shown)]
        for line in gone:
            answer = asked.get(id(line))
            by_box = answer is not None and (answer.is_place or stands_still(answer))
            said = plain(line) in told or plain(line).endswith(" —") or " = 0 " in f"{plain(line)} "
            said = said or any(plain(line).replace("^2", "²") in text.replace("^2", "²") for text in sentences)
            lost = any(number in plain(line).split(" = ")[0] for number in rejected)
            assert by_box or said or lost or plain(line) in before, (step.number, plain(line))
        before |= set(map(plain, step.formulas))
        sentences.append(told)


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


def _begins(line: Node, shown: Node) -> bool:
    """Whether a line is shown, whole or without its numbers."""
    way, _, end = plain(shown).rpartition(" = ")
    return plain(line).startswith(plain(shown)) or (plain(line).startswith(f"{way} = ") and f"= {end}" in plain(line))


def test_numbers_that_work_out_what_is_plain_are_left_out_where_all_lines_of_a_kind_do() -> None:
    drawn, couples = solve(load("4-3d")), solve(load("rotor-dalby"))
    (line,) = [plain(one) for step in drawn.construction.steps for one in displayed(step, drawn) if _starts(one, "v_B")]
    assert line.endswith("l_AB = 0.0800 m/s"), "of 1 × 0.08"
    lines = [plain(one) for step in couples.construction.steps for one in displayed(step, couples)]
    assert any("= 1.00 × 1.2 =" in one for one in lines), "beside lines that reckon, it reckons too"


def _starts(line: Node, symbol: str) -> bool:
    return plain(line).startswith(f"{symbol} = ")


def test_reactions_in_a_row_that_are_equal_have_one_line_and_one_row() -> None:
    solution, objects = solve(load("4-6")), Objects()
    told = [step for part in sections(solution, "en", objects) for step in part["steps"] if step["n"] == 14]
    set_lines = [objects.named[ref] for step in told for ref in step["formulas"]]
    lines = [plain(one) for one in set_lines if isinstance(one, Row)]
    assert sum(line.endswith("= 659 N") for line in lines) == 2, "measured once for both senses, then one chain"
    assert lines[0].startswith("R_21 = R_12 = μ_F")
    assert lines[-1] == "R_32 = R_12 = R_23 = R_43 = R_21 = 659 N", "what another line has found stands last"
    found = [row.keys for row in rows_in(answer_box(solution, "en")) if row.value == "659"]
    assert sorted(key for keys in found for key in keys) == ["R_12", "R_23", "R_32", "R_43"] and len(found) == 2, (
        "two directions of one length on paper"
    )


@each(DRAFTED)
def test_lines_that_reckon_the_same_of_many_bodies_stand_two_by_two(name: str) -> None:
    solution, objects = drafted(name), Objects()
    for part in sections(solution, "en", objects) if solution is not None else ():
        for step in part["steps"]:
            lines = [one for ref in step["formulas"] if isinstance(one := objects.named[ref], Row)]
            forms = {re.sub(r"_\w+|[\d.]+", "", plain(line)) for line in lines}
            wide = any(layout(line, BODY.em).width > 78.0 for line in lines)
            assert len(lines) < 4 or len(forms) > 2 or wide, plain(lines[0])


def starred(solution: Solution) -> set[str]:
    """The keys of what is marked in the answer as hardly found by drawing."""
    return {key for row in rows_in(answer_box(solution, "en")) for key in row.keys if row.error.endswith("*")}


def test_what_is_ill_conditioned_is_marked_and_to_be_taken_from_the_exact_values() -> None:
    solution = solve(load("3-1d"))
    assert starred(solution) == {"P_24", "P_46"}
    errors = {row.keys[0]: row.error for row in rows_in(answer_box(solution, "en"))}
    assert (errors["P_24"], errors["P_46"]) == ("21.9*", "12.7*")
    assert [note for note in answer_box(solution, "en").notes if note.startswith("* ill-conditioned")]
    assert not starred(solve(load("3-9"))) and "ill-conditioned" not in str(answer_box(solve(load("3-9")), "en").notes)


def test_a_length_of_a_linkage_of_which_the_drawing_tells_too_little_is_marked_too() -> None:
    solution = solve(load("K-slider-crank-AB"))
    (moved,) = solution.verification
    assert starred(solution) == set(moved.loose) == {"BC", "e"}


@pytest.mark.parametrize(("asked", "told"), [("P_24", True), ("P_13", False)])
def test_a_value_that_was_read_alone_is_marked_where_it_is_ill_conditioned(asked: str, told: bool) -> None:
    assert starred(solve(loads(f"id: one\nextends: 3-1d\nfind: [{asked}]\n"))) == ({asked} if told else set())


def test_a_deviation_that_is_larger_than_expected_is_told_and_no_other() -> None:
    drawings = (solve(load("3-9"), by="pencil", seed=seed) for seed in range(60))
    pencil = next(one for one in drawings if any("exceed" in note for note in answer_box(one, "en").notes))
    (said,) = (note for note in answer_box(pencil, "en").notes if "exceed" in note)
    named = {row.name for row in rows_in(answer_box(pencil, "en")) if exceeds(row.off, row.error)}
    assert named and {name for name in named if name in said} == named
    assert any("超过预期误差" in note for note in answer_box(pencil, "zh").notes)
    assert not any("exceed" in note for note in answer_box(solve(load("3-9")), "en").notes)


@each(DRAFTED)
def test_distances_have_no_more_decimals_than_the_coordinates(name: str) -> None:
    solution = drafted(name)
    for table in tables_of(answer_box(solution, "en")) if solution is not None else ():
        for row in table.rows if "Distance /mm" in table.header else ():
            off = row[table.header.index("Distance /mm")]
            assert off == "—" or off.endswith("°") or len(off.partition(".")[2]) == 2


@each(DRAFTED)
def test_expected_errors_of_one_column_have_as_many_decimals(name: str) -> None:
    solution = drafted(name)
    for table in tables_of(answer_box(solution, "en")) if solution is not None else ():
        heads = [head for head in table.header if head.startswith("Expected error /")]  # else each has its unit
        for head in heads:
            cells = [row[table.header.index(head)].rstrip("*") for row in table.rows]
            cells = [cell for cell in cells if " " not in cell and "°" not in cell]  # others have their own unit
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

    shown = sheets(
        solution.construction, title=solution.problem.title, on=solution.problem.paper, plates=True, bands=False
    )
    begun = [max((_begun(solution, one.view, one.name) for one in sheet.figures), default=0) for sheet in shown]
    assert homes == [max(0, max(begun[: n + 1]) - 1) for n in range(len(homes))]


def _begun(solution: Solution, view: View, name: str) -> int:
    """The section, from 0, whose step first draws on this figure."""
    titles = list(dict.fromkeys(step.section.en for step in solution.construction.steps))
    section = {step.number: titles.index(step.section.en) for step in solution.construction.steps}
    places = [(act.head.place, act.head.step) for act in solution.construction.acts]
    named = [(view_of(at), at.name if isinstance(at, Pane) else "", step) for at, step in places if at is not None]
    return min(
        (section[step] for kind, own, step in named if (kind, own) == (view, name) and step in section), default=0
    )


@pytest.mark.parametrize("name", ["3-7d", "3-12"])
def test_what_is_computed_has_the_figures_of_what_is_read_beside_it(name: str) -> None:
    solution = solve(load(name))
    lines = [plain(line) for step in solution.construction.steps for line in step.formulas]
    assert any(line.endswith(" = 0.500 m/s") for line in lines) and any(
        line.endswith(" = 5.00 m/s^2") for line in lines
    )
    assert rows_in(answer_box(solution, "en"))


def test_lines_that_reckon_the_same_of_equal_bodies_are_one_and_a_factor_of_zero_has_no_numbers() -> None:
    solution, objects = solve(load("6-6")), Objects()
    steps = [step for part in sections(solution, "en", objects) for step in part["steps"]]
    lines = [plain(one) for step in steps for ref in step["formulas"] if isinstance(one := objects.named[ref], Row)]
    assert "W_1 = W_2 = W_3 = m_1\u2009r_1 = 400 × 12.7 = 5080 g·mm" in lines
    (zero,) = (line for line in lines if line.startswith("W_S = "))
    assert zero.endswith(" = 0 g·mm") and "×" not in zero
