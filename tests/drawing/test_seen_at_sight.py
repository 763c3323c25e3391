"""What a reader misses at sight: signs that are hidden or look cut off, points lost in bars, labels read as one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.drawing.test_details import polygon
from tests.drawing.test_labels import figure
from tests.drawn_library import drawn
from tests.label_faults import text_of
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import AngleMark, Arc, Block, Dot, Ground, ImageOf, Mark, Point, Role, Segment, TurnArrow
from vecpoly.drawing.details.knots import knots
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.hung import hung
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.scene import Fill, Layer, Rect, Scene
from vecpoly.drawing.sheets.packing import Layout
from vecpoly.drawing.sheets.pages import Page
from vecpoly.drawing.sheets.paging import Drawn, _rank
from vecpoly.drawing.strokes import short
from vecpoly.drawing.style import Hue
from vecpoly.drawing.symbols.angles import draw_turn
from vecpoly.drawing.weighing.stood import Stood
from vecpoly.methods.forces.acting import Acting
from vecpoly.methods.forces.bodies.arrows import place_arrows
from vecpoly.names import Named


@pytest.mark.parametrize("off", [0j, 3.0 + 1.0j])
def test_a_compass_stroke_that_finds_the_pin_of_a_block_is_not_inked(off: complex) -> None:
    """The block would leave scraps of it."""
    stroke = Arc(centre=-40 + 0j, radius=40.0, start=-0.1, sweep=0.2, role=Role.CONSTRUCTION)
    block = Block(at=off, along=1 + 0j)
    assert short((stroke, block)) == (block,)
    assert len(short((stroke, replace(block, at=10j)))) == 2


def test_a_part_of_a_circle_stays_beside_a_block() -> None:
    path = Arc(centre=-4 + 0j, radius=4.0, start=-1.5, sweep=3.0, role=Role.CONSTRUCTION)
    assert path in short((path, Block(at=0j, along=1 + 0j)))


@pytest.mark.parametrize("ccw", [True, False])
@pytest.mark.parametrize("radius", [5.0, 6.5, 12.0])
def test_the_head_of_a_curved_arrow_leans_to_neither_side_of_its_arc_and_is_short_beside_it(
    radius: float, ccw: bool
) -> None:
    _, head = draw_turn(TurnArrow(at=0j, radius=radius, start=0.6, ccw=ccw, label=""), Hue.BLACK)
    assert isinstance(head, Fill)
    tip, one, other = head.points
    assert abs(tip) == pytest.approx(radius) and abs(one + other) / 2 == pytest.approx(radius)
    assert abs(one - tip) == pytest.approx(abs(other - tip))
    assert abs(np.angle((one + other) / tip)) < 1 / 3


@pytest.mark.parametrize("end", [60 + 0j, 30 + 0j])
def test_a_point_on_the_line_of_a_link_is_wider_than_the_line(end: complex) -> None:
    """Within it, or at its end; a point beside it has the small dot of a polygon."""
    bar = Segment(a=0j, b=60 + 0j, role=Role.LINK)

    def width(at: complex) -> float:
        shown = replace(figure(bar, Point(at=at, label="E", dot=Dot.POINT)), view=View.MECHANISM)
        items = drawing(shown).obstacles
        (dot,) = (item for item in items if isinstance(item, Fill) and item.layer is Layer.HEAD)
        return max(abs(z - at) for z in dot.points)

    assert width(end) > 1.4 * width(end + 8j)


@pytest.mark.parametrize("gap", [2.0, 4.0])
def test_two_labels_in_one_line_cost_each_other_something_until_they_are_clearly_two(gap: float) -> None:
    one, other = (Stood.at(x + 0j, 1 + 1j, None, Thing.POINT) for x in (0.0, 2.0 + gap))
    assert one.meets(other) > 0
    assert one.meets(Stood.at(other.centre + 1.8j, 1 + 1j, None, Thing.POINT)) == 0
    assert one.meets(Stood.at(other.centre + 4.0, 1 + 1j, None, Thing.POINT)) == 0


def test_a_centre_at_infinity_is_not_named_in_one_line_with_the_pin() -> None:
    (diagram,) = drawn("3-1e").figures(View.MECHANISM)[:1]
    labels = {text_of(label): label for label in drawing(diagram).labels}
    pin, far = (next(label for text, label in labels.items() if text.startswith(name)) for name in ("B", "P∞34"))
    assert abs(pin.centre.imag - far.centre.imag) > 3.0


@pytest.mark.parametrize("side", [6.0, 10.0])
def test_an_image_that_is_small_beside_the_vectors_to_it_is_drawn_apart(side: float) -> None:
    corners = (30 + 40j, 30 + 40j + side, 30 + 40j + side * 1j)
    slight = polygon(40.0)
    assert not knots(slight)
    (knot,) = knots(replace(slight, marks=(*_times(slight.marks, 1.6), ImageOf(points=corners))))
    assert all(map(knot.holds, corners)) and side * knot.factor >= 16.0 and 2 * knot.radius * knot.factor <= 52.0
    assert not knots(replace(slight, marks=(*slight.marks, ImageOf(points=tuple(3 * z for z in corners)))))


def _times(marks: tuple[Mark, ...], factor: float) -> tuple[Mark, ...]:
    """The vectors and points so many times larger."""
    ends = ("a", "b", "at")
    return tuple(replace(m, **{k: getattr(m, k) * factor for k in ends if hasattr(m, k)}) for m in marks)


def test_a_support_does_not_cover_a_point_where_a_side_is_free() -> None:
    pivot, bars = Ground(at=0j, down=-1j), [Segment(a=0j, b=b, role=Role.LINK) for b in (20 + 50j, -20 + 50j)]
    angle = AngleMark(at=0j, radius=12.0, start=1.2, sweep=0.8, label="ψ")
    centre = Point(at=-4j, label="O", dot=Dot.POINT)
    (alone,) = (mark for mark in hung((pivot, angle, *bars)) if isinstance(mark, Ground))
    (beside,) = (mark for mark in hung((pivot, angle, *bars, centre)) if isinstance(mark, Ground))
    assert alone.down == -1j and beside.down.imag == 0


def test_of_pages_that_cost_the_same_plain_rows_come_before_columns_in_rows() -> None:
    """And white between figures before a little more of the page."""

    one = Drawn(View.FORCE, "", Scene((), Rect(0.0, 0.0, 150.0, 200.0)))

    def page(white: float, nested: int) -> list[Page[Drawn]]:
        return [((one,), Layout((190.0, 251.0), (20 + 25j,), white, 0, nested))]

    plain, deep, tight = page(12.0, 0), page(12.0, 2), page(3.0, 0)
    cost = (1, 0, 0, 0, 0)
    assert min((deep, plain, tight), key=lambda pages: _rank((cost, pages))) is plain


def test_an_arrow_that_stands_farther_out_is_as_near_to_its_point_as_the_others_leave_it() -> None:
    size = {"R_1": 13 - 2j, "R_2": -20 + 0j, "R_3": 12 + 0j, "R_4": 16j}
    forces = [Acting(named=Named(k, k, "N"), vector=v, at=0j) for k, v in size.items()]
    far = [one for one in place_arrows(forces, [0j], pressing={"R_4"}, pulling={"R_1", "R_2", "R_3"}) if one.far]
    assert far and all(min(abs(arrow.start), abs(arrow.end)) < 24.0 for arrow in far)
