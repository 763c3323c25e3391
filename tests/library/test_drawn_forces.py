"""Forces as they stand on the paper:
polygons that close, arrows with the sense of the readings, reactions in their cones and on their circles."""

from __future__ import annotations

import cmath
import re
from math import pi

import numpy as np
import pytest

from tests.drawn_library import drawn, ids
from tests.each import Later, each
from vecpoly.algebra.formula import plain
from vecpoly.board.construction import EquationTable, Figure, Reading, Step, View
from vecpoly.board.paper.marks import AngleMark, Dot, FrictionCircle, Point, Role, Segment, TurnArrow, Vector
from vecpoly.mechanism.loads import Force, Moment
from vecpoly.mechanism.model import FRAME, Prismatic
from vecpoly.names import reaction
from vecpoly.oracle.forces import forces

IDS = Later(lambda: ids(view=View.FORCE))
DEVICES = Later(lambda: ids(mechanisms=False, view=View.FORCE))
NEAR = 1e-6  # mm


def by_symbol(name: str) -> dict[str, Reading]:
    """Everything that the force analysis found, by its printed symbol."""
    return {
        reading.symbol: reading for reading in drawn(name).construction.forces.values() if reading.vector is not None
    }


def arrows(figure: Figure) -> list[Vector]:
    """The arrows of a figure that carry a symbol."""
    return [mark for mark in figure.marks if isinstance(mark, Vector) and mark.label]


def balances(name: str) -> list[tuple[Step, EquationTable, Figure]]:
    """Every equation of equilibrium with the polygon in which it was drawn."""
    found = []
    for step in drawn(name).construction.steps:
        figure = drawn(name).construction.figure(step.view) if step.view is not None else None
        if step.equation is not None and figure is not None and figure.view is View.FORCE:
            found.append((step, step.equation, figure))
    return found


# -- polygons -------------------------------------------------------------------------------------------------------


@each(Later(lambda: [*IDS, *DEVICES]))
def test_the_forces_of_an_equation_are_drawn_head_to_tail_and_close(name: str) -> None:
    assert balances(name)
    for step, table, figure in balances(name):
        there = {mark.label: mark for mark in arrows(figure)}
        forces = [there[label] for label in table.symbols if label in there]
        missing = [label for label in table.symbols if label not in there and label not in ("0", "")]
        if not missing:
            assert abs(sum(mark.b - mark.a for mark in forces)) < NEAR or name in DEVICES, step.number
        assert len(forces) >= 2
        for mark in forces:
            assert any(abs(mark.b - other.a) < NEAR for other in arrows(figure) if other is not mark), (
                step.number,
                mark.label,
            )


@each(IDS)
def test_every_reaction_of_a_polygon_has_the_size_and_the_sense_that_was_read(name: str) -> None:
    read, seen = by_symbol(name), 0
    for figure in drawn(name).figures(View.FORCE):
        for mark in arrows(figure):
            if mark.label in read and mark.label.startswith("R"):
                vector = read[mark.label].vector
                assert vector is not None and abs((mark.b - mark.a) * figure.scale.value - vector) < 1e-9 * abs(
                    vector
                ), mark.label
                seen += 1
    assert seen >= 1


def size_of(name: str, load: Force) -> float:
    """As given, or of a load that depends on place and speed as the oracle finds it."""
    problem = drawn(name).problem
    assert problem.loads is not None and load.size is not None
    if load.law is None:
        return load.size
    return float(np.real(forces(problem.mechanism, problem.loads).value(load.name)))


@each(IDS)
def test_every_given_load_of_a_polygon_has_its_size_and_direction(name: str) -> None:
    loads = drawn(name).problem.loads
    given = {load.name: load for load in loads.all if isinstance(load, Force) and load.size} if loads else {}
    for figure in drawn(name).figures(View.FORCE):
        for mark in arrows(figure):
            load = given.get(re.sub("[{}]", "", mark.label))
            if load is not None and load.size is not None:
                size = size_of(name, load)
                assert (mark.b - mark.a) * figure.scale.value == pytest.approx(
                    cmath.rect(size, load.direction), rel=1e-9
                )


def test_given_loads_stand_in_the_polygons() -> None:
    labels = {mark.label for name in IDS for figure in drawn(name).figures(View.FORCE) for mark in arrows(figure)}
    assert {"F", "Q", "F_{r}", "F_{i1}"} <= labels


@each(Later(lambda: [*IDS, *DEVICES]))
def test_the_forces_that_a_step_measures_are_written_in_the_order_in_which_they_are_named(name: str) -> None:
    for step in drawn(name).construction.steps:
        if found := re.search(r"由图量得 ([^。；]*)。", step.words.zh):
            named = [re.sub("[{}$ ]", "", symbol) for symbol in found[1].split("、")]
            written = [
                plain(node).split(" = ")[0].replace("{", "").replace("}", "").replace(" ", "") for node in step.formulas
            ]
            assert named == [symbol for symbol in written if symbol in named], step.number


