"""A table among what is given stands on the page: a printed problem can be solved without a file beside it."""

from __future__ import annotations

import re
from typing import get_args

import pytest

from tests.drawn_library import DRAFTED, LIBRARY, drafted, given
from tests.each import each
from tests.found import DEVICES
from tests.lawful import CARD, ENGINE, PLAIN, slider
from tests.presses import press
from tests.studies import studied
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem
from vecpoly.problem.values.given import as_printed
from vecpoly.report.content import beside_tables
from vecpoly.report.course.statement import known
from vecpoly.report.statement.in_table import in_table, scalar
from vecpoly.report.tables import MOST_GIVEN, given_tables
from vecpoly.solution import solve
from vecpoly.words import Lang

LANGS = get_args(Lang)


def shown(problem: Problem) -> list[tuple[str, str]]:
    """The pairs of the one table, block by block."""
    (table,) = given_tables(problem, "en")
    wide = range(0, len(table.header), 3)
    return [(row[at], row[at + 1]) for at in wide for row in table.rows if row[at]]


def test_an_indicator_card_is_printed_with_its_units() -> None:
    problem = load("engine-card")
    (table,) = given_tables(problem, "zh")
    assert table.header[:2] == ("$φ$ /°", "$p$ /MPa")
    pairs = shown(problem)
    assert pairs[:2] == [("0", "2.20"), ("10", "3.40")] and pairs[-1] == ("720", "2.20") and len(pairs) == 19
    assert ("380", "−0.01") in pairs


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_what_is_given_names_the_table_by_its_quantities_and_no_file(lang: Lang) -> None:
    told = " ".join(datum.of(lang) for datum in load("engine-card").given.loads)
    assert {"zh": "$F$ 由 $p$–$φ$ 数据表给出", "en": "$F$ by the table of $p$ over $φ$"}[lang] in told
    assert ".csv" not in told


def test_a_table_over_a_length_tells_what_travels_so_far() -> None:
    """A reader was given F over s, and not told of what point s is the travel, nor from where it counts."""
    of_point = " ".join(datum.of("zh") for datum in slider(ENGINE).given.loads)
    assert "（$s$ 为 $C$ 点沿力的方向自行程起点量起的位移），活塞直径" in of_point
    driven = PLAIN.replace("{link: 1, phi: 50 deg, omega: 300 r/min ccw}", "{link: 3, s: 200 mm, v: 1 m/s}")
    rows = "columns: [s (mm), F (N)], rows: [[0, 100], [400, 300]]"
    pressed = f"F: {{on: 2, at: B, size: {{{rows}}}, direction: 90 deg}}"
    unknown = 'Q: {on: 3, at: C, size: "?", direction: 0 deg}'
    of_drive = slider(pressed, unknown=unknown, find="Q", plain=driven.replace("C right of B", "B above AC"))
    assert "over $s$ ($s$: the travel of the driving link)" in " ".join(one.of("en") for one in of_drive.given.loads)


def test_a_table_that_would_fill_pages_is_not_printed() -> None:
    rows = ", ".join(f"[{n / 2}, {n}]" for n in range(MOST_GIVEN + 1))
    long = f"columns: [s (mm), p (MPa)], rows: [{rows}]"
    assert not given_tables(slider(ENGINE.replace(CARD, long)), "en")
    assert len(given_tables(slider(ENGINE), "en")) == 1


@each(DRAFTED)
def test_many_given_numbers_stand_in_a_table_and_no_number_twice(name: str) -> None:
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        told, tables = beside_tables(solution, lang)["given"], given_tables(solution.problem, lang)
        assert len(re.findall(r"\$ = −?[\d.]+(?:°| \S+)?[，,]", told)) < 12, told
        for table in tables:
            symbols = {cell for row in table.rows for cell in row if cell.startswith("$")}
            assert not [one for one in symbols if f"{one} = " in told]


def test_a_datum_with_a_sense_stays_in_the_line_and_the_others_have_symbol_value_and_unit() -> None:
    problem = load("jansen-leg")
    (table,) = given_tables(problem, "en")
    assert table.header[:3] == ("Symbol", "Value", "Unit") and table.rows[0][:3] == ("$l_AB$", "15", "mm")
    told = beside_tables(solve(problem, repeats=20), "en")["given"]
    assert "5 rad/s (counter-clockwise, constant)" in told and told.endswith("the other data are in the table")


def test_places_are_given_in_one_notation_and_directions_say_what_they_are() -> None:
    told = beside_tables(solve(load("8-10"), repeats=20), "en")["given"]
    assert told.startswith("$A$ = (0, 0) mm, directions of $CE$ in its positions $φ_{CE}$ = 150°, 180°")


