"""Claims about whole cycles: continuous angles, rates as derivatives,
exact extremes, strokes, paths, tables, curves."""

from __future__ import annotations

import csv
import tracemalloc
from collections.abc import Callable
from dataclasses import replace
from io import BytesIO, StringIO
from math import acos, degrees, hypot, pi
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner, Result

from tests.laws import often
from vecpoly.cli import app
from vecpoly.cycle import (
    Cycle,
    Shape,
    csv_bytes,
    cycle,
    extremes,
    facts,
    path,
    path_sentences,
    sentences,
    table,
    xlsx_bytes,
)
from vecpoly.cycle.follow import follow
from vecpoly.cycle.root import ridders
from vecpoly.errors import AssemblyError, EquilibriumError, MobilityError, NotAskedError, UnknownNameError
from vecpoly.mechanism.model import Circle, Drive, Link, Mechanism, Prismatic, Revolute, Rolling, Side, SideOf
from vecpoly.oracle.forces import forces
from vecpoly.problem.load import load

Run = Callable[..., Result]
QUICK = settings(max_examples=often(10))
rates = st.sampled_from([10.0, -7.0])


@st.composite
def four_bars(draw: st.DrawFn) -> Mechanism:
    """Four-bars whose shortest link turns right round,
    as crank (crank-rocker) or as frame (double crank), not near a change point."""
    short, bars = 0.05, [draw(st.floats(0.09, 0.2)) for _ in range(2)]
    longest = (
        draw(st.floats(max(bars), sum(bars) - short - 0.02)) if sum(bars) - short - 0.02 > max(bars) else max(bars)
    )
    shape = [short, longest, *bars]
    turn = draw(st.integers(0, 3))
    frame, crank, coupler, rocker = shape[turn:] + shape[:turn] if turn in (0, 3) else [longest, short, *bars]
    return four_bar(crank, coupler, rocker, frame, draw(rates), draw(st.sampled_from([Side.LEFT, Side.RIGHT])))


def four_bar(
    crank: float,
    coupler: float,
    rocker: float,
    frame: float,
    rate: float = 10.0,
    side: Side = Side.LEFT,
    phi: float = 1.0,
) -> Mechanism:
    links = (
        Link(name="1", points={"A": 0j, "B": crank + 0j}),
        Link(name="2", points={"B": 0j, "C": coupler + 0j, "E": complex(coupler / 2, 0.04)}),
        Link(name="3", points={"D": 0j, "C": rocker + 0j}),
    )
    joints = tuple(
        Revolute(point=p, a=a, b=b) for p, a, b in (("A", "0", "1"), ("B", "1", "2"), ("C", "2", "3"), ("D", "3", "0"))
    )
    return Mechanism(
        frame={"A": 0j, "D": frame + 0j},
        links=links,
        joints=joints,
        drives=(Drive(link="1", position=phi, rate=rate),),
        branches=(SideOf(point="C", side=side, ref=("B", "D")),),
    )


def slider_crank(r: float, l: float, e: float, rate: float = 10.0) -> Mechanism:  # noqa: E741
    links = (
        Link(name="1", points={"A": 0j, "B": r + 0j}),
        Link(name="2", points={"B": 0j, "C": l + 0j}),
        Link(name="3", points={"C": 0j}),
    )
    pins = tuple(Revolute(point=p, a=a, b=b) for p, a, b in (("A", "0", "1"), ("B", "1", "2"), ("C", "2", "3")))
    guide = Prismatic(guide="0", block="3", origin=1j * e, direction=0.0, pin="C")
    return Mechanism(
        frame={"A": 0j},
        links=links,
        joints=(*pins, guide),
        drives=(Drive(link="1", position=0.7, rate=rate),),
        branches=(SideOf(point="C", side=Side.RIGHT, ref=("A",)),),
    )


def nephroid() -> Mechanism:
    """A gear of 20 mm that rolls on a fixed one of 40 mm: its rim draws an epicycloid of two cusps."""
    links = (Link(name="1", points={"A": 0j, "B": 0.06 + 0j}), Link(name="2", points={"B": 0j, "P": 0.02 + 0j}))
    rolls = Rolling(
        point="H", gear=Circle(link="2", centre="B", radius=0.02), on=Circle(link="0", centre="A", radius=0.04)
    )
    return Mechanism(
        frame={"A": 0j},
        links=links,
        joints=(Revolute(point="A", a="0", b="1"), Revolute(point="B", a="1", b="2"), rolls),
        drives=(Drive(link="1", position=0.3, rate=10.0),),
    )


