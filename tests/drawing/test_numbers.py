"""Numbers of links: along bars clear of their joints, beside the outlines of blocks; and labels that make room."""

from __future__ import annotations

import cmath

import pytest
import shapely

from tests.drawing.test_labels import figure
from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import (
    AngleMark,
    Arc,
    Block,
    Disc,
    Dot,
    GearMark,
    LinkNumber,
    Mark,
    Passing,
    Plate,
    Point,
    Role,
    Segment,
    Slot,
    TurnArrow,
)
from vecpoly.diagram.owners import FIXED
from vecpoly.drawing.details.apart import all_detailed
from vecpoly.drawing.figure import draw_figure, drawing
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.scene import Fill, Stroke, TextBox
from vecpoly.drawing.symbols.angles import draw_angle
from vecpoly.drawing.symbols.bodies import block_corners
from vecpoly.drawing.weighing.placed import Placed
from vecpoly.typeset.box import Glyphs


def numbers(*marks: Mark) -> list[Placed]:
    return [label for label in drawing(figure(*marks)).labels if label.want.thing is Thing.LINK]


@pytest.mark.parametrize("at", [0.3, 0.5, 0.7])
def test_the_number_of_a_bar_stands_beside_its_longest_piece_and_not_at_the_joint_in_its_middle(at: float) -> None:
    end = cmath.rect(60, 1.4)
    bar = Segment(a=0j, b=end, role=Role.LINK, owner="link 2")
    pins = [Point(at=z, label=letter, dot=Dot.JOINT) for letter, z in (("B", 0j), ("C", end), ("E", at * end))]
    (number,) = numbers(bar, *pins, Passing(at=at * end, along=end / abs(end)), LinkNumber(a=0j, b=end, number="2"))
    share = (number.centre / end).real
    longest = [(low, high) for low, high in ((0.0, at), (at, 1.0)) if high - low > 0.5 - 1e-9]
    assert number.foot is None and any(abs(share - (low + high) / 2) < 0.2 * (high - low) for low, high in longest)


@pytest.mark.parametrize("turn", [0.0, 0.5, 1.2, 2.4])
def test_the_number_of_a_block_in_a_slot_stands_outside_the_slot_beside_the_block(turn: float) -> None:
    u = cmath.exp(1j * turn)
    block = Block(at=0j, along=u, owner="link 4")
    slot, pin = Slot(a=-20 * u, b=20 * u, owner="link 5"), Point(at=0j, label="D", dot=Dot.JOINT)
    (number,) = numbers(slot, block, pin, LinkNumber(a=0j, b=0j, number="4", owner="link 4"))
    assert number.foot is None
    corners = block_corners(block)
    assert min(abs(number.centre - corner) for corner in corners) < 6.0
    assert abs((number.centre * u.conjugate()).imag) > abs((corners[0] * u.conjugate()).imag)


def test_the_ring_of_a_detail_has_no_cross_in_its_centre() -> None:
    figures = drawn("3-1d").construction.figures
    details = [one for some in all_detailed(figures) for one in some[1:]]
    assert details
    for one in details:
        strokes = [item for item in drawing(one).scene.items if isinstance(item, Stroke)]
        assert not any(abs(sum(s.points)) < 1e-9 and abs(s.points[0]) < 3 and len(s.points) == 2 for s in strokes)


def test_a_circle_of_the_construction_keeps_its_cross() -> None:
    circle = Arc(centre=0j, radius=20.0, start=0.0, sweep=cmath.tau, role=Role.CONSTRUCTION)
    strokes = [item for item in drawing(figure(circle)).scene.items if isinstance(item, Stroke)]
    assert sum(len(stroke.points) == 2 for stroke in strokes) == 2


