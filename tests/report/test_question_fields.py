"""What is filled in on a question sheet: lines in the frames, cells of the table of results, poles to be chosen."""

from __future__ import annotations

from functools import cache
from math import pi

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.construction import Construction, Figure
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.marks import Arc, Dot, Ground, Note, Point, Segment
from vecpoly.figures import View
from vecpoly.figures.balancing import HODOGRAPH
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.question.blanks import all_sought, empty_table
from vecpoly.report.question.framed.bar import BAR
from vecpoly.report.question.framed.fields import FIELDS
from vecpoly.report.question.framed.frames import frames
from vecpoly.report.question.framed.known import begins_at
from vecpoly.report.question.framed.readings import READ
from vecpoly.report.question.framed.room import is_free
from vecpoly.report.question.ruled import named
from vecpoly.typeset.box import MM


@cache
def blank_of(name: str) -> Construction:
    """The blank sheets of a problem."""
    return frames(drawn(name).construction, drawn(name).problem)[0]


DRAWN = Later(lambda: [name for name in few(IDS, 6) if blank_of(name).figures])


@each(DRAWN)
def test_a_polygon_has_its_pole_in_its_frame_in_the_middle_wherever_it_fits(name: str) -> None:
    """Off it a pole tells to which side its polygon lies: only where the frame would not hold this about its middle."""
    answer = drawn(name).construction
    for frame in blank_of(name).figures:
        drawing = next(one for one in answer.figures if (one.view, one.name) == (frame.view, frame.name))
        begins = begins_at(drawing)
        if begins is None or begins.dot is not Dot.POLE or frame.view is HODOGRAPH:
            continue
        (pole,) = (mark.at for mark in frame.marks if isinstance(mark, Point) and mark.dot is Dot.POLE)
        start, end = bounds(frame.marks[:4])
        low, high = bounds(drawing.marks)
        assert start.real < low.real and high.real < end.real and start.imag < low.imag and high.imag < end.imag
        wide, tall = (2 * max(b - at, at - a) + 8.0 for at, a, b in zip(*map(parts, (pole, low, high)), strict=True))
        if wide <= (end - start).real and tall <= (end - start).imag - 28.0:  # under it are lines to write on, over it
            assert pole.real == pytest.approx((start + end).real / 2)


def parts(place: complex) -> tuple[float, float]:
    """Across and up."""
    return place.real, place.imag


@pytest.mark.parametrize("name", ["3-9", "jansen-leg", "6-4", "8-12", "4-3a"])
def test_a_bar_in_a_frame_is_as_long_as_its_round_value_is_to_scale(name: str) -> None:
    bars = 0
    for frame in blank_of(name).figures:
        lines = [mark for mark in frame.marks if mark.key == BAR and isinstance(mark, Segment)]
        told = [mark.words.en for mark in frame.marks if mark.key == BAR and isinstance(mark, Note)]
        assert len(told) == bool(lines)
        for words in told:
            value, unit, *real = words.split(" ")
            assert real == ["(real)"] * (unit == "mm")  # of the mechanism: on the paper another bar is so long
            per_mm = frame.scale.told.value * (1e3 if unit == "mm" else 1.0)
            assert max(abs(line.b - line.a) for line in lines) * per_mm == pytest.approx(float(value))
            assert value.strip("0.")[:1] in "125" and 15.0 < float(value) / per_mm <= 40.0 + 1e-9
            bars += 1
    assert bars


@pytest.mark.parametrize("name", ["straight-chebyshev", "straight-hoecken", "straight-roberts"])
def test_a_bar_under_a_magnified_height_holds_as_it_lies_and_says_so(name: str) -> None:
    """It lay level and told heights."""
    (frame,) = (one for one in blank_of(name).figures if one.scale.across is not None)
    (told,) = (mark.words.en for mark in frame.marks if mark.key == BAR and isinstance(mark, Note))
    long = max(abs(mark.b - mark.a) for mark in frame.marks if mark.key == BAR and isinstance(mark, Segment))
    assert told == f"along $x$: {long * frame.scale.right.value:.3g} mm (real)"
    lines = {mark.words.en.partition(" ")[0] for mark in frame.marks if isinstance(mark, Note) and mark.key == READ}
    assert {"$L$", "$δ$"} <= lines


@pytest.mark.parametrize("name", ["winch-gears", "4-3c", "six-bar-dynamic", "3-9"])
def test_the_bar_of_a_scale_lies_in_its_frame_with_its_value(name: str) -> None:
    """In a slim frame it began in the one beside it."""
    for frame in blank_of(name).figures:
        low, high = bounds(frame.marks[:4])
        bar = [mark for mark in frame.marks if mark.key == BAR]
        ends = [end.real for mark in bar if isinstance(mark, Segment) for end in (mark.a, mark.b)]
        assert not ends or (min(ends) > low.real and max(ends) - min(ends) >= 5.0)
        assert all(mark.at.real < high.real for mark in bar if isinstance(mark, Note))


