"""A sheet can be read: figures as large as it allows, knots drawn apart, angles and letters that say what they mean."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest

from tests.drawn_library import drawn
from tests.drawn_sheets import laid, share
from tests.laws import few
from vecpoly.board.construction import Construction, Figure, Scale, View
from vecpoly.board.paper.marks import AngleMark, Dot, FrictionCircle, LinkNumber, Mark, Point, Role, Segment, Vector
from vecpoly.board.paper.scales import Sketched, finer
from vecpoly.drawing.details.apart import detailed
from vecpoly.drawing.details.knots import knots
from vecpoly.drawing.sheets.paper import linked, nearest_pins
from vecpoly.drawing.sheets.scales.composition import CRAMPED, OWN, STANDS, Composing
from vecpoly.drawing.sheets.scales.growing import grown
from vecpoly.drawing.sheets.sheet import bound, sheets
from vecpoly.drawing.sheets.space import SPARSE, room_inside
from vecpoly.problem.load import load
from vecpoly.solution import solve
from vecpoly.words import Words

SCALE = Scale(symbol="μ_a", value=0.006, unit="m/s^2")


def polygon(spread: float, far: float = 80.0) -> Figure:
    """Five letters round the pole at a distance of `spread` mm, and one far away."""
    near = [cmath.rect(spread, 2 * math.pi * k / 5) for k in range(5)]
    marks: list[Mark] = [
        Point(at=0j, label="p′", dot=Dot.POLE),
        Point(at=far + 0j, label="f^′", dot=Dot.POINT),
        Vector(a=0j, b=far + 0j, role=Role.RESULT),
    ]
    for k, at in enumerate(near):
        marks += [Point(at=at, label="bcden"[k] + "^′", dot=Dot.POINT), Vector(a=0j, b=at, role=Role.GIVEN)]
    return Figure(
        view=View.ACCELERATION, title=Words("加速度多边形", "Acceleration polygon"), scale=SCALE, marks=tuple(marks)
    )


def letters(figure: Figure) -> set[str]:
    return {m.label for m in figure.marks if isinstance(m, Point) and m.label}


def test_a_knot_keeps_the_letters_of_its_pole_and_of_two_more_places_and_has_them_all_in_the_detail() -> None:
    figure = polygon(3.0)
    main, detail = detailed(figure)
    assert letters(main) == {"p′", "b^′", "c^′", "f^′", "Ⅰ"}
    assert letters(detail) == letters(figure) - {"f^′"}


def test_a_length_in_the_detail_times_its_own_scale_is_the_same_quantity() -> None:
    figure = polygon(3.0)
    _, detail = detailed(figure)
    places = {m.label: m.at for m in detail.marks if isinstance(m, Point)}
    assert abs(places["b^′"] - places["p′"]) * detail.scale.value == pytest.approx(3.0 * SCALE.value)


def test_an_arrow_that_leaves_the_circle_has_no_head_in_the_detail() -> None:
    _, detail = detailed(polygon(3.0))
    cut = [m for m in detail.marks if isinstance(m, Segment)]
    (knot,) = knots(polygon(3.0))
    assert len(cut) == 1
    assert abs(cut[0].b) == pytest.approx(knot.radius * knot.factor)


@pytest.mark.parametrize(
    "figure", [polygon(20.0), polygon(3.0, far=20.0)], ids=["letters wide apart", "small altogether"]
)
def test_a_polygon_without_a_knot_is_left_as_it_is(figure: Figure) -> None:
    assert detailed(figure) == (figure,)


def test_sheets_bound_together_are_numbered_through_and_named() -> None:
    loose = [
        sheet
        for _ in range(3)
        for sheet in sheets(Construction(problem="x", hand="exact", figures=(polygon(3.0),), steps=(), readings={}))
    ]
    made = bound(loose, [Words(f"图 6-{n}", f"Figure 6-{n}") for n in (1, 2, 3)])
    assert [(s.strip.number, s.strip.total, s.strip.name.zh) for s in made] == [
        (1, 3, "图 6-1"),
        (2, 3, "图 6-2"),
        (3, 3, "图 6-3"),
    ]
    assert [len(s.figures) for s in made] == [2, 2, 2]


@pytest.mark.parametrize("phi", [60.0, 200.0, 257.7, 340.0, -30.0])
def test_the_arc_of_the_driving_angle_runs_as_far_as_the_angle_that_is_stated(phi: float) -> None:
    problem = load("A-27")
    mech = problem.mechanism
    turned = replace(problem, subject=replace(mech, drives=(replace(mech.drive, position=math.radians(phi)),)))
    figure = solve(turned, repeats=0).construction.figure(View.MECHANISM)
    assert figure is not None
    (arc,) = (m for m in figure.marks if isinstance(m, AngleMark))
    assert math.degrees(arc.sweep) == pytest.approx(phi)


def test_two_coriolis_accelerations_of_one_polygon_end_in_letters_of_their_own() -> None:
    figure = solve(load("A-16"), repeats=0).construction.figure(View.ACCELERATION)
    assert figure is not None
    places: dict[str, set[complex]] = {}
    for mark in figure.marks:
        if isinstance(mark, Point) and mark.label:
            places.setdefault(mark.label, set()).add(complex(round(mark.at.real, 3), round(mark.at.imag, 3)))
    assert {"k_2^′", "k_5^′"} <= set(places)
    assert all(len(at) == 1 for at in places.values())


def test_finer_scales_go_down_the_series_with_one_and_a_half_before_two() -> None:
    steps = [0.004]
    while steps[-1] > 0.0008:
        steps.append(finer(steps[-1]))
    assert steps == [0.004, 0.003, 0.0025, 0.002, 0.0015, 0.001, 0.0008]


def test_lines_narrower_than_their_title_grow_into_the_white_beside_it() -> None:
    """40 mm of lines and 30 mm of white beside them, 10 mm of letters; as they shrink the white stays as estimated."""
    kind = View.MECHANISM
    one = Sketched(view=kind, of=kind, scale=2.0, size=(40.0, 20.0), around=(40.0, 30.0), spare=30.0)
    assert one.at(2.0) == (80.0, 50.0)
    assert one.at(1.25) == pytest.approx((80.0, 62.0))
    assert one.at(1.0) == pytest.approx((90.0, 70.0))
    assert one.at(4.0) == pytest.approx((60.0, 40.0))


@pytest.mark.parametrize("name", ["4-4", "4-7", "shaper-cut"])
def test_about_a_short_crank_forces_have_the_room_of_one_sheet_more(name: str) -> None:
    diagram = drawn(name).figures(View.MECHANISM)[0]
    assert nearest_pins(diagram, 1.0) >= CRAMPED


def test_no_sheet_more_is_drawn_for_a_crank_that_would_hardly_be_larger_on_it() -> None:
    assert len(laid("4-5")) == 2


@pytest.mark.parametrize("name", few(["4-4", "4-7", "shaper-cut", "plate-on-crank", "plate-two-slides"], 3))
def test_the_sheet_more_is_not_left_white(name: str) -> None:
    assert all(share(sheet) > SPARSE for sheet in laid(name))


def bearing(radius: float) -> Figure:
    """A mechanism 80 mm long with a friction circle of this radius about one of its pins."""
    marks = (
        Segment(a=0j, b=80 + 0j, role=Role.LINK),
        Segment(a=-10 + 1j * radius, b=90 + 1j * radius, role=Role.CONSTRUCTION),
        Point(at=0j, label="A", dot=Dot.JOINT),
        Point(at=80 + 0j, label="B", dot=Dot.JOINT),
        FrictionCircle(centre=0j, radius=radius),
    )
    return Figure(view=View.MECHANISM, title=Words("机构运动简图", "Diagram"), scale=SCALE, marks=marks)


def test_a_friction_circle_too_small_to_see_where_it_is_touched_is_drawn_apart() -> None:
    main, detail = detailed(bearing(0.8))
    (circle,) = (mark for mark in detail.marks if isinstance(mark, FrictionCircle))
    assert circle.radius == pytest.approx(0.8 * SCALE.value / detail.scale.value) and circle.radius >= 3.0
    (line,) = (mark for mark in detail.marks if isinstance(mark, Segment) and mark.role is Role.CONSTRUCTION)
    assert line.a.imag - circle.centre.imag == pytest.approx(circle.radius)
    assert letters(main) == {"A", "B", "Ⅰ"} and letters(detail) == {"A"}


@pytest.mark.parametrize("radius", [0.8, 1.6, 1.9])
def test_a_friction_circle_is_drawn_apart_more_than_twice_as_large(radius: float) -> None:
    """At 2:1 one of 3 mm is hardly seen better."""
    main, detail = detailed(bearing(radius))
    (circle,) = (mark for mark in detail.marks if isinstance(mark, FrictionCircle))
    assert main.scale.value >= 2.5 * detail.scale.value and circle.radius >= 2.5


def test_a_friction_circle_that_can_be_seen_is_not_drawn_apart() -> None:
    assert detailed(bearing(2.5)) == (bearing(2.5),)


POLYGONS = (View.VELOCITY, View.ACCELERATION)


def sheetful(mechanism: float, *, bodies: int = 0) -> list[Sketched]:
    """A mechanism, so many free bodies to its scale and two polygons, of the sizes (mm) that they have at scale 1."""
    kinds = [View.MECHANISM, *[View.BODY] * bodies, *POLYGONS]
    sizes = [(mechanism, mechanism / 2)] * (bodies + 1) + [(100.0, 90.0)] * 2
    return [
        Sketched(view=kind, of=View.MECHANISM if kind is View.BODY else kind, scale=1.0, size=size, around=(20.0, 25.0))
        for kind, size in zip(kinds, sizes, strict=True)
    ]


@pytest.mark.parametrize("bodies", [0, 1, 2, 3, 4])
def test_as_many_sheets_hold_no_scales_at_which_the_smallest_figure_is_larger(bodies: int) -> None:
    page, sheets = (
        Composing(sheetful(150.0, bodies=bodies), {View.MECHANISM, *POLYGONS}, room_inside()),
        1 + bodies // 3,
    )
    start = dict.fromkeys(page.kinds, 4.0)
    scales = grown(page, start, sheets)
    assert scales is not None and page.needed(scales) <= sheets
    least, larger = page.legibles(scales)[0], dict(start)
    for kind in page.kinds:
        while page.legible(kind, larger) <= least:
            larger[kind] = finer(larger[kind])
    assert least < 1.0 and page.needed(larger) > sheets


@pytest.mark.parametrize("name", few(["4-3a", "4-3d", "winch-gears"], 2))
def test_sheets_that_are_one_more_for_a_small_mechanism_are_well_filled(name: str) -> None:
    assert all(share(sheet) > SPARSE for sheet in laid(name))


@pytest.mark.parametrize("name", ["4-3a", "4-3d", "winch-gears", "class-iii"])
def test_a_small_mechanism_with_forces_or_centres_about_it_has_the_room_of_one_sheet_more(name: str) -> None:
    assert len(laid(name)) == 2
    assert linked(drawn(name).figures(View.MECHANISM)[0]) >= OWN


@pytest.mark.parametrize("name", ["curv-1", "curv-2"])
def test_no_mechanism_is_made_small_for_a_plate(name: str) -> None:
    assert len(laid(name)) == 1 and linked(drawn(name).figures(View.MECHANISM)[0]) > 0.9 * OWN


def test_a_first_sheet_of_which_bands_would_be_white_is_a_plate_in_the_text() -> None:
    one, other = laid("class-iii")
    assert one.plate and share(one) > 0.85 and not other.plate


LETTERED = ["stephenson-valve-gear", "class-iii-slides", "B-24", "A-30-b", "dump-hoist"]


@pytest.mark.parametrize("name", few(LETTERED, 2))
def test_a_mechanism_too_small_for_its_letters_beside_its_polygons_has_the_room_of_one_sheet_more(name: str) -> None:
    diagram = drawn(name).figures(View.MECHANISM)[0]
    letters = sum(1 for mark in diagram.marks if getattr(mark, "label", "") or isinstance(mark, LinkNumber))
    assert len(laid(name)) == 2 and linked(diagram) > STANDS * letters


@pytest.mark.parametrize("name", few(LETTERED, 2))
def test_no_sheet_that_is_one_more_for_the_letters_is_half_white(name: str) -> None:
    assert all(share(sheet) > 0.5 for sheet in laid(name))


def test_a_mechanism_stays_on_one_sheet_where_two_would_be_left_white() -> None:
    assert len(laid("cam-roller")) == len(laid("planetary-reactions")) == 1