@pytest.mark.parametrize("name", ["A-16", "A-27", "3-12", "oldham-coupling"])
def test_a_block_between_the_links_of_a_mechanism_needs_no_leader_for_its_number(name: str) -> None:
    mechanism = drawn(name).construction.figure(View.MECHANISM)
    assert mechanism is not None
    blocks = {mark.owner for mark in mechanism.marks if isinstance(mark, Block)}
    beside = [label for label in drawing(mechanism).labels if label.want.thing is Thing.LINK and label.want.bow]
    numbered = [label for label in beside if label.want.own[0] != label.want.own[1]]  # in a plate it has its middle
    assert len(numbered) == len(blocks) and all(label.foot is None for label in numbered)


@pytest.mark.parametrize("name", ["rack-lift", "stepped-planet", "travel-doubler", "watt-line"])
def test_numbers_keep_off_the_joints_of_other_links(name: str) -> None:
    mechanism = drawn(name).construction.figure(View.MECHANISM)
    assert mechanism is not None
    labels = drawing(mechanism).labels
    joints = [label.want.own[0] for label in labels if label.want.thing is Thing.POINT]
    for number in (label for label in labels if label.want.thing is Thing.LINK):
        for joint in joints:
            off, rect = joint - number.centre, number.rect
            beyond = complex(max(abs(off.real) - rect.width / 2, 0.0), max(abs(off.imag) - rect.height / 2, 0.0))
            assert abs(beyond) > 2.3, (joint, number.centre)


@pytest.mark.parametrize("name", ["3-9", "three-legged-plate", "whitworth-quick-return", "curv-6"])
def test_the_number_of_the_frame_stands_by_no_arrow_of_a_drive_where_there_is_another_pivot(name: str) -> None:
    mechanism = drawn(name).figures(View.MECHANISM)[0]
    [number] = [mark for mark in mechanism.marks if isinstance(mark, LinkNumber) and mark.owner == FIXED]
    arrows = [mark.at for mark in mechanism.marks if isinstance(mark, TurnArrow) and mark.label.startswith("ω")]
    assert arrows and all(abs(number.a - at) > 5.0 for at in arrows)


@pytest.mark.parametrize("name", ["2-8full", "stepped-planet", "planetary-sun-drives"])
def test_the_number_of_a_wheel_stands_at_its_rim_and_not_about_a_shaft_that_it_shares(name: str) -> None:
    mechanism = drawn(name).figures(View.MECHANISM)[0]
    wheels = [mark for mark in mechanism.marks if isinstance(mark, GearMark)]
    texts = [label for label in drawing(mechanism).labels if label.want.thing is Thing.LINK and label.want.bow]
    assert texts
    for label in texts:
        away = [abs(abs(label.centre - wheel.centre) - wheel.radius) for wheel in wheels]
        assert min(away) < 6.0 and all(abs(label.centre - wheel.centre) > 4.0 for wheel in wheels)


@pytest.mark.parametrize("long", [4.5, 6.0, 7.9, 12.0])
def test_every_arc_of_an_angle_has_arrowheads_that_leave_some_of_it(long: float) -> None:
    heads = [
        item
        for item in draw_angle(AngleMark(at=0j, start=0.0, sweep=long / 10.0, label="α", radius=10.0))
        if isinstance(item, Fill)
    ]
    assert len(heads) == 2
    assert sum(max(abs(item.points[0] - z) for z in item.points) for item in heads) < 0.8 * long


def test_a_dashed_line_that_is_drawn_from_either_end_stays_dashed() -> None:
    there, back = (Segment(a=a, b=b, role=Role.OTHER) for a, b in ((0j, 50 + 0j), (50 + 0j, 0j)))
    assert sum(isinstance(item, Stroke) for item in drawing(figure(there, back)).scene.items) == 1


