"""Pressure and transmission angles marked in a given mechanism: seven cases of exercise 8-2, slips, refusals."""

from __future__ import annotations

from math import acos, degrees

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import vecpoly
from tests.at_once import exactly
from tests.drawn_library import drawn
from tests.laws import often
from vecpoly.board.acts import Angle, Corner
from vecpoly.board.otherwise.slip import Mistake, Slip
from vecpoly.board.paper.marks import AngleMark, Point, Vector
from vecpoly.errors import ProblemFileError, VecpolyError

CASES = {"8-2a": 20.92483, "8-2b": 26.88183, "8-2d": 0.0, "8-2g": 0.0}
RETOLD = {"8-2c": 3.11817, "8-2e": 40.87688, "8-2f": 50.06288}  # the drive's place is written in five digits
FOUR_BAR = """
id: t
title: t
frame: {A: [0 mm, 0 mm], D: [80 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {BC: 70 mm}, 3: {DC: 50 mm}}
input: {link: 1, phi: 60 deg, omega: ccw}
branch: [C above AD]
"""
SIX_BAR = """
id: t
title: t
frame: {A: [0 mm, 0 mm], C: [0 mm, -60 mm]}
links:
  1: {AB: 30 mm}
  2: {block: B}
  3: {slot: C, D: {along: C, at: 120 mm}}
  4: {DE: 60 mm}
  5: {block: E}
joints: [2 slides in 3, 5 slides on y = 65 mm]
input: {link: 1, phi: 20 deg, omega: ccw}
branch: [E left of D]
"""


@pytest.mark.parametrize(("name", "alpha"), list((CASES | RETOLD).items()))
def test_the_seven_mechanisms_have_the_angles_of_the_triangle_formulas(name: str, alpha: float) -> None:
    found = exactly(vecpoly.load(name)).answers
    slack = 1e-5 if name in CASES else 1e-3
    assert found["alpha"].drawn == pytest.approx(alpha, abs=slack)
    assert found["gamma"].drawn == pytest.approx(90.0 - alpha, abs=slack)
    assert found["alpha"].exact == pytest.approx(found["alpha"].drawn, abs=1e-9)
    assert found["gamma"].exact == pytest.approx(found["gamma"].drawn, abs=1e-9)


def test_both_angles_have_their_arcs_and_a_right_one_its_square() -> None:
    marked = [act.key for act in vecpoly.load("8-2a").solve().construction.acts if isinstance(act, Angle)]
    assert {"alpha", "gamma"} <= set(marked)
    square = vecpoly.load("8-2d").solve().construction.acts
    assert any(isinstance(act, Corner) for act in square)
    assert {"alpha", "gamma"} & {act.key for act in square if isinstance(act, Angle)} == {"gamma"}


@pytest.mark.parametrize("name", ["8-2d", "8-2g"])
def test_a_pressure_angle_of_nothing_is_told_at_the_force_and_the_right_angle_by_its_arc(name: str) -> None:
    """Also where no arc can be drawn the sheet says what was asked."""
    marks = vecpoly.load(name).solve().construction.figures[0].marks
    assert [mark.label for mark in marks if isinstance(mark, AngleMark) and "γ" in mark.label] == ["γ = 90.0°"]
    (point,) = (mark for mark in marks if isinstance(mark, Point) and mark.label.startswith("α"))
    (force,) = (mark for mark in marks if isinstance(mark, Vector) and mark.label == "F")
    assert point.label == "α = 0°" and abs(((point.at - force.a) / (force.b - force.a)).imag) < 1e-6


def test_several_driven_links_are_told_apart_by_their_points() -> None:
    found = exactly(vecpoly.loads(SIX_BAR + "find: [alpha_B, gamma_B, alpha_E, gamma_E]")).answers
    assert found["alpha_B"].drawn == pytest.approx(0.0, abs=1e-9)
    assert 0 < found["alpha_E"].drawn < 90
    assert found["alpha_E"].drawn == pytest.approx(found["alpha_E"].exact, abs=1e-9)


