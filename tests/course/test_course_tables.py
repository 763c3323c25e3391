"""The tables of a course report hold what the oracle has, row by row, and read as a person reads them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import floor, log10

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.presses import Made, press, shown
from tests.studies import studied
from vecpoly import loads
from vecpoly.cycle import Column
from vecpoly.findings.study.study import study
from vecpoly.report.answers.errors import alike
from vecpoly.report.answers.tables import readings_at
from vecpoly.report.course.numbering import SMALL, TINY
from vecpoly.report.course.results.extreme_values import _exact, extremes
from vecpoly.report.course.results.tabled import TIGHT, _formats, decimal, tabled
from vecpoly.report.flow.results.blocked import BlockTable
from vecpoly.solution import solve
from vecpoly.words import Words

NAMES = ("A-27", "B-24", "3-9", "3-5")


def half_unit(cell: str) -> float:
    return 0.5 * 10.0 ** -len(cell.partition(".")[2])


# -- columns ----------------------------------------------------------------------------------------------------------


def unfolded(made: Made, columns: int) -> tuple[list[str], list[tuple[str, ...]]]:
    """A table told in two halves beside each other, read down the left one and then the right one."""
    if len(made.header) == columns:
        return list(made.header), list(made.rows)
    assert len(made.header) == 2 * columns + 1 and made.header[columns] == ""
    assert made.header[:columns] == made.header[columns + 1 :]
    right = [row[columns + 1 :] for row in made.rows]
    assert [row[0] for row in right[:-1]].count("") == 0  # the left half is longer by one row at most
    return list(made.header[:columns]), [*(row[:columns] for row in made.rows), *(row for row in right if row[0] != "")]


@pytest.mark.parametrize(
    ("name", "keys", "every"),
    [
        ("A-27", ("phi_2", "omega_5", "alpha_5"), 1),
        ("B-24", ("phi_5", "v_E", "a_E", "omega_2", "omega_5"), 1),
        ("3-9", ("omega_3", "v_E"), 3),
        ("3-5", ("s_56", "v_F"), 2),
    ],
)
def test_every_cell_of_a_table_over_the_cycle_is_the_oracle_s_to_its_last_digit(
    name: str, keys: tuple[str, ...], every: int
) -> None:
    it, kept = studied(name), press()
    tabled(it, kept, keys, Words("", ""), SMALL, every)
    parts = [p for key in keys for p in it.turn.info(key).parts if it.varies(p)]
    head, rows = unfolded(kept.made[0], 1 + len(parts))
    narrow, long = 1 + len(parts) <= (6 if it.dense else 5), len(rows) > 12
    assert (len(kept.made[0].rows) < len(rows)) == (narrow and long)
    again = it.whole.whole and all(np.isclose(it.turn.real(p)[0], it.turn.real(p)[-1], atol=1e-9) for p in parts)
    assert len(rows) == len(it.rows[::every]) - again, "a row at 360° that is the first once more"
    drive = it.turn.drive
    for k, key in enumerate(parts, 1):
        info, places = it.turn.info(key), {len(row[k].partition(".")[2]) for row in rows}
        assert head[k].startswith(f"${info.symbol}$") and info.shown_unit.replace("^2", "²") in head[k]
        assert len(places) == 1
        values = info.factor * np.asarray(it.turn.at(key, np.array([shown(row[0]) for row in rows]) / drive.factor))
        for row, value in zip(rows, values, strict=True):
            gap = (shown(row[k]) - value + 180) % 360 - 180 if info.unit == "rad" else shown(row[k]) - value
            assert abs(gap) <= 1.001 * half_unit(row[k]) + 1e-9 * abs(value), (key, row)


@pytest.mark.parametrize(
    ("key", "head"), [("M", "$M$ /(N·m)"), ("omega_2", "$ω_{2}$ /(rad/s)"), ("phi_2", "$φ_{2}$ /°"), ("eta", "$η$")]
)
def test_the_unit_stands_behind_the_symbol_in_brackets_where_it_has_a_bar_or_a_dot(key: str, head: str) -> None:
    kept = press()
    tabled(studied("4-3a"), kept, (key,), Words("", ""))
    assert kept.made[0].header[1] == head


def test_many_columns_are_set_in_tiny_type() -> None:
    few, many = press(), press()
    tabled(studied("A-27"), few, ("phi_2", "omega_2"), Words("", ""))
    links = [f"{stem}_{n}" for n in (2, 3, 5) for stem in ("phi", "omega", "alpha")]
    tabled(studied("A-27"), many, [*links, "v_F", "a_F"], Words("", ""))
    assert few.made[0].style is SMALL and many.made[0].style is TINY and len(many.made[0].header) > TIGHT


@given(st.floats(-1e6, 1e6), st.integers(0, 6))
def test_a_decimal_is_its_number_without_hyphen_or_minus_zero(value: float, places: int) -> None:
    text = decimal(value, places)
    assert "-" not in text and abs(shown(text) - value) <= 0.5001 * 10.0**-places + 1e-9
    assert not (text.startswith("−") and shown(text) == 0) and len(text.partition(".")[2]) == places
    assert decimal(float("nan"), places) == decimal(float("inf"), places) == "—"


def columns(units: Sequence[str]) -> list[Column]:
    return [Column(key=f"q{unit}_{n}", symbol="q", unit=unit, words=Words("", "")) for n, unit in enumerate(units)]


@example([1.2345678, 10123.078])  # 0.078 is as good as nothing beside ten thousand, and no whole number for that
@given(st.lists(st.floats(-4.5, 4).map(lambda e: 1.2345678 * 10**e), min_size=1, max_size=5))
def test_columns_of_one_quantity_have_the_same_decimals_that_suit_the_smallest_and_the_largest(
    tops: list[float],
) -> None:
    values = np.array([[top, -0.37123456 * top, np.nan] for top in tops]).T
    places = _formats(columns(["m/s"] * len(tops)), values)
    assert len(set(places)) == 1
    digits = [places[0] + 1 + floor(log10(top)) for top in tops]
    assert min(digits) >= 3 or places[0] == 6
    assert max(digits) == 4 or min(digits) == 3 or places[0] in (0, 6)


def test_angles_have_two_decimals_at_most_and_whole_numbers_none() -> None:
    values = np.array([[12.3456, 100.0, 0.0], [20.1234, 200.0, 0.0]])
    assert _formats(columns(["rad", "m", "N"]), values) == [2, 0, 0]


# -- extremes ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*NAMES, "4-3a"])
def test_no_value_of_a_fine_grid_lies_beyond_the_extremes_and_they_are_where_they_are_told(name: str) -> None:
    it, kept = studied(name), press()
    extremes(it, kept)
    told = {row[0].strip("$|"): row for row in kept.made[0].rows}
    keys = {it.whole.info(key).symbol: key for key in expected(name)}
    assert set(told) == set(keys)
    for symbol, key in keys.items():
        info, (_, unit, high, at_high, low, at_low) = it.whole.info(key), told[symbol]
        values = info.factor * np.asarray(it.turn.real(key))
        size = float(np.nanmax(np.abs(values)))
        assert unit == (info.shown_unit.replace("^2", "²") or "—")
        for text, place, best in ((high, at_high, np.nanmax), (low, at_low, np.nanmin)):
            if "∞" in text:
                continue
            assert (shown(text) - best(values)) * (
                1 if best is np.nanmax else -1
            ) >= -6e-4 * size  # four digits are printed
            if "*" in place:
                continue  # a limit from one side: there is no value at the place itself
            for one in re.split("[、,]", place.rstrip("…")):  # both of two that are alike
                there = shown(re.sub("[° a-z]", "", one)) / it.turn.drive.factor
                near = info.factor * np.asarray(it.turn.at(key, np.array([there])))
                found = abs(near[0]) if info.is_vector else near[0]
                assert abs(found) == pytest.approx(abs(shown(text)), abs=2e-3 * size)
    assert len(told) >= 5


def test_two_positions_in_which_a_value_is_greatest_are_both_told() -> None:
    """The rate of the swinging block of 3-9 is the same on both sides of the line of its pivots."""
    kept = press()
    extremes(studied("3-9"), kept)
    pairs = [place for row in kept.made[0].rows for place in (row[3], row[5]) if "," in place]
    assert pairs
    for pair in pairs:
        one, two = (float(text.rstrip("°")) for text in pair.split(", "))
        assert (one + two) % 360 == pytest.approx(0.0, abs=0.02)


@pytest.mark.parametrize(("name", "unit"), [("3-4a-straight", "°"), ("elliptic-trammel", "mm")])
def test_places_of_extremes_are_in_the_drive_s_unit_under_its_symbol_and_no_zero_has_a_minus(
    name: str, unit: str
) -> None:
    kept, symbol = press(), f"${studied(name).turn.drive.symbol}$ /{unit}"
    extremes(studied(name), kept)
    (made,) = kept.made
    assert list(made.header) == ["Quantity", "Unit", "Maximum", symbol, "Minimum", symbol]
    places = [place for row in made.rows for place in (row[3], row[5])]
    assert all(re.fullmatch(r"−?\d+\.\d\*?", place) for place in places)
    assert {place for place in places if not shown(re.sub("[° a-z]", "", place))} == {"0.0"}


def expected(name: str) -> Iterator[str]:
    """Rates of all links, places and rates of all points, all forces: what changes over the cycle."""
    it = studied(name)
    keys = [f"{stem}_{link}" for link in it.links for stem in ("omega", "alpha")]
    keys += [key for p in it.points for key in (f"p_{p}.x", f"p_{p}.y", f"v_{p}", f"a_{p}")]
    for key in (*keys, *it.forces):
        values = np.asarray(it.turn.real(key))
        if it.varies(key) and np.nanmax(values) - np.nanmin(values) > 1e-9 * np.nanmax(np.abs(values)):
            yield key


CRANK_DRIVES = """
id: at-the-dead-centre
title: The force that a given moment of the crank can hold
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 120 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
input: {link: 1, phi: 60 deg, omega: 5 rad/s ccw}
branch: [C right of A]
loads: {M: {on: 1, size: 10 N*m ccw}, F: {on: 3, at: C, direction: 180 deg, size: "?"}}
find: [F, R_12, R_43]
"""


def test_beside_a_value_that_runs_away_the_other_extreme_is_still_a_number() -> None:
    kept = press()
    extremes(study(solve(loads(CRANK_DRIVES), repeats=0)), kept)
    told = {row[0]: row[2:] for row in kept.made[0].rows}
    assert (told["$F$"][0], told["$F$"][2]) == ("∞", "−∞")
    assert (told["$|R_{12}|$"][0], told["$|R_{12}|$"][2]) == ("∞", "200.0")  # M / AB, where AB is square to BC
    assert (told["$|R_{43}|$"][0], told["$|R_{43}|$"][2]) == ("142.9", "58.82")  # M / AC at both dead centres


@given(st.floats(1e-3, 1e5))
def test_an_extreme_has_four_digits_as_the_diagrams_have_and_what_rounding_leaves_is_zero(value: float) -> None:
    text = _exact(value, value)
    assert float(text) == pytest.approx(value, rel=6e-4, abs=6e-7)
    assert _exact(-value, value) == f"−{text}" and _exact(1e-10 * value, value) == "0"
    assert len(text.replace(".", "").lstrip("0")) <= max(4, len(str(round(value))))


def test_expected_errors_under_each_other_have_as_many_decimals_unless_they_are_of_quite_different_sizes() -> None:
    assert alike([0.27, 1.01, 6.46]) == ["0.27", "1.01", "6.46"]
    assert alike([0.27, 1.01, 6.46, 10.34]) == ["0.3", "1.0", "6.5", "10.3"]
    assert alike([0.0002, 35.0]) == ["0.00020", "35.0"]


def test_where_no_other_position_is_drawn_there_is_no_table_of_them() -> None:
    kept = press()
    assert kept.tabled(Words("其余位置", "Other positions"), readings_at([], "φ", "en")) == [] and not kept.made


def test_nothing_beside_what_runs_away_is_told_as_nothing() -> None:
    assert [_exact(value, 0.0) for value in (0.0, -0.0, np.inf, -np.inf)] == ["0", "0", "∞", "−∞"]


def test_the_rows_of_a_long_narrow_table_run_down_one_part_after_the_other_and_none_is_lost() -> None:
    body = [(f"{n}", f"{n}²") for n in range(35)]
    made = BlockTable.of(["n", "n²"], body, 3, "rr", "zh")
    header, rows = made.header, made.rows
    assert header == ("n", "n²", "", "n", "n²", "", "n", "n²") and len(rows) == 12
    assert all(len(row) == len(header) for row in rows)
    parts = [row[start : start + 2] for start in (0, 3, 6) for row in rows]
    assert [part for part in parts if any(part)] == body and parts[-1] == ("", "")
