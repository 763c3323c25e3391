"""The kinematic diagram of every problem: what is lettered stands where the oracle has it, what slides lies on its
guide, what is fixed is hatched."""

from __future__ import annotations

import cmath
import re
from functools import cache
from math import pi
from typing import TypeVar

import pytest

from tests.drawn_library import LIBRARY, desk_of, drawn, given, ids
from tests.each import Later, each
from tests.found import FOUND
from vecpoly import oracle
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.extent import extent
from vecpoly.board.paper.marks import (
    AngleMark,
    Block,
    Dot,
    FixedGuide,
    GearMark,
    Ground,
    LinkNumber,
    Mark,
    Plate,
    Point,
    Role,
    Segment,
    Slot,
    TurnArrow,
)
from vecpoly.mechanism.gearing import pitch_circles
from vecpoly.mechanism.laws.springs import Spring
from vecpoly.mechanism.model import FRAME, Mechanism, Prismatic, Revolute, Rolling
from vecpoly.names import At, Kind, Rel, subscripted
from vecpoly.oracle import Motion
from vecpoly.report.statement.structure import structure

IDS = Later(lambda: (*ids(view=View.MECHANISM), *FOUND))
M = TypeVar("M", bound=Mark)
NEAR = 1e-6  # mm
PINS = (Dot.JOINT, Dot.MULTIPLE)
LETTERED = (*PINS, Dot.MASS, Dot.POINT)


@cache
def motion(name: str) -> Motion:
    """What the oracle knows of a problem."""
    return oracle.solve(drawn(name).problem.mechanism)


def diagram(name: str) -> Figure:
    """The kinematic diagram itself."""
    return next(figure for figure in drawn(name).figures(View.MECHANISM) if not figure.name)


def place(name: str, point: str, link: str = "") -> complex:
    """Where the oracle has a point, in mm on the diagram."""
    mech = drawn(name).problem.mechanism
    metres = (
        mech.frame[point]
        if not link and point in mech.frame
        else complex(motion(name).value(Rel(Kind.P, At(point, link))))
    )
    return metres / diagram(name).scale.value


def marks(name: str, kind: type[M]) -> list[M]:
    """The diagram's marks of a kind."""
    return [mark for mark in diagram(name).marks if isinstance(mark, kind)]


def letters(mech: Mechanism) -> set[str]:
    """Letters of points of links and of the frame."""
    return {*mech.frame, *(point for link in mech.links for point in link.points)}


@each(IDS)
def test_every_lettered_point_stands_where_the_oracle_has_it(name: str) -> None:
    seen, known = 0, {subscripted(point): point for point in letters(drawn(name).problem.mechanism)}
    for mark in marks(name, Point):
        if mark.label in known and mark.dot in LETTERED:
            assert abs(mark.at - place(name, known[mark.label])) < NEAR, mark.label
            seen += 1
    assert seen >= len(drawn(name).problem.mechanism.frame)


@each(IDS)
def test_every_pin_is_an_open_circle_and_every_fixed_pin_stands_on_the_ground(name: str) -> None:
    mech = drawn(name).problem.mechanism
    real = [
        j
        for j in mech.joints
        if isinstance(j, Revolute) and all(end == FRAME or end[0].isdigit() for end in (j.a, j.b))
    ]
    circles = {mark.label for mark in marks(name, Point) if mark.dot in PINS}
    assert {subscripted(j.point) for j in real if "'" not in j.point} <= circles
    grounds = [mark.at for mark in marks(name, Ground)]
    fixed = {j.point for j in real if FRAME in (j.a, j.b)}
    assert all(any(abs(at - place(name, point)) < NEAR for at in grounds) for point in fixed)
    loads = drawn(name).problem.loads
    feet = {spring.foot for spring in loads.springs if isinstance(spring, Spring)} if loads is not None else set[str]()
    pinned = {j.point for j in mech.joints if isinstance(j, Revolute)} | feet
    assert len(grounds) == len(pinned & set(mech.frame))
    assert all(mark.down == -1j for mark in marks(name, Ground))


@each(IDS)
def test_the_links_that_are_counted_are_those_that_have_numbers(name: str) -> None:
    problem = drawn(name).problem
    told = re.search(r"has (\d+) moving links", structure(problem).en)
    assert told is not None and int(told[1]) == len(problem.mechanism.numbered)


@each(IDS)
def test_every_moving_link_has_its_number_beside_it(name: str) -> None:
    mech = drawn(name).problem.mechanism
    names = [link.name for link in mech.links if link.name[0].isdigit()]
    numbers, near = marks(name, LinkNumber), max(30.0, 0.3 * max(extent(diagram(name).marks)))
    assert set(names) <= {mark.number for mark in numbers}
    for mark in numbers:
        own = [place(name, point) for link in mech.links if link.name == mark.number for point in link.points]
        assert not own or min(abs(mark.a - at) for at in own) < near or min(_from_rims(name, mark)) < 5.0, mark


