"""Arcs of angles and curved arrows keep clear of links and hatching; their letters stand beside their own arc."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from math import pi, radians

import numpy as np
import pytest
import shapely

from tests.drawn_library import IDS, drawn
from tests.each import each
from vecpoly.board.construction import View
from vecpoly.board.paper.marks import TURN, AngleMark, FixedGuide, Ground, Mark, Role, Segment, TurnArrow, Vector
from vecpoly.drawing.labels.wants import wants
from vecpoly.drawing.scene import Layer
from vecpoly.drawing.swung import marked_once, swung
from vecpoly.drawing.symbols.angles import draw_angle
from vecpoly.drawing.symbols.outlines import outlines
from vecpoly.foundation.slotted import replace

LINK = Segment(a=-20 + 7j, b=20 + 7j, role=Role.LINK, step=1)


def arc(mark: AngleMark | TurnArrow) -> shapely.LineString:
    sweep = mark.sweep if isinstance(mark, AngleMark) else TURN if mark.ccw else -TURN
    points = [mark.at + cmath.rect(mark.radius, mark.start + sweep * k / 50) for k in range(1, 50)]
    return shapely.LineString([(z.real, z.imag) for z in points])


def line(mark: Segment | Vector) -> shapely.LineString:
    return shapely.LineString([(mark.a.real, mark.a.imag), (mark.b.real, mark.b.imag)])


def test_an_angle_under_a_link_is_drawn_smaller_until_it_clears_it() -> None:
    angle = AngleMark(at=0j, radius=10.0, start=0.0, sweep=radians(120), label="φ_1", step=1)
    _, found = swung((LINK, angle))
    assert isinstance(found, AngleMark) and found.radius < 7.0
    assert (found.at, found.start, found.sweep, found.label) == (0j, 0.0, radians(120), "φ_1")
    assert arc(found).distance(line(LINK)) > 0.5


@pytest.mark.parametrize("ccw", [True, False])
def test_an_arrow_over_a_link_or_a_ground_begins_elsewhere_and_keeps_its_sense(ccw: bool) -> None:
    start = pi / 2 - TURN / 2 if ccw else pi / 2 + TURN / 2
    arrow = TurnArrow(at=0j, radius=9.0, start=start, ccw=ccw, label="ω_1", step=1)
    *_, found = swung((LINK, Ground(at=0j, down=-1j, step=1), arrow))
    assert isinstance(found, TurnArrow) and found.ccw is ccw and found.radius == 9.0 and found.start != arrow.start
    assert arc(found).distance(line(LINK)) > 0.5
    assert arc(found).distance(shapely.box(-4.6, -6.4, 4.6, -5)) > 0


def test_a_narrow_angle_that_is_pointed_at_from_outside_keeps_its_tails_off_the_hatching_of_a_guide() -> None:
    angle = AngleMark(at=0j, radius=13.0, start=pi / 2, sweep=radians(13), label="α", step=1)
    walls = FixedGuide(a=1.5 + 26j, b=1.5 + 11j, step=1), FixedGuide(a=-1.5 + 11j, b=-1.5 + 26j, step=1)
    *_, found = swung((*walls, angle))
    assert isinstance(found, AngleMark) and found.radius < 11.0
    assert (found.at, found.start, found.sweep) == (0j, pi / 2, radians(13))


def test_an_arrow_over_a_force_begins_elsewhere_yet_never_on_a_link_for_it() -> None:
    force = Vector(a=-20 + 7j, b=20 + 7j, role=Role.GIVEN, label="F_I3", step=2)
    arrow = TurnArrow(at=0j, radius=9.0, start=pi / 2 - TURN / 2, ccw=True, label="ω_1", step=1)
    *_, found = swung((force, arrow))
    assert isinstance(found, TurnArrow) and arc(found).distance(line(force)) > 0.5 > arc(arrow).distance(line(force))
    rays = [Segment(a=0j, b=cmath.rect(20, k * pi / 6), role=Role.LINK, step=1) for k in range(6, 13)]  # but above
    *_, kept = swung((*rays, force, arrow))
    assert isinstance(kept, TurnArrow) and not any(arc(kept).distance(line(ray)) < 0.5 for ray in rays)


@each(["six-bar-dynamic", "cam-roller-load"])
def test_the_arrow_of_the_drive_crosses_no_force_of_its_diagram(name: str) -> None:
    (figure, *_) = drawn(name).construction.figures
    marks = swung(figure.marks)
    (arrow,) = (mark for mark in marks if isinstance(mark, TurnArrow))
    assert all(arc(arrow).distance(line(mark)) > 0.5 for mark in marks if isinstance(mark, Vector))


def test_what_is_clear_stays_as_it_is() -> None:
    marks: tuple[Mark, ...] = (
        AngleMark(at=0j, radius=6.0, start=0.0, sweep=radians(40), label="φ_1", step=1),
        TurnArrow(at=0j, radius=9.0, start=pi, ccw=True, label="ω_1", step=1),
        LINK,
    )
    assert swung(marks) == marks


def test_a_letter_stands_where_no_other_arc_lies_between() -> None:
    inner = AngleMark(at=0j, radius=9.0, start=0.0, sweep=radians(125), label="ψ_1", step=1)
    outer = AngleMark(at=0j, radius=13.0, start=0.0, sweep=radians(75), label="ψ_2", step=1)
    own, other = wants(View.MECHANISM, (inner, outer))
    assert own.feet and all(75 < cmath.phase(foot) * 180 / pi < 125 for foot in own.feet)
    assert len(other.feet) > len(own.feet)


@each(IDS)
def test_in_the_library_arrows_of_speeds_and_moments_cross_no_link_where_there_is_another_place(name: str) -> None:
    for figure in (one for one in drawn(name).construction.figures if one.view.bodies):
        edges = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in outlines(figure.marks)]
        links = [edge for edge in edges if edge.length]  # bars, and the edges of plates
        marks = swung(figure.marks)
        before, after = (
            [sum(link.distance(arc(mark)) < 0.3 for link in links) for mark in some if isinstance(mark, TurnArrow)]
            for some in (figure.marks, marks)
        )
        assert sum(after) <= sum(before)
        arrows = [mark for mark in marks if isinstance(mark, TurnArrow)]
        assert not any(crossed and is_free_elsewhere(mark, marks) for mark, crossed in zip(arrows, after, strict=True))


def is_free_elsewhere(arrow: TurnArrow, marks: Sequence[Mark]) -> bool:
    """Whether an arrow begun elsewhere about its point would be well clear of all that is drawn there."""
    lines = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in outlines(marks) if ends[0] != ends[1]]
    lines += [line(mark) for mark in marks if isinstance(mark, Segment | Vector) and mark.a != mark.b]
    arcs = [arc(mark) for mark in marks if isinstance(mark, TurnArrow | AngleMark) and mark is not arrow]
    hatched = [mark.at + 5 * mark.down / abs(mark.down) for mark in marks if isinstance(mark, Ground)]
    hatched += [z for mark in marks if isinstance(mark, FixedGuide) for z in np.linspace(mark.a, mark.b, 40)]
    trials = (arc(replace(arrow, start=arrow.start + k * pi / 12)) for k in range(24))
    return any(
        all(one.distance(bow) > 1.0 for one in lines)
        and all(one.distance(bow) > 2.0 for one in arcs)
        and all(shapely.Point(z.real, z.imag).distance(bow) > 6.0 for z in hatched)
        for bow in trials
    )


def test_the_arc_of_an_angle_is_hidden_by_no_slot_and_no_block() -> None:
    for sweep in (1.0, 0.2):
        arc, *rest = draw_angle(AngleMark(at=0j, radius=12.0, start=0.0, sweep=sweep, label="φ"))
        assert all(item.layer > max(Layer.SLOT, Layer.BODY) for item in (arc, *rest))


def test_an_angle_that_two_solutions_have_in_common_is_marked_once() -> None:
    angle = AngleMark(at=0j, radius=10.0, start=0.2, sweep=radians(36), label="θ = 36°", step=1)
    again = AngleMark(at=0j, radius=14.0, start=0.2 + radians(36), sweep=-radians(36), label="θ = 36°", step=2)
    other = AngleMark(at=0j, radius=14.0, start=1.5, sweep=radians(36), label="θ = 36°", step=2)
    outside = AngleMark(
        at=0j, radius=14.0, start=0.2 + radians(36), sweep=2 * pi - radians(36), label="θ = 36°", step=2
    )
    assert marked_once((angle, LINK, again, other, outside)) == (angle, LINK, other, outside)