def derivative(turn: Cycle, key: str) -> np.ndarray:
    """d/dt of a column by seven points."""
    weights = np.array([-1, 9, -45, 0, 45, -9, 1])[::-1] / 60
    return np.asarray(
        np.convolve(np.asarray(turn.column(key)), weights, "valid") * turn.mech.drive.rate / (turn.phi[1] - turn.phi[0])
    )


def sizes(turn: Cycle, key: str, phi: np.ndarray) -> np.ndarray:
    """The column at these positions, of a vector its magnitude."""
    values = turn.at(key, phi)
    return np.abs(values) if np.iscomplexobj(values) else np.asarray(values)


@QUICK
@given(four_bars())
def test_angles_run_on_without_jumps_and_columns_are_derivatives_of_each_other(mech: Mechanism) -> None:
    turn = cycle(mech, 3601)
    for of, rate in (
        ("phi_2", "omega_2"),
        ("phi_3", "omega_3"),
        ("omega_2", "alpha_2"),
        ("omega_3", "alpha_3"),
        ("p_E", "v_E"),
        ("v_E", "a_E"),
    ):
        truth = np.asarray(turn.column(rate))
        assert np.abs(derivative(turn, of) - truth[3:-3]).max() < 1e-6 * np.abs(truth).max(), of


@QUICK
@given(four_bars(), st.integers(3, 40))
def test_a_coarse_cycle_has_the_angles_of_a_fine_one(mech: Mechanism, n: int) -> None:
    coarse, fine = cycle(mech, n), cycle(mech, 60 * (n - 1) + 1)
    for link in "23":
        assert np.allclose(coarse.column(f"phi_{link}"), np.asarray(fine.column(f"phi_{link}"))[::60], atol=1e-12)


@QUICK
@given(four_bars(), st.sampled_from(["omega_3", "alpha_3", "v_E", "a_C", "p_E.x", "alpha_2", "gamma_23"]))
def test_extremes_are_stationary_and_nothing_beats_them(mech: Mechanism, key: str) -> None:
    turn = cycle(mech)
    found = extremes(turn, key)
    assert found.highest is not None and found.lowest is not None
    everywhere = sizes(turn, key, np.linspace(0, 2 * pi, 2880))
    span = np.ptp(everywhere)
    assert (
        found.highest.value >= everywhere.max() - 1e-12 * span and found.lowest.value <= everywhere.min() + 1e-12 * span
    )
    for spot in (*found.maxima, *found.minima):
        before, after = sizes(turn, key, spot.phi + np.array([-1e-5, 1e-5]))
        if (
            not turn.info(key).is_vector or spot.value > 1e-6 * everywhere.max()
        ):  # a magnitude has a corner where it is zero
            assert abs(after - before) < 1e-8 * max(span, 1e-3)
    assert len(found.maxima) == len(found.minima)


@QUICK
@given(st.floats(0.02, 0.06), st.floats(0.14, 0.3), st.floats(-0.07, 0.07), rates)
def test_quick_return_of_an_offset_slider_crank_is_the_closed_form(r: float, l: float, e: float, rate: float) -> None:  # noqa: E741
    told = facts(cycle(slider_crank(r, l, e, rate)))
    (stroke,) = told.strokes
    theta = abs(acos(e / (l + r)) - acos(e / (l - r)))
    assert stroke.ratio == pytest.approx((pi + theta) / (pi - theta), abs=1e-9)
    assert stroke.theta == pytest.approx(theta, abs=1e-9)
    assert stroke.swing == pytest.approx(((l + r) ** 2 - e * e) ** 0.5 - ((l - r) ** 2 - e * e) ** 0.5, rel=1e-12)
    least = next(t for t in told.transmissions if t.key == "gamma_23").least
    assert np.cos(least.value) == pytest.approx((r + abs(e)) / l, abs=1e-12)


