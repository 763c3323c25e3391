"""What a frame of a question begins with rests on no datum: the axes of an end view, the numbers on a polygon of
centres; nothing that is to be drawn."""

from __future__ import annotations

import re
from io import BytesIO

import pdfplumber
import pytest
from reportlab.pdfgen.canvas import Canvas

from tests.drawn_library import LIBRARY, drawn, given
from tests.each import Later, each
from vecpoly.board.construction import Figure
from vecpoly.board.paper.marks import (
    AngleMark,
    Arc,
    Disc,
    Dot,
    FixedGuide,
    FrictionCircle,
    Mark,
    Note,
    Outline,
    Point,
    RackMark,
    Role,
    Segment,
    Vector,
)
from vecpoly.designs.base import Design
from vecpoly.designs.inversion.cognates import Cognates
from vecpoly.designs.inversion.positions import Positions
from vecpoly.designs.straight_line import StraightLine
from vecpoly.devices.gears.generation import GearGeneration
from vecpoly.drawing.sheets.lettering import title_width
from vecpoly.figures import View
from vecpoly.report.document import markup
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.equation_rows import MOVING, SUMMED, EquationRows, equation_rows
from vecpoly.report.question.framed.blank import framed
from vecpoly.report.question.framed.fields import FIELDS
from vecpoly.report.question.framed.frames import frames
from vecpoly.report.question.framed.known import stands
from vecpoly.typeset.box import MM


def figure(name: str, view: str, called: str = "") -> Figure:
    figures = drawn(name).construction.figures
    return next(one for one in figures if one.view.name == view and one.name.startswith(called))


@pytest.mark.parametrize("name", ["rotor-bolt-circle", "6-1", "6-4", "engine-four"])
def test_an_end_view_begins_with_its_axes_and_tells_no_mass(name: str) -> None:
    _, marks = framed(figure(name, "end-view"), (150.0, 120.0), ())
    assert {mark.label for mark in marks if isinstance(mark, Point)} <= {"O", "x", ""}
    lines = [mark for mark in marks if isinstance(mark, Segment)]
    assert len(lines) == 2 and all(mark.role is Role.CENTRE for mark in lines)
    assert not any(isinstance(mark, Vector | AngleMark | Arc) for mark in marks)


@pytest.mark.parametrize(("name", "links"), [("3-1a", 4), ("3-12", 6), ("3-1c", 3)])
def test_a_polygon_of_centres_begins_with_the_numbers_of_the_links_and_no_line(name: str, links: int) -> None:
    polygons = [one for one in drawn(name).construction.figures if one.name == "centre polygon"]
    for one in polygons:
        _, marks = framed(one, (150.0, 60.0), ())
        labels = [mark.label for mark in marks if isinstance(mark, Point)]
        assert labels == [str(n) for n in range(1, links + 1)]
        assert not any(isinstance(mark, Segment | Vector) for mark in marks)
    assert polygons or name == "3-12"


def blanks(name: str) -> dict[tuple[str, str], tuple[Mark, ...]]:
    """What stands in each frame of a question, by its view and name, in the order of the sheets."""
    sheets, _ = frames(drawn(name).construction, drawn(name).problem)
    return {
        (one.view.name, one.name): tuple(mark for mark in one.marks[4:] if mark.key not in FIELDS)
        for one in sheets.figures
    }


@pytest.mark.parametrize("name", ["4-3a", "4-6", "winch-gears", "C-inertia"])
def test_a_force_polygon_begins_at_the_first_force_and_a_free_body_at_one_joint(name: str) -> None:
    for (view, called), marks in blanks(name).items():
        if view not in (View.FORCE.name, View.BODY.name):
            continue
        starts = [mark for mark in marks if isinstance(mark, Point)]
        if view == View.FORCE.name and not starts:  # it is for the student to choose
            continue
        (start,) = starts
        figures = drawn(name).construction.figures
        answer = next(one for one in figures if (one.view.name, one.name) == (view, called))
        if view == View.BODY.name:
            assert start in answer.marks and start.dot is Dot.JOINT
        else:
            vectors = [mark for mark in answer.marks if isinstance(mark, Vector)]
            first = min(mark.step for mark in vectors)
            assert any(abs(mark.a - start.at) < 1e-9 for mark in vectors if mark.step == first)


@pytest.mark.parametrize("name", ["6-5", "rotor-grade", "engine-four"])
def test_a_rotor_along_its_axis_begins_with_that_axis_alone(name: str) -> None:
    (line,) = blanks(name)["mechanism", ""]
    assert isinstance(line, Segment) and line.role is Role.CENTRE and line.a.imag == line.b.imag == 0.0


