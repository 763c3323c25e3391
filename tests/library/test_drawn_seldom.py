"""What stands on the paper and is seldom looked at: offset circles, arcs, normals of faces, ghosts, equations."""

from __future__ import annotations

import cmath
import re

import numpy as np
import pytest

from tests.drawn_library import desk_of, drawn, ids
from tests.each import Later, each
from vecpoly import oracle
from vecpoly.board.construction import EquationTable, Step, View
from vecpoly.board.paper.marks import AngleMark, Arc, Dot, Point, Role, Segment, Vector
from vecpoly.curves.skeleton import skeleton
from vecpoly.cycle import cycle
from vecpoly.drawing.labels.about.bounds import Bounds
from vecpoly.errors import NoMethodError
from vecpoly.mechanism.model import FRAME, Prismatic
from vecpoly.methods.standing import standing
from vecpoly.names import At, Kind, Rel
from vecpoly.problem.load import load, loads
from vecpoly.solution import solve

DIAGRAMS = Later(lambda: ids(view=View.MECHANISM))
NEAR = 1e-6  # mm
FOLLOWER = """
id: f
title: f
frame: {A: [0 mm, 0 mm]}
links: {1: {AO: 15 mm, disc: O, radius: 40 mm}, 2: {block: E, disc: E, radius: %s mm}}
joints: [2 slides on x = %s mm, 1 touches 2 at K]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
branch: [E above O]
find: [v_E]
"""


@pytest.mark.parametrize("radius", [0, 10])
@pytest.mark.parametrize("offset", [-12, -6, 0, 6, 12])
def test_an_offset_circle_about_the_cam_s_pivot_touches_the_way_of_the_follower(offset: int, radius: int) -> None:
    construction = solve(loads(FOLLOWER % (radius, offset)), by="exact", repeats=0).construction
    figure = next(figure for figure in construction.figures if figure.view is View.MECHANISM)
    circles = {
        round(m.radius * figure.scale.value * 1e3, 6)
        for m in figure.marks
        if isinstance(m, Arc) and m.role is Role.CENTRE and abs(m.centre) < NEAR
    }
    assert circles - {25.0} == (
        {float(abs(offset))} if offset else set()
    )  # 25 mm: the circle of the nearest point of the cam
    foot = offset * 1e-3 / figure.scale.value
    assert [
        m
        for m in figure.marks
        if isinstance(m, Segment) and m.role is Role.CENTRE and abs(m.a - foot) < NEAR and abs(m.b.real - foot) < NEAR
    ]


def told_arcs(name: str) -> list[str]:
    """The centres of the arcs that the steps tell."""
    said = [
        step.words.zh
        for step in drawn(name).construction.steps
        if step.view is View.MECHANISM and "画弧" in step.words.zh
    ]
    return [
        letter
        for words in said
        for pair in re.findall(r"\$(\w+)\$(?:、\$(\w+)\$)? 为圆心", words)
        for letter in pair
        if letter
    ]


@each(Later(lambda: [name for name in DIAGRAMS if told_arcs(name)]))
def test_as_many_arcs_are_drawn_about_a_point_as_are_told(name: str) -> None:
    figure, at = next(f for f in drawn(name).figures(View.MECHANISM) if not f.name), desk_of(name).at
    arcs = [mark for mark in figure.marks if isinstance(mark, Arc) and mark.role is not Role.CENTRE]
    for letter in set(told_arcs(name)):
        if letter in at:
            assert sum(abs(arc.centre - complex(at[letter])) < NEAR for arc in arcs) >= told_arcs(name).count(letter), (
                letter
            )


@each(
    Later(
        lambda: [
            name for name in ids(mechanisms=False) if any(f.name == "limits" for f in drawn(name).construction.figures)
        ]
    )
)
def test_every_normal_of_the_limits_of_self_locking_is_drawn_and_lettered(name: str) -> None:
    marks = next(f for f in drawn(name).construction.figures if f.name == "limits").marks
    rays = [m for m in marks if isinstance(m, Segment) and m.role is Role.CENTRE and m.a == 0]
    normals = [m for m in marks if isinstance(m, Point) and m.label.lstrip("−").startswith("n")]
    assert len(normals) == len({m.label for m in normals}) >= 2 and all(
        m.dot is Dot.NONE and any(abs(m.at - ray.b) < NEAR for ray in rays) for m in normals
    )


def equations(name: str) -> list[tuple[Step, EquationTable]]:
    return [(step, step.equation) for step in drawn(name).construction.steps if step.equation is not None]


