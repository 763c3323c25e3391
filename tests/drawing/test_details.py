"""Crowded places are drawn apart: what is a knot, how it is enlarged, where its detail stands."""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations, pairwise
from math import pi

import numpy as np
import pytest

from tests.drawn_library import drafted
from vecpoly import load
from vecpoly.board.construction import Construction, Figure, Scale, View
from vecpoly.board.paper.marks import Arc, Dot, FrictionCircle, Mark, Point, Role, Segment, Vector
from vecpoly.board.ruler import READABLE
from vecpoly.drawing.details.apart import all_detailed, detailed, is_detail, numeral
from vecpoly.drawing.details.knot import FACTORS, FULL, HALF, LEAST, LONG, largest
from vecpoly.drawing.details.knots import MOST, knots
from vecpoly.drawing.details.room import CELL, WHITE, Grow, Room, along, reach_of
from vecpoly.drawing.scene import Fill, Rect, Scene, Stroke
from vecpoly.drawing.sheets.nested import nested
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.words import Words


def polygon(short: float, *, view: View = View.FORCE, name: str = "2") -> Figure:
    """A force polygon of 90 mm with a vector of so many mm."""
    at = [0j, 90 + 0j, 90 - 1j * short, 30 + 40j]
    marks: list[Mark] = [Point(at=z, label=letter, dot=Dot.POINT) for z, letter in zip(at, "abcd", strict=True)]
    marks += [
        Vector(a=a, b=b, role=Role.RESULT, label=f"F_{n}")
        for n, (a, b) in enumerate(zip(at, (*at[1:], at[0]), strict=True))
    ]
    scale = Scale(symbol="μ_F", value=10.0, unit="N")
    return Figure(view=view, title=Words("力多边形", "Force polygon"), scale=scale, marks=tuple(marks), name=name)


@pytest.mark.parametrize("short", [0.3, 0.6, 1.2, 2.0, 2.9, 3.4, 4.4])
def test_a_vector_that_is_found_and_short_is_drawn_apart_and_readable_there(short: float) -> None:
    main, detail = detailed(polygon(short))
    (knot,) = knots(polygon(short))
    (long,) = [abs(m.b - m.a) for m in detail.marks if isinstance(m, Vector) and m.label == "F_1"]
    assert long == pytest.approx(short * knot.factor) and long >= READABLE
    assert knot.factor in FACTORS and 2 * knot.radius * knot.factor <= FULL
    assert detail.scale.value == pytest.approx(10.0 / knot.factor)
    assert {m.label for m in main.marks if isinstance(m, Point)} - {""} == {"a", "b", "c", "d", "Ⅰ"}
    assert not any(isinstance(m, Vector) and m.label == "F_1" for m in main.marks)
    (ring,) = [m for m in main.marks if isinstance(m, Arc)]
    assert (ring.radius, abs(ring.sweep)) == pytest.approx((knot.radius, 2 * np.pi))


@pytest.mark.parametrize("short", [0.05, 4.5, 20.0])
def test_what_no_enlargement_shows_and_what_is_long_enough_is_left_as_it_is(short: float) -> None:
    assert detailed(polygon(short)) == (polygon(short),)


@pytest.mark.parametrize(("short", "apart"), [(2.9, True), (3.1, False), (4.4, False)])
def test_a_vector_that_is_laid_off_is_drawn_apart_only_where_it_cannot_be_measured(short: float, apart: bool) -> None:
    plain = polygon(short)
    marks = tuple(replace(mark, role=Role.GIVEN) if isinstance(mark, Vector) else mark for mark in plain.marks)
    assert (len(detailed(replace(plain, marks=marks))) == 2) is apart


def test_free_bodies_have_no_details_for_their_arrows_have_no_length() -> None:
    assert knots(polygon(1.0)) and not knots(polygon(1.0, view=View.BODY))


def test_details_of_several_figures_are_numbered_through() -> None:
    figures = (polygon(1.0, name="2"), polygon(20.0, name="3"), polygon(2.0, name="4"))
    made = all_detailed(figures)
    assert [len(one) for one in made] == [2, 1, 2]
    assert ["Ⅰ" in made[0][1].title.zh, "Ⅱ" in made[2][1].title.zh] == [True, True]
    assert is_detail(made[0][1].name, figures[0]) and not is_detail(made[0][1].name, figures[2])
    assert len({numeral(n) for n in range(1, 30)}) == 29


def square(x: float, y: float, side: float) -> Scene:
    """A filled square."""
    corners = (complex(x, y), complex(x + side, y), complex(x + side, y + side), complex(x, y + side))
    return Scene.of((Fill(points=corners),))


@pytest.mark.parametrize("grow", list(Grow))
def test_a_detail_stands_clear_of_the_ink_of_its_figure_and_of_other_details(grow: Grow) -> None:
    ell = Scene.of((Stroke(points=(0j, 100 + 0j), width=0.5), Stroke(points=(0j, 80j), width=0.5)))
    details = [(square(500, 0, side), 10 + 10j) for side in (30.0, 25.0, 40.0)]
    boxes = [one.moved(by).extents for (one, _), by in zip(details, nested(ell, details)[grow], strict=True)]
    assert not any(a.grown(WHITE - 1e-6).overlaps(b) for a, b in combinations(boxes, 2))
    for box in boxes:
        assert not any(box.grown(WHITE - 1.0).overlaps(Rect(z.real, z.imag, z.real, z.imag)) for z in _points(ell))


