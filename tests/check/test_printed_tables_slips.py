"""Slips put into the exact tables of many mechanisms:
the right one is named, coarse or noisy numbers lead to no wrong one."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.laws import few, often, soaking
from vecpoly import oracle
from vecpoly.check.slips.divisors import undivided
from vecpoly.check.slips.formula import component, ways_to
from vecpoly.check.slips.guess import Slip
from vecpoly.check.slips.lengths import lengths
from vecpoly.check.slips.rates import mixed
from vecpoly.check.table.header import split
from vecpoly.check.table.quantity_names import read_target
from vecpoly.check.table.weigh import Level
from vecpoly.check.table.whole import TableCheck, check_table
from vecpoly.cycle import csv_bytes, cycle
from vecpoly.cycle import table as table_of
from vecpoly.errors import AssemblyError
from vecpoly.names import Kind
from vecpoly.oracle import Motion
from vecpoly.problem.load import load

Reals = NDArray[np.float64]
Columns = Mapping[str, Reals]
FEW = settings(max_examples=often(1), suppress_health_check=[HealthCheck.function_scoped_fixture])
TURN = np.arange(0.0, 361.0, 10.0)
TABLES = {
    "B-24": ("phi2 [deg]", "phi3 [deg]", "omega2 [rad/s]", "omega5 [rad/s]", "alpha3 [rad/s^2]", "vE [m/s]"),
    "A-16": ("phi3 [deg]", "phi5 [deg]", "omega3 [rad/s]", "omega5 [rad/s]", "alpha3 [rad/s^2]", "alpha5 [rad/s^2]"),
    "A-26": ("phi5 [deg]", "omega2 [rad/s]", "omega5 [rad/s]", "alpha5 [rad/s^2]", "xE [mm]", "aE [m/s^2]"),
    "3-5": ("phi3 [deg]", "omega3 [rad/s]", "alpha3 [rad/s^2]"),
    "slider-crank-dynamic": ("phi2 [deg]", "omega2 [rad/s]", "alpha2 [rad/s^2]", "xC [mm]", "aC [m/s^2]"),
}


def columns_of(motion: Motion, problem: str) -> dict[str, Reals]:
    table = {}
    for header in TABLES[problem]:
        name, unit = split(header)
        target = read_target(name)
        assert target is not None
        table[header] = target.of(motion) * {"deg": 180 / np.pi, "mm": 1e3}.get(unit, 1.0)
    return table


@cache
def turning(problem: str) -> Motion:
    return oracle.solve(load(problem).mechanism, np.radians(TURN))


@cache
def exact(problem: str) -> Columns:
    return columns_of(turning(problem), problem)


@pytest.fixture
def against(tmp_path: Path) -> Callable[..., TableCheck]:
    """Write a table with so many significant digits (of each column's largest true number),
    the last of them unsure, and check it."""

    def check(problem: str, table: Columns, digits: int = 5, noise: int = 0, seed: int = 0) -> TableCheck:
        rng, texts = np.random.default_rng(seed), []
        for header, values in table.items():
            size = 100.0 if "phi" in header else float(np.abs(exact(problem)[header]).max())
            decimals = max(0, digits - 1 - int(np.floor(np.log10(size))))
            texts.append(
                [
                    f"{value:.{decimals}f}"
                    for value in np.round(values, decimals)
                    + rng.integers(-noise, noise + 1, len(values)) * 10.0**-decimals
                ]
            )
        rows = [
            ",".join(("phi1 [deg]", *table)),
            *(",".join((f"{q:g}", *cells)) for q, *cells in zip(TURN, *texts, strict=True)),
        ]
        path = tmp_path / "table.csv"
        path.write_text("\n".join(rows), "utf-8")
        return check_table(load(problem), path)

    return check


# -- no column is accused that is right --------------------------------------------------------------------------


@FEW
@given(st.sampled_from(sorted(TABLES)), st.integers(2, 6), st.integers(0, 2), st.integers(0, 99))
def test_a_true_table_is_never_accused_however_coarse(
    against: Callable[..., TableCheck], problem: str, digits: int, noise: int, seed: int
) -> None:
    check = against(problem, exact(problem), digits, noise, seed)
    assert check.agrees and all(one.verdict <= Level.LAST_DIGIT for one in check.columns)


@pytest.mark.parametrize("problem", few(["slider-crank-dynamic", "A-16", "six-bar-dynamic", "3-1e", "3-9"], 4))
def test_the_table_that_vecpoly_writes_of_a_cycle_is_reproduced_with_its_forces(tmp_path: Path, problem: str) -> None:
    path = tmp_path / "cycle.csv"
    path.write_bytes(csv_bytes(table_of(cycle(load(problem), n=25))))
    check = check_table(load(problem), path)
    assert check.agrees and {one.verdict for one in check.columns} == {Level.REPRODUCED}
    assert not any("left out" in note.en for note in check.notes)


# -- the slip is named -------------------------------------------------------------------------------------------


@FEW
@given(st.sampled_from(sorted(TABLES)), st.integers(4, 6), st.integers(0, 2), st.data())
def test_a_table_with_another_length_is_explained_by_it(
    against: Callable[..., TableCheck], problem: str, digits: int, noise: int, data: st.DataObject
) -> None:
    assume(digits > 4 or noise < 2)  # four digits, the last unsure by two: an angle of B-24 cannot tell 7 % of a length
    crank = lengths(load(problem).mechanism)[0]
    value = round(crank.value * data.draw(st.sampled_from([0.85, 0.93, 1.06])), 4)
    try:
        table = columns_of(oracle.solve(crank.instead(value), np.radians(TURN)), problem)
    except AssemblyError:
        assume(False)
    check = against(problem, table, digits, noise)
    for one in check.columns:
        if one.verdict is Level.WRONG and (problem, digits) != ("3-5", 4):
            found = [
                slip.parameter
                for slip in one.explanations
                if slip.slip is Slip.LENGTH and slip.length == crank.words.en
            ]
            assert found == [pytest.approx(value, rel=3e-3)], one.words.en


@pytest.mark.parametrize("index", few([0, 1, 3], 3))
def test_a_single_rate_with_another_length_is_found_even_where_it_is_hardly_another(
    against: Callable[..., TableCheck], index: int
) -> None:
    mech = load("B-24").mechanism
    length = lengths(mech)[index]
    motion = mixed(length.instead(round(1.04 * length.value, 4)), oracle.solve(mech, np.radians(TURN)))
    table = {**exact("B-24"), "alpha3 [rad/s^2]": motion.alpha("3")}
    first = against("B-24", table, digits=3).column("alpha3 [rad/s^2]").explanations[0]
    assert first.slip is Slip.RATES and first.length == length.words.en
    assert first.parameter == pytest.approx(1.04 * length.value, rel=5e-3)


@FEW
@given(st.sampled_from(sorted(TABLES)), st.sampled_from([-40.0, 15.0, 30.0, 180.0]), st.integers(4, 6))
def test_another_zero_of_the_crank_angle_is_found_at_any_angle(
    against: Callable[..., TableCheck], problem: str, zero: float, digits: int
) -> None:
    check = against(
        problem, columns_of(oracle.solve(load(problem).mechanism, np.radians(TURN + zero)), problem), digits
    )
    sign = f"{zero:+g}°".replace("-", "−")
    assert all(
        any(f"the zero of the crank angle shifted by {sign}" in slip.words.en for slip in one.explanations)
        for one in check.columns
    )


@pytest.mark.parametrize(("digits", "noise"), few([(3, 2), (3, 0), (5, 2)], 3))
def test_a_left_out_omega_is_told_before_a_shifted_decimal_point(
    against: Callable[..., TableCheck], digits: int, noise: int
) -> None:
    table = {**exact("A-26"), "omega5 [rad/s]": exact("A-26")["omega5 [rad/s]"] / 10}
    first = against("A-26", table, digits, noise).column("omega5 [rad/s]").explanations[0]
    assert first.slip is Slip.OMEGA and first.words.en == "$ω_{1}$ left out"


@pytest.mark.parametrize("problem", few(["A-16", "A-26", "B-24"], 3))
def test_a_divisor_left_out_in_any_dyad_is_found_in_all_that_follows(
    against: Callable[..., TableCheck], problem: str
) -> None:
    mech = load(problem).mechanism
    for kind, words, motion in list(undivided(mech, oracle.solve(mech, np.radians(TURN))))[:: 5 if soaking() else 10]:
        column = "alpha5 [rad/s^2]" if problem != "B-24" else "alpha3 [rad/s^2]"
        wrong = columns_of(motion, problem)[column]
        if kind is Kind.ALPHA and not np.allclose(wrong, exact(problem)[column]):
            told = against(problem, {**exact(problem), column: wrong}, digits=6).column(column)
            assert words.en in told.words.en or {one.slip for one in told.explanations} <= {
                Slip.UNIT,
                Slip.DIVISOR,
                Slip.FACTOR,
            }, told.words.en


def test_an_arctangent_without_its_quadrant_is_found(against: Callable[..., TableCheck]) -> None:
    table = {**exact("A-16"), "phi5 [deg]": exact("A-16")["phi5 [deg]"] % 180}
    assert [one.slip for one in against("A-16", table).column("phi5 [deg]").explanations] == [Slip.QUADRANT]


@FEW
@given(st.sampled_from([37, 100, 271]), st.sampled_from([4, 5, 6]), st.integers(0, 2))
def test_a_row_typed_over_is_found_beside_a_slip_of_the_whole_column(
    against: Callable[..., TableCheck], k: int, digits: int, noise: int
) -> None:
    values = 1.37 * exact("A-16")["omega5 [rad/s]"]
    row = k % len(TURN)
    values[row] += 0.4 * np.ptp(values)
    column = against("A-16", {**exact("A-16"), "omega5 [rad/s]": values}, digits, noise).column("omega5 [rad/s]")
    assert column.explanations[0].slip is Slip.FACTOR and column.explanations[0].parameter == pytest.approx(
        1.37, rel=5e-3
    )
    assert column.rows == pytest.approx([TURN[row]])


def test_a_length_that_fits_with_either_sign_is_no_division_by_zero(tmp_path: Path) -> None:
    mech = load("3-12").mechanism
    motion = oracle.solve(mech, np.radians(TURN))
    path = tmp_path / "table.csv"
    rows = zip(TURN, np.degrees(motion.angle("5")), 2 * np.abs(motion.velocity("F")), strict=True)
    path.write_text(
        "phi1 [deg],phi5 [deg],vF [m/s]\n" + "".join(f"{q:g},{phi:.3f},{v:.5f}\n" for q, phi, v in rows), "utf-8"
    )
    assert any(
        one.slip is Slip.FACTOR and one.parameter == 2
        for one in check_table(load("3-12"), path).columns[1].explanations
    )


def test_a_constant_column_in_other_units_is_named(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("phi1 [deg],aB [m/s^2]\n" + "".join(f"{q:g},{5 * (30 / np.pi) ** 2:.2f}\n" for q in TURN), "utf-8")
    assert "r/min taken for rad/s" in check_table(load("3-7b"), path).columns[0].words.en


# -- nothing is explained that cannot be ------------------------------------------------------------------------


@FEW
@given(
    st.sampled_from(sorted(TABLES)), st.integers(2, 5), st.integers(2, 5), st.data()
)  # one wave is, to two digits, the rod of a slider-crank
def test_a_smooth_column_of_nonsense_is_explained_by_nothing(
    against: Callable[..., TableCheck], problem: str, digits: int, waves: int, data: st.DataObject
) -> None:
    header = data.draw(st.sampled_from([name for name in TABLES[problem] if name[0] in "oav"]))
    nonsense = np.abs(exact(problem)[header]).max() * np.cos(waves * np.radians(TURN) + 1)
    one = against(problem, {**exact(problem), header: nonsense}, digits).column(header)
    assert one.verdict is Level.WRONG and not one.explanations, one.words.en


@FEW
@given(
    st.sampled_from([("A-26", "vE [m/s]"), ("B-24", "aE [m/s^2]"), ("A-27", "vF [m/s]")]),
    st.integers(1, 3),
    st.integers(0, 10**6),
)
def test_slips_in_the_formula_of_a_point_are_found_by_a_choice_that_gives_the_same_numbers(
    tmp_path: Path, case: tuple[str, str], count: int, pick: int
) -> None:
    (problem, header), motion = case, turning(case[0])
    target = read_target(split(header)[0])
    assert target is not None
    way = ways_to(target, motion)[0]
    term = way.terms[pick % len(way.terms)]
    which = np.flatnonzero(term.count == count)
    values = component(target, way.right + term.change[which[pick % len(which)]])
    path = tmp_path / "table.csv"
    path.write_text(
        f"phi1 [deg],{header}\n" + "".join(f"{q:g},{value:.6f}\n" for q, value in zip(TURN, values, strict=True)),
        "utf-8",
    )
    column = check_table(load(problem), path).columns[0]
    assert column.best.level <= Level.LAST_DIGIT, column.words.en
    assert all(one.slips <= count for one in column.explanations)


# -- as people write ---------------------------------------------------------------------------------------------

WORDS = "曲柄转角（°）;构件3转角（°）;构件5的角速度(rad/s);ε5/(rad·s⁻²)"
LATEX = "$\\varphi_1$;$\\varphi_3$/(°);$\\omega_5$ [rad/s];$\\alpha_5$"


HEADERS = ("phi1;phi3 [deg];w5;a5", WORDS, LATEX)
WAYS = ("decimal comma", "tabs", "quoted", "utf-16", "title", "D exponents", "degree signs", "blanks", "aligned")


@pytest.mark.parametrize(
    ("header", "way"),
    [*((header, "plain") for header in HEADERS), *((HEADERS[i % 3], way) for i, way in enumerate(WAYS))],
)
def test_a_table_is_read_as_people_write_it(tmp_path: Path, header: str, way: str) -> None:
    columns = [exact("A-16")[name] for name in ("phi3 [deg]", "omega5 [rad/s]", "alpha5 [rad/s^2]")]
    rows = [[f"{q:g}", *(f"{v:.5f}" for v in row)] for q, *row in zip(TURN, *columns, strict=True)]
    text = "\n".join(";".join(row) for row in [header.split(";"), *rows])
    match way:
        case "decimal comma":
            text = "\n".join([header, *(";".join(row).replace(".", ",") for row in rows)])
        case "tabs":
            text = text.replace(";", "\t")
        case "quoted":
            text = "\n".join(
                [header.replace(";", ","), *(",".join(f'"{cell.replace(".", ",")}"' for cell in row) for row in rows)]
            )
        case "title":
            text = "表 3  计算结果\n" + text
        case "D exponents":
            text = "\n".join(
                [
                    header,
                    *(
                        ";".join([row[0], *(f"{float(cell):.8e}".replace("e", "D") for cell in row[1:])])
                        for row in rows
                    ),
                ]
            )
        case "degree signs":
            text = "\n".join([header, *(";".join([f"{row[0]}°", *row[1:]]) for row in rows)])
        case "blanks":
            text = "\n".join(
                [
                    header,
                    *(
                        ";".join(["n/a" if i % 9 == 3 and j else cell for j, cell in enumerate(row)]) + "\n;;;"
                        for i, row in enumerate(rows)
                    ),
                ]
            )
        case "aligned":
            text = "\n".join(["   ".join(header.split(";")), *("   ".join(row) for row in rows)])
    path = tmp_path / "table.csv"
    path.write_text(text, "utf-16" if way == "utf-16" else "utf-8")
    check = check_table(load("A-16"), path)
    assert [one.column.target.key for one in check.columns] == ["phi_3", "omega_5", "alpha_5"]
    assert check.agrees, [one.words.en for one in check.columns]
