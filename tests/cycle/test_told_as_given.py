"""What a cycle, its tables and curves, and a slider tell of the drive's angle is told as the problem tells it: of the
ray from the pivot, from the line that is named; what is told there does not change with how the letters stand."""

from __future__ import annotations

import cmath
import math
import re
from pathlib import Path

import numpy as np
import pytest

import vecpoly
from tests.ggb_reader import construction, evaluated
from vecpoly.check.table.whole import check_table
from vecpoly.cycle import csv_bytes, cycle, facts, sentences, table
from vecpoly.export.geogebra.document import to_ggb
from vecpoly.export.recording import record
from vecpoly.findings.study.study import Study
from vecpoly.problem.problem import Problem
from vecpoly.project.part import Told

WAYS = [(bar, lean) for bar in ("AB", "BA") for lean in (0, 35, -160)]
PLAIN = ("AB", 0)


def crank(bar: str, lean: float, find: str = "omega_3, M_1", more: str = "", phi: float = 60) -> Problem:
    d = 80 * cmath.exp(1j * math.radians(lean))
    return vecpoly.loads(
        f"""
id: t
title: t
frame: {{A: [0 mm, 0 mm], D: [{d.real:.10f} mm, {d.imag:.10f} mm]}}
links: {{1: {{{bar}: 30 mm}}, 2: {{BC: 90 mm}}, 3: {{DC: 60 mm}}}}
input: {{link: 1, phi: {phi} deg from AD, n: 60 r/min ccw}}
branch: [C left of BD]
{more or 'loads: {M_3: {on: 3, size: 2 N*m cw}, M_1: {on: 1, size: "?"}}'}
find: [{find}]
"""
    )


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_a_table_begins_where_the_told_angle_is_0_and_is_the_same_table(bar: str, lean: float) -> None:
    keys = ("phi_1", "omega_3", "M_1")
    one, other = (table(cycle(crank(*way), 73), keys).values for way in ((bar, lean), PLAIN))
    assert one[:, 0] == pytest.approx(np.arange(0, 361, 5), abs=1e-9)
    assert one == pytest.approx(other, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_a_table_that_is_written_is_found_right_where_it_is_checked(bar: str, lean: float, tmp_path: Path) -> None:
    problem, path = crank(bar, lean), tmp_path / "t.csv"
    path.write_bytes(csv_bytes(table(cycle(problem, 37), ("omega_3", "alpha_3", "M_1"))))
    checked = check_table(problem, path)
    assert len(checked.columns) == 3 and checked.agrees


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_the_places_that_sentences_tell_are_those_of_the_told_angle(bar: str, lean: float) -> None:
    one, other = (
        [
            sorted(re.findall(r"φ_\{1\}\$ = ([^）)]+)", words.zh))
            for words in sentences(turn, facts(turn))
            if "φ_{1}" in words.zh
        ]
        for turn in (cycle(crank(*way)) for way in ((bar, lean), PLAIN))
    )
    assert one == other and len(one) >= 2


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_the_drive_stands_where_a_refusal_says_that_it_stands(bar: str, lean: float) -> None:
    problem = crank(bar, lean, "omega_3", "scales: {}", phi=0)
    with pytest.raises(vecpoly.VecpolyError, match=r"drive stands at 0°"):
        vecpoly.solve(vecpoly.loads(problem.text.replace("BC: 90", "BC: 9")))


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_the_limits_of_the_rocker_are_told_so_as_drawn_and_in_truth(bar: str, lean: float) -> None:
    found, plain = (
        vecpoly.solve(
            crank(letters, at, "phi_C_extended, phi_C_overlapped", "method: centres"),
            by="exact",
            repeats=0,
            precise=False,
        ).answers
        for letters, at in ((bar, lean), PLAIN)
    )
    for key, one in found.items():
        assert one.exact == pytest.approx(plain[key].exact, abs=1e-6)
        assert one.exact == pytest.approx({"phi_C_extended": 26.384, "phi_C_overlapped": 228.190}[key], abs=1e-3)
        assert one.drawn == pytest.approx(one.exact, abs=1e-6)


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_the_slider_of_a_moving_drawing_stands_at_the_given_angle(bar: str, lean: float) -> None:
    problem = crank(bar, lean, "omega_3", "scales: {}")
    made = to_ggb(record(problem))
    told = next(one for one in construction(made) if one.find("slider") is not None)
    number, ends = told.find("value"), told.find("slider")
    assert number is not None and ends is not None
    found = [float(text) for text in (number.get("val", ""), ends.get("min", ""), ends.get("max", ""))]
    assert found == pytest.approx([60, 0, 360])
    omega = vecpoly.solve(problem, by="exact", repeats=0, precise=False).answers["omega_3"]
    assert evaluated(made)["ω_{3}"] == pytest.approx(omega.drawn)


@pytest.mark.parametrize(("bar", "lean"), WAYS)
def test_a_part_of_a_project_is_headed_by_the_given_angle_and_a_course_by_that_of_its_equations(
    bar: str, lean: float
) -> None:
    solution = vecpoly.solve(crank(bar, lean), by="exact", repeats=0, precise=False)
    part, course = Told(solution, solution), Study(solution, solution)
    drive = solution.problem.mechanism.drive
    assert part.where(drive.position) == "$φ_{1}$ = 60°"
    for one, zero in ((part, drive.lead), (course, 0.0)):
        rows = one.turn.phi[one.rows]
        assert rows - zero == pytest.approx(np.radians(np.arange(0, 361, 10)))
        assert one.whole.drive.told(rows)[:3] == pytest.approx([0, 10, 20])