@QUICK
@given(four_bars())
def test_transmission_angle_of_a_four_bar_is_extreme_where_crank_and_frame_are_in_line(mech: Mechanism) -> None:
    a, b, c, d = (
        abs(mech.link("1").points["B"]),
        abs(mech.link("2").points["C"]),
        abs(mech.link("3").points["C"]),
        abs(mech.frame["D"]),
    )
    angles = [acos((b * b + c * c - reach * reach) / (2 * b * c)) for reach in (d - a, d + a)]
    (told,) = facts(cycle(mech)).transmissions
    assert told.least.value == pytest.approx(min(min(g, pi - g) for g in angles), abs=1e-10)
    assert min(told.least.phi, abs(told.least.phi - pi), abs(told.least.phi - 2 * pi)) < 1e-6


@QUICK
@given(four_bars())
def test_the_crank_pin_goes_once_round_a_circle(mech: Mechanism) -> None:
    turn, r = cycle(mech), abs(mech.link("1").points["B"])
    found = path(turn, "B")
    assert found.shape is Shape.CIRCLE and found.closed and not found.crossings and not found.cusps
    assert found.turning == (1 if mech.drive.rate > 0 else -1)
    assert found.length == pytest.approx(2 * pi * r, rel=1e-12)


def test_a_rocker_pin_goes_there_and_back_on_an_arc_and_a_slider_on_a_line() -> None:
    rocker, slider = cycle(four_bar(0.05, 0.2, 0.15, 0.18)), cycle(slider_crank(0.05, 0.2, 0.0))
    arc, line = path(rocker, "C"), path(slider, "C")
    (swing,) = facts(rocker).strokes
    assert arc.shape is Shape.ARC and arc.length == pytest.approx(2 * 0.15 * swing.swing, rel=1e-12)
    assert line.shape is Shape.LINE and line.length == pytest.approx(4 * 0.05, rel=1e-12)
    assert facts(slider).strokes[0].ratio == pytest.approx(1.0, abs=1e-9)


def test_the_length_told_of_an_arc_or_a_line_is_its_own_and_the_way_there_and_back_is_told_apart() -> None:
    rocker, slider = cycle(four_bar(0.05, 0.2, 0.15, 0.18)), cycle(slider_crank(0.05, 0.2, 0.0))
    (swing,) = facts(rocker).strokes
    arc, line, circle = path(rocker, "C"), path(slider, "C"), path(rocker, "B")
    assert arc.once == pytest.approx(0.15 * swing.swing, rel=1e-9) and line.once == pytest.approx(0.1, rel=1e-9)
    assert (arc.passes, line.passes, circle.passes) == (2, 2, 1)
    (of_line,) = path_sentences(slider, line)
    said = "Point $C$ moves on a straight line 100 mm long and passes it twice per cycle"
    assert of_line.en == f"{said}: the distance travelled is 200 mm."
    assert of_line.zh == "点 $C$ 的轨迹为一段直线，长 100 mm，每循环沿此线走过 2 次，总路程为 200 mm。"
    (of_arc,) = path_sentences(rocker, arc)
    assert f"arc {1e3 * 0.15 * swing.swing:.1f} mm long" in of_arc.en


def test_a_nephroid_has_two_cusps_and_the_length_24_r() -> None:
    turn = cycle(nephroid())
    found = path(turn, "P")
    assert found.closed and len(found.cusps) == 2 and found.turning is None and not found.crossings
    assert found.length == pytest.approx(24 * 0.02, rel=1e-9)
    assert [abs(place) for place, _ in found.cusps] == pytest.approx([0.04, 0.04], rel=1e-9)
    assert turn.column("phi_2")[-1] - turn.column("phi_2")[0] == pytest.approx(6 * pi)


def test_limits_of_a_rocker_are_where_crank_and_coupler_are_in_line() -> None:
    crank, coupler, rocker, frame = 0.05, 0.2, 0.15, 0.18
    (stroke,) = facts(cycle(four_bar(crank, coupler, rocker, frame))).strokes
    psi = [
        pi - acos((rocker**2 + frame**2 - reach**2) / (2 * rocker * frame))
        for reach in (coupler + crank, coupler - crank)
    ]
    assert sorted(psi) == pytest.approx([stroke.lower.value, stroke.upper.value], abs=1e-10)