def test_a_gear_that_is_generated_begins_with_its_reference_circle_and_the_datum_line_of_the_rack() -> None:
    centre, line, circle, letter, datum, told = blanks("gear-shifted")["mechanism", ""]
    assert isinstance(centre, Point) and centre.label == "O" and isinstance(line, Segment)
    assert line.a.real == line.b.real == centre.at.real
    assert isinstance(circle, Arc) and isinstance(letter, Point) and letter.label == "r" and isinstance(told, Note)
    assert isinstance(datum, Segment) and datum.a.imag == datum.b.imag > centre.at.imag + circle.radius
    gear = drawn("gear-shifted").problem.subject
    assert isinstance(gear, GearGeneration)
    shift = (datum.a.imag - centre.at.imag - circle.radius) * figure("gear-shifted", "mechanism").scale.value
    assert shift == pytest.approx(gear.x * gear.m.si)


def test_a_hodograph_begins_with_the_axes_through_its_pole() -> None:
    marks = blanks("engine-single-best")["hodograph", ""]
    assert [mark.label for mark in marks if isinstance(mark, Point)] == ["O", "x", "y"]
    assert all(mark.role is Role.CENTRE for mark in marks if isinstance(mark, Segment))


def test_the_guide_of_an_engine_runs_through_its_frame_and_does_not_tell_where_the_slider_stands() -> None:
    guides = [m for m in blanks("engine-single-best")["mechanism", ""] if isinstance(m, FixedGuide)]
    points = (m for m in figure("engine-single-best", "mechanism").marks if isinstance(m, Point))
    slider = next(m.at for m in points if m.label == "C")
    assert len(guides) == 1  # at the other end stands the pivot of the crank
    assert not any(min(g.a.real, g.b.real) < slider.real < max(g.a.real, g.b.real) for g in guides)


@pytest.mark.parametrize(("name", "guides"), [("8-16", 2), ("8-3b", 2), ("K-slider-crank-AB", 0)])
def test_the_place_of_greatest_pressure_is_not_told_by_its_guide(name: str, guides: int) -> None:
    """Nor, where the offset is to be found, the guide."""
    told = [m for m in blanks(name)["mechanism", "alpha 1"] if isinstance(m, FixedGuide)]
    points = (m for m in figure(name, "mechanism", "alpha 1").marks if isinstance(m, Point))
    slider = next(m.at for m in points if m.label == "C′")
    assert len(told) == guides
    assert not any(abs(((g.a + g.b) / 2 - slider).real) < 2.0 for g in told)


@pytest.mark.parametrize("name", ["3-9", "4-3a", "jansen-leg", "3-7a", "3-7d", "balance-slider-crank"])
def test_the_cells_of_an_equation_do_not_tell_how_many_terms_it_has_nor_its_signs(name: str) -> None:
    """There is a Coriolis term in 3-7a, and none in 3-7d."""
    rows = equation_rows(drawn(name).solution, "en")
    sums = [step.equation for step in drawn(name).construction.steps if step.equation is not None]
    assert len(rows) == len(sums) and {row.cells for row in rows} <= {*MOVING.values(), SUMMED}
    assert all(len(one.symbols) <= row.cells for row, one in zip(rows, sums, strict=True))
    for row in rows:
        printed = printed_words(row)
        assert not re.search(r"[+=]", printed), printed


def test_an_equation_that_is_longer_than_others_gives_all_of_its_kind_as_many_cells() -> None:
    """And those of another kind none: velocities keep their wide cells beside long accelerations."""
    steps = [step for step in drawn("A-30-b").construction.steps if step.equation is not None]
    rows = equation_rows(drawn("A-30-b").solution, "en")
    for view, fewest in MOVING.items():
        here = [(row, step.equation) for row, step in zip(rows, steps, strict=True) if step.view is view]
        longest = max(len(one.symbols) for _, one in here if one is not None)
        assert {row.cells for row, _ in here} == {max(fewest, longest)}
    assert len({row.cells for row in rows}) == 2


@pytest.mark.parametrize(("name", "cells"), [("3-9", {5, 7}), ("4-2", {5}), ("3-4b", {5})])
def test_a_sign_has_a_column_of_its_own_behind_each_term_which_has_room_for_a_hand(name: str, cells: set[int]) -> None:
    """A velocity had seven narrow cells, of which it filled three."""
    rows = equation_rows(drawn(name).solution, "en")
    for row in rows:
        row.wrap(COLUMN, 500.0)
        assert row.term >= (15.0 if row.cells > SUMMED else 20.0) * MM
    assert {row.cells for row in rows} == cells


def printed_words(row: EquationRows) -> str:
    """All that is printed in it."""
    data = BytesIO()
    canvas = Canvas(data)
    row.wrap(COLUMN, 500.0)
    row.drawOn(canvas, 20.0, 300.0)
    canvas.save()
    with pdfplumber.open(data) as pdf:
        return str(pdf.pages[0].extract_text())