@each(Later(lambda: ["3-10", "hand-lever", *DRAWN]))
def test_the_bar_of_a_scale_stands_under_no_pivot(name: str) -> None:
    """It lay in the hatching of C (3-10)."""
    for frame in blank_of(name).figures:
        bar = [mark for mark in frame.marks if mark.key == BAR]
        rest = [mark for mark in frame.marks[4:] if mark.key not in FIELDS and isinstance(mark, Ground)]
        if bar:
            assert is_free(*bounds(bar), rest), (frame.view, frame.name)


def test_a_body_is_printed_in_the_positions_that_a_synthesis_is_given_and_no_pin_that_it_finds() -> None:
    (frame,) = blank_of("three-positions-frame").figures
    letters = {mark.label for mark in frame.marks if isinstance(mark, Point)}
    assert letters == {"A", "D", *(f"{point}_{n}" for point in "PQ" for n in (1, 2, 3))}
    (log, *_) = (one for one in blank_of("function-log").figures if not one.name)  # its angles are worked out first
    assert {mark.label for mark in log.marks if isinstance(mark, Point)} <= {"A", "D"}


@each(DRAWN)
def test_every_line_to_write_on_in_a_frame_tells_what_is_written_there(name: str) -> None:
    """One line named "readings" stood under every figure, for an unknown number of them."""
    for frame in blank_of(name).figures:
        rules = [mark for mark in frame.marks if isinstance(mark, Segment) and mark.key == READ]
        told = [mark.words.en for mark in frame.marks if isinstance(mark, Note) and mark.key == READ]
        assert sum("$" in text or text in ("mm", "°") for text in told) >= len(rules)
        assert all(any(abs(rule.a - at) < 60.0 for at in places_of(frame)) for rule in rules)


def places_of(frame: Figure) -> list[complex]:
    """Where it tells what is read."""
    return [mark.at for mark in frame.marks if isinstance(mark, Note) and mark.key == READ]


@pytest.mark.parametrize(("name", "whole"), [("cam-undercut", False), ("cam-heart", False), ("cam-flat-face", True)])
def test_a_base_circle_lies_in_its_frame_whole_where_that_needs_no_sheet_more(name: str, whole: bool) -> None:
    """They were cut at the edge of the frame and over the lines to write on; then three places of a cam had three
    sheets, for circles of which a part has what is needed."""
    cams = [frame for frame in blank_of(name).figures if frame.name and frame.view is View.MECHANISM]
    for frame in cams:
        (circle,) = [mark for mark in frame.marks if isinstance(mark, Arc)]
        low, high = bounds(frame.marks[:4])
        first, last = bounds([circle])
        assert (circle.sweep == pytest.approx(2 * pi)) is whole
        assert min(part for one in (first - low, high - last) for part in parts(one)) > 0.0
    assert cams


def test_what_is_asked_has_its_rows_in_the_order_in_which_it_is_found() -> None:
    """A moment behind the forces that give it; links by their numbers."""
    rows = [row[0] for row in empty_table(drawn("plate-on-crank").solution, "en").rows]
    assert rows.index("$M_{1}$") > rows.index("$R_{61}$")
    assert rows.index("$ω_{2}$") < rows.index("$ω_{3}$") < rows.index("$ω_{4}$")


def test_a_vector_on_the_way_has_cells_for_its_length_and_its_direction() -> None:
    rows = {row[0]: row[1:] for row in empty_table(drawn("plate-on-crank").solution, "en").rows}
    assert rows["$v_{B}$"] == ("", "", "m/s", "") and rows["$ω_{2}$"] == ("—", "", "rad/s", "")


@each(IDS)
def test_a_value_that_is_asked_has_its_unit_printed_and_no_direction_that_is_asked_by_its_angle(name: str) -> None:
    solution = drawn(name).solution
    if all_sought(solution):
        return
    table = empty_table(solution, "en")
    assert not any(cell == "" for row in table.rows for head, cell in zip(table.header, row, strict=True)
                   if head == "Unit" and not any(text.startswith("**") for text in row) and any(row))  # fmt: skip
    assert name != "6-5" or "Direction, sense" not in table.header


@each(IDS)
def test_no_column_of_results_is_for_nothing_and_the_table_is_as_wide_as_the_squares_over_it(name: str) -> None:
    table = empty_table(drawn(name).solution, "en")
    columns = [*zip(*(row for row in table.rows if not row[0].startswith("**")), strict=True)]
    assert not any(set(column) == {"—"} for column in columns)
    assert sum(table.widths or ()) == pytest.approx(COLUMN / MM)


def test_short_groups_of_results_stand_side_by_side_each_under_its_name() -> None:
    table = empty_table(drawn("2-7").solution, "zh")
    assert len(table.header) == 4 and len(table.rows) < 10
    names = [(row, n) for n, row in enumerate(table.rows) if any(text.startswith("**") for text in row)]
    assert sum(text.startswith("**") for row, _ in names for text in row) == 3
    assert table.rows[0][0].startswith("**") and table.rows[0][2].startswith("**")  # both blocks begin with one


def test_no_line_parts_the_name_of_a_group_and_every_cell_to_be_filled_in_has_its_lines() -> None:
    assert named(("**Velocities**", "", ""), 0) and named(("**Velocities**", "", ""), 1)
    assert not named(("$v_{B}$", "", ""), 1)
    assert not named(("$n$", "", "**Others**", ""), 1) and named(("$n$", "", "**Others**", ""), 2)
