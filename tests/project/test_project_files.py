"""What is refused in a project file: told with file, line, both languages, and what to do."""

from __future__ import annotations

import re
from math import tau
from pathlib import Path

import pytest

from tests.laws import few
from tests.sources import ROOT
from vecpoly.devices.cams.cam import Cam
from vecpoly.errors import ProblemFileError
from vecpoly.project.project import load_project

GOOD = """\
title: A feeder
statement: Find it.
parts:
  linkage:
    title: The linkage
    synthesis: slider-crank
    data: {K: 1.25, H: 160 mm, e: 50 mm}
    find: [theta, AB, BC]
  motion:
    title: Its motion
    of: linkage
    round: 1 mm
    input: {phi: 250 deg, omega: 2 rad/s ccw}
    works: {load: F_r, from: 20 %}
    loads:
      F_r: {on: 3, at: C, size: 600 N, direction: 180 deg, role: resisting}
      M_1: {on: 1, size: "?", role: driving}
    find: [v_C, M_1]
demands:
  - motion.K = 1.25 within 1 %
"""


def solved(tmp_path: Path, old: str, new: str) -> None:
    assert old in GOOD
    path = tmp_path / "feeder.yaml"
    path.write_text(GOOD.replace(old, new), encoding="utf-8")
    load_project(path)


def test_the_file_that_is_damaged_below_is_sound(tmp_path: Path) -> None:
    solved(tmp_path, "Find it.", "Find it.")


@pytest.mark.parametrize(
    ("old", "new", "line", "said"),
    [
        ("of: linkage", "of: linkages", 11, "no earlier part called 'linkages'.*did you mean 'linkage'"),
        ("round: 1 mm", "round: 1 kg", 11, "'1 kg' is not a length"),
        ("phi: 250 deg", "phi: <linkage.psi>", 13, "no quantity 'linkage.psi'; known here: linkage.theta"),
        ("phi: 250 deg", "phi: <linkage.theta + linkage.AB>", 13, "different kinds"),
        ("phi: 250 deg", "phi: <linkage.theta / 0>", 13, "divides by zero"),
        ("phi: 250 deg", "phi: <motion.K * 90 deg>", 13, "no quantity 'motion.K'"),
        ("phi: 250 deg", "phi: <2 ** 99>", 13, "cannot be read"),
        ("phi: 250 deg", "phi: 60 deg", 14, "F_r does not act at the given position, 60°.*choose phi there"),
        ("direction: 180 deg", "direction: 90 deg", 14, "resists nowhere"),
        ("load: F_r,", "load: F_x,", 14, "no force of known size is called 'F_x'; known: F_r"),
        ("from: 20 %", "from: 20 %, to: 10 %", 14, "from 20% must be less than to 10%"),
        ("from: 20 %", "from: 20 %, to: 20 %", 14, "from 20% must be less than to 20%"),
        ("from: 20 %", "from: 20 mm", 14, "'20 mm' must be a number between"),
        ("from: 20 %", "from: -1 %", 14, "'-1 %' must be a number between 0 and 1"),
        ("from: 20 %", "from: 20 %, to: 101 %", 14, "'101 %' must be a number between 0 and 1"),
        ("    round: 1 mm\n", "    round: 1 mm\n    unevenness: 51 %\n", 12, "'51 %' must .* between 1e-06 and 0.5"),
        ("    round: 1 mm\n", "    round: 1 mm\n    unevenness: 0\n", 12, "'0' must .* between 1e-06 and 0.5"),
        ("from: 20 %", "form: 20 %", 14, "unknown key 'form'"),
        ("    find: [v_C, M_1]", "    also: [3 m]\n    find: [v_C, M_1]", 18, "not an angle"),
        ("    find: [theta", "    also: [3 deg]\n    find: [theta", 8, "'also' is for mechanisms only"),
        (
            "motion.K = 1.25 within 1 %",
            "linkage.theta = 20 deg",
            20,
            "would hold whatever linkage is found.*motion.theta",
        ),
        ("motion.K = 1.25 within 1 %", "motion.K is 1.25", 20, "is no demand; write e.g."),
        ("motion.K = 1.25 within 1 %", "motion.K <= 30 deg", 20, "of different kinds"),
        ("title: A feeder\n", "", 1, "'title' is missing"),
        ("data: {K: 1.25", "data: {K: 0.25", 7, "K = 0.25"),
        ("phi: 250 deg", "phi: 518 deg", 14, "F_r does not act at the given position, 158°"),
        (
            "synthesis: slider-crank\n    data: {K: 1.25, H: 160 mm, e: 50 mm}\n    find: [theta, AB, BC]",
            "synthesis: crank-rocker\n    data: {K: 1.73, CD: 156 mm, swing: 55 deg, AD: 226 mm}\n    find: [AB, BC]",
            5,
            "No linkage satisfies the conditions.*l_AD may be 25.06 to 204 mm",
        ),
    ],
)
def test_a_fault_is_told_with_its_line(tmp_path: Path, old: str, new: str, line: int, said: str) -> None:
    with pytest.raises(ProblemFileError) as refused:
        solved(tmp_path, old, new)
    (fault,) = refused.value.faults
    assert fault.place is not None
    assert abs(fault.place.line - line) <= 1, fault.place
    assert re.search(said, str(refused.value.words.en)), refused.value.words.en
    assert re.search("[\u4e00-\u9fff]", refused.value.words.zh)


