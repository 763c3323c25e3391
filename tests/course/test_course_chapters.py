"""The course report beyond class II and one exercise:
class III loops, links told from their pivots, assumed speeds, worked numbers, checks."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from io import BytesIO

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pypdf import PdfReader

from tests.laws import few
from tests.studies import course_report, course_words, studied, words_of
from tests.texts import CLASS_III
from vecpoly import oracle
from vecpoly.algebra.formula import plain
from vecpoly.analytic.numbers import worked
from vecpoly.board.paper.marks import Point
from vecpoly.curves.turning import turning
from vecpoly.cycle import table
from vecpoly.errors import NoMethodError
from vecpoly.findings.conditioning import conditioning
from vecpoly.findings.grashof import full_rotation
from vecpoly.findings.study.from_pivots import from_pivots
from vecpoly.findings.study.study import Study, study
from vecpoly.problem.load import load, loads
from vecpoly.report.content import Objects
from vecpoly.report.course.appendix import own_slides
from vecpoly.report.course.checks.chapter import _checked, _told
from vecpoly.report.course.modelling import formulas
from vecpoly.report.course.modelling.dimensions import rounded
from vecpoly.report.course.numbering import Press
from vecpoly.report.course.results import drawings
from vecpoly.report.course.results.tabled import _formats
from vecpoly.report.course.statement import assumed
from vecpoly.report.course.structure import chapter as structure
from vecpoly.report.course.structure.undrawn import undrawn
from vecpoly.report.flow.blocks import SheetPage
from vecpoly.report.flow.table import DataTable
from vecpoly.report.picture import picture
from vecpoly.solution import solve


@cache
def class_three() -> Study:
    problem = loads(CLASS_III)
    return study(undrawn(problem, NoMethodError("no graphical method on file draws class III")))


def test_the_loop_equations_of_a_class_three_group_give_the_oracle_s_motion() -> None:
    """Positions by Newton's method on the printed loops, rates by the printed Jacobian and right sides."""
    it = class_three()
    phi = np.linspace(it.whole.low, it.whole.high, 25)[2:-2]
    env, exact = it.model.values(phi), oracle.solve(it.mech, phi)
    for link in "2345":
        assert np.allclose(env[f"ω_{{{link}}}"], exact.omega(link), rtol=1e-9)
        assert np.allclose(env[f"α_{{{link}}}"], exact.alpha(link), rtol=1e-8)
    for letter in "CEF":
        assert np.allclose(
            np.asarray(env[f"x_{{{letter}}}"]) + 1j * np.asarray(env[f"y_{{{letter}}}"]),
            exact.position(letter),
            atol=1e-12,
        )
        assert np.allclose(
            np.asarray(env[f"a_{{{letter}x}}"]) + 1j * np.asarray(env[f"a_{{{letter}y}}"]),
            exact.acceleration(letter),
            rtol=1e-8,
        )


def test_the_jacobian_of_a_class_three_group_is_printed_from_its_loops() -> None:
    group = class_three().model.groups[-1]
    assert group.loops is not None and group.loops.unknowns == ("φ_{2}", "φ_{3}", "φ_{4}", "φ_{5}")
    first = next(e for e in group.equations if plain(e.left.node).startswith("f_"))
    assert (
        plain(first.node)
        == "f_1 = x_B + l_BC\u2009cos\u2009φ_2 + l_CE\u2009cos\u2009φ_3 − x_D − l_ED\u2009cos\u2009φ_4"
    )
    assert [plain(entry.node) for entry in group.loops.jacobian[0]] == [
        "−l_BC\u2009sin\u2009φ_2",
        "−l_CE\u2009sin\u2009φ_3",
        "l_ED\u2009sin\u2009φ_4",
        "0",
    ]


@given(angles=st.lists(st.floats(-3, 3), min_size=4, max_size=4))
def test_a_jacobian_is_the_derivative_of_its_loops(angles: list[float]) -> None:
    loops = class_three().model.groups[-1].loops
    assert loops is not None
    env: dict[str, float] = {"x_{B}": 0.03, "y_{B}": 0.04} | dict(zip(loops.unknowns, angles, strict=True))
    for j, q in enumerate(loops.unknowns):
        up, down = (env | {q: env[q] + h} for h in (1e-6, -1e-6))
        for f, row in zip(loops.conditions, loops.jacobian, strict=True):
            assert row[j].value(env) == pytest.approx((f.value(up) - f.value(down)) / 2e-6, abs=1e-9)


