"""The library: every file loads, and says what the exercise says."""

from __future__ import annotations

import cmath
import math
import subprocess
import sys
from functools import cache

import pytest

from tests.each import each
from vecpoly.foundation.data import data_dir
from vecpoly.mechanism.model import FRAME, Circle, Mechanism, Prismatic, Rack, Rolling, Side, SideOf
from vecpoly.problem.asked.asks import AskCoriolis, AskPoint, AskRel
from vecpoly.problem.library import library, natural
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem, Shape
from vecpoly.problem.template import template_text

TITLES = {entry.id: entry.title for entry in library()}
IDS = [*TITLES]
CH3 = {f"3-{n}" for n in ("4a", "4a-straight", "4b", "5", "5-xD400", "6", *range(8, 15))}
CH3 |= {f"3-7{letter}" for letter in "abcde"} | {"C-conveyor", "ex10"}


def modules_after(code: str) -> set[str]:
    """Names of all modules that a fresh Python has loaded after running this."""
    run = [sys.executable, "-c", f"{code}; print(*sys.modules)"]
    return set(subprocess.run(run, capture_output=True, text=True, check=True).stdout.split())


def sliding(problem: Problem) -> list[Prismatic]:
    return [joint for joint in problem.mechanism.joints if isinstance(joint, Prismatic)]


def test_every_exercise_of_chapter_3_is_there() -> None:
    assert set(IDS) >= CH3
    assert [i for i in IDS if i.startswith("3-")] == sorted((i for i in IDS if i.startswith("3-")), key=natural)


@cache
def problem_of(name: str) -> Problem:
    return load(name)


@each(IDS)
def test_every_file_loads_with_both_languages_and_something_to_find(name: str) -> None:
    problem = problem_of(name)
    assert problem.id == name and problem.asks and problem.path is not None
    assert problem.title.zh and problem.title.en and problem.statement.zh and problem.statement.en
    assert problem.statement.zh != problem.statement.en
    assert not isinstance(problem.subject, Mechanism) or len(problem.mechanism.drives) == 1


@each(IDS)
def test_every_number_that_is_given_is_told_with_its_symbol_or_in_words(name: str) -> None:
    assert all(datum.symbol or datum.words for datum in problem_of(name).given.data)


@each(IDS)
def test_the_cheap_head_tells_the_title_of_the_file(name: str) -> None:
    assert TITLES[name] == problem_of(name).title


def test_the_six_bar_of_problem_27_takes_fifteen_lines() -> None:
    text = (data_dir("problems") / "homework" / "A-27.yaml").read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 15


def test_an_id_a_chapter_and_id_and_a_path_name_one_problem() -> None:
    path = data_dir("problems") / "ch3" / "3-9.yaml"
    assert load("3-9") == load("ch3/3-9") == load(path) == load(str(path))


def test_swinging_block_has_a_rod_that_passes_through_the_block() -> None:
    problem = load("3-9")
    (guide,) = sliding(problem)
    assert (guide.guide, guide.block, guide.pin, guide.offset, guide.through) == ("2", "3", "C", 0.0, "B")
    assert dict(problem.mechanism.link("2").points) == {"B": 0, "D": 0.05, "E": 0.05 + 0.04j}
    assert problem.given.shapes["2"] is Shape.ROD and problem.given.shapes["3"] is Shape.BLOCK
    assert problem.mechanism.drive.rate == -10
    assert [(d.symbol, d.text) for d in problem.given.lengths] == [
        ("l_AB", "30 mm"), ("l_BD", "50 mm"), ("l_DE", "40 mm")]  # fmt: skip
    assert problem.scales.given == {"mu_l": 0.002, "mu_v": 0.006, "mu_a": 0.03}


def test_offset_guide_keeps_the_pin_left_of_the_line() -> None:
    (guide,) = sliding(load("3-10"))
    assert (guide.guide, guide.block, guide.pin, guide.offset, guide.through) == ("3", "2", "B", 0.025, "C")


def test_translating_bar_has_its_slot_turned_against_the_guide() -> None:
    in_slot, fixed = sliding(load("3-14"))
    assert (in_slot.guide, in_slot.block) == ("3", "2")
    assert (fixed.guide, fixed.block, fixed.pin) == (FRAME, "3", "C")
    assert fixed.turn == pytest.approx(math.radians(120))