def _points(scene: Scene) -> list[complex]:
    lines = [item.points for item in scene.items if isinstance(item, Stroke)]
    return [a + (b - a) * share for a, b in lines for share in np.linspace(0.0, 1.0, 400).tolist()]


def test_a_detail_stands_in_a_corner_that_its_figure_leaves_free() -> None:
    ell = Scene.of((Stroke(points=(0j, 100 + 0j), width=0.5), Stroke(points=(0j, 80j), width=0.5)))
    (by,) = nested(ell, [(square(0, 0, 30), 90 + 70j)])[Grow.LEAST]
    assert 0 < by.real < 70 and 0 < by.imag < 50


def test_a_sheet_has_the_detail_beside_its_figure_inside_the_frame() -> None:
    (sheet,) = sheets(Construction(problem="x", hand="exact", figures=(polygon(1.0),), steps=(), readings={}))
    main, detail = sheet.figures
    assert (main.name, detail.name) == ("2", "2 detail 1") and detail.figure is not None
    assert not main.extents.overlaps(detail.extents) or detail.extents.width < main.extents.width
    assert detail.extents.x0 >= 10 and detail.extents.x1 <= sheet.size[0] - 10


def solved(name: str) -> Construction:
    solution = drafted(name)
    return solution.construction if solution is not None else load(name).solve().construction


@pytest.mark.parametrize(
    ("name", "view", "letters"),
    [("crank-pin-in-slot", View.MECHANISM, "AD"), ("A-30", View.ACCELERATION, ["p′", "e^′"])],
)
def test_what_is_spoken_of_has_its_letter_on_the_figure_itself_too(
    name: str, view: View, letters: Sequence[str]
) -> None:
    figure = solved(name).figure(view)
    assert figure is not None
    whole, *details = detailed(figure)
    kept = {mark.label for mark in whole.marks if isinstance(mark, Point)}
    apart = {mark.label for detail in details for mark in detail.marks if isinstance(mark, Point)}
    assert set(letters) <= kept and set(letters) <= apart


def test_beside_a_ring_there_are_two_letters_at_most() -> None:
    for name in ("A-30", "crank-pin-in-slot"):
        for figure in solved(name).figures:
            whole, *_ = detailed(figure)
            for knot in knots(figure):
                left = {
                    mark.at for mark in whole.marks if isinstance(mark, Point) and mark.label and knot.holds(mark.at)
                }
                assert 1 <= len({complex(round(at.real, 1), round(at.imag, 1)) for at in left}) <= 2


def test_a_detail_finds_room_beyond_lines_that_run_on_past_the_figure_on_every_side() -> None:
    """As of a sketch that is drawn four times as large, whose lines of direction grow with it."""
    figure, detail = Rect(0.0, 0.0, 20.0, 20.0), Rect(0.0, 0.0, 30.0, 30.0)
    lines = [along([complex(-90, y), complex(110, y)]) for y in range(-70, 91, 20)]
    room = Room.about(figure, lines, reach_of([detail]))
    assert not len(room.free(detail.width + 2 * WHITE, detail.height + 2 * WHITE)), "none is near"
    found = room.put(detail, figure.centre, Grow.LEAST)
    assert (found.width, found.height) == (30.0, 30.0)
    assert not any(found.grown(WHITE - CELL).overlaps(Rect(-90.0, y, 110.0, y)) for y in range(-70, 91, 20))
    assert room.extents == figure | found


@pytest.mark.parametrize("short", [0.3, 0.6, 1.2, 2.0, 2.9])
def test_a_detail_is_no_larger_than_it_must_be(short: float) -> None:
    (knot,) = knots(polygon(short))
    across = 2 * knot.radius * knot.factor
    assert across <= largest(90.0)
    smaller = [factor for factor in FACTORS if factor < knot.factor]
    assert all(short * factor < LONG for factor in smaller)


def test_a_detail_of_a_small_figure_is_small() -> None:
    assert largest(30.0) == LEAST and largest(64.0) == HALF * 64.0 and largest(200.0) == FULL


def test_of_many_small_friction_circles_those_that_most_lines_touch_are_drawn_apart() -> None:
    """Five pins of a chain; at the last two lines of action touch the circle, at the others one."""
    pins, radius = [complex(45 * n, 20 * (n % 2)) for n in range(5)], 1.0
    marks: list[Mark] = [Segment(a=a, b=b, role=Role.LINK) for a, b in pairwise(pins)]
    for n, (pin, letter) in enumerate(zip(pins, "ABCDE", strict=True)):
        marks += [Point(at=pin, label=letter, dot=Dot.JOINT), FrictionCircle(centre=pin, radius=radius)]
        for k, turn in enumerate((0.4, 1.9)[: 1 + (n == len(pins) - 1)]):
            way, touch = rect(1.0, turn), pin + rect(radius, turn + pi / 2)
            marks.append(Segment(a=touch - 15 * way, b=touch + 15 * way, role=Role.DIRECTION, key=f"R_{n}{k}"))
    shown = knots(replace(polygon(90.0, view=View.MECHANISM), marks=tuple(marks)))
    assert len(shown) == MOST and shown[0].holds(pins[-1])