def chapters_of_class_three() -> tuple[str, Objects]:
    """What chapters 2, 4, 6 and 7 say of it: its cycle, on which the others are built, is found slowly."""
    it, press = class_three(), Press("en", Objects())
    told = (
        structure.chapter(it, press),
        formulas.chapter(it, press),
        drawings.chosen(it, "en"),
        _told(it, _checked(it)).en,
    )
    return str(told), press.objects


def report_of_class_three() -> tuple[str, Objects]:
    text, objects = words_of(class_three(), "en")
    assert "checked independently in chapter 7" in text
    return text, objects


@pytest.mark.parametrize("made", few([chapters_of_class_three, report_of_class_three], 2))
def test_a_class_three_mechanism_has_a_course_report_without_sheets(made: Callable[[], tuple[str, Objects]]) -> None:
    text, objects = made()
    captions = [one.caption for one in objects.named.values() if isinstance(one, DataTable)]
    for said in ("class III mechanism", "Newton", "differs from the solver by more than"):
        assert said in text, said
    assert any("The Jacobian" in caption for caption in captions)
    assert not any(isinstance(one, SheetPage) for one in objects.named.values())


def test_what_is_not_drawn_for_another_reason_is_refused_as_before() -> None:
    with pytest.raises(NoMethodError, match="another reason"):
        undrawn(load("3-11"), NoMethodError("another reason"))


@pytest.mark.parametrize("name", ["A-26", "A-27", "4-3a", "six-bar-dynamic"])
def test_links_told_from_their_fixed_pivots_are_the_same_mechanism(name: str) -> None:
    mech = load(name).mechanism
    turned, phi = from_pivots(mech), np.linspace(0.3, 1.2, 5)
    one, two = oracle.solve(mech, phi), oracle.solve(turned, phi)
    for link in mech.links:
        assert np.allclose(one.omega(link.name), two.omega(link.name)) and np.allclose(
            one.alpha(link.name), two.alpha(link.name)
        )
        for letter in link.points:
            assert np.allclose(one.position(letter), two.position(letter))


def test_a_rocker_s_angle_counts_from_its_fixed_pivot() -> None:
    it = studied("A-27")
    rocker = it.mech.link("3")
    assert next(iter(rocker.points)) == "D"
    at = np.array([it.mech.drive.position])
    motion = oracle.solve(it.mech, at)
    assert motion.angle("3")[0] == pytest.approx(np.angle(motion.position("C")[0] - motion.position("D")[0]))


def test_a_drive_known_only_by_its_sense_is_said_to_turn_at_one_radian_a_second() -> None:
    told = assumed(studied("3-1a"))
    assert "1 rad/s" in told.zh and "1 rad/s" in told.en and "square" in told.en
    assert assumed(studied("A-27")).en == ""


def test_an_exercise_about_centres_gets_polygons_and_curves_in_its_course_report() -> None:
    it = studied("3-1a")
    assert {"omega_2", "alpha_2", "v_C", "a_C"} <= {*it.outputs} and not {"omega_2", "v_C"} & {*it.given.answers}


def test_the_condition_of_full_rotation_tells_the_double_crank() -> None:
    (told,) = full_rotation(studied("A-27"))
    assert "双曲柄" in told.zh and "510 mm" in told.zh and "600 mm" in told.zh
    (rocker,) = full_rotation(studied("B-24"))
    assert "crank-rocker" in rocker.en


TRUSS = """
id: truss
title: {zh: 铰链四杆机构与桁架, en: A four-bar beside a truss}
statement: {zh: 求 $F$ 点的速度。, en: Find the velocity of $F$.}
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm], E: [160 mm, 0 mm], G: [-60 mm, -60 mm]}
links: {1: {AB: 30 mm}, 2: {DC: 50 mm}, 3: {EC: 50 mm}, 4: {BF: 100 mm}, 5: {GF: 95 mm}}
input: {link: 1, phi: 60 deg, omega: 10 rad/s}
branch: [C left of DE, F left of BG]
find: [v_F]
"""


def test_two_links_that_are_pinned_to_the_frame_and_stand_still_are_no_four_bar_loop() -> None:
    (told,) = full_rotation(study(solve(loads(TRUSS), repeats=0)))
    assert "loop $ABFG$" in told.en


def test_the_determinant_is_least_where_the_transmission_angle_is() -> None:
    """G_1 = l l sin γ: both minima are one position, found between the positions of the grid."""
    it = studied("B-24")
    last = conditioning(it)[-1]
    gamma = next(t for t in it.facts.transmissions if t.links == "45")
    assert np.degrees(last.phi) == pytest.approx(np.degrees(gamma.least.phi) % 360, abs=1e-2)


