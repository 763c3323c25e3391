"""What a line goes on with has been given, measured or worked out before, and stands for one thing alone."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest

import vecpoly
from tests.at_once import exactly
from tests.drawn_library import LIBRARY, drafted, given
from tests.each import Later, each
from tests.studies import studied
from vecpoly.algebra.formula import plain
from vecpoly.board.paper.marks import AngleMark, Point
from vecpoly.mechanism.model import Drive, Mechanism, Prismatic
from vecpoly.mechanism.rams import driven_joint, stretched
from vecpoly.report.question.sketch import sketched
from vecpoly.solution import Solution

_NEGATIVE = re.compile(r"由数据表查得（直线内插）\$(\S+)\$ = −")


def _solved(name: str) -> Solution:
    found = drafted(name)
    assert found is not None
    return found


def _lines(name: str) -> list[str]:
    return [plain(line) for step in _solved(name).construction.steps for line in step.formulas]


def _said(name: str) -> list[str]:
    return [step.words.zh for step in _solved(name).construction.steps]


def _mechanisms() -> Iterator[tuple[str, Mechanism]]:
    for name in LIBRARY:
        if isinstance(subject := given(name).subject, Mechanism):
            yield name, subject


def _in_turns() -> Iterator[str]:
    return (name for name, mech in _mechanisms() if any(drive.in_turns for drive in mech.drives))


def _cylinder(mech: Mechanism) -> Drive | None:
    return next((one for one in mech.drives if isinstance(driven_joint(mech, one), Prismatic) and one.between), None)


def _rammed() -> Iterator[str]:
    return (name for name, mech in _mechanisms() if (ram := _cylinder(mech)) is not None and stretched(mech, ram))


@each(Later(_in_turns))
def test_a_speed_in_turns_a_minute_is_worked_out_before_its_angular_velocity_is_used(name: str) -> None:
    lines = [line for line in _lines(name) if "ω_1" in line]
    assert not lines or lines[0].startswith("ω_1 = (π\u2009n_1)/(30) = ")


@each(Later(_rammed))
def test_the_length_of_a_cylinder_that_is_given_is_not_read_off_the_diagram(name: str) -> None:
    mech = dict(_mechanisms())[name]
    ram = _cylinder(mech)
    assert ram is not None
    letters = "".join(stretched(mech, ram))
    assert not [line for line in _lines(name) if line.startswith(f"l_{letters} = μ_l")]


def test_a_load_that_a_table_gives_with_its_minus_has_none_before_its_symbol() -> None:
    """F = −39.3 N: P_F = F v is negative where v is along F; −F v told the opposite."""
    name = "engine-flywheel"
    loads = [found[1] for text in _said(name) if (found := _NEGATIVE.search(text)) is not None]
    powers = [line for line in _lines(name) if line.startswith("P_")]
    assert loads and powers
    assert not [line for line in powers for load in loads if f"= −{load}" in line]


@each(("three-legged-plate", "class-iii-slides"))
def test_where_the_lines_through_a_special_point_meet_is_told(name: str) -> None:
    special = [text for text in _said(name) if "求特殊点" in text]
    assert special and all("两线交于" in text for text in special)


def test_lines_that_pass_through_a_pin_do_not_meet_at_an_angle() -> None:
    """The normal at a roller passes through its pin, at which the load acts: B is that point, however small the angle
    is."""
    told = [text for text in _said("cam-roller-load") if "取构件 2 为分离体" in text]
    assert told and all("均过 $B$" in text and "交角" not in text for text in told)


def test_the_given_position_is_told_as_it_is_given() -> None:
    """127.35° is neither 127.3° nor 127.4°; an extreme value keeps its tenth."""
    study = studied("C-conveyor")
    assert study.where(study.mech.drive.position).endswith("= 127.35°")
    assert re.fullmatch(r".*= \d+\.\d°", study.where(study.mech.drive.position + 0.123456))


def test_that_two_points_coincide_is_told_of_velocities_too() -> None:
    """Crank and frame in one line: nothing slides, and so there is no Coriolis term."""
    assert any("重合，故 $v_{B3B2}$ = 0" in text.replace("_B3B2", "_{B3B2}") for text in _said("3-7c"))


def test_the_sketch_of_what_is_given_has_no_angle_that_is_worked_out_of_a_function() -> None:
    """The precision points are found on paper, and so are ψ_1, ψ_2, ψ_3."""
    one = _solved("function-log")
    figure = sketched(one.problem, one.construction, 120.0, 70.0)
    assert figure is not None
    labels = {mark.label for mark in figure.marks if isinstance(mark, Point | AngleMark)}
    assert {"A", "D"} <= labels and not [label for label in labels if label[:1] in "MNφψ" and label]


BESIDE = """
id: offset
title: a cylinder whose rod passes beside its pin
frame: {A: [0 mm, 0 mm], D: [-17 mm, 7 mm]}
links: {1: {AC: 106 mm}, 2: {rod: D}, 3: {block: C}}
joints: [3 slides on 2 with C 36 mm right]
input: {cylinder: 2-3, s: 119.01 mm, v: 0.3 m/s, a: -0.5 m/s^2}
branch: [C right of AD]
find: [v_C, a_C, omega_2, alpha_2]
"""


def test_the_length_of_a_cylinder_is_the_distance_of_its_hinges_only_where_its_rod_passes_through_both() -> None:
    found = exactly(vecpoly.loads(BESIDE))
    assert all(one.drawn == pytest.approx(one.exact, rel=1e-9) for one in found.answers.values())
