"""Forces as they stand on free bodies: arrows on their lines of action with the sense of the readings, reactions in
their cones and on their circles."""

from __future__ import annotations

import cmath
import re
from math import pi

from tests.drawn_forces import IDS, NEAR, arrows, by_symbol, size_of
from tests.drawn_library import drawn
from tests.each import Later, each
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import AngleMark, Dot, FrictionCircle, Point, Role, Segment, TurnArrow, Vector
from vecpoly.mechanism.asked.forces import load_symbol
from vecpoly.mechanism.loads import Moment
from vecpoly.mechanism.model import FRAME, Prismatic
from vecpoly.names import reaction


def bodies(name: str) -> list[Figure]:
    """The free bodies of links."""
    return list(drawn(name).figures(View.BODY))


def beside(mark: Vector, point: complex) -> float:
    """How far a point lies from the line of an arrow."""
    along = (mark.b - mark.a) / abs(mark.b - mark.a)
    return abs(((point - mark.a) * along.conjugate()).imag)


@each(Later(lambda: [name for name in IDS if bodies(name)]))
def test_an_arrow_on_a_free_body_has_the_sense_that_was_read_and_stands_on_its_line_of_action(name: str) -> None:
    read = by_symbol(name)
    for figure in bodies(name):
        brought = {mark.label for mark in figure.marks if isinstance(mark, TurnArrow)}
        for mark in on_links(figure):
            reading = read[mark.label]
            assert reading.vector, (figure.name, mark.label)
            turn = (mark.b - mark.a) / reading.vector
            assert turn.real > 0 and abs(turn.imag) < 1e-9 * turn.real, (figure.name, mark.label)
            carried = f"M({mark.label})" in brought  # with its couple, from a line far off
            place = reading.acts.point / figure.scale.value if reading.acts is not None else mark.a
            on_line = beside(mark, place) < NEAR
            out = [circle.radius - true(circle) for circle in circles(figure) if circle.enlarged > 1]
            as_drawn = any(abs(beside(mark, place) - far) < NEAR for far in out)  # with a circle that is drawn larger
            assert (on_line or as_drawn) is not carried, (figure.name, mark.label)


def on_links(figure: Figure) -> list[Vector]:
    """The reactions between two links on a free body, not their parts, nor those of a pin."""
    return [mark for mark in arrows(figure) if re.fullmatch(r"R'?_\{\d\d\D*\}", mark.label)]


def test_many_reactions_stand_on_free_bodies() -> None:
    assert sum(len(on_links(figure)) for name in IDS for figure in bodies(name)) >= 40


@each(Later(lambda: [name for name in IDS if bodies(name)]))
def test_every_force_on_a_link_stands_on_its_free_body(name: str) -> None:
    read = by_symbol(name)
    for figure in bodies(name):
        shown = [mark.label for mark in arrows(figure)]
        on = {
            symbol
            for symbol, reading in read.items()
            if re.fullmatch(rf"R_{{\d{figure.name}}}", symbol) and reading.scalar > 1e-6
        }
        assert on <= set(shown), figure.name
        assert len(shown) == len(set(shown))


@each(Later(lambda: [name for name in IDS if bodies(name)]))
def test_a_moment_on_a_free_body_turns_as_it_was_given_or_found(name: str) -> None:
    problem = drawn(name).problem
    for load in (load for load in problem.loads.all if isinstance(load, Moment)) if problem.loads else ():
        size = size_of(name, load) if load.size is not None else drawn(name).construction.forces[load.name].scalar
        turned = [
            mark.ccw
            for f in bodies(name)
            if f.name == load.link
            for mark in f.marks
            if isinstance(mark, TurnArrow) and mark.label == load_symbol(load.name)
        ]
        assert not bodies(name) or not size or (size > 0) in turned, load.name


