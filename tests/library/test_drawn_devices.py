"""Devices as they stand on the paper:
a body lies on its face, a reaction presses into it inside its friction cone, nut and cone on the right side."""

from __future__ import annotations

import cmath
from itertools import combinations

import shapely

from tests import drawn_library
from tests.drawn_library import drawn, ids
from tests.each import Later, each
from tests.found import APART
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import (
    AngleMark,
    Disc,
    FixedGuide,
    FrictionCircle,
    Ground,
    LinkNumber,
    Outline,
    Role,
    Segment,
    Vector,
)

NEAR = 0.01  # mm


def shape(mark: Outline | Disc) -> shapely.Polygon:
    """A body as an area."""
    if isinstance(mark, Disc):
        return shapely.Point(mark.centre.real, mark.centre.imag).buffer(mark.radius, 256)
    return shapely.Polygon([(p.real, p.imag) for p in mark.points])


def dot(p: complex) -> shapely.Point:
    return shapely.Point(p.real, p.imag)


def bodies(figure: Figure, *, fixed: bool = False) -> list[shapely.Polygon]:
    """The moving (or the fixed) bodies of a figure."""
    return [
        shape(m)
        for m in figure.marks
        if (isinstance(m, Disc) and not fixed) or (isinstance(m, Outline) and m.fixed == fixed)
    ]


def reactions(figure: Figure) -> list[Vector]:
    """The arrows of reactions."""
    return [m for m in figure.marks if isinstance(m, Vector) and m.label.startswith("R")]


def apart(name: str) -> list[Figure]:
    """The figures in which one body stands alone with the forces on it."""
    return [
        f
        for f in drawn(name).figures(View.BODY)
        if reactions(f) and len(bodies(f)) == 1 and not f.name.startswith("limit")
    ]


IDS = Later(lambda: (name for name in ids(mechanisms=False, view=View.BODY) if apart(name)))
SKETCHED = Later(
    lambda: (
        name for name in IDS if any(isinstance(m, LinkNumber) for m in drawn(name).figures(View.MECHANISM)[0].marks)
    )
)


def test_wedges_planes_clamps_rings_and_screws_are_drawn_apart() -> None:
    here = {*drawn_library.IDS}
    assert here & {"4-2", "5-1", "5-2", "5-3", "5-4", "5-5"} <= set(IDS) and here & {"4-2", "5-3", "5-4"} <= set(
        SKETCHED
    )
    assert [sum(len(reactions(f)) for f in apart(name)) for name in ("4-2", "5-2", "5-4")] == [4, 2, 4]


@each(drawn_library.IDS)
def test_every_link_that_has_a_number_is_drawn(name: str) -> None:
    for figure in drawn(name).figures(View.MECHANISM):
        if not figure.name:
            numbered = {mark.owner for mark in figure.marks if isinstance(mark, LinkNumber)}
            assert numbered <= {mark.owner for mark in figure.marks if not isinstance(mark, LinkNumber)}


@each(SKETCHED)
def test_a_sketch_of_bodies_shows_what_stands(name: str) -> None:
    figure = drawn(name).figures(View.MECHANISM)[0]
    assert any(isinstance(m, Ground | FixedGuide) or (isinstance(m, Outline) and m.fixed) for m in figure.marks)


def ends_on_a_circle(figure: Figure, arrow: Vector) -> bool:
    """Whether an arrow ends on a friction circle as it is drawn."""
    circles = [m for m in figure.marks if isinstance(m, FrictionCircle)]
    return any(abs(abs(arrow.b - circle.centre) - circle.radius) < NEAR for circle in circles)


@each(IDS)
def test_a_reaction_presses_on_the_face_of_its_body_from_outside(name: str) -> None:
    for figure in apart(name):
        (body,) = bodies(figure)
        for arrow in reactions(figure):
            if ends_on_a_circle(figure, arrow):
                continue  # at a pin, inside the disc
            way = (arrow.b - arrow.a) / abs(arrow.b - arrow.a)
            assert body.exterior.distance(dot(arrow.b)) < NEAR, (figure.name, arrow.label)
            assert body.contains(dot(arrow.b + 0.2 * way)) and not body.contains(dot(arrow.a)), (
                figure.name,
                arrow.label,
            )


@each(IDS)
def test_a_reaction_lies_inside_the_cone_of_friction_about_the_normal_of_its_face(name: str) -> None:
    coned = 0
    for figure in apart(name):
        (body,) = bodies(figure)
        cones = [m for m in figure.marks if isinstance(m, AngleMark) and "φ" in m.label]
        for arrow in reactions(figure):
            here = [m for m in cones if abs(m.at - arrow.b) < NEAR]
            inward = min((normal(body, arrow.b, mark) for mark in here), key=abs, default=None)
            if inward is not None:
                lean = abs(cmath.phase((arrow.b - arrow.a) / cmath.rect(1, inward)))
                assert lean <= max(abs(mark.sweep) for mark in here) + 1e-9, (figure.name, arrow.label)
                coned += 1
    assert coned