def test_a_worked_formula_ends_in_its_value() -> None:
    it = studied("3-11")
    env = {k: float(np.asarray(v).ravel()[0]) for k, v in it.model.values(np.array([it.mech.drive.position])).items()}
    for equation in (e for g in it.model.groups for e in g.equations if e.gives):
        text = plain(worked(equation, env))
        assert text.startswith(plain(equation.left.node)) and " = " in text and "nan" not in text


def test_a_longer_bar_may_be_tried_in_the_printed_formulas() -> None:
    it = studied("A-27")
    phi = np.radians([10.0, 60.0, 200.0])
    length = next(c for g in it.model.groups for c in g.constants if c.symbol == "l_{AB}")
    assert np.array_equal(it.model.values(phi, {"l_{AB}": length.size})["ω_{5}"], it.model.values(phi)["ω_{5}"])
    assert not np.allclose(it.model.values(phi, {"l_{AB}": 1.01 * length.size})["ω_{5}"], it.model.values(phi)["ω_{5}"])


@pytest.mark.parametrize("name", few(["3-1a", "A-30"], 2))
def test_small_and_large_mechanisms_alike_have_fifteen_to_thirty_pages(name: str) -> None:
    assert 15 <= len(PdfReader(BytesIO(course_report(name, "zh"))).pages) <= 30


@pytest.mark.parametrize("name", ["A-27", "3-5", "3-7c", "3-11", "A-16", "six-bar-dynamic"])
def test_a_sliding_motion_has_one_symbol_in_the_model_and_in_the_tables(name: str) -> None:
    """s_45 of the formulas is the column s_45, zero at the same place; and so are its rates."""
    it = studied(name)
    shared = [c for c in it.whole.columns if c.key[:2] in ("s_", "v_", "a_") and c.symbol in it.env and not c.is_vector]
    assert len(shared) >= 3
    for column in shared:
        assert np.allclose(np.asarray(it.env[column.symbol]), it.turn.real(column.key), rtol=1e-9, atol=1e-9), (
            column.symbol
        )


@pytest.mark.parametrize("name", ["3-14", "oldham-coupling"])
def test_a_sliding_motion_that_is_told_from_the_other_link_than_in_the_model_is_said_to_be(name: str) -> None:
    """s_23 of the appendix stood nowhere in chapter 4, where it was s_32."""
    it, (said, _) = studied(name), course_words(name, "en")
    for key in own_slides(it):
        shown, pair = it.whole.info(key).symbol, key[2:]
        assert shown in it.env or f"${shown}$ = $−s_{{{pair[::-1]}}}$ of chapter 4" in said, shown


def test_one_quantity_has_the_same_decimals_in_all_columns_of_a_table() -> None:
    it = studied("B-24")
    made = table(it.turn, ("phi_2", "phi_5", "omega_2", "omega_5", "alpha_2", "alpha_5", "v_E", "a_E"), it.rows)
    told: dict[str, set[object]] = {}
    for column, places in list(zip(made.columns, _formats(made.columns, made.values), strict=True))[1:]:
        told.setdefault(column.key.partition("_")[0], set()).add(places)
    assert (told["phi"], told["omega"], told["alpha"]) == ({2}, {3}, {3}) and all(
        len(one) == 1 for one in told.values()
    )


def test_the_dots_of_a_curve_stand_at_its_extremes() -> None:
    it = studied("A-27")
    spots = turning(it.turn.phi, it.turn.real("alpha_5"), True)
    for extreme in (it.extremes("alpha_5").highest, it.extremes("alpha_5").lowest):
        assert extreme is not None
        assert (
            min(abs(x - extreme.phi) for x, _ in spots) < 1e-3 and min(abs(y - extreme.value) for _, y in spots) < 0.1
        )


def test_the_kinematic_diagram_has_a_round_scale() -> None:
    it = studied("A-27")
    drawn = picture(it.problem, it.solution.construction, 130.0, 80.0)
    assert drawn is not None
    made = rounded(drawn)
    assert made.scale.value >= drawn.scale.value and float(f"{made.scale.value:.2g}") == pytest.approx(
        made.scale.value, rel=1e-12
    )
    at = {m.label: m.at for m in made.marks if isinstance(m, Point)}
    assert abs(at["B"] - at["A"]) * made.scale.value == pytest.approx(0.280, rel=1e-2)