@each(Later(lambda: [name for name in IDS if any(isinstance(m, AngleMark) for f in bodies(name) for m in f.marks)]))
def test_a_reaction_leans_by_the_friction_angle_of_the_steps_from_a_normal_that_is_drawn(name: str) -> None:
    loads = drawn(name).problem.loads
    assert loads is not None
    angles = {round(phi, 9) for phi in (*loads.friction.slides.values(), *loads.friction.contacts.values())}
    for figure in bodies(name):
        for mark in (m for m in figure.marks if isinstance(m, AngleMark) and m.label.startswith("φ")):
            normal = [
                m
                for m in figure.marks
                if isinstance(m, Segment) and m.role is Role.CENTRE and abs(m.a - mark.at) < NEAR
            ]
            assert any(abs(cmath.phase((m.b - m.a) / cmath.rect(1, mark.start))) < 1e-9 for m in normal)
            assert any(
                isinstance(m, Point) and m.label == "n" and m.dot is Dot.NONE and abs(m.at - normal[0].b) < NEAR
                for m in figure.marks
            )
            lean = cmath.rect(1, mark.start + mark.sweep)
            leaning = [
                m
                for m in arrows(figure)
                if beside(m, mark.at) < NEAR and abs(((m.b - m.a) / lean).imag) < 1e-7 * abs(m.b - m.a)
            ]
            assert leaning and round(abs(mark.sweep), 9) in angles, (figure.name, mark)
            assert any(f"${mark.label}$" in step.words.zh for step in drawn(name).construction.steps), mark.label


@each(IDS)
def test_no_reaction_of_a_guide_leaves_its_friction_cone(name: str) -> None:
    problem, forces = drawn(name).problem, drawn(name).construction.forces
    mech, loads = problem.mechanism, problem.loads
    desk = drawn(name).desk
    assert loads is not None and desk is not None
    frame = str(max(int(link.name) for link in mech.links if link.name.isdigit()) + 1)
    for joint in (j for j in mech.joints if isinstance(j, Prismatic)):
        by, on = (frame if joint.guide == FRAME else joint.guide), joint.block
        found = forces.get(reaction(by, on).key)
        if found is not None and found.vector and on.isdigit() and by.isdigit():
            normal = 1j * complex(desk.guide_line(joint).along)
            lean = abs(cmath.phase(found.vector / normal))
            lean = min(lean, pi - lean)
            most = max(
                (abs(mark.sweep) for figure in bodies(name) for mark in figure.marks if isinstance(mark, AngleMark)),
                default=0.0,
            )
            assert lean <= most + 1e-9, (by, on)


@each(
    Later(lambda: [name for name in IDS if any(isinstance(m, FrictionCircle) for f in bodies(name) for m in f.marks)])
)
def test_a_reaction_at_a_pin_with_friction_touches_its_circle_as_drawn_on_the_side_that_was_read(name: str) -> None:
    read = by_symbol(name)
    for figure in bodies(name):
        for mark in on_links(figure):
            acts = read[mark.label].acts
            if acts is None or not acts.tangent:
                continue
            place = acts.point / figure.scale.value
            touched = [circle for circle in circles(figure) if abs(abs(place - circle.centre) - true(circle)) < NEAR]
            assert touched or not figure.name.isdigit(), (figure.name, mark.label)  # no circles on those of groups
            for circle in touched:
                assert abs(beside(mark, circle.centre) - circle.radius) < NEAR, (figure.name, mark.label)
                moment = ((mark.a - circle.centre).conjugate() * (mark.b - mark.a)).imag
                assert ("ccw" if moment > 0 else "cw") == acts.tangent, (figure.name, mark.label)


def circles(figure: Figure) -> list[FrictionCircle]:
    """The friction circles of a body."""
    return [mark for mark in figure.marks if isinstance(mark, FrictionCircle)]


def true(circle: FrictionCircle) -> float:
    """The radius of a circle that may be drawn enlarged (mm)."""
    return circle.radius / circle.enlarged
