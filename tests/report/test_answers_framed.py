"""The framed answer: each value asked once, with unit and direction, and beside what was read what it is exactly, how
far it is off and may be off."""

from __future__ import annotations

import re
from itertools import groupby
from math import pi

import pytest

from tests.drawn_library import DRAFTED, drafted
from tests.each import each
from tests.framed_answers import KNOWN, keys_of, rows_in, tables_of
from vecpoly.algebra.formula import plain
from vecpoly.algebra.rounding import places_of, read_back
from vecpoly.printed.digits import coordinates, exact_number, is_hopeless
from vecpoly.printed.places import place_parts
from vecpoly.printed.units import printed_unit
from vecpoly.problem.load import load
from vecpoly.report.answers.box import answer_box
from vecpoly.report.answers.errors import NOTHING
from vecpoly.report.answers.line import direction_told, result_of
from vecpoly.report.answers.order import solution_of
from vecpoly.report.answers.placed import clean
from vecpoly.report.answers.verdict import exceeds, is_ill
from vecpoly.report.flow.results.box import PAD, WHOLE
from vecpoly.report.flow.results.halved import GAP
from vecpoly.report.flow.results.tabled import TabledAnswers
from vecpoly.report.statement.groups import GROUPS, group_of, parted
from vecpoly.solution import YES_NO, solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang

WIDTH = 170.0 * MM
NUMBERED = re.compile(r"\^\{\(\d\)\}")  # of a solution
LANGS: tuple[Lang, ...] = ("zh", "en")


@each(DRAFTED)
def test_every_quantity_asked_stands_in_the_answer_once_with_its_value_unit_and_direction(name: str) -> None:
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        box = answer_box(solution, lang)
        assert sorted(keys_of(box)) == sorted(solution.answers)
        for line in box.lines:
            text = plain(line.node)
            assert text == line.result or re.search(rf"{re.escape(line.result)}(?:（.*）| \(.*\))?$", text), text
        for row in rows_in(box):
            for answer in (solution.answers[key] for key in row.keys):
                assert f"${answer.reading.symbol}$" in NUMBERED.sub("", row.name)
                ways, result = {direction_told(answer, solution, lang), row.way}, result_of(answer, lang)
                if answer.is_place:
                    at = answer.drawn_vector
                    turn = f"∠{answer.drawn:.1f}°".replace("-", "−")
                    parts = (turn,) if at is None else place_parts(at, coordinates(answer))
                    assert all(part in f"{row.value} {row.way}" for part in parts)
                    assert at is None or "mm" in (row.unit, row.cells["value"][1])
                    continue
                unit = row.unit if row.unit not in ("", "—") else row.cells["value"][1].strip("()")
                assert result == f"{row.value}{'' if unit in ('', '°') else ' '}{unit}", (result, row)
                assert len(ways - {"", "—"}) <= 1 and (not direction_told(answer, solution, lang) or row.way in ways)


@each((*DRAFTED, "incline-at-its-limit"))
def test_beside_every_value_that_was_read_stand_what_is_exact_its_deviation_and_its_expected_error(name: str) -> None:
    """The deviation is that of the two numbers as they are printed; what is computed or given says so, and has none."""
    solution = drafted(name)
    for row in rows_in(answer_box(solution, "en")) if solution is not None else ():
        assert solution is not None
        for answer in (solution.answers[key] for key in row.keys):
            if row.exact.partition(",")[0] in KNOWN:
                assert {row.off, row.error} <= {"—", ""} and (answer.computed or answer.expected_error < 1e-9)
                continue
            assert not answer.computed and row.error not in ("", "—")
            assert row.error.endswith("*") is is_ill(answer, solution)
            error, unit = row.in_unit("error")
            factor = {"%": 100.0 / abs(answer.exact) if answer.exact else 0.0, "°": 180.0 / pi}.get(unit)
            factor = printed_unit(answer.reading.unit)[0] if factor is None or "deg" in answer.reading.unit else factor
            factor = 1e3 if unit == "mm" and answer.is_place else factor
            half = 0.501 * 10.0 ** -places_of(error)
            assert read_back(error)[0] == pytest.approx(factor * answer.expected_error, rel=0.06, abs=half), row
            if not answer.is_place:
                assert row.exact == exact_number(answer, clean(answer)) or answer.reading.unit == YES_NO
            if row.off in ("", "—"):
                assert is_hopeless(answer) or not clean(answer) or answer.reading.unit == YES_NO
            elif not answer.is_place:
                here, there = read_back(row.value)[0], read_back(row.exact)[0]
                off, of = row.in_unit("off")
                told = here - there if of == "°" else 100 * (here - there) / abs(there)
                assert read_back(off)[0] == pytest.approx(told, abs=0.0051), row


@each(DRAFTED)
def test_nothing_is_said_in_a_note_that_the_table_shows(name: str) -> None:
    """No number of the table, no largest deviation, no sentence that all is within what was expected; but what exceeds
    that is named."""
    solution = drafted(name)
    if solution is None:
        return
    for lang in LANGS:
        box = answer_box(solution, lang)
        rows = rows_in(box)
        told = " ".join(box.notes)
        shown = {cell.rstrip("*") for row in rows for column in ("off", "error") for cell in [row.in_unit(column)[0]]}
        said = re.sub(r"(\$[^$]+\$) \d+\.\d mm", r"\1", told)  # but for how long what is too short is on paper
        assert not {text for text in shown if len(text) > 2} & set(re.findall(r"[+−]?\d+\.\d+", said))
        told_off = [row for row in rows if row.off]  # where nothing could be read well, no deviation is told
        over = [row for row in told_off if exceeds(row.in_unit("off")[0], row.in_unit("error")[0])]
        assert all(row.name in told for row in over)
        assert ("超过预期误差" in told or "what is expected" in told) is bool(over)
        assert ("* " in told) is any(row.error.endswith("*") for row in rows)


