"""Symbols say what is so: how a block is driven, where a guide lies, what is pinned, which force is which."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Disc, Dot, FixedGuide, Point, RightAngle, Role, Vector
from vecpoly.board.paper.tones import whose
from vecpoly.drawing.scene import Fill
from vecpoly.drawing.symbols.around import Surroundings
from vecpoly.drawing.symbols.marks import draw
from vecpoly.mechanism.model import FRAME, Circle, Rolling


def figure(name: str, view: View = View.MECHANISM, called: str = "") -> Figure:
    figures = drawn(name).construction.figures
    return next(one for one in figures if one.view is view and one.name == called)


def place(of: Figure, letter: str) -> complex:
    return next(mark.at for mark in of.marks if isinstance(mark, Point) and mark.label == letter)


def test_a_driving_block_has_an_arrow_with_its_velocity_before_it() -> None:
    mechanism = figure("elliptic-trammel")
    (arrow,) = (mark for mark in mechanism.marks if isinstance(mark, Vector))
    pin = place(mechanism, "A")
    assert arrow.label == "v_{A}" and arrow.a.imag == arrow.b.imag == pin.imag
    assert pin.real < arrow.a.real < arrow.b.real  # to the right, outside the block


@pytest.mark.parametrize(("name", "pin", "far"), [("3-5-xD400", "F", "E"), ("elliptic-trammel", "B", "A")])
def test_a_fixed_guide_lies_on_the_side_on_which_no_rod_leaves_its_block(name: str, pin: str, far: str) -> None:
    mechanism = figure(name)
    at, rod = place(mechanism, pin), place(mechanism, far)
    guide = next(m for m in mechanism.marks if isinstance(m, FixedGuide) and abs((m.a + m.b) / 2 - at) < 5.0)
    along = (guide.b - guide.a) / abs(guide.b - guide.a)
    hatched, leaves = (((z - at) * along.conjugate()).imag for z in (guide.a, rod))
    assert hatched * leaves < 0


def test_a_guide_stays_below_its_block_where_a_rod_leaves_it_at_a_small_angle() -> None:
    mechanism = figure("slider-crank-dynamic")
    at = place(mechanism, "C")
    guide = next(mark for mark in mechanism.marks if isinstance(mark, FixedGuide))
    assert guide.a.imag < at.imag


def test_the_arm_of_the_couple_is_on_the_free_body_of_the_link_whose_moment_is_sought() -> None:
    body = figure("slider-crank-dynamic", View.BODY, "1")
    assert any(isinstance(mark, Point) and mark.label == "h" for mark in body.marks)
    (square,) = (mark for mark in body.marks if isinstance(mark, RightAngle))
    force = next(mark for mark in body.marks if isinstance(mark, Vector) and mark.label == "R_{21}")
    along = (force.b - force.a) / abs(force.b - force.a)
    assert abs(((square.at - force.a) * along.conjugate()).imag) < 1e-6  # it meets the line of that force


def test_a_tangent_circle_has_its_letter_and_the_right_angle_at_which_it_is_touched() -> None:
    mechanism = figure("swinging-block-offset-rod")
    circle = next(mark for mark in mechanism.marks if isinstance(mark, Arc) and mark.role is Role.CONSTRUCTION)
    (square,) = (mark for mark in mechanism.marks if isinstance(mark, RightAngle))
    assert abs(square.at - circle.centre) == pytest.approx(circle.radius)
    assert any(isinstance(mark, Point) and mark.label == "r = e" for mark in mechanism.marks)


def test_on_a_group_a_pin_of_what_was_taken_off_before_is_a_point_of_its_link() -> None:
    groups = [one for one in drawn("2-4").construction.figures if one.name.startswith("group")]
    dots = {one.name: {m.label: m.dot for m in one.marks if isinstance(m, Point)} for one in groups}
    (inner,) = (found for found in dots.values() if {"B", "C", "D", "E"} <= set(found))
    (outer,) = (found for found in dots.values() if "F" in found)
    assert inner["E"] is Dot.POINT and outer["E"] is Dot.JOINT
    assert {inner[letter] for letter in "BD"} == {Dot.JOINT}


@pytest.mark.parametrize(("away", "filled"), [(12.0, False), (20.0, True), (3.0, True), (30.0, True)])
def test_discs_that_cross_have_outlines_alone(away: float, filled: bool) -> None:
    one, other = Disc(centre=0j, radius=12.0), Disc(centre=away + 0j, radius=8.0)
    around = Surroundings.of(View.MECHANISM, (one, other))
    assert any(isinstance(item, Fill) for item in draw(one, around)) is filled


def test_two_forces_in_joints_of_one_problem_have_different_tones_while_there_are_hues() -> None:
    tones = figure("slider-crank-dynamic").tones
    assert tones is not None
    joints = [tones[one] for one in tones if one.startswith("joint ")]
    assert len(joints) == len(set(joints)) == 4
    assert tones["M_1"] not in {tones["F_I2"], tones["F"], tones["F_I3"]}


def test_a_couple_and_its_force_on_the_lever_are_one_vector() -> None:
    assert whose("F_M1") == whose("M_1") and whose("F_MI2") == whose("M_I2") != whose("M_2")


@pytest.mark.parametrize(("name", "inner"), [("planet-drive", False), ("hypocycloid-drive", True)])
def test_a_fixed_gear_is_hatched_along_its_own_rim_on_the_side_of_its_body(name: str, inner: bool) -> None:
    one = drawn(name)
    mechanism, scale = figure(name), figure(name).scale.value
    rolling = next(joint for joint in one.problem.mechanism.joints if isinstance(joint, Rolling))
    fixed = next(c for c in (rolling.gear, rolling.on) if isinstance(c, Circle) and c.link == FRAME)
    centre, radius = place(mechanism, fixed.centre), fixed.radius / scale
    rim = [m for m in mechanism.marks if isinstance(m, FixedGuide) and abs(abs(m.a - centre) - radius) < 1e-6]
    assert len(rim) >= 4
    for mark in rim:
        hatched = -1j * (mark.b - mark.a)  # on the right hand of its line
        assert abs(mark.b - centre) == pytest.approx(radius)
        assert ((hatched / ((mark.a + mark.b) / 2 - centre)).real > 0) is inner