def test_a_rocking_input_has_a_range_with_dead_points_at_its_ends() -> None:
    mech = four_bar(0.2, 0.1, 0.15, 0.2, phi=0.9)  # the longest link is no crank
    turn = cycle(mech, 181)
    limit = acos((0.2**2 + 0.2**2 - (0.1 + 0.15) ** 2) / (2 * 0.2 * 0.2))
    assert not turn.whole and turn.high == pytest.approx(limit, abs=1e-9)
    assert np.isfinite(turn.column("omega_3")[2:-2]).all() and turn.assembled[2:-2].all()
    told = facts(turn)
    assert (
        told.turns is None and [spot.phi for spot in told.dead] == [turn.low, turn.high] and told.ranges == turn.ranges
    )
    outside = cycle(mech, over=np.array([0.9, turn.high + 0.1]))
    assert (
        np.isnan(outside.column("phi_3")[1])
        and np.isnan(outside.column("v_C")[1])
        and list(outside.assembled) == [True, False]
    )


def test_a_sliding_input_is_taken_over_its_travel() -> None:
    mech = replace(
        slider_crank(0.05, 0.2, 0.0),
        drives=(Drive(link="3", position=0.19, rate=0.1, slide=True),),
        branches=(SideOf(point="B", side=Side.ABOVE, ref=("A",)),),
    )
    turn = cycle(mech, 101)
    assert (turn.low, turn.high) == pytest.approx((0.15, 0.25), abs=1e-9) and turn.drive.shown_unit == "mm"
    assert np.abs(turn.column("p_C") - turn.phi).max() < 1e-12
    assert "150 mm" in sentences(turn, facts(turn))[0].en


def test_extremes_lie_between_the_positions_of_the_grid() -> None:
    coarse, fine = (extremes(cycle(load("A-27"), n), "alpha_5") for n in (13, 3601))
    assert coarse.highest is not None and fine.highest is not None
    assert coarse.highest.value == pytest.approx(fine.highest.value, rel=1e-12)
    dense = cycle(load("A-27"), over=fine.highest.phi + np.linspace(-1e-3, 1e-3, 4001)).column("alpha_5")
    assert fine.highest.value == pytest.approx(dense.max(), rel=1e-12)


def test_the_zeros_of_a_rocker_are_its_limits_and_a_steady_crank_has_no_extremes() -> None:
    turn = cycle(load("3-8"))
    (stroke,), zeros = facts(turn).strokes, extremes(turn, "omega_3").zeros
    assert sorted(z.phi for z in zeros) == pytest.approx(sorted((stroke.lower.phi, stroke.upper.phi)), abs=1e-9)
    assert extremes(turn, "omega_1").is_constant and not extremes(turn, "omega_1").maxima


def test_a_pole_is_neither_a_zero_nor_an_extreme() -> None:
    assert np.isnan(ridders(lambda x: 1 / x, np.array([-1.0]), np.array([2.0]))).all()
    assert ridders(np.cos, np.array([0.0]), np.array([2.0]))[0] == pytest.approx(pi / 2, abs=1e-15)


def test_gaps_do_not_spoil_an_angle() -> None:
    angle = np.angle(np.exp(1j * np.linspace(0.0, 12.0, 200)))
    angle[50:60] = np.nan
    followed = follow(angle)
    assert np.isnan(followed[50:60]).all() and followed[-1] == pytest.approx(12.0)


def test_reactions_and_balancing_moment_over_the_cycle_are_those_of_single_positions() -> None:
    problem = load("six-bar-dynamic")
    turn = cycle(problem, 13)
    assert {"M_1", "R_12", "R_65"} <= {column.key for column in turn.columns}
    for i in (0, 5, 9):
        assert problem.loads is not None
        single = forces(problem.mechanism, problem.loads, turn.phi[i])
        for key in ("M_1", "R_12", "R_65"):
            assert turn.column(key)[i] == pytest.approx(complex(single.value(key)), rel=1e-9)
    power = turn.column("M_1_power")
    assert np.allclose(turn.real("M_1"), power, rtol=1e-9, atol=1e-9 * np.abs(power).max())
    with pytest.raises(EquilibriumError, match="no loads"):
        cycle(load("A-27")).column("R_12")


def test_travel_speed_and_relative_acceleration_along_a_turning_guide_are_derivatives() -> None:
    turn = cycle(load("A-27"), 7201)
    for of, rate in (("s_45", "v_45"), ("v_45", "a_45")):
        truth = turn.real(rate)
        assert np.abs(derivative(turn, of) - truth[3:-3]).max() < 1e-6 * np.abs(truth).max()
    assert np.allclose(np.abs(turn.column("v_45")), np.abs(turn.column("v_F4") - turn.column("v_F5")))


