"""Frames of a question: of a few fixed sizes where these hold them, else cut as the figures need, on one sheet."""

from __future__ import annotations

import pytest

from tests.drawn_library import drawn
from vecpoly.board.paper.marks import Ground
from vecpoly.drawing.sheets.space import CAPTION, CLEAR, room_inside
from vecpoly.drawing.symbols.bodies import foot_of
from vecpoly.figures import View
from vecpoly.foundation.stock import A4
from vecpoly.report.question.framed.frames import BORDER, frames
from vecpoly.report.question.framed.grid import Need, grid
from vecpoly.report.question.framed.room import outline
from vecpoly.report.question.framed.snug import PARTS, snug

ROOM = (100.0, 200.0)


def test_frames_that_fixed_parts_hold_have_these() -> None:
    found = grid((Need(70.0, 90.0), Need(70.0, 90.0)), False, A4)
    width, height = (side - CLEAR for side in room_inside(False, A4))
    assert found is not None
    for wide, high in found.sizes:
        assert (wide + CLEAR) / width in (pytest.approx(1 / 2), pytest.approx(1.0))
        assert (high + CLEAR + CAPTION) / height in (pytest.approx(1 / 2), pytest.approx(1.0))


def test_frames_that_no_fixed_parts_hold_are_cut_so_that_each_has_what_it_needs() -> None:
    needs = (Need(170.0, 96.0), Need(100.0, 110.0), Need(65.0, 118.0))
    found = grid(needs, False, A4)
    assert found is not None and found.ease >= 1.0
    assert all(need.wide <= wide and need.high <= high for need, (wide, high) in zip(needs, found.sizes, strict=True))


def test_cuts_fill_the_room_and_stand_at_its_parts_where_the_figures_leave_them_free() -> None:
    sizes = [(90.0, 60.0), (40.0, 70.0), (45.0, 80.0)]
    cuts = list(snug(sizes, ROOM))
    assert cuts
    for boxes in cuts:
        assert sum(wide * high for _, _, wide, high in boxes) == pytest.approx(ROOM[0] * ROOM[1])
        for (left, top, wide, high), need in zip(boxes, sizes, strict=True):
            assert wide >= need[0] - 1e-6 and high >= need[1] - 1e-6
            assert left * PARTS / ROOM[0] == pytest.approx(round(left * PARTS / ROOM[0]))
            assert top * PARTS / ROOM[1] == pytest.approx(round(top * PARTS / ROOM[1]))


def test_what_is_larger_than_the_room_is_not_cut() -> None:
    assert not list(snug([(90.0, 110.0), (90.0, 95.0)], ROOM))
    assert not list(snug([(101.0, 10.0)], ROOM))


@pytest.mark.parametrize("name", ["3-7a", "3-10", "travel-doubler", "A-27"])
def test_a_mechanism_and_its_velocity_polygon_are_drawn_on_one_sheet(name: str) -> None:
    """Directions are carried from one to the other with set squares; poles off the edges may take one sheet more."""
    blank, places = frames(drawn(name).construction, drawn(name).problem)
    assert len(places) <= 2 and len(places[0].tops) > 1
    assert [one.view for one in blank.figures[:2]] == [View.MECHANISM, View.VELOCITY]


@pytest.mark.parametrize("name", ["3-10", "7-2b", "A-27"])
def test_the_foot_of_a_pivot_stands_inside_its_frame(name: str) -> None:
    answer = drawn(name).construction
    figure = next(one for one in answer.figures if one.view is View.MECHANISM)
    frame = next(one for one in frames(answer, drawn(name).problem)[0].figures if one.view is View.MECHANISM)
    low, high = (mark.a for mark in (frame.marks[0], frame.marks[2]))  # type: ignore[union-attr]
    feet = [end for mark in figure.marks if isinstance(mark, Ground) for end in foot_of(mark)]
    assert feet and len(frame.marks) > BORDER
    for end in feet:
        assert low.real + 2.0 < end.real < high.real - 2.0 and low.imag + 2.0 < end.imag < high.imag - 2.0
    assert outline(figure)[0].imag <= min(mark.at.imag for mark in figure.marks if isinstance(mark, Ground)) - 3.0


@pytest.mark.parametrize(("name", "sheets"), [("4-6", 2), ("winch-gears", 3), ("cam-heart", 2), ("cam-rocker", 2)])
def test_sheets_lie_each_its_own_way_where_that_spares_one(name: str, sheets: int) -> None:
    """Those of one problem lay all upright or all across: five figures of one had a sheet each."""
    assert len(frames(drawn(name).construction, drawn(name).problem)[1]) <= sheets


@pytest.mark.parametrize(("name", "dropped"), [("3-1d", True), ("3-3", True), ("class-iii", False), ("8-4", False)])
def test_a_mechanism_that_is_drawn_once_more_for_its_centres_has_one_frame(name: str, dropped: bool) -> None:
    """None in which it would stand alone; drawn to another scale, or read off, it has its own."""
    blank = frames(drawn(name).construction, drawn(name).problem)[0]
    names = [one.name for one in blank.figures if one.view is View.MECHANISM]
    assert ("" not in names) is dropped and names