def test_the_whole_stroke_and_the_greatest_unevenness_are_within_the_bounds(tmp_path: Path) -> None:
    solved(tmp_path, "from: 20 %}", "from: 0 %, to: 100 %}\n    unevenness: 50 %")


def test_a_demand_that_fails_is_no_error_but_said(tmp_path: Path) -> None:
    path = tmp_path / "feeder.yaml"
    path.write_text(GOOD.replace("K = 1.25 within", "K = 1.4 within"), encoding="utf-8")
    (demand,) = load_project(path).demands
    assert not demand.holds


@pytest.mark.parametrize("manual", few(["problem-file.zh.md", "problem-file.md"], 2))
def test_the_project_of_the_manual_is_solved_and_meets_its_demands(manual: str, tmp_path: Path) -> None:
    text = (ROOT / "docs" / manual).read_text(encoding="utf-8")
    (block,) = [one for one in re.findall(r"```yaml\n(.*?)```", text, re.S) if "\nparts:" in one]
    path = tmp_path / "feeder.yaml"
    path.write_text(block, encoding="utf-8")
    assert [one.holds for one in load_project(path).demands] == [True, True]


CAM = """\
  cam:
    title: Its cam
    device: cam
    data:
      follower: {roller: 10 mm}
      r0: 50 mm
      turns: ccw
      motion:
        - rise 25 mm in <(180 deg - linkage.theta) / 2> cosine
        - return in <(180 deg - linkage.theta) / 2> parabolic
        - dwell <180 deg + linkage.theta>
    find: [alpha_rise]
"""


@pytest.mark.parametrize("advance", few(["1.17", "1.3", "1.35", "1.42"], 2))
def test_a_cam_whose_angles_follow_from_any_time_ratio_closes_its_turn(advance: str, tmp_path: Path) -> None:
    """Three angles, each put in with six digits, missed 360° by some 10⁻⁴."""
    path = tmp_path / "feeder.yaml"
    path.write_text(GOOD.replace("K: 1.25", f"K: {advance}").replace("demands:", f"{CAM}demands:"), encoding="utf-8")
    cam = load_project(path).parts[-1].problem.device
    assert isinstance(cam, Cam) and cam.pieces[-1].end == tau


def test_angles_that_miss_a_turn_by_more_than_their_digits_are_refused(tmp_path: Path) -> None:
    path, cam = tmp_path / "feeder.yaml", CAM.replace("dwell <180 deg", "dwell <180.01 deg")
    path.write_text(GOOD.replace("demands:", f"{cam}demands:"), encoding="utf-8")
    with pytest.raises(ProblemFileError, match=r"take away 0\.01 deg"):
        load_project(path)