def test_a_rack_that_moves_is_not_printed_where_it_is_found_to_lie() -> None:
    racks = [m for marks in blanks("crank-rack-pinion").values() for m in marks if isinstance(m, RackMark)]
    fixed = [m for marks in blanks("rack-lift").values() for m in marks if isinstance(m, RackMark)]
    assert not racks and all(mark.fixed for mark in fixed)


def test_the_frames_follow_the_steps_of_the_solution() -> None:
    """The line of the released clamp is drawn after the polygons of clamping, and has its frame behind theirs."""
    assert [called for _, called in blanks("5-3")] == ["disc", "disc", "ideal", "released"]
    assert [called for _, called in blanks("4-3a")] == ["", "", "3 ideal", "2", "3", "3", "1"]


@pytest.mark.parametrize("name", ["4-3a", "4-6", "winch-gears"])
def test_a_frame_is_as_wide_as_the_title_below_it(name: str) -> None:
    sheets, _ = frames(drawn(name).construction, drawn(name).problem)
    for one in sheets.figures:
        border = [mark for mark in one.marks[:4] if isinstance(mark, Segment)]
        assert max(abs(mark.b - mark.a) for mark in border if mark.a.imag == mark.b.imag) >= title_width(one), one.name


def test_an_equation_of_several_solutions_is_told_by_its_solution() -> None:
    told = [row.purpose for row in equation_rows(drawn("rotor-dalby").solution, "en")]
    assert [text.partition(":")[0] for text in told] == [f"Mass–radius polygon, solution {n}" for n in (1, 2)]


def test_a_circle_diagram_that_would_need_a_sheet_more_stands_in_the_text() -> None:
    assert "centre polygon" not in {name for _, name in blanks("3-1b")}
    assert ("mechanism", "centre polygon") in blanks("3-1a")
    for name, shown in (("3-1b", 2), ("3-1a", 1)):  # the sketch, and the circle
        text, _ = markup([drawn(name).solution], "en", "question", {}, None, None)
        assert text.count('<figure ref="pic') == shown


def test_the_table_of_results_does_not_tell_which_centre_lies_at_infinity() -> None:
    assert "∞" in "".join(one.reading.symbol for one in drawn("3-1d").solution.answers.values())
    assert "∞" not in "".join(cell for row in empty_table(drawn("3-1d").solution, "en").rows for cell in row)


def test_a_second_figure_of_the_mechanism_has_the_letters_of_its_pivots() -> None:
    letters = {mark.label for mark in blanks("3-1d")["mechanism", "centres"] if isinstance(mark, Point)}
    assert letters == {"A", "C"}


@pytest.mark.parametrize(("name", "shown"), [("4-2", 2), ("5-2", 2), ("5-1", 0), ("5-5", 0)])
def test_a_wedge_is_printed_in_its_free_body_and_no_body_whose_angle_is_sought(name: str, shown: int) -> None:
    """The block of 5-1 lies at the limit of self-locking, the nut of 5-5 at its lead angle."""
    bodies = [marks for (view, _), marks in blanks(name).items() if view == View.BODY.name]
    assert sum(isinstance(mark, Outline) for marks in bodies for mark in marks) == shown


def test_the_disc_of_a_clamp_is_printed_with_its_handle_and_the_friction_circle_of_its_pin() -> None:
    """A whole sheet was printed with one circle, A. The clamp itself, all of which is given, needs no frame."""
    body = blanks("5-3")["body", "disc"]
    assert {type(mark) for mark in body} == {Disc, Point, FrictionCircle, Segment, Vector}
    assert all(mark.role is Role.GIVEN and mark.label == "F" for mark in body if isinstance(mark, Vector))
    assert any(isinstance(mark, FrictionCircle) for mark in blanks("5-3")["mechanism", "released"])
    vectors = {key: [m for m in marks if isinstance(m, Vector)] for key, marks in blanks("5-3").items()}
    assert [key for key, some in vectors.items() if some] == [("body", "disc")], "R_21 is the student's to find"


DESIGNS = Later(lambda: (name for name in LIBRARY if isinstance(given(name).subject, Design)))


@each(DESIGNS)
def test_every_point_that_is_given_by_coordinates_stands_in_the_frame(name: str) -> None:
    """C_2 of 8-5 and C_1 of 8-14 were given and not there: which is drawn after the pivots, or is no pivot."""
    problem, construction = given(name), drawn(name).construction
    figure = construction.figure(View.MECHANISM)
    if figure is None or isinstance(problem.subject, StraightLine | Cognates):  # whose E counts from a bar
        return
    own = problem.subject.body if isinstance(problem.subject, Positions) else {}
    points = {
        datum.symbol.replace("{", "").replace("}", "") for datum in problem.given.data if datum.text.startswith("(")
    } - set(own)
    places = [getattr(mark, "at", None) for mark in stands(construction, figure, problem)]
    shown = {mark.label for mark in figure.marks if isinstance(mark, Point) and mark.at in places}
    assert points <= shown, points - shown