def test_one_pass_reads_what_the_columns_hold() -> None:
    keys = ("phi_5", "omega_5", "p_F", "a_F", "s_45", "phi_1")
    once, kept = cycle(load("A-27"), 9001), cycle(load("A-27"), 9001)
    for column, key in zip(once.read(*keys), keys, strict=True):
        assert np.array_equal(column, kept.column(key))


def test_memory_grows_linearly_with_the_positions() -> None:
    def peak(n: int) -> int:
        tracemalloc.start()
        cycle(load("A-27"), n).read("phi_5", "omega_5", "alpha_5", "a_F")
        _, highest = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        return highest

    peak(9001)
    small, large = peak(9001), peak(72001)
    assert large < 8.5 * small and large < 72001 * 200


@pytest.mark.parametrize("key", ["omega_9", "v_Q", "phi_9", "s_12", "gamma_12", "p_F.z", "omega_5.x", "nonsense"])
def test_an_unknown_column_is_refused_by_name(key: str) -> None:
    with pytest.raises(UnknownNameError):
        cycle(load("A-27")).column(key)


def test_a_device_has_no_cycle_and_one_position_is_none() -> None:
    with pytest.raises(MobilityError, match="device"):
        cycle(load("4-1"))
    with pytest.raises(AssemblyError, match="at least 2"):
        cycle(load("A-27"), 1)


def test_facts_read_in_both_languages() -> None:
    for name in ("A-27", "3-8", "B-24"):
        turn = cycle(load(name))
        for words in (*sentences(turn, facts(turn)), *path_sentences(turn, path(turn, "C"))):
            assert words.zh and words.en and words.zh != words.en
            assert (
                "nan" not in words.en
                and words.zh.count("$") % 2 == 0
                and words.en.endswith(".")
                and words.zh.endswith("。")
            )


def test_a_csv_table_has_units_and_reads_back_with_all_digits() -> None:
    turn = cycle(load("A-27"), 37)
    made = table(turn, ("omega_5", "a_F"))
    rows = list(csv.reader(StringIO(csv_bytes(made).decode())))
    assert rows[0] == ["phi_1", "omega_5", "a_F.x", "a_F.y"] and rows[1] == ["°", "rad/s", "m/s²", "m/s²"]
    values = np.array(rows[2:], np.float64)
    assert np.allclose(values[:, 0], np.arange(0, 361, 10)) and np.allclose(
        values[:, 2] + 1j * values[:, 3], turn.column("a_F"), rtol=1e-14
    )
    assert len(table(turn, ("omega_5",), turn.rows(np.radians(30.0))).values) == 13


def test_a_spreadsheet_has_words_keys_and_units_over_the_numbers() -> None:
    from openpyxl import load_workbook

    turn = cycle(four_bar(0.2, 0.1, 0.15, 0.2, phi=0.9), over=np.array([0.5, 0.9, 3.0]))
    sheet = load_workbook(BytesIO(xlsx_bytes(table(turn, ("phi_3", "omega_3")), "four-bar", "zh"))).active
    rows = [[cell.value for cell in row] for row in sheet.iter_rows()]
    assert (
        rows[1] == ["phi_1", "phi_3", "omega_3"] and rows[2] == ["°", "°", "rad/s"] and rows[0][2] == "构件 3 的角速度"
    )
    assert rows[4][1] == pytest.approx(degrees(turn.real("phi_3")[1])) and rows[5][1:] == [None, None]


def test_curves_carry_units_and_differ_without_colour() -> None:
    from vecpoly.curves import curves
    from vecpoly.drawing.scene import Stroke

    turn = cycle(load("A-27"))
    plot = curves(turn, ("omega_2", "omega_3", "omega_5", "phi_5"), "zh")
    svg = plot.svg()
    assert "rad/s" in svg and "原动件" in svg and plot.width == pytest.approx(150.0)
    long = [item for item in plot.scene.items if isinstance(item, Stroke) and len(item.points) > 300]
    assert len(long) == 4 and len({item.dash for item in long[:3]}) == 3
    assert all(0 <= z.real <= plot.width and 0 <= z.imag <= plot.height for item in long for z in item.points)