@pytest.mark.parametrize("name", ["elliptic-trammel", "3-1e"])
def test_the_number_of_a_frame_without_pivots_stands_at_the_hatching_of_its_guide(name: str) -> None:
    mechanism = drawn(name).figures(View.MECHANISM)[0]
    (guide,) = {(m.a, m.b) for m in mechanism.marks if isinstance(m, LinkNumber) and m.owner == FIXED}
    labels = [
        label for label in drawing(mechanism).labels if label.want.thing is Thing.LINK and label.want.own == guide
    ]
    along = (guide[1] - guide[0]) / abs(guide[1] - guide[0])
    for label in labels:
        assert -8.0 < ((label.centre - guide[0]) * along.conjugate()).imag < -1.7
    assert labels


def test_the_number_of_a_plate_stands_in_it_and_that_of_a_bar_over_it_beside_it() -> None:
    figure = next(one for one in drawn("A-27-c").construction.figures if one.view is View.MECHANISM)
    (plate,) = (mark for mark in figure.marks if isinstance(mark, Plate))
    shape = shapely.Polygon([(z.real, z.imag) for z in plate.points])
    boxes = [one for one in draw_figure(figure, lang="en").items if isinstance(one, TextBox)]
    where = {
        text: shapely.Point((box.rect.x0 + box.rect.x1) / 2, (box.rect.y0 + box.rect.y1) / 2)
        for box in boxes
        if (text := "".join(part.text for part in box.box.items if isinstance(part, Glyphs))) in ("2", "5")
    }
    assert shape.contains(where["2"]) and not shape.contains(where["5"])


@pytest.mark.parametrize("name", ["A-27-c", "A-27-d", "A-30", "B-24", "plate-two-slides"])
def test_no_number_of_a_bar_stands_in_the_body_of_another_link_over_which_the_bar_runs(name: str) -> None:
    mechanism = drawn(name).figures(View.MECHANISM)[0]
    owners = {(m.a, m.b): m.owner for m in mechanism.marks if isinstance(m, LinkNumber)}
    plates = [m for m in mechanism.marks if isinstance(m, Plate)]
    numbered = [label for label in drawing(mechanism).labels if label.want.own in owners and label.foot is None]
    assert plates and numbered
    for label in numbered:
        for plate in (one for one in plates if one.owner != owners[label.want.own]):
            turns = [corner - label.centre for corner in plate.points]
            round_it = sum(cmath.phase(b / a) for a, b in zip(turns, (*turns[1:], turns[0]), strict=True))
            assert abs(round_it) < 1.0, label.centre


@pytest.mark.parametrize("turn", [0.0, 1.1, 2.3, 3.9, 5.2])
def test_the_number_of_a_roller_stands_outside_it_and_in_no_plate_that_carries_it(turn: float) -> None:
    pin, size = 4 + 3j, 4.0
    corners = tuple(pin + cmath.rect(1.0, turn) * z for z in (0j, 28 + 12j, 28 - 12j))
    roller = Disc(centre=pin, radius=size, owner="link 3")
    plate = Plate(points=corners, owner="link 4")
    found = numbers(
        plate, roller, Point(at=pin, label="F", dot=Dot.JOINT), LinkNumber(a=pin, b=pin, number="3", owner="link 3")
    )
    (number,) = found
    shape = shapely.Polygon([(z.real, z.imag) for z in plate.points])
    assert abs(number.centre - pin) > size and not shape.contains(shapely.Point(number.centre.real, number.centre.imag))


def test_the_number_of_the_roller_stands_outside_the_rocker_that_carries_it_in_exercise_2_7() -> None:
    sketch = next(one for one in drawn("2-7").figures(View.MECHANISM) if any(isinstance(m, Disc) for m in one.marks))
    plates = [shapely.Polygon([(z.real, z.imag) for z in m.points]) for m in sketch.marks if isinstance(m, Plate)]
    boxes = [one.rect for one in draw_figure(sketch, lang="en").items if isinstance(one, TextBox) and _reads(one, "3")]
    (middle,) = [shapely.Point((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2) for box in boxes]
    assert plates and not any(plate.contains(middle) for plate in plates)


def _reads(box: TextBox, text: str) -> bool:
    return "".join(part.text for part in box.box.items if isinstance(part, Glyphs)) == text