@pytest.mark.parametrize(
    ("text", "find", "said"),
    [
        (SIX_BAR, "alpha", "say at which point: alpha_B, gamma_B, alpha_E, gamma_E"),
        (FOUR_BAR, "alpha_B", "did you mean 'alpha'"),
        (
            FOUR_BAR.replace("AB: 30 mm", "AB: 30 mm, E: {along: AB, at: 60 mm}"),
            "gamma_E",
            "no pressure or transmission angle",
        ),
    ],
)
def test_an_angle_that_does_not_exist_is_refused_with_those_that_do(text: str, find: str, said: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        vecpoly.loads(text + f"find: [{find}]")
    assert said in refused.value.words.en


def test_a_mechanism_of_teeth_has_no_such_angle() -> None:
    text = vecpoly.load("rack-lift").path
    assert text is not None
    lines = [line for line in text.read_text(encoding="utf-8").splitlines() if not line.startswith("find")]
    with pytest.raises(ProblemFileError, match="two forces"):
        vecpoly.loads("\n".join([*lines, "find: [alpha]"]))


@pytest.mark.parametrize("name", ["8-2a", "8-2b", "8-2c", "8-2e", "8-2f"])
def test_who_takes_the_direction_along_the_link_gets_gamma_for_alpha(name: str) -> None:
    problem = vecpoly.load(name)
    right = exactly(problem).answers
    turned = [slip for slip in vecpoly.slips(problem) if slip.mistake is Mistake.TURNED and slip.key.startswith("v_")]
    assert len(turned) == 1
    wrong = vecpoly.solve(problem, by="exact", slip=turned[0]).answers
    assert wrong["alpha"].drawn == pytest.approx(right["gamma"].drawn)
    assert wrong["gamma"].drawn == pytest.approx(right["alpha"].drawn)


def test_who_takes_the_guide_for_its_normal_is_offered_as_a_slip() -> None:
    problem = vecpoly.load("8-2e")
    assert Slip(Mistake.TURNED, "F") in vecpoly.slips(problem)
    wrong = vecpoly.solve(problem, by="exact", slip=Slip(Mistake.TURNED, "F")).answers["alpha"]
    assert wrong.drawn == pytest.approx(49.12312, abs=1e-3)


@settings(max_examples=often(12))
@given(
    bars=st.tuples(st.integers(20, 40), st.integers(60, 90), st.integers(45, 70), st.integers(70, 95)),
    phi=st.integers(0, 359),
)
def test_gamma_of_a_four_bar_is_the_acute_angle_of_coupler_and_rocker(bars: tuple[int, ...], phi: int) -> None:
    ab, bc, cd, ad = bars
    text = FOUR_BAR.replace("80 mm", f"{ad} mm").replace("AB: 30", f"AB: {ab}").replace("BC: 70", f"BC: {bc}")
    text = text.replace("DC: 50", f"DC: {cd}").replace("60 deg", f"{phi} deg").replace("above AD", "left of BD")
    try:
        found = exactly(vecpoly.loads(text + "find: [alpha, gamma]")).answers
    except VecpolyError:
        return
    corner = exactly(vecpoly.loads(text + "find: [p_B]")).answers["p_B"].exact_vector
    assert corner is not None
    diagonal = abs(corner - ad * 1e-3) * 1e3
    mu = degrees(acos((bc**2 + cd**2 - diagonal**2) / (2 * bc * cd)))
    assert found["gamma"].drawn == pytest.approx(min(mu, 180 - mu), abs=1e-6)
    assert found["alpha"].drawn + found["gamma"].drawn == pytest.approx(90.0, abs=1e-9)


def test_an_angle_that_is_zero_by_the_build_is_not_said_to_be_measured() -> None:
    told = {name: "".join(step.words.zh for step in drawn(name).construction.steps) for name in ("8-2g", "8-2a")}
    assert "力与速度方向重合" in told["8-2g"] and "量得" not in told["8-2g"]
    assert "量得：" in told["8-2a"] and "重合" not in told["8-2a"]