def test_a_plot_in_a_pdf_is_lines_and_embedded_type(tmp_path: Path) -> None:
    import pypdf

    from vecpoly.curves import hodograph, trace

    turn = cycle(load("A-27"))
    for name, plot in (("h", hodograph(turn, "a_F")), ("t", trace(turn, ("F", "C"), "en"))):
        file = tmp_path / f"{name}.pdf"
        file.write_bytes(plot.pdf())
        (page,) = pypdf.PdfReader(file).pages
        assert not page.images and float(page.mediabox.width) == pytest.approx(plot.width * 72 / 25.4, abs=0.1)
        fonts = [font.get_object() for font in cast("Any", page["/Resources"])["/Font"].values()]
        assert fonts and all("/FontFile2" in font["/FontDescriptor"] for font in fonts)
        assert "[U+" not in page.extract_text()


def test_a_curve_is_interrupted_where_nothing_can_be_assembled() -> None:
    from vecpoly.curves import curves
    from vecpoly.drawing.scene import Stroke

    turn = cycle(four_bar(0.2, 0.1, 0.15, 0.2, phi=0.9), over=np.linspace(-3.0, 3.0, 601))
    long = [
        i for i in curves(turn, ("phi_3",), marks=False).scene.items if isinstance(i, Stroke) and len(i.points) > 50
    ]
    finite = int(np.isfinite(turn.real("phi_3")).sum())
    assert 0 < finite < 500 and sum(len(item.points) for item in long) <= finite + 2


def test_too_many_curves_or_none_are_refused() -> None:
    from vecpoly.curves import curves, hodograph, trace

    turn = cycle(load("A-30"), 37)
    with pytest.raises(NotAskedError, match="told apart"):
        curves(turn, tuple(f"omega_{i}" for i in range(1, 9)))
    with pytest.raises(NotAskedError, match="no quantity"):
        curves(turn, ())
    with pytest.raises(NotAskedError, match="no vector"):
        hodograph(turn, "omega_2")
    with pytest.raises(NotAskedError, match="paths"):
        trace(turn, ())


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    monkeypatch.chdir(tmp_path)
    return lambda *words: CliRunner().invoke(app, [str(word) for word in words], prog_name="vecpoly")


def test_the_command_tells_facts_and_extremes(run: Run) -> None:
    done = run("cycle", "3-8")
    assert (
        done.exit_code == 0
        and "K = 239.1019°/120.8981°" in done.stdout
        and "ω_3" in done.stdout
        and "$" not in done.stdout
    )
    assert "急回" in run("cycle", "3-14", "--lang", "zh").stdout


def test_the_command_writes_tables_and_plots(run: Run) -> None:
    for words in (
        ("-o", "a.csv", "--step", "0.5"),
        ("-o", "a.xlsx", "-n", "37"),
        ("--plot", "a.svg", "--of", "omega_5,alpha_5"),
        ("--plot", "p.pdf", "--path", "F,C"),
        ("--plot", "h.png", "--hodograph", "a_F"),
    ):
        done = run("cycle", "A-27", *words)
        assert done.exit_code == 0, done.stderr
    assert len(Path("a.csv").read_text("utf-8").splitlines()) == 2 + 721
    assert all(Path(name).stat().st_size > 3000 for name in ("a.xlsx", "a.svg", "p.pdf", "h.png"))


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("4-1",), "device"),
        (("A-27", "--of", "omega_9"), "no link 9"),
        (("A-27", "-o", "a.doc"), ".csv"),
        (("A-27", "--plot", "a.gif"), ".svg"),
        (("A-27", "--path", "F"), "--plot"),
        (("A-27", "--of", "R_12"), "loads"),
        (("A-27", "--step", "0.00001", "-o", "a.csv"), "positions"),
    ],
)
def test_the_command_refuses_in_one_sentence(run: Run, words: tuple[str, ...], said: str) -> None:
    done = run("cycle", *words)
    assert done.exit_code == 2 and said in done.stderr and "Traceback" not in done.stderr and not list(Path().iterdir())


def test_length_of_a_path_is_what_chords_come_near_to() -> None:
    turn = cycle(load("B-24"), 36001)
    p = np.asarray(turn.column("p_E"))
    chords = sum(hypot(d.real, d.imag) for d in np.diff(p))
    assert path(turn, "E").length == pytest.approx(chords, rel=1e-7)