@each(DRAFTED)
def test_the_answer_tells_kinds_as_they_follow_and_within_each_keeps_the_order_of_the_questions(name: str) -> None:
    solution = drafted(name)
    if solution is None:
        return
    box, order = answer_box(solution, "zh"), list(solution.answers)
    several = len({solution_of(one) for one in solution.answers.values()} - {0}) > 1
    rows = [(row.solution, row.keys[0], row.is_place) for row in rows_in(box)]
    listed = (
        [(part, key) for part, key, spot in rows if not spot],
        [(part, key) for part, key, spot in rows if spot],
        [(line.heading, line.key) for line in box.lines],
    )
    for some in listed:
        parts = [(head, [key for _, key in of]) for head, of in groupby(some, key=lambda one: one[0])]
        assert len(parts) == len({head for head, _ in parts}), "a solution stands in two places"
        assert all(bool(head) for head, _ in parts) is several or not several or len(parts) <= 1 or some is listed[2]
        for _, part in parts:
            kinds = [group_of(key, part) if parted(order) and not several else None for key in part]
            runs = [
                (kind, [key for key, _ in of])
                for kind, of in groupby(zip(part, kinds, strict=True), key=lambda one: one[1])
            ]
            assert all(sorted(run, key=order.index) == run for _, run in runs)
            places = [GROUPS.index(kind) if kind is not None else len(GROUPS) for kind, _ in runs]
            assert places == sorted(set(places)), "velocities before angular velocities, these before accelerations"


@each(DRAFTED)
def test_the_answer_tells_once_the_scales_by_which_it_was_read(name: str) -> None:
    """No μ_l·69.9 mm = 69.9 mm: the length stands in its step, the answer has the value."""
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        box = answer_box(solution, lang)
        assert not any(
            "·" in plain(line.node).partition(" = ")[2] and " mm = " in plain(line.node) for line in box.lines
        )
        read = {
            one.reading.scale for one in solution.answers.values() if one.reading.mm is not None and not one.computed
        }
        told = [note for note in (*box.notes, box.head if isinstance(box, TabledAnswers) else "") if "/mm" in note]
        assert len(told) == bool(read - {""})
        assert all(told[0].count(f"${scale}$ = ") == 1 for scale in read if scale)


def test_two_solutions_are_told_one_after_the_other_each_by_its_number() -> None:
    rows = rows_in(answer_box(solve(load("field-two-runs")), "en"))
    assert [(row.solution, *row.keys) for row in rows] == [
        (f"Solution {n}", f"{stem}_{n}") for n in (1, 2) for stem in ("V_t", "m_b", "theta_b")
    ]
    assert [row.solution for row in rows_in(answer_box(solve(load("8-4")), "zh"))] == [
        "各解",
        *["解 1"] * 4,
        *["解 2"] * 4,
    ]
    assert not any(row.solution for row in rows_in(answer_box(solve(load("best-gamma")), "zh"))), "one solution alone"


@each(DRAFTED)
def test_a_long_answer_is_parted_between_rows_and_every_row_is_on_one_page(name: str) -> None:
    solution = drafted(name)
    box = answer_box(solution, "zh") if solution is not None else None
    if not isinstance(box, TabledAnswers):
        return
    high = box.wrap(WIDTH, 1e4)[1]
    for height in (0.5 * high, 0.75 * high, high - 1.0):
        parts = answer_box(solution, "zh").split(WIDTH, height) if solution is not None else []
        assert not parts or high > WHOLE
        for part in parts[:1]:
            assert part.wrap(WIDTH, height)[1] <= height
        rows = [row for part in parts if isinstance(part, TabledAnswers) for table in part.tables for row in table.rows]
        assert not parts or rows == [row for table in box.tables for row in table.rows]


@each(DRAFTED)
def test_the_tables_of_an_answer_fill_its_frame(name: str) -> None:
    """Two halves side by side, or one table, as wide as the frame within."""
    solution = drafted(name)
    for lang in LANGS if solution is not None else ():
        assert solution is not None
        box = answer_box(solution, lang)
        box.wrap(WIDTH, 1e4)
        inner = WIDTH - 2 * PAD * MM
        for table in tables_of(box):
            halves = table._parted(inner)
            wide = sum(table.set_in(inner).widths) if halves is None else 2 * sum(halves[0].widths or ()) + GAP
            assert wide == pytest.approx(inner / MM, abs=0.01)
            assert halves is None or (*halves[0].rows, *halves[1].rows) == table.rows


@pytest.mark.parametrize(
    ("off", "error", "over"),
    [
        (NOTHING, "0.5°", False),
        ("+0.5 %", NOTHING, False),
        ("+0.5 %", "0.4 %", True),
        ("−0.5 %", "0.4 %*", True),
        ("+0.4 %", "0.5 %", False),
        ("+0.5 %", "0.5 %", False),
    ],
)
def test_only_what_is_off_by_more_than_expected_exceeds_it(off: str, error: str, over: bool) -> None:
    assert exceeds(off, error) is over