def normal(body: shapely.Polygon, at: complex, mark: AngleMark) -> float:
    """The direction of the angle's first side, turned into the body; it is square to the face."""
    side = cmath.rect(1, mark.start)
    inward = side if body.contains(dot(at + 0.2 * side)) else -side
    edges = list(zip(body.exterior.coords, body.exterior.coords[1:], strict=False))
    face = min(edges, key=lambda edge: shapely.LineString(edge).distance(dot(at)))
    along = complex(*face[1]) - complex(*face[0])
    assert len(edges) > 100 or abs((along.conjugate() * side).real) < 1e-6 * abs(along), (
        "the normal is not square to the face"
    )
    return cmath.phase(inward)


@each(IDS)
def test_the_normal_of_a_face_is_drawn_where_the_friction_angle_starts(name: str) -> None:
    for figure in apart(name):
        for mark in (m for m in figure.marks if isinstance(m, AngleMark) and "φ" in m.label):
            lines = [
                (m.a, m.b)
                for m in figure.marks
                if isinstance(m, Segment) and m.role in (Role.CENTRE, Role.CONSTRUCTION)
            ]
            assert any(
                abs(a - mark.at) < NEAR and abs(cmath.phase((b - a) / cmath.rect(1, mark.start))) < 1e-6
                for a, b in lines
            ), figure.name


@each(Later(lambda: (*SKETCHED, "ring-spring-of-steep-faces")))
def test_bodies_touch_each_other_and_never_lie_in_one_another(name: str) -> None:
    for figure in (f for f in drawn(name).figures(View.MECHANISM) if bodies(f)):
        moving, everything = bodies(figure), bodies(figure) + bodies(figure, fixed=True)
        for one, two in combinations(everything, 2):
            assert one.buffer(-0.3).intersection(two.buffer(-0.3)).area < 0.01, figure.name
        for one in moving if len(everything) > 1 else ():
            assert any(one.distance(other) < 0.3 for other in everything if other is not one), figure.name


@each(IDS)
def test_the_speed_of_sliding_makes_an_obtuse_angle_with_the_reaction(name: str) -> None:
    for figure in apart(name):
        for arrow in (m for m in figure.marks if isinstance(m, Vector) and m.label.startswith("v")):
            near = min(reactions(figure), key=lambda r: abs(r.b - (arrow.a + arrow.b) / 2))
            assert abs(cmath.phase((arrow.b - arrow.a) / (near.b - near.a))) > cmath.pi / 2 - 1e-9, (
                figure.name,
                arrow.label,
            )


def test_the_nut_stands_on_the_thread_and_climbs_it() -> None:
    (nut,) = (f for f in drawn("5-5").figures(View.BODY) if f.name == "nut")
    (body,) = bodies(nut)
    (thread,) = (m for m in nut.marks if isinstance(m, Vector) and m.label == "R_1")
    (speed,) = (m for m in nut.marks if isinstance(m, Vector) and m.label == "v")
    assert body.centroid.y > thread.b.imag and (thread.b - thread.a).imag > 0 and (speed.b - speed.a).imag > 0
    (load,) = (m for m in nut.marks if isinstance(m, Vector) and m.label == "Q_1")
    assert (load.b - load.a).imag < 0 and abs((load.b - load.a).real) < 1e-9


@each(Later(lambda: (*ids(mechanisms=False), *APART, "dead-centre")))
def test_the_sides_of_an_angle_that_is_marked_are_lines_through_its_corner(name: str) -> None:
    for figure in drawn(name).construction.figures:
        lines = [line for mark in figure.marks for line in straight(mark)]
        for mark in (m for m in figure.marks if isinstance(m, AngleMark)):
            for side in (cmath.rect(1, mark.start), cmath.rect(1, mark.start + mark.sweep)):
                assert any(runs(line, mark.at, side) for line in lines), (figure.name, mark.label)


def straight(mark: object) -> list[tuple[complex, complex]]:
    """The straight lines of a mark from end to end."""
    if isinstance(mark, Outline):
        return list(zip(mark.points, (*mark.points[1:], mark.points[0]), strict=True))
    return [(mark.a, mark.b)] if isinstance(mark, Segment | Vector) else []


def runs(line: tuple[complex, complex], at: complex, way: complex) -> bool:
    """Whether the line, or its continuation, passes through a place in a direction."""
    along = (line[1] - line[0]).conjugate()
    return (
        abs(along) > NEAR
        and abs((along * way).imag) < 1e-3 * abs(along)
        and abs((along / abs(along) * (at - line[0])).imag) < NEAR
    )
