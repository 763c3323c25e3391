"""Lettering stands beside what it names and on nothing else."""

from __future__ import annotations

import cmath
import math
import random
from itertools import combinations

import pytest
import shapely

from tests.drawn_library import DRAFTED, LIBRARY, drafted
from tests.drawn_sheets import lettered
from tests.each import each
from tests.label_faults import astray, close, crammed, faults, fractions, leaders, parted
from tests.laws import few
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import AngleMark, Dot, Hatched, LinkNumber, Point, Role, Segment, Vector
from vecpoly.drawing.figure import Drawing, drawing
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.labels.wants import unnamed
from vecpoly.drawing.scene import Fill, Item, Rect, Stroke
from vecpoly.drawing.style import LETTER, NOTE, THIN, Hue
from vecpoly.typeset import Glyphs
from vecpoly.typeset.box import MM
from vecpoly.words import Words

LONGEST = 31.0  # mm
ACROSS = 0.015  # of all labels: parted from their things, where a leader would cross more
CLOSE = 0.01  # of as many labels: pairs that stand less than 1.8 mm apart
SCALE = Scale(symbol="μ_v", value=0.006, unit="m/s")


def figure(*marks: object) -> Figure:
    """A velocity polygon of these marks."""
    return Figure(view=View.VELOCITY, title=Words("速度多边形", "Velocity polygon"), scale=SCALE, marks=tuple(marks))  # type: ignore[arg-type]