def _from_rims(name: str, mark: LinkNumber) -> list[float]:
    """How far (mm) the number stands from the pitch circles of its link: a ring has it at its rim."""
    rings = [circle for circle in pitch_circles(drawn(name).problem.mechanism) if circle.link == mark.number]
    return [
        abs(abs(mark.a - place(name, ring.centre)) - ring.radius / diagram(name).scale.value) for ring in rings
    ] or [99.0]


@each(IDS)
def test_a_block_lies_on_its_guide_and_along_it(name: str) -> None:
    mech, mm = drawn(name).problem.mechanism, 1 / diagram(name).scale.value
    lines: list[tuple[complex, complex]] = []
    for joint in (j for j in mech.joints if isinstance(j, Prismatic)):
        turn = 1 + 0j if joint.guide == FRAME else cmath.rect(1, motion(name).angle(joint.guide))
        origin = 0j if joint.guide == FRAME else complex(motion(name).origin(joint.guide))
        lines.append(((origin + turn * joint.origin) * mm, turn * cmath.rect(1, joint.direction)))
    for block in marks(name, Block):
        assert any(
            abs(((block.at - at) / along).imag) < NEAR and abs((block.along / along).imag) < 1e-9 for at, along in lines
        ), block
    guides: tuple[FixedGuide | Slot, ...] = (*marks(name, FixedGuide), *marks(name, Slot))
    for guide in (m for m in guides if lines):
        along = (guide.b - guide.a) / abs(guide.b - guide.a)
        assert any(abs((along / line).imag) < 1e-9 for _, line in lines) or isinstance(guide, FixedGuide)


@each(Later(lambda: [name for name in IDS if any(isinstance(m, FixedGuide) for m in diagram(name).marks)]))
def test_what_slides_on_a_fixed_guide_lies_on_its_unhatched_side(name: str) -> None:
    for guide in marks(name, FixedGuide):
        across = 1j * (guide.b - guide.a) / abs(guide.b - guide.a)
        blocks = [
            b
            for b in marks(name, Block)
            if abs((b.along.conjugate() * across).real) < 1e-9 and abs(b.at - (guide.a + guide.b) / 2) < 20
        ]
        assert all(((b.at - guide.a) * across.conjugate()).real > 0 for b in blocks), guide


@each(Later(lambda: [name for name in IDS if any(isinstance(m, GearMark) for m in diagram(name).marks)]))
def test_gears_have_their_radii_and_touch_each_other(name: str) -> None:
    mech, mm = drawn(name).problem.mechanism, 1 / diagram(name).scale.value
    gears = marks(name, GearMark)
    for joint in (j for j in mech.joints if isinstance(j, Rolling)):
        centre = place(name, joint.gear.centre)
        assert any(abs(g.centre - centre) < NEAR and abs(g.radius - joint.gear.radius * mm) < NEAR for g in gears)
        contact = place(name, joint.point)
        assert abs(abs(contact - centre) - joint.gear.radius * mm) < NEAR


@each(IDS)
def test_the_arrow_of_the_drive_turns_as_the_drive_does(name: str) -> None:
    drive = drawn(name).problem.mechanism.drives[0]
    symbol = f"ω_{{{drive.link}{drive.on}}}" if drive.between else f"ω_{drive.link}"
    arrows = [mark for mark in marks(name, TurnArrow) if mark.label == symbol]
    assert [mark.ccw for mark in arrows] == ([] if drive.slide else [drive.rate > 0])
    if drive.between and not drive.slide:
        assert all(min(abs(mark.at - place(name, pin)) for pin in between(name)) < NEAR for mark in arrows)


def between(name: str) -> list[str]:
    """The pins at which the links of the drive are hinged together."""
    mech = drawn(name).problem.mechanism
    return [j.point for j in mech.joints if isinstance(j, Revolute) and {j.a, j.b} == mech.drives[0].pair]


def test_a_drive_that_gains_speed_has_a_second_arrow_clear_of_the_first() -> None:
    first, second = marks("planet-drive", TurnArrow)
    assert (first.label, second.label, second.ccw) == ("ω_1", "α_1", True)
    assert abs(cmath.phase(cmath.exp(1j * (second.start - first.start)))) > 1.8 or second.radius != first.radius


