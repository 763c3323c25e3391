"""The tables of a course report hold what the oracle has, row by row, and read as a person reads them."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from math import floor, log10
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.studies import studied
from vecpoly import oracle
from vecpoly.cycle import Column
from vecpoly.mechanism.model import FRAME
from vecpoly.report.content import Objects
from vecpoly.report.course.modelling.dimensions import dimensions, rounded
from vecpoly.report.course.modelling.order import order
from vecpoly.report.course.numbering import SMALL, TINY, Press
from vecpoly.report.course.results.extreme_values import _exact, extremes
from vecpoly.report.course.results.tabled import TIGHT, _formats, decimal, tabled
from vecpoly.report.picture import picture
from vecpoly.words import Words

NAMES = ("A-27", "B-24", "3-9", "3-5")
LENGTH = re.compile(r"\$l_\{(\w)(\w)\}\$ = ([\d.]+)")


@dataclass(frozen=True, slots=True)
class Made:
    """A table as it was asked for."""

    title: Words
    header: Sequence[str]
    rows: Sequence[tuple[str, ...]]
    style: Any


@dataclass(slots=True)
class Kept(Press):
    """A press that keeps the tables."""

    made: list[Made] = field(default_factory=list)

    def table(self, title: Any, header: Any, rows: Any, align: str, **style: Any) -> str:
        assert len(align) == len(header) and {len(row) for row in rows} == {len(header)}
        self.made.append(Made(title, header, rows, style.get("style")))
        return "made"


def press(lang: Any = "en") -> Kept:
    return Kept(lang, Objects())


def shown(cell: str) -> float:
    return float(cell.replace("−", "-"))


def half_unit(cell: str) -> float:
    return 0.5 * 10.0 ** -len(cell.partition(".")[2])


# -- dimensions -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [*NAMES, "cam-roller", "jansen-leg"])
@pytest.mark.parametrize("lang", ["zh", "en"])
def test_every_distance_of_a_link_stands_in_nature_and_as_it_is_on_paper(name: str, lang: Any) -> None:
    it, kept = studied(name), press(lang)
    drawn = picture(it.problem, it.solution.construction, 130.0, 80.0)
    assert drawn is not None
    figure = rounded(drawn)
    dimensions(it, kept, figure)
    motion, scale = oracle.solve(it.mech), figure.scale.value
    bodies = {it.name(body): body for body in it.mech.bodies if body not in it.mech.substitutes}
    for head, nature, paper in kept.made[0].rows:
        link = bodies.get(head, FRAME)
        told = LENGTH.findall(nature)
        for (p, q, size), mm in zip(told, re.split("，|, ", paper), strict=True):
            apart = abs(complex(motion.position(p)) - complex(motion.position(q)))
            assert float(size) == pytest.approx(1e3 * apart, rel=6e-5)
            assert float(mm) == pytest.approx(apart / scale, abs=0.0501)
            assert f"l_{p}{q}" in given_symbols(name) or (f"l_{q}{p}" not in given_symbols(name) and p < q)
        assert {frozenset(one[:2]) for one in told} == apart_on(name, link)
    assert [row[0] for row in kept.made[0].rows] == [
        *(head for head, body in bodies.items() if apart_on(name, body)),
        *({"zh": ["机架"], "en": ["frame"]}[lang] if apart_on(name, FRAME) else []),
    ]


def given_symbols(name: str) -> set[str]:
    return {datum.symbol for datum in studied(name).problem.given.lengths}


def apart_on(name: str, link: str) -> set[frozenset[str]]:
    """The pairs of letters that are told of a link: all, of more than four those with the first."""
    mech = studied(name).mech
    points = dict(mech.frame if link == FRAME else mech.link(link).points)
    pairs = list(combinations(points, 2)) if len(points) <= 4 else [(next(iter(points)), p) for p in [*points][1:]]
    return {frozenset(pair) for pair in pairs if abs(points[pair[0]] - points[pair[1]]) > 1e-9}


def test_what_is_not_drawn_or_not_to_scale_has_no_table_of_dimensions() -> None:
    kept = press()
    sketch = picture(studied("3-9").problem, studied("3-9").solution.construction, 130.0, 80.0)
    assert dimensions(studied("3-9"), kept, None) == "" and sketch is not None and kept.made == []


# -- columns ----------------------------------------------------------------------------------------------------------


def unfolded(made: Made, columns: int) -> tuple[list[str], list[tuple[str, ...]]]:
    """A table told in two halves beside each other, read down the left one and then the right one."""
    if len(made.header) == columns:
        return list(made.header), list(made.rows)
    assert len(made.header) == 2 * columns + 1 and made.header[columns] == ""
    assert made.header[:columns] == made.header[columns + 1 :]
    right = [row[columns + 1 :] for row in made.rows]
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
    assert len(rows) == len(it.rows[::every])
    drive = it.turn.drive
    for k, key in enumerate(parts, 1):
        info, places = it.turn.info(key), {len(row[k].partition(".")[2]) for row in rows}
        assert head[k].startswith(f"${info.symbol}$") and info.shown_unit.replace("^2", "²") in head[k]
        assert len(places) == 1
        values = info.factor * np.asarray(it.turn.at(key, np.array([shown(row[0]) for row in rows]) / drive.factor))
        for row, value in zip(rows, values, strict=True):
            gap = (shown(row[k]) - value + 180) % 360 - 180 if info.unit == "rad" else shown(row[k]) - value
            assert abs(gap) <= 1.001 * half_unit(row[k]) + 1e-9 * abs(value), (key, row)


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


@given(st.lists(st.floats(0.011, 9e3).map(lambda v: v + 1e-3), min_size=1, max_size=5))
def test_columns_of_one_quantity_have_the_same_decimals_that_suit_the_smallest_and_the_largest(
    tops: list[float],
) -> None:
    values = np.array([[top, -0.37123456 * top, np.nan] for top in tops]).T
    places = _formats(columns(["m/s"] * len(tops)), values)
    assert len(set(places)) == 1
    digits = [places[0] + 1 + floor(log10(top)) for top in tops]
    assert min(digits) >= 3 or places[0] == 6
    assert max(digits) == 5 or min(digits) == 3 or places[0] in (0, 6)


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
            ) >= -6e-5 * size  # five digits are printed
            if "*" in place:
                continue  # a limit from one side: there is no value at the place itself
            there = shown(re.sub("[° a-z]", "", place)) / it.turn.drive.factor
            near = info.factor * np.asarray(it.turn.at(key, np.array([there])))
            assert abs(abs(near[0]) if info.is_vector else near[0]) == pytest.approx(abs(shown(text)), abs=2e-3 * size)
    assert len(told) >= 5


def expected(name: str) -> Iterator[str]:
    """Rates of all links, places and rates of all points, all forces: what changes over the cycle."""
    it = studied(name)
    keys = [f"{stem}_{link}" for link in it.links for stem in ("omega", "alpha")]
    keys += [key for p in it.points for key in (f"p_{p}.x", f"p_{p}.y", f"v_{p}", f"a_{p}")]
    for key in (*keys, *it.forces):
        values = np.asarray(it.turn.real(key))
        if it.varies(key) and np.nanmax(values) - np.nanmin(values) > 1e-9 * np.nanmax(np.abs(values)):
            yield key


@given(st.floats(1e-3, 1e5))
def test_an_extreme_has_five_digits_and_what_rounding_leaves_is_zero(value: float) -> None:
    text = _exact(value, value)
    assert float(text) == pytest.approx(value, rel=6e-5, abs=6e-7)
    assert _exact(-value, value) == f"−{text}" and _exact(1e-10 * value, value) == "0"
    assert len(text.replace(".", "").lstrip("0")) <= max(6, len(str(int(value))))


# -- the order of solution --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", NAMES)
def test_every_letter_is_found_once_and_none_is_taken_over_before_it_was_found(name: str) -> None:
    it, zh, en = studied(name), press("zh"), press("en")
    order(it, en)
    order(it, zh)
    known, lines = set(it.mech.frame), en.made[0].rows
    for n, (number, title, taken, gives) in enumerate(lines, 1):
        letters = re.findall(r"\$([A-Z])\$", taken)
        assert number == str(n) and title and set(letters) <= known
        new = set(re.findall(r"\$([A-Z])\$", gives))
        assert not new & known
        known |= new
    assert known == {*it.mech.frame, *(letter for link in it.mech.links for letter in link.points)}
    assert lines[0][2] == f"${it.turn.drive.symbol}$"
    assert [re.findall(r"\$[^$]*\$", " ".join(row)) for row in lines] == [
        re.findall(r"\$[^$]*\$", " ".join(row)) for row in zh.made[0].rows
    ]
