"""Printed tables against the oracle: the three of the course assignments, every usual slip, and what cannot be read."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from typer.testing import CliRunner

from tests.checked_tables import PRINTED, checked
from tests.laws import few, often
from vecpoly import oracle
from vecpoly.check.slips.guess import Slip
from vecpoly.check.slips.lengths import lengths, other_assemblies
from vecpoly.check.slips.rates import Loops, mixed
from vecpoly.check.table.header import split
from vecpoly.check.table.quantity_names import read_target
from vecpoly.check.table.sheet import digits, last_unit
from vecpoly.check.table.target import Target
from vecpoly.check.table.weigh import Level
from vecpoly.check.table.whole import ColumnCheck, TableCheck, check_table
from vecpoly.cli import app
from vecpoly.cycle import cycle
from vecpoly.cycle.table import csv_bytes, table, xlsx_bytes
from vecpoly.errors import AssemblyError, TableError
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import Motion
from vecpoly.problem.load import load

Reals = NDArray[np.float64]
FEW = settings(max_examples=often(1), suppress_health_check=[HealthCheck.function_scoped_fixture])
TURN = np.arange(0.0, 361.0, 10.0)
SIX_BAR = (
    "theta2_deg",
    "theta3_deg",
    "theta4_deg",
    "omega2_rad_s",
    "omega4_rad_s",
    "alpha3_rad_s2",
    "vE_m_s",
    "aE_m_s2",
)
DOUBLE_CRANK = ("phi2_deg", "phi5_deg", "omega5_rad_s", "alpha5_rad_s2", "vF_m_s")
GUIDES = ("phi3_deg", "phi5_deg", "omega5_rad_s", "alpha5_rad_s2", "xD_mm", "aD_m_s2")


def slips(column: ColumnCheck) -> set[Slip]:
    return {one.slip for one in column.explanations}


def found(column: ColumnCheck, slip: Slip) -> list[float]:
    return [one.parameter or 0.0 for one in column.explanations if one.slip is slip]


# -- tables made here -------------------------------------------------------------------------------------------


def exact(motion: Motion, headers: Sequence[str]) -> dict[str, Reals]:
    table = {}
    for header in headers:
        name, unit = split(header)
        target = read_target(name)
        assert target is not None
        table[header] = target.of(motion) * {"deg": 180 / np.pi, "mm": 1e3}.get(unit, 1.0)
    return table


@cache
def true(problem: str, headers: Sequence[str]) -> Mapping[str, Reals]:
    return exact(oracle.solve(load(problem).mechanism, np.radians(TURN)), headers)


def columns_of(mech: Mechanism, headers: Sequence[str]) -> dict[str, Reals]:
    return exact(oracle.solve(mech, np.radians(TURN)), headers)


def written(path: Path, columns: Mapping[str, Reals], decimals: int = 5, drive: str = "phi1_deg") -> Path:
    rows = [",".join((drive, *columns))]
    rows += [
        ",".join((f"{q:g}", *(f"{values[i]:.{decimals}f}" for values in columns.values()))) for i, q in enumerate(TURN)
    ]
    path.write_text("\n".join(rows) + "\n", "utf-8")
    return path


@pytest.fixture
def against(tmp_path: Path) -> Callable[..., TableCheck]:
    def check(
        problem: str, columns: Mapping[str, Reals], decimals: int = 5, said: Mapping[str, str] | None = None
    ) -> TableCheck:
        return check_table(load(problem), written(tmp_path / "table.csv", columns, decimals), said)

    return check


# -- the printed tables -----------------------------------------------------------------------------------------


def test_problem_16_has_right_angles_and_velocities_thirteen_of_them_with_three_digits() -> None:
    phi, omega = (checked("A-16", "A_p16").column(header) for header in ("phi5_rad", "omega5_rad_s"))
    assert (phi.verdict, phi.given.rows_right) == (Level.REPRODUCED, 361)
    assert (omega.verdict, omega.given.rows_right) == (Level.REPRODUCED, 361)
    assert "13 of them printed with 3 digits only" in phi.words.en and "13 行只印了 3 位" in phi.words.zh


def test_the_accelerations_of_problem_16_lack_the_divisor_of_their_dyad() -> None:
    alpha = checked("A-16", "A_p16").column("alpha5_rad_s2")
    assert alpha.verdict is Level.WRONG and [one.slip for one in alpha.explanations] == [Slip.DIVISOR]
    assert alpha.best.level is Level.REPRODUCED and alpha.best.rows_right == 361
    assert "wrong in 359 of 361 rows, right only at 90°, 270°" in alpha.words.en
    assert (
        "$α_{3}$ not divided by the coefficient of its dyad, $l_{CB} cos θ$" in alpha.words.en
        and "以 mm 计" in alpha.words.zh
    )


@pytest.mark.parametrize(
    ("table", "problem", "l1", "l1_of_rates"),
    few(
        [
            ("B_table_1A", "B-24", 24.0, 26.5),
            ("B_table_1A", "B-26.5", 24.0, 26.5),
            ("B_table_1B", "B-29.5", 29.5, 24.0),
        ],
        3,
    ),
)
def test_the_six_bar_tables_were_computed_with_two_crank_lengths(
    table: str, problem: str, l1: float, l1_of_rates: float
) -> None:
    check = checked(problem, table)
    for header in ("theta2_deg", "theta3_deg", "theta5_deg", "theta6_deg"):
        column = check.column(header)
        assert column.best.level < Level.WRONG
        if f"B-{l1:g}" == problem:
            assert not column.explanations
        else:
            assert 1e3 * found(column, Slip.LENGTH)[0] == pytest.approx(l1, abs=1e-9)
    for link in (2, 3, 5, 6):
        for header in (f"omega{link}_rad_s", f"alpha{link}_rad_s2"):
            column = check.column(header)
            assert column.verdict is Level.WRONG and column.best.level <= Level.LOW
            assert column.explanations[0].slip is Slip.RATES
            assert 1e3 * found(column, Slip.RATES)[0] == pytest.approx(l1_of_rates, abs=1e-9)
        factor = found(check.column(f"omega{link}_rad_s"), Slip.FACTOR)
        assert factor == [pytest.approx(l1_of_rates / l1, rel=1e-9)]
    assert "no one mechanism" in check.whole[-2].en


@pytest.mark.parametrize(
    ("table", "problem", "header", "rows"),
    few(
        [
            ("B_table_1A", "B-24", "theta3_deg", range(0, 61, 10)),
            ("B_table_1B", "B-29.5", "theta3_deg", (0, 40)),
            ("B_table_1B", "B-29.5", "theta6_deg", range(0, 81, 10)),
            ("B_table_1A", "B-26.5", "theta3_deg", range(0, 61, 10)),
        ],
        4,
    ),
)
def test_rows_typed_over_are_found_and_told_by_the_velocities_beside_them(
    table: str, problem: str, header: str, rows: Sequence[int]
) -> None:
    column = checked(problem, table).column(header)
    assert column.best.level is Level.ROWS and column.rows == pytest.approx([*rows])
    assert "typed over" in column.words.en


def test_the_dyad_angles_of_table_1a_are_right_with_low_accuracy() -> None:
    check = checked("B-24", "B_table_1A")
    assert check.column("theta2_deg").verdict is Level.LAST_DIGIT
    for header, largest in (("theta5_deg", 0.0892), ("theta6_deg", 0.0963)):
        column = check.column(header)
        assert column.verdict is Level.LOW
        assert np.degrees(column.given.largest) == pytest.approx(largest, abs=1e-4)


V_E = (
    "the term $l_{BC} ω_{2}$ lacks its $ω_{2}$ and has $φ_{3}$ for $φ_{2}$ in its x component; the term "
    "$l_{CE} ω_{2}$ has the wrong sign in its y component"
)
A_E = (
    "the term $l_{BC} α_{2}$ has $φ_{3}$ for $φ_{2}$ in its x component; the term $l_{BC} ω_{2}^2$ has $φ_{3}$ "
    "for $φ_{2}$ in its y component; the term $l_{CE} α_{2}$ has the wrong sign in its y component"
)


@pytest.mark.parametrize(
    ("table", "problem", "l1", "l1_of_rates"),
    few(
        [
            ("B_table_1A", "B-24", 24.0, 26.5),
            ("B_table_1B", "B-29.5", 29.5, 24.0),
            ("B_table_1A", "B-26.5", 24.0, 26.5),
        ],
        3,
    ),
)
def test_speed_and_acceleration_of_e_hold_three_slips_of_their_formulas_beside_the_two_crank_lengths(
    table: str, problem: str, l1: float, l1_of_rates: float
) -> None:
    check = checked(problem, table)
    for header, slips_told in (("vE_m_s", V_E), ("aE_m_s2", A_E)):
        column = check.column(header)
        assert column.verdict is Level.WRONG and [one.slip for one in column.explanations] == [Slip.FORMULA]
        assert column.best.level is Level.REPRODUCED and column.best.rows_right == 37
        words = column.explanations[0].words
        assert words.en.startswith(
            f"angles with $l_{{AB}}$ = {l1:g} mm, but rates computed with $l_{{AB}}$ = {l1_of_rates:g} mm; "
            "besides, in the formula of"
        )
        assert words.en.endswith(slips_told)
    assert (
        "$l_{BC} ω_{2}$ 项漏乘 $ω_{2}$，x 分量误用 $φ_{3}$ 代替 $φ_{2}$；$l_{CE} ω_{2}$ 项 y 分量正负号相反"
        in check.column("vE_m_s").words.zh
    )


VARIANTS = {
    "B_table_1A": (
        "$l_{AB}$ = 24 mm is that of variant B, 26.5 mm that of variant A.",
        "$l_{AB}$ = 24 mm 即方案 B 的尺寸，26.5 mm 即方案 A 的尺寸。",
    ),
    "B_table_1B": (
        "$l_{AB}$ = 29.5 mm is that of variant C, 24 mm that of variant B.",
        "$l_{AB}$ = 29.5 mm 即方案 C 的尺寸，24 mm 即方案 B 的尺寸。",
    ),
}


@pytest.mark.parametrize(
    ("table", "problem"), few([("B_table_1A", "B-24"), ("B_table_1B", "B-29.5"), ("B_table_1A", "B-26.5")], 3)
)
def test_lengths_that_belong_to_variants_of_the_problem_are_named_by_them(table: str, problem: str) -> None:
    last = checked(problem, table).whole[-1]
    assert (last.en, last.zh) == VARIANTS[table]


def test_a_slip_that_many_columns_share_leaves_no_room_for_one_that_fits_a_single_column() -> None:
    check = checked("B-24", "B_table_1A")
    told = {slip.words.en for one in check.columns for slip in one.explanations if slip.slip is not Slip.FORMULA}
    assert told == {
        "angles with $l_{AB}$ = 24 mm, but rates computed with $l_{AB}$ = 26.5 mm",
        "a constant factor 1.10417 = 26.5/24, the ratio of two values of $l_{AB}$",
    }
    assert (
        "the printed" not in check.column("omega3_rad_s").words.en
        and "so it is 1.1042 times" in check.column("omega3_rad_s").words.en
    )


def test_a_table_that_numbers_its_links_otherwise_is_matched_by_its_angles() -> None:
    check = checked("B-24", "B_table_1A")
    assert [check.column(f"theta{n}_deg").column.target.key for n in (2, 3, 5, 6)] == [
        "phi_2",
        "phi_3",
        "phi_4",
        "phi_5",
    ]
    assert any("its links 5, 6 are the problem's links 4, 5" in note.en for note in check.notes)
    assert check.column("theta5_deg").column.label.en == "$θ_{5}$ (here $φ_{4}$)"


@pytest.mark.parametrize(
    ("header", "symbol"), [("theta5_deg", "θ_{5}"), ("Th_5", "θ_{5}"), ("θ5", "θ_{5}"), ("phi5_deg", "φ_{5}")]
)
def test_an_angle_keeps_the_letter_of_its_header(header: str, symbol: str) -> None:
    assert Target(link="5").named_as_in(header) == symbol


# -- true tables ------------------------------------------------------------------------------------------------


@FEW
@given(st.sampled_from([("B-24", SIX_BAR), ("A-16", GUIDES)]), st.integers(2, 8))
def test_a_true_table_is_reproduced_with_any_number_of_digits(
    against: Callable[..., TableCheck], case: tuple[str, Sequence[str]], decimals: int
) -> None:
    problem, headers = case
    check = against(problem, true(problem, headers), decimals)
    assert {column.verdict for column in check.columns} == {Level.REPRODUCED}
    assert [words.en for words in check.whole] == ["All columns agree."]


@FEW
@given(st.integers(0, 2**32 - 1), st.sampled_from([("B-24", SIX_BAR), ("A-16", GUIDES)]))
def test_noise_in_the_last_digits_is_no_mistake(
    against: Callable[..., TableCheck], seed: int, case: tuple[str, Sequence[str]]
) -> None:
    rng, (problem, headers) = np.random.default_rng(seed), case
    noisy = {
        header: values + rng.integers(-5, 6, len(values)) * 1e-5 for header, values in true(problem, headers).items()
    }
    check = against(problem, noisy)
    assert all(column.verdict <= Level.LAST_DIGIT and not column.explanations for column in check.columns)


def test_angles_counted_from_the_other_end_of_the_link_and_beyond_a_turn_are_no_mistake(
    against: Callable[..., TableCheck],
) -> None:
    table = dict(true("B-24", SIX_BAR))
    table["theta3_deg"] = table["theta3_deg"] + 180
    table["theta2_deg"] = table["theta2_deg"] - 360 * (TURN < 100)
    check = against("B-24", table)
    assert {column.verdict for column in check.columns} == {Level.REPRODUCED}
    assert any("180°" in note.en for note in check.notes)


def test_degrees_and_radians_are_told_apart_where_no_unit_is_written(against: Callable[..., TableCheck]) -> None:
    table = true("A-16", GUIDES)
    bare = {
        "phi3": table["phi3_deg"],
        "phi5": np.radians(table["phi5_deg"]),
        "x_D": table["xD_mm"],
        "a_D": 1e3 * table["aD_m_s2"],
    }
    check = against("A-16", bare)
    assert [column.column.unit for column in check.columns] == ["deg", "rad", "mm", "mm/s^2"]
    assert {column.verdict for column in check.columns} == {Level.REPRODUCED}
    assert sum("no unit is written" in note.en for note in check.notes) == 4


def test_a_position_in_rounded_radians_is_the_round_angle_that_it_stands_for(tmp_path: Path) -> None:
    path = tmp_path / "rad.csv"
    omega = true("A-16", GUIDES)["omega5_rad_s"]
    path.write_text(
        "φ1 [rad],ω5 [rad/s]\n" + "".join(f"{np.radians(q):.3f},{w:.6f}\n" for q, w in zip(TURN, omega, strict=True)),
        "utf-8",
    )
    assert check_table(load("A-16"), path).columns[0].verdict is Level.REPRODUCED


# -- one slip at a time -----------------------------------------------------------------------------------------


@FEW
@given(st.integers(0, 5), st.sampled_from([0.7, 0.97, 1.02, 1.13]))
def test_another_length_is_found(against: Callable[..., TableCheck], which: int, times: float) -> None:
    length = lengths(load("A-27").mechanism)[which]
    try:
        table = columns_of(length.instead(length.value * times), DOUBLE_CRANK)
    except AssemblyError:
        assume(False)
    check = against("A-27", table)
    for column in check.columns:
        if column.verdict is not Level.REPRODUCED:
            assert any(
                value == pytest.approx(length.value * times, rel=1e-5) for value in found(column, Slip.LENGTH)
            ), column.words.en


@FEW
@given(st.sampled_from([21.0, 30.0]))
def test_rates_with_another_crank_length_are_found(against: Callable[..., TableCheck], l1: float) -> None:
    mech = load("B-24").mechanism
    poses = oracle.solve(mech, np.radians(TURN))
    angles, rates = SIX_BAR[:1], ("omega4_rad_s", "alpha3_rad_s2")
    table = exact(poses, angles) | exact(mixed(lengths(mech)[0].instead(l1 / 1e3), poses), rates)
    check = against("B-24", table)
    for header in rates:
        assert any(1e3 * value == pytest.approx(l1, rel=1e-4) for value in found(check.column(header), Slip.RATES)), (
            check.column(header).words.en
        )
    assert {check.column(header).verdict for header in angles} == {Level.REPRODUCED}


FACTORS = {
    2 * np.pi: "2π too many",
    1 / (2 * np.pi): "2π left out",
    60 / (2 * np.pi): "r/min taken for rad/s",
    10.0: "ω_{1}$ taken once too often",
    0.1: "ω_{1}$ left out",
    1000.0: "1000 times too large",
    1.37: "a constant factor 1.37",
    -1.0: "opposite sign",
}


@FEW
@given(st.sampled_from(sorted(FACTORS)), st.sampled_from(["omega5_rad_s", "alpha5_rad_s2"]))
def test_a_constant_factor_is_found_and_named(against: Callable[..., TableCheck], factor: float, header: str) -> None:
    table = dict(true("A-16", GUIDES))
    table[header] = table[header] * factor
    check = against("A-16", table)
    told = " ".join(one.words.en for one in check.column(header).explanations)
    assert FACTORS[factor] in told
    assert all(column.verdict is Level.REPRODUCED for column in check.columns if column.column.header != header)


@FEW
@given(st.sampled_from([-90.0, 45.0, 17.35]), st.sampled_from(["phi3_deg", "phi5_deg"]))
def test_a_shifted_zero_of_an_angle_is_found(against: Callable[..., TableCheck], shift: float, header: str) -> None:
    table = dict(true("A-16", GUIDES))
    table[header] = table[header] + shift
    column = against("A-16", table).column(header)
    assert np.degrees(found(column, Slip.ZERO)) == pytest.approx([shift], abs=1e-4)


def test_an_angle_counted_clockwise_and_one_in_radians_are_found(against: Callable[..., TableCheck]) -> None:
    table = dict(true("A-16", GUIDES))
    table["phi3_deg"], table["phi5_deg"] = -table["phi3_deg"], np.radians(table["phi5_deg"])
    check = against("A-16", table)
    assert Slip.SIGN in slips(check.column("phi3_deg")) and Slip.UNIT in slips(check.column("phi5_deg"))


def test_the_other_assembly_is_found(against: Callable[..., TableCheck]) -> None:
    words, mech = next(
        (words, mech) for words, mech in other_assemblies(load("B-24").mechanism) if "F$ left" in words.en
    )
    column = against("B-24", columns_of(mech, ("theta4_deg",))).column("theta4_deg")
    assert words.en in [one.words.en for one in column.explanations]


def test_two_columns_swapped_are_found(against: Callable[..., TableCheck]) -> None:
    table = dict(true("B-24", ("omega4_rad_s", "omega2_rad_s")))
    table["omega2_rad_s"], table["omega4_rad_s"] = table["omega4_rad_s"], table["omega2_rad_s"]
    check = against("B-24", table)
    assert "this column is $ω_{4}$" in check.column("omega2_rad_s").words.en
    assert "this column is $ω_{2}$" in check.column("omega4_rad_s").words.en


def test_a_crank_angle_in_degrees_taken_for_radians_is_found(against: Callable[..., TableCheck]) -> None:
    table = dict(true("A-16", GUIDES))
    mech = load("A-16").mechanism
    table["omega5_rad_s"] = oracle.solve(mech, TURN).omega("5")
    assert Slip.RADIANS in slips(against("A-16", table).column("omega5_rad_s"))


def test_a_column_shifted_by_one_row_is_found(against: Callable[..., TableCheck]) -> None:
    table = dict(true("A-16", GUIDES))
    table["alpha5_rad_s2"] = oracle.solve(load("A-16").mechanism, np.radians(TURN + 10)).alpha("5")
    assert "shifted by one row" in against("A-16", table).column("alpha5_rad_s2").words.en


@FEW
@given(st.data())
def test_a_missing_or_reversed_term_of_the_acceleration_is_found(
    against: Callable[..., TableCheck], data: st.DataObject
) -> None:
    mech = load("A-16").mechanism
    words, motion = data.draw(
        st.sampled_from(list(Loops.of(mech, oracle.solve(mech, np.radians(TURN))).without())), label="term"
    )
    table = {**true("A-16", GUIDES), "alpha5_rad_s2": motion.alpha("5")}
    told = [one.words.en for one in against("A-16", table).column("alpha5_rad_s2").explanations]
    assert words.en in told


def test_an_acceleration_without_its_normal_part_is_found(against: Callable[..., TableCheck]) -> None:
    mech = load("A-16").mechanism
    motion = oracle.solve(mech, np.radians(TURN))
    table = {**true("A-16", GUIDES), "aD_m_s2": np.abs(0.2 * motion.alpha("3"))}
    assert "a^n_{DC}$ left out" in against("A-16", table).column("aD_m_s2").words.en


@pytest.mark.parametrize(("way", "words"), [("forward", "forward differences"), ("central", "central differences")])
def test_finite_differences_of_the_printed_velocities_are_found(
    against: Callable[..., TableCheck], way: str, words: str
) -> None:
    table = dict(true("A-16", GUIDES))
    omega, step = np.round(table["omega5_rad_s"], 5), np.radians(10) / 10
    rate = np.gradient(omega, step) if way == "central" else np.append(np.diff(omega), omega[1] - omega[0]) / step
    table["alpha5_rad_s2"] = rate
    assert words in against("A-16", table).column("alpha5_rad_s2").words.en


@FEW
@given(st.sets(st.integers(0, len(TURN) - 1), min_size=1, max_size=9), st.sampled_from(GUIDES))
def test_rows_typed_over_are_found_in_any_column(
    against: Callable[..., TableCheck], rows: set[int], header: str
) -> None:
    table = dict(true("A-16", GUIDES))
    values = table[header].copy()
    values[list(rows)] += 0.3 * np.ptp(values) * np.where(np.arange(len(rows)) % 2, 1, -0.4)
    column = against("A-16", {**table, header: values}).column(header)
    assert column.verdict is Level.ROWS and not column.explanations
    assert column.rows == pytest.approx(sorted(TURN[list(rows)]))


def test_random_numbers_are_explained_by_nothing(against: Callable[..., TableCheck]) -> None:
    rng = np.random.default_rng(7)
    table = {
        header: values if header.startswith("phi") else rng.normal(size=len(values)) * np.abs(values).max()
        for header, values in true("A-16", GUIDES).items()
    }
    check = against("A-16", table)
    for header in GUIDES[2:]:
        assert check.column(header).verdict is Level.WRONG and not check.column(header).explanations


# -- what every length means ------------------------------------------------------------------------------------


@pytest.mark.parametrize("problem", ["A-16", "A-27", "B-24", "3-7b", "3-10"])
def test_a_length_put_in_place_of_itself_changes_nothing(problem: str) -> None:
    mech = load(problem).mechanism
    here = oracle.solve(mech)
    for length in lengths(mech):
        there = oracle.solve(length.instead(length.value))
        assert all(there.omega(name) == pytest.approx(here.omega(name), rel=1e-9, abs=1e-12) for name in mech.bodies), (
            length.words.en
        )


@pytest.mark.parametrize("problem", ["A-16", "A-27", "B-24"])
def test_rates_at_the_angles_of_the_same_mechanism_are_its_own(problem: str) -> None:
    mech = load(problem).mechanism
    motion = oracle.solve(mech, np.radians(TURN))
    again = mixed(mech, motion)
    for name in mech.bodies:
        assert again.alpha(name) == pytest.approx(motion.alpha(name), rel=1e-9, abs=1e-7)


# -- reading ----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "unit", "count"),
    [("9.32E-03", 1e-5, 3), ("-14893.4445", 1e-4, 9), ("54", 1.0, 2), ("0.0176", 1e-4, 3), ("", 0.0, 0)],
)
def test_the_last_digit_is_read_from_the_text(text: str, unit: float, count: int) -> None:
    assert last_unit(text) == pytest.approx(unit) and digits(text) == count


@pytest.mark.parametrize(
    ("header", "key", "unit"),
    [
        ("phi5_rad", "phi_5", "rad"),
        ("θ5/°", "phi_5", "°"),
        ("ω5/(rad/s)", "omega_5", "rad/s"),
        ("omega5 rad/s", "omega_5", "rad/s"),
        ("w5 [deg/s]", "omega_5", "deg/s"),
        ("alpha5_rad_s2", "alpha_5", "rad/s2"),
        ("a5", "alpha_5", ""),
        ("ε_5", "alpha_5", ""),
        ("v_Ex (mm/s)", "vx_E", "mm/s"),
        ("vxE_mm_s", "vx_E", "mm/s"),
        ("xE", "x_E", ""),
        ("aE", "a_E", ""),
        ("l_AB [mm]", "l_AB", "mm"),
        ("ak_B3B2", "ak_B3B2", ""),
        ("v_CB", "v_CB", ""),
    ],
)
def test_headers_are_read_as_people_write_them(header: str, key: str, unit: str) -> None:
    name, written_unit = split(header)
    target = read_target(name)
    assert target is not None and (target.key, written_unit) == (key, unit)


def test_a_second_row_may_hold_the_units_and_columns_may_stand_apart_by_semicolons_in_gb18030(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    omega = true("A-16", GUIDES)["omega5_rad_s"]
    rows = "".join(f"{q:g};{np.degrees(w):.4f};第 {i} 行\n" for i, (q, w) in enumerate(zip(TURN, omega, strict=True)))
    path.write_bytes(("# 表 1\n曲柄转角;ω5;备注\n°;deg/s;\n" + rows).encode("gb18030"))
    check = check_table(load("A-16"), path)
    assert check.columns[0].verdict is Level.REPRODUCED and any("备注" in note.en for note in check.notes)


def test_a_workbook_is_read_like_a_text(tmp_path: Path) -> None:
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    book.active.append(["phi1 [deg]", "omega5 [rad/s]"])
    for q, w in zip(TURN, true("A-16", GUIDES)["omega5_rad_s"], strict=True):
        book.active.append([float(q), round(float(w), 6)])
    book.save(tmp_path / "table.xlsx")
    assert check_table(load("A-16"), tmp_path / "table.xlsx").columns[0].verdict is Level.REPRODUCED


def test_what_the_user_says_of_a_column_counts(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    table = true("A-16", GUIDES)
    rows = "".join(
        f"{q:g},{w:.6f},{x:.6f}\n" for q, w, x in zip(TURN, table["omega5_rad_s"], table["phi3_deg"], strict=True)
    )
    path.write_text(f"t,speed,omega9\n{rows}", "utf-8")
    check = check_table(load("A-16"), path, {"t": "phi_1[deg]", "speed": "omega_5", "omega9": "phi3[deg]"})
    assert [column.verdict for column in check.columns] == [Level.REPRODUCED] * 2


GOOD = "phi1_deg,omega5_rad_s\n" + "".join(f"{q},1.0\n" for q in range(0, 60, 10))


@pytest.mark.parametrize(("text", "said", "words"), [
    (GOOD.replace("30,1.0", "30,1.O"), {}, "line 5, column 2 ('omega5_rad_s'): '1.O' is not a number"),
    (GOOD.replace("30,1.0", ",1.0"), {}, "line 5, column 1 ('phi1_deg'): the position of the drive is missing"),
    (GOOD.replace("30,1.0", "30"), {}, "line 5: 1 cells where the header has 2"),
    (GOOD.replace("phi1_deg", "row"), {}, "no column tells the position of the drive"),
    (GOOD.replace("omega5", "omega7"), {}, "column 2 ('omega7_rad_s'): there is no link 7; known: 1, 2, 3, 4, 5"),
    (GOOD.replace("omega5_rad_s", "vQ"), {}, "column 2 ('vQ'): there is no point Q"),
    (GOOD.replace("omega5", "omga5"), {}, "'omga5' is no quantity"),
    (GOOD.replace("omega5_rad_s", "omega5 [mm]"), {}, "the unit 'mm' does not belong to a quantity in rad/s"),
    (GOOD.replace("omega5_rad_s", "omega5 [furlong]"), {}, "unit 'furlong' is unknown"),
    (GOOD.replace("omega5_rad_s", "remarks"), {}, "no column holds a quantity to compare"),
    ("".join(GOOD.splitlines(True)[:4]), {}, "3 rows of numbers; at least 5 are needed"),
    ("".join(GOOD.splitlines(True)[1:]), {}, "the first row must name the columns"),
    ("", {}, "the table is empty"), ("a\0b", {}, "is no table of text"),
    (GOOD, {"omega5_rad": "rad/s"}, "there is no column 'omega5_rad'; did you mean 'omega5_rad_s'?"),
    (GOOD.replace("omega5_rad_s", "theta1"), {}, "both tell the position of the drive"),
    ("phi1,omega5\n" + "10,1.0\n" * 6, {}, "the drive stands at 10 in every row"),
])  # fmt: skip
def test_a_table_that_cannot_be_read_is_refused_in_one_sentence(
    tmp_path: Path, text: str, said: Mapping[str, str], words: str
) -> None:
    path = tmp_path / "bad.csv"
    path.write_text(text, "utf-8")
    with pytest.raises(TableError) as refusal:
        check_table(load("A-16"), path, said)
    assert words in str(refusal.value) and "bad.csv" in str(refusal.value) and "\n" not in str(refusal.value)


def test_a_missing_file_a_broken_workbook_and_a_device_are_refused(tmp_path: Path) -> None:
    (tmp_path / "broken.xlsx").write_bytes(b"PK nonsense")
    for problem, name, words in (
        ("A-16", "none.csv", "No such file"),
        ("A-16", "broken.xlsx", "no XLSX workbook"),
        ("5-1", "none.csv", "is about a device"),
    ):
        with pytest.raises(TableError, match=words):
            check_table(load(problem), tmp_path / name)


# -- the command ------------------------------------------------------------------------------------------------


def run(*words: object) -> tuple[int, str, str]:
    result = CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")
    return result.exit_code, result.stdout, result.stderr


def test_the_command_prints_a_verdict_on_each_column_in_both_languages() -> None:
    code, shown, _ = run("check", "A-16", "--table", PRINTED / "A_p16_printed.csv")
    assert code == 1 and "ω_5" in shown and "right only at 90°, 270°" in shown and "$" not in shown
    _, shown, _ = run("check", "A-16", "--table", PRINTED / "A_p16_printed.csv", "--lang", "zh")
    assert "361 行中有 359 行错误，仅在 90°、270° 相符" in shown and "漏除以杆组的系数" in shown and "$" not in shown
    assert "速度和加速度却按 $l_{AB}$ = 26.5 mm 计算" in checked("B-24", "B_table_1A").column("omega2_rad_s").words.zh


def test_the_command_writes_json() -> None:
    code, shown, _ = run("check", "A-16", "--table", PRINTED / "A_p16_printed.csv", "--json", "-")
    data = json.loads(shown)
    assert (
        code == 1
        and data["agrees"] is False
        and [column["verdict"] for column in data["columns"]] == ["reproduced", "reproduced", "wrong"]
    )
    assert data["columns"][2]["rows_right"] == 2 and [one["slip"] for one in data["columns"][2]["explanations"]] == [
        "missing divisor"
    ]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("A-16", "--table", "none.csv"), "No such file"),
        (("A-16", "A-27", "--table", "none.csv"), "one problem"),
        (("A-16", "--table", PRINTED / "A_p16_printed.csv", "--columns", "phi5"), "HEADER=MEANING"),
        (("A-16", "--table", PRINTED / "A_p16_printed.csv", "--columns", "phi9=rad"), "there is no column 'phi9'"),
    ],
)
def test_the_command_refuses_in_one_line(words: Sequence[object], told: str) -> None:
    code, _, error = run("check", *words)
    assert code == 2 and told in error and len(error.splitlines()) == 1 and "Traceback" not in error


WRITTEN = [(name, form) for name in ("A-27", "4-3a", "C-inertia", "3-4a", "4-5", "lift-gate") for form in
           ("csv", "zh.xlsx", "en.xlsx")]  # fmt: skip


@pytest.mark.parametrize(("name", "form"), few(WRITTEN, 7))
def test_a_table_that_vecpoly_writes_is_read_again_column_by_column(name: str, form: str, tmp_path: Path) -> None:
    """Words above symbols above units; places without an answer at the end of a row;
    an end of the drive's range in fifteen digits."""
    problem = load(name)
    made = table(cycle(problem, 25))
    path = tmp_path / form
    path.write_bytes(
        csv_bytes(made) if form == "csv" else xlsx_bytes(made, problem.id, "zh" if form.startswith("zh") else "en")
    )
    checked = check_table(problem, path)
    assert checked.agrees and not checked.table.left_out
    assert {column.column.header for column in checked.columns} == {column.key for column in made.columns[1:]}