def polygon(seed: int, vectors: int = 7) -> Figure:
    """A random polygon: vectors from the pole, closing sides, directions, all lettered."""
    dice = random.Random(seed)
    tips = [cmath.rect(dice.uniform(18, 70), dice.uniform(0, 2 * math.pi)) for _ in range(vectors // 2 + 1)]
    marks: list[object] = [Point(at=0j, label="p", dot=Dot.POLE)]
    for i, tip in enumerate(tips):
        letter = "bcdefg"[i]
        marks += [
            Vector(a=0j, b=tip, role=Role.RESULT, label=f"v_{letter.upper()}", step=i),
            Point(at=tip, label=letter, dot=Dot.POINT, step=i),
        ]
        if i:
            u = (tip - tips[i - 1]) / abs(tip - tips[i - 1])
            marks += [
                Vector(a=tips[i - 1], b=tip, role=Role.GIVEN, label=f"v_{{{letter.upper()}B}}", step=i),
                Segment(a=tips[i - 1], b=tip + 6 * u, role=Role.DIRECTION, step=i),
            ]
    return figure(*marks)


def sizes(drawn: Drawing, things: set[Thing] | None = None) -> set[float]:
    """How large the type of each label is (mm): its largest glyph, for indices are smaller."""
    labels = [label for label in drawn.labels if things is None or label.want.thing in things]
    boxes = [piece.box for label in labels for piece in label.want.pieces]
    return {round(max(item.size for item in box.items if isinstance(item, Glyphs)) / MM, 6) for box in boxes}


@pytest.mark.parametrize("seed", few(range(40), 4))
def test_no_label_stands_on_a_line_an_arrowhead_or_another_label(seed: int) -> None:
    assert faults(drawing(polygon(seed))) == []


def test_a_label_is_nearer_to_its_own_vector_than_to_half_its_length() -> None:
    drawn = drawing(figure(Vector(a=0j, b=60 + 20j, role=Role.RESULT, label="v_B")))
    (box,) = drawn.label_boxes
    line = shapely.LineString([(0, 0), (60, 20)])
    assert 0.4 < line.distance(shapely.box(box.x0, box.y0, box.x1, box.y1)) < 2.5


def test_letters_of_the_same_point_share_one_label_in_the_order_they_were_drawn() -> None:
    drawn = drawing(
        figure(Point(at=0j, label="p", dot=Dot.POLE, step=1), Point(at=0j, label="d", dot=Dot.POINT, step=2))
    )
    (label,) = drawn.labels
    assert [piece.step for piece in label.want.pieces] == [1, 2, 2]
    assert label.want.pieces[0].dx < label.want.pieces[1].dx < label.want.pieces[2].dx


def test_the_same_letter_given_twice_at_one_point_is_set_once() -> None:
    twice = Point(at=0j, label="B", dot=Dot.JOINT)
    assert len(drawing(figure(twice, twice)).labels[0].want.pieces) == 1


def test_a_very_short_vector_gets_its_label_beside_it_and_not_over_it() -> None:
    drawn = drawing(
        figure(
            Point(at=0j, label="p'", dot=Dot.POLE),
            Vector(a=0j, b=2 + 0j, role=Role.RESULT, label="a^n_CB"),
            Point(at=2 + 0j, label="n'", dot=Dot.POINT),
            Vector(a=0j, b=40j, role=Role.RESULT, label="a_C"),
        )
    )
    assert faults(drawn) == []


def test_a_vector_of_no_length_is_lettered_without_complaint() -> None:
    drawn = drawing(figure(Vector(a=5j, b=5j, role=Role.RESULT, label="a^k"), LinkNumber(a=1j, b=1j, number="2")))
    assert len(drawn.labels) == 2 and faults(drawn) == []


def test_letters_move_before_they_shrink() -> None:
    star = [Vector(a=0j, b=cmath.rect(40, k * math.pi / 5), role=Role.RESULT, label=f"v_{k}") for k in range(10)]
    drawn = drawing(figure(Point(at=0j, label="p", dot=Dot.POLE), *star))
    assert faults(drawn) == [] and sizes(drawn) == {LETTER}


def test_letters_stay_within_a_frame_where_one_is_given() -> None:
    frame = Rect(-75.0, -75.0, 75.0, 75.0)
    for rect in drawing(polygon(3), frame=frame).label_boxes:
        assert rect.x0 >= frame.x0 - 1e-6 and rect.y1 <= frame.y1 + 1e-6


def test_hatching_is_left_out_about_a_letter_that_stands_on_it_and_nowhere_else() -> None:
    area = Hatched(points=(0j, 40 + 0j, 40 + 40j, 40j), rising=True)
    bare, lettered = drawing(figure(area)), drawing(figure(area, Point(at=20 + 20j, label="A_1", dot=Dot.NONE)))
    (letter,) = lettered.label_boxes
    grown = shapely.box(letter.x0 - 0.45, letter.y0 - 0.45, letter.x1 + 0.45, letter.y1 + 0.45)
    hatch, left = (shapely.union_all([_line(item) for item in each.obstacles]) for each in (bare, lettered))
    assert hatch.intersects(grown) and faults(lettered) == []
    assert hatch.difference(grown).length - left.length < 1.0 and not left.crosses(grown)


def _line(item: Item) -> shapely.LineString:
    assert isinstance(item, Stroke)
    return shapely.LineString([(z.real, z.imag) for z in item.points])


def test_placing_is_deterministic() -> None:
    once, again = (drawing.__wrapped__(polygon(11)) for _ in range(2))  # what was drawn first is not taken again
    assert once.label_boxes == again.label_boxes


@each(DRAFTED)
def test_no_label_of_the_library_stands_on_a_line_an_arrowhead_or_another_label(name: str) -> None:
    for one in lettered(name):
        assert faults(one) == []


@each(DRAFTED)
def test_no_label_of_the_library_stands_nearer_to_another_thing_of_its_kind_or_a_point_than_to_its_own(
    name: str,
) -> None:
    solution = drafted(name)
    for figure, one in zip(solution.construction.figures if solution else (), lettered(name), strict=True):
        assert astray(one, unnamed(figure.marks)) == []


def test_a_measured_arm_is_named_along_it_and_never_as_the_pivot_at_its_end() -> None:
    arm = Segment(a=0j, b=12 + 5j, role=Role.CONSTRUCTION)
    drawn = drawing(figure(arm, Point(at=0j, label="A", dot=Dot.JOINT), Point(at=6 + 2.5j, label="h", dot=Dot.NONE)))
    letter = next(label for label in drawn.labels if label.want.thing is Thing.END)
    assert letter.want.own == (arm.a, arm.b) and astray(drawn) == []


def test_an_angle_is_named_beside_its_arc_and_not_as_the_joint_on_it() -> None:
    vertex, joint = Point(at=0j, label="A", dot=Dot.JOINT), Point(at=cmath.rect(8, 0.5), label="", dot=Dot.JOINT)
    angle = AngleMark(at=0j, radius=8.0, start=0.0, sweep=1.0, label="φ_1")
    drawn = drawing(figure(vertex, joint, angle))
    assert len(drawn.labels) == 2 and astray(drawn, unnamed((vertex, joint, angle))) == []


@each(DRAFTED)
def test_no_two_labels_of_the_library_are_read_as_one(name: str) -> None:
    for one in lettered(name):
        assert crammed(one) == []


@each(DRAFTED)
def test_no_number_of_a_link_and_letter_of_a_point_are_read_as_a_fraction(name: str) -> None:
    for drawn in lettered(name):
        assert fractions(drawn) == []


@pytest.mark.parametrize("turn", range(8))
def test_a_letter_stands_on_its_side_of_a_line_that_runs_close_by_its_point(turn: int) -> None:
    way = cmath.exp(1j * math.pi * turn / 4)
    line = Segment(a=way * (1.5 - 20j), b=way * (1.5 + 20j), role=Role.CONSTRUCTION)
    assert parted(drawing(figure(Point(at=0j, label="C", dot=Dot.POINT), line))) == []


def test_hardly_any_label_lies_across_another_line_from_what_it_names_or_close_to_another() -> None:
    drawn = [one for name in few(LIBRARY, 3) for one in lettered(name)]  # a share is told by many
    count = sum(len(one.labels) for one in drawn)
    assert sum(len(parted(one)) for one in drawn) <= ACROSS * count
    assert sum(map(close, drawn)) <= CLOSE * count


@each(DRAFTED)
def test_the_letters_of_a_figure_have_one_size(name: str) -> None:
    """Those that name something; numbers, notes and directions in words are smaller, and alike too."""
    for one in lettered(name):
        assert sizes(one) <= {LETTER, NOTE}
        named = {Thing.POINT, Thing.VECTOR, Thing.LINK, Thing.END}
        assert sizes(one, named) <= {LETTER}


@each(DRAFTED)
def test_a_leader_is_a_thin_grey_line_without_a_head_and_no_longer_than_a_crowd_asks(name: str) -> None:
    for one in lettered(name):
        for line in leaders(one):
            a, b = line.points
            assert line.width == THIN and line.hue is Hue.GREY and abs(b - a) < LONGEST
        heads = [item for label in one.labels for item in label.items() if isinstance(item, Fill)]
        assert heads == []


def test_leaders_are_few_and_short() -> None:
    labels = sum(len(one.labels) for name in DRAFTED for one in lettered(name))
    long = [abs(line.points[1] - line.points[0]) for name in DRAFTED for one in lettered(name) for line in leaders(one)]
    assert len(long) < 0.08 * labels and sum(length > 14 for length in long) < 0.012 * labels


def test_leaders_hardly_ever_cross_each_other() -> None:
    drawn = [[_line(line) for line in leaders(one)] for name in DRAFTED for one in lettered(name)]
    crossed = sum(a.intersects(b) for lines in drawn for a, b in combinations(lines, 2))
    assert crossed < 0.015 * sum(map(len, drawn))


@each(DRAFTED)
def test_a_direction_is_lettered_where_its_line_runs_on_past_the_point_that_it_found(name: str) -> None:
    for one in lettered(name):
        for label in one.labels:
            if label.want.thing is Thing.DIRECTION and label.foot is None:
                start, end = label.want.own
                past = (end - start) / abs(end - start)
                assert ((label.centre - start) * past.conjugate()).real > 0, label


def test_a_letter_that_finds_no_place_beside_its_own_point_is_led_to_it() -> None:
    crowd = [Point(at=0.9 * cmath.rect(1.0, k * math.pi / 3), label=f"n_{k}^′", dot=Dot.POINT) for k in range(6)]
    drawn = drawing(figure(Point(at=0j, label="p′", dot=Dot.POLE), *crowd))
    assert astray(drawn) == [] and any(label.foot is not None for label in drawn.labels)
