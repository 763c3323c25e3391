"""What a polygon and a mechanism lacked: directions of guides, vectors asked for, plates, pins of racks."""

from __future__ import annotations

import cmath
from math import pi

import pytest

from tests.drawing.test_labels import figure
from tests.drawing.test_numbers import numbers
from tests.drawn_library import drawn
from tests.label_faults import text_of
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import (
    Arc,
    Disc,
    Dot,
    FixedGuide,
    Ground,
    LinkNumber,
    Plate,
    Point,
    Role,
    Segment,
    Vector,
)
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.labels.points import piece
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.style import Hue
from vecpoly.typeset import Glyphs
from vecpoly.words import Lang, Words


@pytest.mark.parametrize("problem", ["3-5", "4-3a", "7-1"])
@pytest.mark.parametrize(("lang", "said"), [("zh", "∥导路"), ("en", "∥guide")])
def test_the_direction_of_a_guide_stands_in_words_at_its_line(problem: str, lang: Lang, said: str) -> None:
    (polygon,) = drawn(problem).figures(View.VELOCITY)
    named = [label for label in drawing(polygon, lang=lang).labels if text_of(label) == said]
    assert len(named) == 1 and named[0].want.thing is Thing.DIRECTION


def test_a_vector_that_is_asked_for_between_two_points_of_an_image_stands_on_the_polygon() -> None:
    (polygon,) = drawn("3-4a-straight").figures(View.VELOCITY)
    tips = {mark.label: mark.at for mark in polygon.marks if isinstance(mark, Point)}
    ends = [(mark.a, mark.b) for mark in polygon.marks if isinstance(mark, Vector)]
    assert ends.count((tips["d"], tips["c"])) == 1


def test_arcs_that_meet_flatly_are_left_where_the_point_was_carried_over() -> None:
    for one in drawn("8-18").figures(View.MECHANISM):
        primed = [mark for mark in one.marks if isinstance(mark, Point) and "′" in mark.label]
        carried = [mark.at for mark in primed if mark.label[0] in "BEF"]
        arcs = [mark for mark in one.marks if isinstance(mark, Arc)]
        assert carried
        for at in carried:
            assert sum(abs(abs(at - arc.centre) - arc.radius) < 0.05 for arc in arcs) >= 2


def test_a_coupler_with_three_points_is_a_plate_and_one_with_its_point_in_line_is_a_bar() -> None:
    plates = {
        name: [m for f in drawn(name).figures(View.MECHANISM) for m in f.marks if isinstance(m, Plate)]
        for name in ("straight-roberts", "straight-chebyshev")
    }
    assert len(plates["straight-roberts"]) == 1 and not plates["straight-chebyshev"]


def test_a_pin_on_the_pitch_line_of_a_rack_is_joined_to_its_body() -> None:
    (diagram,) = drawn("crank-rack-pinion").figures(View.MECHANISM)
    pin = next(mark.at for mark in diagram.marks if isinstance(mark, Point) and mark.label == "B")
    assert any(
        isinstance(mark, Segment)
        and mark.role is Role.LINK
        and abs(mark.a - pin) < 0.3
        and 2.0 < abs(mark.b - pin) < 2.5
        for mark in diagram.marks
    )


def test_the_unit_of_an_axis_is_upright_beside_its_slanting_symbol() -> None:
    faces = {item.text: item.font for item in piece("y/mm", Hue.BLACK, 1).box.items if isinstance(item, Glyphs)}
    slanting = {item.font for item in piece("y", Hue.BLACK, 1).box.items if isinstance(item, Glyphs)}
    assert {font for text, font in faces.items() if "m" in text}.isdisjoint(slanting)


@pytest.mark.parametrize("way", [-1j, 1j, -1.0, 1.0])
def test_the_number_of_a_link_is_not_beside_the_hatching_of_its_pivot(way: complex) -> None:
    end = 12 * cmath.exp(0.6j)
    bar = Segment(a=0j, b=end, role=Role.LINK, owner="link 5")
    ground, pin = Ground(at=0j, down=way, owner="frame"), Point(at=0j, label="G", dot=Dot.JOINT)
    (number,) = numbers(bar, ground, pin, Point(at=end, label="F", dot=Dot.JOINT), LinkNumber(a=0j, b=end, number="5"))
    edge = 6.7 * way
    assert number.foot is not None or abs(number.centre - end / 2) < abs(number.centre - edge)


def test_the_number_of_a_block_stands_on_its_side_of_the_guide() -> None:
    (diagram,) = drawn("7-1").figures(View.MECHANISM)
    guide = next(mark for mark in diagram.marks if isinstance(mark, FixedGuide))
    number = next(label for label in drawing(diagram).labels if text_of(label) == "5")
    assert number.centre.imag > guide.a.imag


def test_the_number_of_an_eccentric_disc_stands_in_it_or_at_its_rim_without_a_leader() -> None:
    disc = Disc(centre=2.5 + 1.5j, radius=10.0, owner="link 1")
    pivot = (Ground(at=0j, down=-1j, owner="frame"), Point(at=0j, label="A", dot=Dot.JOINT))
    at = -0.7 - 2.9j
    (number,) = numbers(disc, *pivot, LinkNumber(a=at, b=at, number="1", owner="link 1"))
    assert number.foot is None and abs(number.centre - disc.centre) < disc.radius + 4.0


@pytest.mark.parametrize("radius", [9.0, 40.0, 300.0])
def test_a_compass_stroke_is_inked_shorter_about_the_point_that_it_finds(radius: float) -> None:
    half = min(0.5, 7.0 / radius)
    stroke = Arc(centre=0j, radius=radius, start=1.0 - half, sweep=2 * half, role=Role.CONSTRUCTION)
    (line,) = [item for item in drawing(figure(stroke)).obstacles if isinstance(item, Stroke)]
    assert abs(line.points[-1] - line.points[0]) <= 9.0 + 1e-6
    assert cmath.phase(line.points[0] + line.points[-1]) == pytest.approx(1.0)


def test_a_whole_circle_of_the_construction_stays_whole() -> None:
    circle = Arc(centre=0j, radius=2.0, start=0.0, sweep=2 * pi, role=Role.CONSTRUCTION)
    assert any(isinstance(item, Stroke) and item.closed for item in drawing(figure(circle)).obstacles)


def test_a_part_of_a_circle_is_no_stroke_however_short() -> None:
    """As the half circle from which a cosine law is drawn."""
    half = Arc(centre=0j, radius=4.0, start=0.0, sweep=pi, role=Role.CONSTRUCTION)
    (line,) = [item for item in drawing(figure(half)).obstacles if isinstance(item, Stroke)]
    assert [line.points[0], line.points[-1]] == pytest.approx([4.0 + 0j, -4.0 + 0j])


def test_words_that_name_lines_of_two_directions_and_those_of_a_line_that_has_them_already_are_left_out() -> None:
    guide = Words("∥导路", "∥guide")

    def ruled(a: complex, b: complex) -> tuple[Segment, Point]:
        return Segment(a=a, b=b, role=Role.DIRECTION), Point(at=b, label="", dot=Dot.NONE, said=guide)

    for marks, count in (
        ((*ruled(0j, 40 + 0j), *ruled(60 + 0j, 95 + 0j)), 1),
        ((*ruled(0j, 40 + 0j), *ruled(30j, 40 + 30j)), 2),
        ((*ruled(0j, 40 + 0j), *ruled(30j, 70j)), 0),
    ):
        assert len(drawing(figure(*marks), lang="en").labels) == count
