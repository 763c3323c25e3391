"""The format: every way to write a link, a joint, a motion, a branch, a unit."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest

from vecpoly.errors import ProblemFileError
from vecpoly.limits import FAULTS
from vecpoly.mechanism.model import Prismatic, Rack, Revolute, Side, SideOf
from vecpoly.problem.assignment import is_assignment, load_assignment
from vecpoly.problem.editors import json_schema
from vecpoly.problem.joints.branches import read_branch
from vecpoly.problem.joints.joints import read_joint
from vecpoly.problem.joints.rolling import read_rolling
from vecpoly.problem.links.bodies import Bodies
from vecpoly.problem.links.draft import Draft
from vecpoly.problem.links.links import read_link
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem, Shape
from vecpoly.units.names import _COMMON, unit_by_pint
from vecpoly.units.reading import Dim, read

FOUR_BAR = """\
id: t
title: test
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 100 mm}
  3: {CD: 80 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
branch: [C above AD]
find: [v_C]
"""


def four_bar(old: str = "", new: str = "") -> Problem:
    return loads(FOUR_BAR.replace(old, new) if old else FOUR_BAR)


def bodies(**links: dict[str, object]) -> Bodies:
    drafts: dict[str, Draft] = {name[1:]: read_link(name[1:], data) for name, data in links.items()}
    return Bodies({"A": 0j, "K": 0.09j}, drafts)


def test_triangle_by_two_lengths_lies_on_the_side_named() -> None:
    data = {"BC": "50 mm", "E": {"BE": "30 mm", "CE": "40 mm", "side": "left of BC"}}
    assert read_link("2", data).points["E"] == pytest.approx(0.018 + 0.024j)
    data["E"] = {"BE": "30 mm", "CE": "40 mm", "side": "right of BC"}
    assert read_link("2", data).points["E"] == pytest.approx(0.018 - 0.024j)
    data["E"] = {"CE": "40 mm", "BE": "30 mm", "side": "left of CB"}
    assert read_link("2", data).points["E"] == pytest.approx(0.018 - 0.024j)


def test_point_by_angle_counts_counter_clockwise_unless_said_otherwise() -> None:
    ccw = read_link("2", {"BC": "50 mm", "E": {"BE": "20 mm", "angle": "90 deg from BC"}})
    cw = read_link("2", {"BC": "50 mm", "E": {"BE": "20 mm", "angle": "90 deg cw from BC"}})
    far = read_link("2", {"BC": "50 mm", "E": {"CE": "20 mm", "angle": "90 deg from CB"}})
    assert ccw.points["E"] == pytest.approx(0.02j) and cw.points["E"] == pytest.approx(-0.02j)
    assert far.points["E"] == pytest.approx(0.05 - 0.02j)


def test_point_by_offsets_right_and_backwards() -> None:
    link = read_link("2", {"BC": "50 mm", "E": {"along": "CB", "at": "60 mm", "right": "5 mm"}})
    assert link.points["E"] == pytest.approx(-0.01 + 0.005j)


def test_collinear_triangle_is_no_fault() -> None:
    data = {"BC": "50 mm", "E": {"BE": "30 mm", "CE": "20 mm", "side": "left of BC"}}
    assert read_link("2", data).points["E"] == pytest.approx(0.03, abs=1e-9)


def test_slot_may_be_inclined_or_beside_its_pin() -> None:
    inclined = read_link("3", {"CD": "80 mm", "slot": {"through": "D", "angle": "60 deg from CD"}})
    assert inclined.line is not None and inclined.line.direction == pytest.approx(math.radians(60))
    assert inclined.line.origin == pytest.approx(0.08)
    beside = read_link("3", {"slot": {"through": "C", "left": "31 mm"}})
    assert beside.line is not None and beside.line.origin == pytest.approx(0.031j)
    assert beside.shape is Shape.SLOT


@pytest.mark.parametrize(
    ("text", "guide", "block", "pin"),
    [
        ("4 slides in 5", "5", "4", "F"),
        ("2 passes through 4", "2", "4", "F"),
        ("4 slides on BE", "2", "4", "F"),
        ("4 slides on BE of 2", "2", "4", "F"),
        ("B of 2 slides on 5", "5", "2", "B"),
        ("4 slides on AK", "0", "4", "F"),
        ("4 slides on x = 5 mm", "0", "4", "F"),
        ("4 slides along line through K at -12 deg", "0", "4", "F"),
    ],
)
def test_sliding_joints(text: str, guide: str, block: str, pin: str) -> None:
    joint = read_joint(text, bodies(_2={"BE": "50 mm"}, _4={"block": "F"}, _5={"slot": "G"}))
    assert isinstance(joint, Prismatic) and (joint.guide, joint.block, joint.pin) == (guide, block, pin)


def test_offset_to_the_right_is_negative() -> None:
    joint = read_joint("4 slides in 5 with F 31 mm right", bodies(_4={"block": "F"}, _5={"slot": "G"}))
    assert isinstance(joint, Prismatic) and joint.offset == -0.031


def test_pin_in_a_slot_brings_its_own_massless_block() -> None:
    text = FOUR_BAR.replace("  2: {BC: 100 mm}\n  3: {CD: 80 mm}", "  2: {slot: D}\njoints: [B runs in 2]")
    problem = loads(text.replace("branch: [C above AD]\n", "").replace("v_C", "v_B2"))
    joint = problem.mechanism.joints[-1]
    assert isinstance(joint, Prismatic) and joint.pin_in_slot and joint.block == "pinB"
    assert problem.given.shapes["pinB"] is Shape.PIN
    assert Revolute(point="B", a="1", b="pinB") in problem.mechanism.joints


def test_three_links_in_one_letter_are_a_compound_hinge_on_the_driving_link() -> None:
    problem = load("3-4a")
    at_b = [j for j in problem.mechanism.joints if isinstance(j, Revolute) and j.point == "B"]
    assert [(j.a, j.b) for j in at_b] == [("1", "2"), ("1", "4")]


def test_rack_on_the_right_and_rack_on_a_link() -> None:
    wheels = bodies(_3={"gear": "C", "radius": "60 mm"}, _5={"rod": "G"})
    below = read_rolling("3 rolls below y = 200 mm at D", wheels)
    moving = read_rolling("3 rolls on 5 at E", wheels)
    assert below.side is Side.RIGHT
    assert isinstance(moving.on, Rack) and moving.on.link == "5"
    ring = read_rolling("3 rolls inside circle about A of 90 mm at P", wheels)
    assert ring.internal


@pytest.mark.parametrize(
    ("text", "side", "ref"),
    [
        ("C above AD", Side.ABOVE, ("A", "D")),
        ("C left of BD", Side.LEFT, ("B", "D")),
        ("C left of B", Side.LEFT, ("B",)),
        ("C 在 AD 上方", Side.ABOVE, ("A", "D")),
        ("C在BD的左侧", Side.LEFT, ("B", "D")),
        ("C 在 B 右边", Side.RIGHT, ("B",)),
    ],
)
def test_branch_in_words(text: str, side: Side, ref: tuple[str, ...]) -> None:
    branch = read_branch(text, "ABCD")
    assert isinstance(branch, SideOf)
    assert (branch.point, branch.side, branch.ref) == ("C", side, ref)


@pytest.mark.parametrize(
    ("text", "dim", "value"),
    [
        ("30 mm", Dim.LENGTH, 0.03),
        ("350 mm", Dim.LENGTH, 0.35),
        ("3 dm", Dim.LENGTH, 0.3),
        ("30毫米", Dim.LENGTH, 0.03),
        ("1.2e-2 m", Dim.LENGTH, 0.012),
        ("0", Dim.LENGTH, 0.0),
        ("-5 mm", Dim.LENGTH, -0.005),
        ("60°", Dim.ANGLE, math.pi / 3),
        ("0.5 rev", Dim.ANGLE, math.pi),
        ("60 度", Dim.ANGLE, math.pi / 3),
        ("10 rad/s ccw", Dim.OMEGA, 10.0),
        ("10 rad/s cw", Dim.OMEGA, -10.0),
        ("10 rad/s 顺时针", Dim.OMEGA, -10.0),
        ("60 rpm", Dim.OMEGA, 2 * math.pi),
        ("60 r/min 逆时针", Dim.OMEGA, 2 * math.pi),
        ("60转/分", Dim.OMEGA, 2 * math.pi),
        ("180 deg/s", Dim.OMEGA, math.pi),
        ("5 rad/s²", Dim.ALPHA, 5.0),
        ("0.5 m/s", Dim.SPEED, 0.5),
        ("2 米/秒", Dim.SPEED, 2.0),
        ("5 mm/s^2", Dim.ACCEL, 0.005),
        ("0.002 m/mm", Dim.MU_L, 0.002),
        ("0.006 (m/s)/mm", Dim.MU_V, 0.006),
        ("0.006 m/s/mm", Dim.MU_V, 0.006),
        ("0.1 (m/s²)/mm", Dim.MU_A, 0.1),
    ],
)
def test_written_units(text: str, dim: Dim, value: float) -> None:
    assert read(text, dim).si == pytest.approx(value, rel=1e-15, abs=0)


@pytest.mark.parametrize("unit", _COMMON)
def test_units_known_by_heart_agree_with_pint(unit: str) -> None:
    factor, dimension = unit_by_pint(unit)
    assert dimension == _COMMON[unit][1] and factor == pytest.approx(_COMMON[unit][0], rel=1e-15)


def test_sliding_input() -> None:
    text = FOUR_BAR.replace("3: {CD: 80 mm}", "3: {block: C}\njoints: [3 slides on y = 0 mm]")
    text = text.replace("{link: 1, phi: 60 deg, omega: 10 rad/s ccw}", "{link: 3, s: 120 mm, v: -0.5 m/s, a: 1 m/s^2}")
    drive = loads(text).mechanism.drive
    assert (drive.slide, drive.link, drive.position, drive.rate, drive.accel) == (True, "3", 0.12, -0.5, 1.0)


def test_crank_written_from_its_far_end_keeps_the_angle_of_the_crank() -> None:
    drive = four_bar("AB: 40", "BA: 40").mechanism.drive
    assert math.remainder(drive.position - math.radians(60 + 180), 2 * math.pi) == pytest.approx(0, abs=1e-12)


def test_schema_is_json_and_forbids_unknown_keys() -> None:
    schema = json.loads(json.dumps(json_schema()))
    assert (
        schema["additionalProperties"] is False and {"required": ["frame", "links", "input"]} in schema["else"]["anyOf"]
    )


def test_byte_order_mark_is_accepted(tmp_path: Path) -> None:
    path = tmp_path / "t.yaml"
    path.write_bytes(b"\xef\xbb\xbf" + FOUR_BAR.encode())
    assert load(path).id == "t"


def test_assignment_with_title_block_and_overrides(tmp_path: Path) -> None:
    path = tmp_path / "sheet.yaml"
    path.write_text(
        "title: {zh: 作业三, en: Assignment 3}\n"
        "title_block: {课程: 机械原理, class: ME-21}\n"
        "problems:\n  - 3-8\n  - ch3/3-9\n"
        "  - {problem: 3-9, id: 3-9-ccw, input: {omega: 10 rad/s ccw}}\n",
        encoding="utf-8",
    )
    sheet = load_assignment(path)
    assert is_assignment(path) and not is_assignment(load("3-9").path or path)
    assert [problem.id for problem in sheet.problems] == ["3-8", "3-9", "3-9-ccw"]
    assert sheet.problems[2].mechanism.drive.rate == 10 and sheet.problems[1].mechanism.drive.rate == -10
    assert sheet.block["course"] == "机械原理" and sheet.block["class"] == "ME-21" and sheet.block["grade"] == ""


def test_the_documented_examples_load(tmp_path: Path) -> None:
    text = (Path(__file__).resolve().parents[2] / "docs" / "problem-file.md").read_text(encoding="utf-8")
    six_bar = text.split("```yaml\n")[1].split("```")[0]
    assert loads(six_bar).mechanism == load("A-27").mechanism
    sheet = tmp_path / "sheet.yaml"
    sheet.write_text(
        next(block for block in text.split("```yaml\n") if "\nproblems:" in block)
        .split("```")[0]
        .replace("  - mine/four-bar.yaml\n", ""),
        encoding="utf-8",
    )
    assert [problem.id for problem in load_assignment(sheet).problems] == ["3-8", "3-9-ccw"]


@pytest.mark.parametrize(
    "link",
    [
        "{slot: {through: A, left: 8 mm}, B: {along: line, at: 30 mm}, disc: B, radius: 12 mm}",
        "{disc: B, radius: 12 mm, B: {along: line, at: 30 mm}, slot: {through: A, left: 8 mm}}",
        "{face: {through: A, left: 5 mm}, B: {along: A, at: 30 mm}, disc: B, radius: 12 mm}",
        "{slot: A, face: {through: A, angle: 20 deg from AB}, B: {along: A, at: 30 mm}, disc: B, radius: 12 mm}",
    ],
)
def test_what_a_link_is_does_not_depend_on_the_order_of_its_keys(link: str) -> None:
    text = (
        f"id: x\ntitle: x\nframe: {{A: [0 mm, 0 mm], C: [60 mm, 0 mm]}}\nlinks: {{1: {link}, 2: {{face: C}}}}\n"
        "joints: [1 touches 2 at K left of the face]\ninput: {link: 1, phi: 50 deg, omega: ccw}\n"
    )
    mech = loads(text).mechanism
    assert mech.link("1").points == {"A": 0j, "B": pytest.approx(0.03)}
    assert mech.contacts[0].disc.radius == pytest.approx(0.012) and mech.contacts[0].disc.centre == "B"


def test_of_very_many_faults_a_message_lists_the_first_and_data_hold_all() -> None:
    asked = ", ".join(f"v_X{n}" for n in range(60))
    with pytest.raises(ProblemFileError) as caught:
        loads(
            "id: x\ntitle: x\nframe: {A: [0 mm, 0 mm]}\nlinks: {1: {AB: 20 mm}}\ninput: {link: 1, phi: "
            f"50 deg, omega: ccw}}\nfind: [{asked}]\n"
        )
    assert len(caught.value.faults) == 60
    assert (
        len(str(caught.value).splitlines()) == FAULTS + 1
        and "and 40 more" in str(caught.value)
        and "另有 40 处" in caught.value.words.zh
    )


@pytest.mark.parametrize(
    "link",
    [
        "{slot: A, G: {AG: 45 mm, angle: 60 deg from line}, E: {along: AG, at: 50 mm}}",
        "{slot: A, E: {along: AG, at: 50 mm}, G: {AG: 45 mm, angle: 60 deg from line}}",
        "{E: {AE: 50 mm, EG: 5 mm, side: left of AG}, slot: A, G: {AG: 45 mm, angle: 60 deg from line}}",
    ],
)
def test_a_ray_to_a_point_that_is_set_out_further_on_goes_to_that_point(link: str) -> None:
    text = (
        "id: x\ntitle: x\nframe: {A: [0 mm, 0 mm], C: [60 mm, 0 mm]}\nlinks: {1: {CB: 20 mm}, 2: {block: "
        f"B}}, 3: {link}}}\njoints: [2 slides in 3]\ninput: {{link: 1, phi: 50 deg, omega: ccw}}\n"
    )
    points = loads(text).mechanism.link("3").points
    assert points["E"] == pytest.approx(points["G"] * 50 / 45)


def test_a_ray_to_a_point_that_is_nowhere_is_refused() -> None:
    text = (
        "id: x\ntitle: x\nframe: {A: [0 mm, 0 mm]}\nlinks: {1: {AB: 20 mm}, 2: {slot: B, E: {along: BZ, at: 50 "
        "mm}}}\ninput: {link: 1, phi: 50 deg, omega: ccw}\n"
    )
    with pytest.raises(ProblemFileError, match=r"links.2: point 'Z' does not exist"):
        loads(text)
