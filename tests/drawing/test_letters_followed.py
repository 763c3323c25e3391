"""Letters of a drawing that follows its problem: as on paper where it starts, and never beside the wrong point."""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import pytest

from tests.drawn_library import drafted
from tests.laws import few
from vecpoly import redraw
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Dot, Point, Segment
from vecpoly.drawing.figure import drawing
from vecpoly.drawing.labels.following import Follower
from vecpoly.drawing.labels.wants import unnamed
from vecpoly.drawing.scene import Item, Rect, Stroke, TextBox
from vecpoly.solution import Solution
from vecpoly.words import Lang, Words

SCALE = Scale(symbol="μ_l", value=0.001, unit="m")
BESIDE_SILENT_POINTS = ("cam-flat-arm", "3-1d", "engine-flywheel")  # figures on which these tell where letters stand
LARGER = 1.3


def paper(name: str) -> Solution:
    solution = drafted(name)
    assert solution is not None
    return solution


def letters(items: tuple[Item, ...]) -> set[tuple[object, ...]]:
    """Type and leaders, and where they stand."""
    types = {(one.box, one.x, one.y) for one in items if isinstance(one, TextBox)}
    return types | {one.points for one in items if isinstance(one, Stroke)}


def figure(*marks: Point | Segment) -> Figure:
    return Figure(view=View.MECHANISM, title=Words.same("t"), scale=SCALE, marks=marks)


@pytest.mark.parametrize("name", few([*BESIDE_SILENT_POINTS, "3-9", "4-3a"], 3))
def test_at_the_first_position_letters_stand_where_they_stand_on_paper(name: str) -> None:
    """Points without a letter are in their way there too."""
    figures = paper(name).construction.figures
    assert name not in BESIDE_SILENT_POINTS or any(unnamed(one.marks) for one in figures)
    for one in figures:
        assert letters(Follower("zh").lettered(one)) == letters(drawing(one, caption=False).scene.items)


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_a_drawing_that_is_redrawn_unchanged_has_its_letters_where_the_paper_has_them(lang: Lang) -> None:
    solution = paper("4-3a")
    again = redraw(solution, solution.problem, lang=lang)
    for one, scene in zip(again.construction.figures, again.scenes, strict=True):
        assert letters(scene.items) == letters(drawing(one, lang=lang).scene.items)


@pytest.mark.parametrize("name", few(["3-9", "3-12", "geared-five-bar"], 2))
def test_larger_letters_stay_at_their_places_of_the_paper_as_far_as_they_fit_there(name: str) -> None:
    moved = 0
    figures = paper(name).construction.figures
    for one in figures:
        own, larger = Follower("zh"), Follower("zh", LARGER)
        own.lettered(one)
        larger.lettered(one)
        assert own.choice.keys() == larger.choice.keys(), "a label is the same in any size"
        moved += sum(own.choice[label] != place for label, place in larger.choice.items())
    assert moved <= 0.25 * sum(len(drawing(one).labels) for one in figures)


def test_a_letter_does_not_stay_beside_a_point_without_one_that_comes_near() -> None:
    named, far = Point(at=0j, label="A", dot=Dot.JOINT), Point(at=90 + 90j, label="", dot=Dot.JOINT)
    follower = Follower("zh")
    first = middle(follower.lettered(figure(named, far)))
    near = replace(far, at=first + 3.3 * first / abs(first))  # the letter lies between the two
    then = box(follower.lettered(figure(named, near)))
    assert gap(then, near.at) > gap(then, named.at)
    assert abs(then.centre - near.at) > abs(first - near.at) + 1.0, "it has gone to another side"


def test_a_letter_stays_where_it_is_while_nothing_comes_in_its_way() -> None:
    follower = Follower("zh")
    places = [middle(follower.lettered(figure(Point(at=z, label="A", dot=Dot.JOINT)))) - z for z in (0j, 9 + 1j, 30j)]
    assert places == pytest.approx([places[0]] * 3)


def box(items: tuple[Item, ...]) -> Rect:
    (rect,) = [one.rect for one in items if isinstance(one, TextBox)]
    return rect


def middle(items: tuple[Item, ...]) -> complex:
    return box(items).centre


def gap(rect: Rect, at: complex) -> float:
    """From a rectangle to a point, mm."""
    return hypot(max(rect.x0 - at.real, at.real - rect.x1, 0), max(rect.y0 - at.imag, at.imag - rect.y1, 0))
