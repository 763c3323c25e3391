"""A value stands in one form in all of its lines; every number of a column has the unit of its head, or its own."""

from __future__ import annotations

from math import inf

import pytest

import vecpoly
from tests.drawn_library import drafted
from tests.presses import press
from tests.studies import studied
from vecpoly.algebra.formula import plain
from vecpoly.algebra.rounding import read_back
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import Block, FixedGuide, Point, Segment
from vecpoly.diagram.chains import INWARD, NEXT
from vecpoly.printed.digits import drawn_number, in_percent
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.line import result_of, short_line
from vecpoly.report.answers.tables import _values
from vecpoly.report.course.checks import chapter, comparison
from vecpoly.report.flow.results.tabled import TabledAnswers
from vecpoly.solution import Solution


def of(name: str) -> Solution:
    solution = drafted(name)
    return solution if solution is not None else vecpoly.load(name).solve()


@pytest.mark.parametrize("name", ["5-3", "4-7", "4-5"])
def test_an_efficiency_in_per_cent_is_that_which_is_printed(name: str) -> None:
    eta = of(name).answers["eta"]
    assert result_of(eta, "en") == f"{drawn_number(eta)} ({in_percent(drawn_number(eta))})"


def test_a_share_keeps_its_figures_in_per_cent() -> None:
    assert [in_percent(text) for text in ("0.44", "0.570", "1.00", "0.05")] == ["44 %", "57.0 %", "100 %", "5 %"]


@pytest.mark.parametrize("name", ["4-3b", "4-4", "4-7"])
def test_the_arm_of_a_couple_is_found_before_its_moment(name: str) -> None:
    """h stood under the line of M, which goes on with it."""
    for step in of(name).construction.steps:
        told = [plain(line).split(" = ")[0] for line in step.formulas]
        if "h" in told:
            assert told.index("h") < min(n for n, symbol in enumerate(told) if symbol.startswith("M"))
            return
    pytest.fail("no line of h")


@pytest.mark.parametrize("name", ["5-1", "cam-flat-arm", "4-5"])
def test_degrees_stand_in_no_column_of_per_cents(name: str) -> None:
    solution = of(name)
    table = _values([one for one in solution.answers.values() if not one.is_place], solution, "en")
    (column,) = (n for n, head in enumerate(table.header) if head.startswith("Deviation"))
    cells = [row[column] for row in table.rows if row[column] != "—"]
    mixed = any(cell.endswith("°") for cell in cells)
    assert table.header[column] in (("Deviation",) if mixed else ("Deviation /%", "Deviation /°"))
    assert not mixed or all(cell.endswith(("°", " %")) for cell in cells)


def test_a_column_of_degrees_alone_has_its_unit_in_its_head() -> None:
    table = _values([*of("8-2g").answers.values()], of("8-2g"), "en")
    assert "Deviation /°" in table.header and not any("°" in cell for row in table.rows for cell in row)


def test_directions_are_explained_where_the_answer_has_an_angle_of_one() -> None:
    for name, shown in (("8-2g", False), ("3-9", True)):
        box = answer_box(of(name), "en")
        told = " ".join((*box.notes, box.head if isinstance(box, TabledAnswers) else ""))
        assert ("direction angles (∠) are counter-clockwise" in told) is shown


@pytest.mark.parametrize("name", ["5-3", "tipper", "whitworth-quick-return", "class-iii-slides"])
def test_a_deviation_is_that_of_the_two_values_beside_it(name: str) -> None:
    solution = of(name)
    table = _values([one for one in solution.answers.values() if not one.is_place], solution, "en")
    drawn, exact, column = (
        next(n for n, head in enumerate(table.header) if head.startswith(start))
        for start in ("Drawn", "Exact", "Deviation")
    )
    rows = [row for row in table.rows if row[column] != "—" and "°" not in row[column]]
    assert rows
    for row in rows:
        (here, _), (there, _) = (read_back(row[n]) for n in (drawn, exact))
        off = float(row[column].removesuffix(" %").replace("−", "-"))
        assert off == pytest.approx(100 * (here - there) / abs(there), abs=0.0051), row


