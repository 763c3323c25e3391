"""Names of directions that would crowd a polygon are left to the equation, which tells them anyhow."""

from __future__ import annotations

from cmath import rect
from dataclasses import replace

import pytest

from tests.drawing.test_labels import figure
from tests.drawn_library import IDS, drawn
from tests.each import each
from tests.label_faults import text_of
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import AngleMark, Dot, Mark, Point, Role, Segment
from vecpoly.board.strokes import OVERRUN
from vecpoly.drawing.figure import Bare, drawing
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.spared import ABOUT, FAR, LED, MANY
from vecpoly.words import Words


def _meeting(around: int) -> Figure:
    """Two direction lines that meet at c, with so many more letters about it."""
    lines: list[Mark] = []
    for turn, name in ((0.3, "⊥BC"), (1.9, "⊥DC")):
        a, b = rect(-40, turn), rect(OVERRUN, turn)
        lines += [Segment(a=a, b=b, role=Role.DIRECTION), Point(at=b, label="", said=Words.same(name), dot=Dot.NONE)]
    letters = [Point(at=rect(11.0, 0.5 * n), label=f"n_{n}", dot=Dot.POINT) for n in range(around)]
    return figure(*lines, Point(at=0j, label="c", dot=Dot.POINT), *letters)


def _named(shown: Figure) -> set[str]:
    return {text_of(one) for one in drawing(shown).labels if one.want.thing is Thing.DIRECTION}


@pytest.mark.parametrize(("around", "named"), [(0, {"⊥BC", "⊥DC"}), (12, set[str]())])
def test_where_letters_crowd_neither_line_of_a_meeting_has_its_name(around: int, named: set[str]) -> None:
    assert _named(_meeting(around)) == named


@pytest.mark.parametrize(
    ("name", "view", "named"),
    [
        ("excavator-boom", View.VELOCITY, {"⊥AC", "⊥DC"}),
        ("boom-thrust", View.VELOCITY, {"⊥AC", "⊥DC"}),
        ("3-6", View.ACCELERATION, {"⊥BC", "⊥DC"}),
    ],
)
def test_a_name_on_a_long_leader_that_is_in_nobodys_way_stays_and_so_does_the_other(
    name: str, view: View, named: set[str]
) -> None:
    assert _named(drawn(name).figures(view)[0]) == named


def test_letters_go_no_farther_off_where_it_is_enough_to_leave_names_of_directions_out() -> None:
    assert not any(one.want.farther for one in drawing(_meeting(20)).labels)
    assert any(one.want.farther for one in drawing(_meeting(28)).labels), "there it is not enough"


def test_on_a_mechanism_every_line_keeps_its_name() -> None:
    named = {text_of(one) for one in drawing(replace(_meeting(12), view=View.MECHANISM)).labels}
    assert {"⊥BC", "⊥DC"} <= named


@each(IDS)
def test_no_name_of_a_direction_stands_in_a_crowd_and_every_letter_of_a_point_stays(name: str) -> None:
    for shown in drawn(name).construction.figures:
        if not shown.view.is_polygon:
            continue
        labels = drawing(shown).labels
        points, wanted = (
            [one for one in wants if one.thing is Thing.POINT]
            for wants in ([one.want for one in labels], Bare.of(shown, "zh").wanted)
        )
        assert len(points) == len(wanted)
        for one in labels:
            near = [LED if other.foot is not None else 1 for other in labels if abs(other.centre - one.centre) <= ABOUT]
            assert one.want.thing is not Thing.DIRECTION or sum(near) <= MANY + LED


def _angled(around: int) -> Figure:
    """An angle with its value, in which so many arms leave no room."""
    angle = AngleMark(at=0j, radius=9.0, start=0.0, sweep=0.9, label="θ = 20.25°")
    arms = [Segment(a=0j, b=rect(60.0, 6.3 * n / max(around, 1)), role=Role.LINK) for n in range(around)]
    letters = [Point(at=rect(r, 6.3 * n / 16), label=f"A_{n}", dot=Dot.POINT) for n in range(16) for r in (20.0, 32.0)]
    return replace(figure(angle, *arms, *(letters if around else ())), view=View.MECHANISM)


@pytest.mark.parametrize(("around", "said"), [(0, "θ=20.25°"), (24, "θ")])
def test_an_angle_in_a_crowd_has_its_symbol_alone_for_the_steps_have_its_value(around: int, said: str) -> None:
    (angle,) = (one for one in drawing(_angled(around)).labels if one.want.thing is Thing.ARC)
    assert text_of(angle) == said


@each(IDS)
def test_no_angle_tells_its_value_far_off_on_a_leader(name: str) -> None:
    for shown in drawn(name).construction.figures:
        for one in drawing(shown).labels:
            assert not (one.want.brief and one.foot is not None and abs(one.centre - one.foot) > FAR + one.want.width)


@pytest.mark.parametrize("letter", ["", "P_"])
def test_numbers_along_a_curve_that_find_no_place_are_left_to_their_neighbours_and_letters_never(letter: str) -> None:
    at = [rect(4.0 + 0.1 * n, 0.42 * n) for n in range(30)]
    crowd = figure(*(Point(at=z, label=f"{letter}{n}", dot=Dot.POINT) for n, z in enumerate(at)))
    told = [text_of(one) for one in drawing(crowd).labels]
    assert (len(told) < len(at)) is (not letter) and len(told) > 5


@pytest.mark.parametrize(("other", "said"), [("γ′ = 40.1°", "γ″=20.25°"), ("θ = 40.1°", "γ″")])
def test_an_angle_in_a_crowd_keeps_its_value_where_a_like_one_has_its_own(other: str, said: str) -> None:
    crowded = _angled(24)
    angle, *rest = crowded.marks
    assert isinstance(angle, AngleMark)
    like = replace(angle, at=200 + 0j, label=other)
    labels = drawing(replace(crowded, marks=(replace(angle, label="γ′′ = 20.25°"), like, *rest))).labels
    assert {text_of(one) for one in labels if one.want.thing is Thing.ARC} == {said, other.replace(" ", "")}