def bars(name: str) -> list[list[complex]]:
    """The points of every plain bar: no guide, no block, no gear, no cam."""
    problem = drawn(name).problem
    mech, shapes = problem.mechanism, problem.given.shapes
    other = {end for j in mech.joints if isinstance(j, Prismatic) for end in (j.guide, j.block)} | {
        end for c in mech.contacts for end in c.links
    }
    plain = [
        li
        for li in mech.links
        if li.name[0].isdigit() and li.name not in other and shapes.get(li.name, "bar") == "bar" and len(li.points) > 1
    ]
    return [[place(name, point) for point in link.points] for link in plain]


@each(Later(lambda: [name for name in IDS if bars(name)]))
def test_the_points_of_a_bar_are_joined(name: str) -> None:
    ends = [(m.a, m.b) for m in marks(name, Segment) if m.role is Role.LINK] + [
        (a, b) for m in marks(name, Plate) for a in m.points for b in m.points
    ]
    for spots in bars(name):
        for spot in spots:
            assert any(off(spot, a, b) < 3.0 and abs(b - a) > 3.0 for a, b in ends), spot


def off(p: complex, a: complex, b: complex) -> float:
    """How far a point lies from a stretch."""
    if abs(b - a) < NEAR:
        return abs(p - a)
    t = min(1.0, max(0.0, ((p - a) * (b - a).conjugate()).real / abs(b - a) ** 2))
    return abs(p - a - t * (b - a))


def test_angles_of_the_drive_are_marked_from_where_they_are_counted() -> None:
    desk = desk_of("3-9")
    (mark,) = [m for m in diagram("3-9").marks if isinstance(m, AngleMark) and m.label == "φ_1"]
    assert abs(mark.start) < 1e-12 and abs((mark.sweep - desk.mech.drive.position + pi) % (2 * pi) - pi) < 1e-9


CAMS = Later(
    lambda: (
        name
        for name in LIBRARY
        if isinstance(given(name).subject, Mechanism) and given(name).mechanism.contacts and given(name).loads is None
    )
)


@each(CAMS)
def test_the_pressure_angle_lies_between_the_common_normal_and_the_way_of_the_follower(name: str) -> None:
    mech = drawn(name).problem.mechanism
    for mark in (m for m in marks(name, AngleMark) if m.label == "α"):
        (contact,) = mech.contacts
        tip = (
            next(point for link in mech.links for point in link.points if abs(place(name, point) - mark.at) < NEAR)
            if abs(mark.at - place(name, contact.point)) > NEAR
            else ""
        )
        way = (
            complex(motion(name).velocity(tip))
            if tip
            else complex(motion(name).velocity(At(contact.point, contact.links[1])))
        )
        normal = cmath.rect(1, mark.start)
        touch, centre = place(name, contact.point), place(name, contact.disc.centre)
        assert abs(((touch - centre).conjugate() * normal).imag) < 1e-6 * abs(touch - centre)
        assert (
            abs((cmath.rect(1, mark.start + mark.sweep).conjugate() * way).imag) < 1e-6 * abs(way)
            and 0 < abs(mark.sweep) < pi / 2
        )


def test_pressure_angles_are_marked() -> None:
    discs = [name for name in CAMS if not drawn(name).problem.mechanism.cams]
    marked = {name for name in discs if any(m.label == "α" for m in marks(name, AngleMark))}
    assert marked == {"D-3-knife", "cam-roller"}


def test_pressure_angles_of_a_profile_are_marked_but_under_a_flat_face_that_slides() -> None:
    profiles = [name for name in CAMS if drawn(name).problem.mechanism.cams and drawn(name).problem.loads is None]
    marked = [name for name in profiles if any(m.label == "α" for m in marks(name, AngleMark))]
    assert marked == ["cam-moves-arm", "cam-moves-flat-arm", "cam-moves-roller"]


@pytest.mark.parametrize("name", ["3-8", "3-12", "shaper-cut"])
def test_a_guide_bar_is_a_line_through_its_block(name: str) -> None:
    """GB/T 4460: how long its slot is, nobody says."""
    figure = diagram(name)
    assert not any(isinstance(mark, Slot) for mark in figure.marks)
    bars = [mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.LINK]
    led = [
        (block, bar)
        for block in figure.marks
        if isinstance(block, Block)
        for bar in bars
        if abs(((bar.b - bar.a) / block.along).imag) < 1e-6 and abs(((block.at - bar.a) / block.along).imag) < 1e-6
    ]
    assert led
    for block, bar in led:  # it goes through
        along = sorted(((end - block.at) / block.along).real for end in (bar.a, bar.b))
        assert along[0] < -5 and along[1] > 5


def test_a_pin_runs_in_a_slot() -> None:
    figure = diagram("crank-pin-in-slot")
    assert any(isinstance(mark, Slot) for mark in figure.marks)