@pytest.mark.parametrize("name", ["curv-10", "shaper-cut", "5-3", "plate-on-crank", "8-9"])
def test_a_length_on_paper_times_its_scale_is_the_value_beside_it(name: str) -> None:
    solution = of(name)
    table = _values([one for one in solution.answers.values() if not one.is_place], solution, "en")
    heads = ("On paper /mm", "Scale", "Drawn")
    length, scale, drawn = (next(n for n, one in enumerate(table.header) if one.startswith(head)) for head in heads)
    known = {f"${one.scale.symbol}$": one.scale.value for one in solution.construction.figures}
    rows = [row for row in table.rows if row[scale] in known]
    assert rows
    for row in rows:
        size, half = read_back(row[drawn])
        per_mm = known[row[scale]] * (1e3 if "mm" in (row[1], table.header[drawn].partition("/")[2]) else 1.0)
        assert size == pytest.approx(float(row[length].split()[0]) * per_mm, abs=half * 1.01), row


def test_both_arms_of_a_balance_by_moments_have_their_letters() -> None:
    figure = of("4-7").construction.figure(View.MECHANISM)
    assert figure is not None
    assert {"h_{Q}", "h_{12,0}"} <= {mark.label for mark in figure.marks if isinstance(mark, Point)}


def test_the_letter_of_a_guide_stands_at_the_guide() -> None:
    guides = 0
    for figure in of("2-12").construction.figures:
        rails = [mark for mark in figure.marks if isinstance(mark, FixedGuide)]
        for spot in (mark.at for mark in figure.marks if isinstance(mark, Point) and mark.label == "D'"):
            guides += bool(rails)
            assert not rails or min(abs(spot - end) for rail in rails for end in (rail.a, rail.b)) < INWARD + 1e-9
    assert guides == 2


@pytest.mark.parametrize("name", ["2-6", "2-9", "2-10", "2-12", "2-13"])
def test_the_letter_of_a_block_with_a_pin_stands_at_the_block_or_at_the_end_of_its_line(name: str) -> None:
    """B' stood as far from its block as the letter of another joint, E' under the line of its guide."""
    letters = 0
    for figure in of(name).construction.figures:
        blocks = [mark.at for mark in figure.marks if isinstance(mark, Block)]
        rails = [mark for mark in figure.marks if isinstance(mark, FixedGuide)]
        ends = [end for mark in figure.marks if isinstance(mark, Segment) for end in (mark.a, mark.b)]
        ends += [end for rail in rails for end in (rail.a, rail.b)]
        for spot in (one.at for one in figure.marks if isinstance(one, Point) and one.label.endswith("'")):
            letters += 1
            at_block = min((abs(spot - at) for at in blocks), default=inf) < NEXT + 1e-9
            assert at_block or min(abs(spot - end) for end in ends) < INWARD + 1e-9
    assert letters


def test_what_is_not_checked_is_not_told_and_the_largest_value_is_that_of_the_extremes() -> None:
    study = studied("excavator-boom")
    kept = press("en")
    told = chapter.chapter(study, kept)["told"]
    assert told.startswith("No velocity or acceleration differs from the solver") and "quotients" not in told
    highest = study.extremes("v_E").highest
    assert highest is not None and comparison.study_size(study, "v_E") == pytest.approx(highest.value, rel=1e-12)


def test_a_centre_at_infinity_is_nowhere_said_to_be_equal_to_infinity() -> None:
    solution = of("3-1e")
    told = [plain(line) for step in solution.construction.steps for line in step.formulas]
    assert "P^∞_13 (∠133.0°)" in told and not any("→" in line for line in told)
    assert plain(short_line(solution.answers["P_13"], solution, "en")) == "P^∞_13 at infinity (∠133.0°)"
    assert plain(short_line(solution.answers["P_13"], solution, "zh")) == "P^∞_13 在无穷远处（∠133.0°）"