def test_what_is_beside_a_guide_and_how_it_is_turned_may_be_said_in_either_order() -> None:
    text = """
id: order
title: {zh: 次序, en: Order}
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {block: B}, 3: {CD: 80 mm, F: {along: CD, at: 40 mm, left: 20 mm}, slot: C}}
joints: [2 slides in 3, 3 slides on y = -50 mm SAID]
input: {link: 1, phi: 70 deg, omega: 10 rad/s cw}
find: [p_B, p_C]
"""
    said = ("with F 10 mm left turned 30 deg", "turned 30 deg with F 10 mm left")
    one, other = (loads(text.replace("SAID", words)).mechanism for words in said)
    assert one == other and sliding(loads(text.replace("SAID", said[1])))[1].offset == 0.01


def test_guide_rod_drives_the_sleeve() -> None:
    problem = load("3-11")
    sleeve, fixed = sliding(problem)
    assert (sleeve.guide, sleeve.block, sleeve.pin) == ("1", "2", "B")
    assert fixed.origin == 0.09j and fixed.direction == pytest.approx(math.radians(-12))
    assert problem.mechanism.link("2").points["D"] == pytest.approx(cmath.rect(0.07, math.radians(80)))
    assert problem.mechanism.drive.position == pytest.approx(math.radians(57))


def test_gears_roll_on_the_rack_and_on_each_other() -> None:
    on_rack, mesh = [joint for joint in load("3-13").mechanism.joints if isinstance(joint, Rolling)]
    assert on_rack.on == Rack(link=FRAME, origin=0j, direction=0.0) and on_rack.side is Side.LEFT
    assert mesh.gear == Circle(link="4", centre="E", radius=0.03)
    assert mesh.on == Circle(link="3", centre="C", radius=0.06) and not mesh.internal


def test_midpoint_is_laid_off_from_the_far_end() -> None:
    assert load("3-5").mechanism.link("2").points["E"] == pytest.approx(0.3)
    assert load("3-5").mechanism.frame["D"] == 0.6 + 0.5j
    assert load("3-5-xD400").mechanism.frame["D"] == 0.4 + 0.5j


def test_rocker_at_its_extreme_has_the_crank_at_right_angles() -> None:
    crank = cmath.rect(0.05, load("3-7b").mechanism.drive.position)
    assert (crank.conjugate() * (crank + 0.11j)).real == pytest.approx(0, abs=1e-17)


def test_points_with_given_velocity_are_asked_by_name() -> None:
    asks = load("3-6").asks
    points = [ask for ask in asks if isinstance(ask, AskPoint)]
    assert [str(ask.rel) for ask in points] == ["p_X1", "p_X2", "p_X3", "p_M2", "p_Q2"]
    assert points[0].velocity == -0.25 + 0.14j and points[3].velocity == 0 and points[4].acceleration == 0
    assert {"a_M2", "v_Q2"} <= {str(ask.rel) for ask in asks if isinstance(ask, AskRel)}


def test_coriolis_is_asked_as_a_question() -> None:
    questions = [ask for name in ("3-7a", "3-7e") for ask in load(name).asks if isinstance(ask, AskCoriolis)]
    assert [str(ask.rel) for ask in questions] == ["ak_B3B2", "ak_C2C3"]


def test_a_length_on_paper_is_read_with_its_scale() -> None:
    reading = next(p for p in load("3-9").printed if p.paper_mm == pytest.approx(41.1))
    assert reading.value == pytest.approx(0.2466) and reading.scale == pytest.approx(0.006)


def test_revolutions_per_minute_and_an_angle_from_the_frame_line() -> None:
    drive = load("C-conveyor").mechanism.drive
    assert drive.rate == pytest.approx(2 * math.pi * 40 / 60)
    assert drive.position == pytest.approx(math.radians(127.35))


def test_the_four_assemblies_of_problem_27_differ_in_pivot_and_branch() -> None:
    kinds = {
        (load(name).mechanism.frame["G"].real, side.side)
        for name in ("A-27", "A-27-b", "A-27-c", "A-27-d")
        if isinstance(side := load(name).mechanism.branches[0], SideOf)
    }
    assert len(kinds) == 4


def test_the_file_that_new_writes_loads() -> None:
    assert len(loads(template_text()).mechanism.links) == 3


def test_asks_and_problem_come_without_pydantic_yaml_and_pint() -> None:
    loaded = modules_after(
        "import sys, vecpoly.problem.problem; from vecpoly.problem.library import library; library()"
    )
    assert not {"pydantic", "ruamel.yaml", "pint"} & loaded


def test_the_library_loads_without_pint() -> None:
    loaded = modules_after("import sys; from vecpoly.problem.load import load; load('3-9'); load('C-conveyor')")
    assert "pint" not in loaded and "ruamel.yaml" not in loaded and "yaml" in loaded
