"""The list of symbols stands in the order of a textbook and has what the chapters define."""

from __future__ import annotations

import pytest

from tests.studies import studied
from vecpoly.report.course.spoken_symbols import Row
from vecpoly.report.course.symbols import ordered, rows_of
from vecpoly.words import Words

SAID = Words.same("x")
KINDS = ["mm", "°", "m/s", "m/s²", "kg·m²", "N", "J", "—"]  # of one of each


def told(name: str) -> list[str]:
    return [symbol for symbol, _, _ in rows_of(studied(name), "$K$ = 1, $θ$ = 2")]


def test_lengths_angles_velocities_accelerations_masses_forces_energies_and_ratios_follow_in_this_order() -> None:
    rows: list[Row] = [(f"${letter}$", SAID, unit) for letter, unit in zip("abcdefgh", reversed(KINDS), strict=True)]
    assert [unit for _, _, unit in ordered(rows)] == KINDS


def test_within_a_kind_latin_letters_stand_before_greek_ones_by_the_alphabet() -> None:
    rows: list[Row] = [(f"${letter}$", SAID, "N·m") for letter in ("ρ", "R_{12}", "M_{fA}", "F_{f43}", "M", "η")]
    assert [symbol.strip("$") for symbol, *_ in ordered(rows)] == ["F_{f43}", "M", "M_{fA}", "R_{12}", "η", "ρ"]


@pytest.mark.parametrize(("name", "has"), [("3-1d", True), ("3-9", False)])
def test_instant_centres_are_listed_where_the_report_finds_any(name: str, has: bool) -> None:
    assert ("$P_{ij}$" in told(name)) is has


@pytest.mark.parametrize(("name", "asked"), [("curv-6", ["$L_{f2}$、$L_{m2}$", "$Q_i$、$Q′_i$"]), ("3-9", [])])
def test_centrodes_and_curvatures_are_listed_where_they_are_asked(name: str, asked: list[str]) -> None:
    assert [symbol for symbol in told(name) if symbol[1] in "LQWU"] == asked


def test_the_list_of_a_report_reads_from_lengths_to_scales() -> None:
    symbols = told("3-1d")
    wanted = ["$F$", "$l_{AB}$", "$φ_i$", "$v_{Ex}$", "$ω_i$", "$a_{Ex}$", "$α_i$", "$K$", "$G_1$", "$μ_l$"]
    assert [one for one in symbols if one in wanted] == wanted and len(symbols) == len({*symbols})


def test_moments_and_forces_of_friction_are_listed_as_the_equations_have_them() -> None:
    shared, guided = told("compound-hinge-six-bar"), told("4-3a")
    assert {"$M_{fA}$", "$M_{fC,23}$", "$M_{fC,34}$"} <= {*shared} and "$M_{fC}$" not in shared
    assert {"$M_{fA}$", "$N_{43}$", "$T_{43}$", "$F_{f43}$"} <= {*guided}
    assert not any(one.startswith(("$M_{f", "$F_{f")) for one in told("six-bar-dynamic"))


def test_symbols_of_masses_arms_and_limit_angles_are_listed_where_they_are_written() -> None:
    """Those of a motion stand for themselves in its formulas; these only in the words."""
    listed = {
        symbol
        for symbol, _, _ in rows_of(studied("six-bar-dynamic"), "$k$ = 4 $m_{3}$, $S_3$, $J_{S3}$, $h_0$, $W_{c1}$")
    }
    assert {"$N$、$k$", "$m_i$", "$S_i$", "$J_{Si}$", "$h$", "$W_{ci}$"} <= listed
    assert not {"$m_i$", "$h$"} & {symbol for symbol, _, _ in rows_of(studied("3-9"), "$ω_m$")}