def test_forces_are_measured_in_many_steps() -> None:
    steps = [step for name in IDS for step in drawn(name).construction.steps if "由图量得" in step.words.zh]
    assert len(steps) >= 20 and all("easure" in step.words.en for step in steps)


# -- free bodies ----------------------------------------------------------------------------------------------------


def bodies(name: str) -> list[Figure]:
    """The free bodies of links."""
    return list(drawn(name).figures(View.BODY))


def beside(mark: Vector, point: complex) -> float:
    """How far a point lies from the line of an arrow."""
    along = (mark.b - mark.a) / abs(mark.b - mark.a)
    return abs(((point - mark.a) * along.conjugate()).imag)


@each(Later(lambda: [name for name in IDS if bodies(name)]))
def test_an_arrow_on_a_free_body_has_the_sense_that_was_read_and_stands_on_its_line_of_action(name: str) -> None:
    read, seen = by_symbol(name), 0
    for figure in bodies(name):
        brought = {mark.label for mark in figure.marks if isinstance(mark, TurnArrow)}
        for mark in arrows(figure):
            reading = read.get(mark.label)
            if reading is not None and reading.vector and mark.label.startswith("R"):
                turn = (mark.b - mark.a) / reading.vector
                assert turn.real > 0 and abs(turn.imag) < 1e-9 * turn.real, (figure.name, mark.label)
                carried = f"M({mark.label})" in brought  # with its couple, from a line far off
                on_line = reading.acts is None or beside(mark, reading.acts.point / figure.scale.value) < NEAR
                assert on_line is not carried
                seen += 1
    assert seen >= 2


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
        size = load.size if load.size is not None else drawn(name).construction.forces[load.name].scalar
        turned = [
            mark.ccw
            for f in bodies(name)
            if f.name == load.link
            for mark in f.marks
            if isinstance(mark, TurnArrow) and mark.label.startswith("M")
        ]
        assert not bodies(name) or not size or (size > 0) in turned, load.name


@each(Later(lambda: [name for name in IDS if any(isinstance(m, AngleMark) for f in bodies(name) for m in f.marks)]))
def test_a_reaction_leans_by_the_friction_angle_from_a_normal_that_is_drawn(name: str) -> None:
    loads = drawn(name).problem.loads
    assert loads is not None
    angles = {round(phi, 9) for phi in (*loads.friction.slides.values(), *loads.friction.contacts.values())}
    for figure in bodies(name):
        for mark in (m for m in figure.marks if isinstance(m, AngleMark) and m.label == "φ"):
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
def test_a_reaction_at_a_pin_with_friction_touches_its_circle_on_the_side_that_was_read(name: str) -> None:
    read, touched = by_symbol(name), 0
    rubbing = {(m.centre, m.radius) for f in bodies(name) for m in f.marks if isinstance(m, FrictionCircle)}
    for figure in bodies(name):
        for circle in (m for m in figure.marks if isinstance(m, FrictionCircle)):
            for mark in arrows(figure):
                reading = read.get(mark.label)
                radius = circle.radius / circle.enlarged
                if (
                    reading is None
                    or reading.acts is None
                    or abs(abs(reading.acts.point / figure.scale.value - circle.centre) - radius) > NEAR
                ):
                    continue
                if tangent := reading.acts.tangent:
                    assert abs(beside(mark, circle.centre) - radius) < NEAR
                    moment = ((mark.a - circle.centre).conjugate() * (mark.b - mark.a)).imag
                    assert ("ccw" if moment > 0 else "cw") == tangent, (figure.name, mark.label)
                    touched += 1
    assert touched >= min(2, len(rubbing))


@each(IDS)
def test_a_reaction_named_on_the_diagram_stands_on_a_line_that_is_its_line_of_action(name: str) -> None:
    read = by_symbol(name)
    (diagram,) = (f for f in drawn(name).figures(View.MECHANISM) if not f.name)
    opposite = {symbol: f"R_{{{symbol[4]}{symbol[3]}{symbol[5:]}" for symbol in read if re.match(r"R_\{\d\d", symbol)}
    ruled = [m for m in diagram.marks if isinstance(m, Segment)]
    for mark in (m for m in diagram.marks if isinstance(m, Point) and m.label in opposite):
        role = Role.IDEAL if mark.label.endswith(",0}") else Role.DIRECTION  # dashed without friction
        force = read[mark.label]
        assert force.vector and force.acts is not None
        along = force.vector / abs(force.vector)
        assert abs(((mark.at - force.acts.point / diagram.scale.value) * along.conjugate()).imag) < 1e-6, mark.label
        assert any(
            min(abs(mark.at - a), abs(mark.at - b)) < 1e-6 and abs(((b - a) * along.conjugate()).imag) < 1e-6
            for a, b in ((line.a, line.b) for line in ruled if line.role is role)
        ), mark.label


def test_reactions_are_named_on_the_diagrams() -> None:
    named = [
        m.label
        for name in IDS
        for f in drawn(name).figures(View.MECHANISM)
        for m in f.marks
        if isinstance(m, Point) and m.label.startswith("R_")
    ]
    assert len(named) >= 20