def test_a_problem_without_a_table_has_none() -> None:
    assert not given_tables(load("3-9"), "zh")


@each(LIBRARY)
def test_the_units_of_a_table_of_data_are_units_and_no_numbers(name: str) -> None:
    """A moment of inertia of a shaft and a gear: 0.08 + 0.01 kg·m² has its unit once."""
    table = in_table(given(name), "en")[1]
    for row in table.rows if table is not None and "Unit" in table.header else ():
        assert table is not None
        units = [row[n] for n, head in enumerate(table.header) if head == "Unit"]
        assert not [unit for unit in units if re.search(r"\d|\+", unit.replace("^2", "").replace("^3", ""))]


def test_a_sum_of_two_in_one_unit_has_it_once() -> None:
    table = in_table(load("7-2a"), "zh")[1]
    assert table is not None and table.rows[1][:3] == ("$J_{I}$", "0.08 + 0.01", "kg·m²")


@pytest.mark.parametrize(
    ("written", "zh"),
    [
        ("1e-1 m", "0.1 m"),
        ("2.5e+2 mm", "250 mm"),
        ("-1.0E1 rad/s", "−10 rad/s"),
        ("3e-9 m", "$3×10^{−9}$ m"),
        ("-5.77432155e-15 deg", "−$5.77432×10^{−15}$°"),
    ],
)
def test_a_number_that_is_given_with_an_exponent_is_printed_as_in_a_book(written: str, zh: str) -> None:
    assert as_printed(written, "zh") == zh


@pytest.mark.parametrize(
    ("written", "en"),
    [
        ("-0 rad/s^2", "0 rad/s^2"),
        ("(-0.0, -3) mm", "(0.0, −3) mm"),
        ("-0.5 mm", "−0.5 mm"),
        ("-0.05 mm at -0 deg", "−0.05 mm at 0°"),
    ],
)
def test_zero_has_no_minus(written: str, en: str) -> None:
    assert as_printed(written, "en") == en


@each(LIBRARY)
def test_a_speed_in_turns_a_minute_stands_in_no_table_as_an_angular_velocity(name: str) -> None:
    for lang in LANGS:
        rows = [row for datum in given(name).given.data if (row := scalar(datum, lang)) is not None]
        for symbol, _, unit in rows:
            assert not (symbol.startswith("$ω") and "min" in unit), f"{symbol} in {unit}"
            assert "（" not in unit and "clockwise" not in unit, "a sense stands in the line, in words"


def test_the_drive_of_a_machine_is_told_by_its_turns_a_minute_in_a_course_report() -> None:
    kept = press("zh")
    told = known(studied("press-flywheel"), kept)
    assert "$n_1$ = 120 r/min（逆时针）" in told["given"]
    assert not any("ω" in cell for row in kept.made[-1].rows for cell in row)


@pytest.mark.parametrize(
    ("written", "zh"),
    [
        ("0°: 150, 22.5°: -3 N·m", "150（0°），−3（22.5°） N·m"),
        ("0°: 1e+06, 180°: 2.5e-05 N·m", "1000000（0°），$2.5×10^{−5}$（180°） N·m"),
        ("0.0000151676 km", "$1.51676×10^{−5}$ km"),
    ],
)
def test_places_between_whole_degrees_and_numbers_with_exponents_are_read_as_one(written: str, zh: str) -> None:
    assert as_printed(written, "zh") == zh


MEASURED = """
id: measured
title: t
device: run-up
data:
  motor: [[0 rad/s, 100 N*m], [40 rad/s, 130 N*m], [80 rad/s, 140 N*m], [110 rad/s, 135 N*m], [130 rad/s, 110 N*m],
    [150 rad/s, 40 N*m], [157 rad/s, 0 N*m]]
  load: 20 N*m
  J: 2 kg*m^2
"""


@pytest.mark.parametrize(
    ("symbol", "text", "places"), [("M_r", DEVICES["rim-of-a-flywheel"], 9), ("M_d", MEASURED, 7)], ids=["φ", "ω"]
)
def test_a_curve_of_many_places_is_given_by_a_table_that_has_them_all(symbol: str, text: str, places: int) -> None:
    problem = loads(text)
    (told,) = (datum for datum in problem.given.data if datum.symbol == symbol)
    assert told.table is not None and len(told.table.rows) == places
    assert "…" not in told.of("zh") and "数据表" in told.of("zh") and "by the table" in told.of("en")
    table = given_tables(problem, "zh")[-1]
    assert all(any(row[at] for row in table.rows) for at in range(0, len(table.header), 3))