@each(Later(lambda: [name for name in ids() if equations(name)]))
def test_every_equation_of_velocities_stands_under_a_step_that_names_its_point(name: str) -> None:
    """Two equations never share a step: each is announced."""
    for step, table in equations(name):
        if step.view in (View.VELOCITY, View.ACCELERATION):
            sought = {
                table.symbols[end].partition("_")[2].strip("{}")[0] for end in (0, -1)
            }  # the whole vector stands first, or alone at the end
            assert sought & set(re.sub(r"[^A-Z]", "", step.words.en)), step.number
    numbers = [step.number for step, _ in equations(name)]
    assert len(numbers) == len(set(numbers))


@each(
    Later(
        lambda: [
            name
            for name in ids(view=View.BODY)
            if any(
                isinstance(m, AngleMark) and m.label.startswith("φ")
                for f in drawn(name).figures(View.BODY)
                for m in f.marks
            )
        ]
    )
)
def test_the_angle_of_friction_opens_on_the_side_on_which_the_arrow_stands(name: str) -> None:
    for figure in drawn(name).figures(View.BODY):
        arrows = [m for m in figure.marks if isinstance(m, Vector) and m.label.startswith("R")]
        for mark in (m for m in figure.marks if isinstance(m, AngleMark) and m.label.startswith("φ")):
            lean = cmath.rect(1.0, mark.start + mark.sweep)
            on_line = [
                m
                for m in arrows
                if abs((lean.conjugate() * (m.a - mark.at)).imag) < NEAR
                and abs((lean.conjugate() * (m.b - mark.at)).imag) < NEAR
            ]
            assert on_line and any((lean.conjugate() * ((m.a + m.b) / 2 - mark.at)).real > 0 for m in on_line)


@pytest.mark.parametrize("name", ["3-9", "A-27", "3-12", "stephenson-valve-gear", "A-30"])
def test_a_ghost_of_a_mechanism_has_every_bar_and_every_guide_up_to_its_block(name: str) -> None:
    mech, phi = load(name).mechanism, np.array([0.3, 1.1])
    turn = cycle(load(name), n=37)
    lines, motion = skeleton(turn, phi), oracle.solve(turn.mech, phi)
    wanted = [list(link.points) for link in turn.mech.links if link.name in turn.mech.bodies and len(link.points) > 1]
    wanted += [
        [next(iter(mech.link(j.guide).points)), j.pin]
        for j in turn.mech.joints
        if isinstance(j, Prismatic)
        and FRAME not in (j.guide, j.block)
        and j.pin
        and mech.link(j.guide).points
        and j.pin not in list(mech.link(j.guide).points)[:1]
    ]
    for letters in wanted:
        places = np.array([1e3 * np.asarray(motion.position(letter)) for letter in letters])
        assert any(
            line.shape[0] >= len(places) and np.allclose(line[: len(places)], places, atol=1e-6, equal_nan=True)
            for line in lines
        ), letters


def test_the_room_of_a_lettering_is_as_wide_and_high_as_it_and_a_margin_more() -> None:
    box = Bounds.about(np.array([3 + 5j]), np.array([4.0]), np.array([2.0]), 0.5)
    assert (*box.x0, *box.y0, *box.x1, *box.y1) == (0.5, 3.5, 5.5, 6.5)


@pytest.mark.parametrize("kind", [Kind.V, Kind.A, Kind.AN, Kind.AT])
def test_a_vector_that_was_not_drawn_is_refused_with_those_that_were(kind: Kind) -> None:
    with pytest.raises(NoMethodError, match="was not drawn.*drawn are" if kind is not Kind.AT else "was not drawn"):
        standing(desk_of("3-9"), Rel(kind, At("Z", "2"), At("Y", "3") if kind in (Kind.AN, Kind.AT) else None))


def test_components_of_a_turning_link_are_none_of_its_slide() -> None:
    """a^n of a sliding pair's points is no vector of the pair: v, a^k and a^r are the same at all of them."""
    desk = desk_of("3-9")
    (pair,) = set(desk.slides)
    for kind, there in (
        (Kind.V, True),
        (Kind.AK, True),
        (Kind.AR, True),
        (Kind.AN, False),
        (Kind.AT, False),
        (Kind.A, False),
    ):
        asked = Rel(kind, At("Z", pair[0]), At("Z", pair[1]))
        if there:
            assert standing(desk, asked)[0] is (View.VELOCITY if kind is Kind.V else View.ACCELERATION)
        else:
            with pytest.raises(NoMethodError):
                standing(desk, asked)


def test_equations_are_written_in_nearly_every_problem() -> None:
    assert sum(bool(equations(name)) for name in ids()) > 40
