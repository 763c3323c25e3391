"""The angle of the crank is told of a ray from its pivot, from the x axis or from a line of the frame: everything that
speaks of it speaks of that angle, however the letters of the crank stand and however the frame lies."""

from __future__ import annotations

import cmath
import math

import pytest

import vecpoly
from vecpoly.check.truth import exact_values
from vecpoly.findings.study.study import study
from vecpoly.problem.problem import Problem
from vecpoly.report.course.statement import counted

WAYS = [(bar, lean) for bar in ("AB", "BA") for lean in (0, 35, -160)]
RUN = "machine: {start: {phi: 30 deg, omega: -1 rad/s}, until: 360 deg, at: [90 deg]}\n"
STEADY = "machine: {n: 60 r/min, delta: 0.05}\n"
PUSH = "M_1: {on: 1, size: 3 N*m cw}, "


def crank(
    bar: str, lean: float, find: str, more: str = "", loads: str = "", masses: str = "inertia: 0.1 kg*m^2"
) -> Problem:
    d = 80 * cmath.exp(1j * math.radians(lean))
    return vecpoly.loads(
        f"""
id: t
title: t
frame: {{A: [0 mm, 0 mm], D: [{d.real:.10f} mm, {d.imag:.10f} mm]}}
links: {{1: {{{bar}: 30 mm}}, 2: {{BC: 90 mm}}, 3: {{DC: 60 mm}}}}
input: {{link: 1, phi: 60 deg from AD, n: 60 r/min cw}}
branch: [C left of BD]
loads: {{{loads}M_3: {{on: 3, size: 2 N*m cw, during: [300 deg, 200 deg]}}}}
masses: {{1: {{mass: 1 kg, {masses}, centre: A}}}}
{more}find: [{find}]
"""
    )


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_a_machine_starts_and_ends_where_it_is_told(bar: str, lean: float) -> None:
    keys = "phi_end, t_end, omega_at_90"
    found, plain = (exact_values(crank(b, at, keys, RUN, PUSH)) for b, at in ((bar, lean), ("AB", 0.0)))
    assert found["phi_end"] == pytest.approx(30 - 360, abs=1e-6)
    assert [found[key] for key in found] == pytest.approx([plain[key] for key in found], rel=1e-7)


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_where_it_is_fastest_is_told_in_the_same_way(bar: str, lean: float) -> None:
    loads = "M_d: {on: 1, size: constant}, "
    found, plain = (
        exact_values(crank(b, at, "M_d, phi_max, phi_min", STEADY, loads)) for b, at in ((bar, lean), ("AB", 0.0))
    )
    assert [found[key] for key in found] == pytest.approx([plain[key] for key in found], rel=1e-6)


@pytest.mark.parametrize(("bar", "lean"), [("BA", 35), ("AB", -160)])
def test_and_so_it_is_drawn(bar: str, lean: float) -> None:
    loads = "M_d: {on: 1, size: constant}, "
    problem = crank(bar, lean, "M_d, phi_max, phi_min", STEADY, loads)
    solution = vecpoly.solve(problem, by="exact", repeats=0, precise=False)
    for one in solution.answers.values():
        assert one.drawn == pytest.approx(one.exact, rel=1e-6)


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_the_step_lays_off_the_angle_that_is_given_and_says_from_which_line(bar: str, lean: float) -> None:
    problem = crank(bar, lean, "M_1, v_C", loads='M_1: {on: 1, size: "?"}, ')
    solution = vecpoly.solve(problem, by="exact", repeats=0, precise=False)
    said = " ".join(step.words.en for step in solution.construction.steps)
    assert "$φ_1$ = 60° to" in said
    assert "The position $φ_{1}$ = 60° lies within 300° to 200°" in said
    if lean or bar == "BA":
        assert ("$φ_1$ = 60° to $AD$" in said) == (lean != 0 or bar == "BA")
    given = [datum.of("en") for datum in problem.given.motion]
    assert any("from $AD$" in one for one in given) == ("to $AD$" in said)


@pytest.mark.parametrize(("bar", "lean", "told"), [("AB", 0, False), ("BA", 0, True), ("AB", 35, True)])
def test_a_course_report_tells_how_its_angles_count_where_the_problem_counts_otherwise(
    bar: str, lean: float, told: bool
) -> None:
    problem = crank(bar, lean, "M_1, v_C", loads='M_1: {on: 1, size: "?"}, ')
    found = study(vecpoly.solve(problem, by="exact", repeats=0, precise=False))
    assert ("the given $φ_1$ = 60° (from $AD$) is" in counted(found).en) == told
