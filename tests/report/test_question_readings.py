"""What is read off a figure is written in its frame under its name; poles betray no direction; frames stand in rows."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from math import inf

import pytest

from tests.drawn_library import IDS, drawn
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.acts import LayOff
from vecpoly.board.construction import Construction, Figure
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.marks import Arc, Dot, Note, Outline, Point, Segment, Vector
from vecpoly.board.place import Pane, View, called
from vecpoly.drawing.sheets.sheet import Hung
from vecpoly.figures.balancing import HODOGRAPH
from vecpoly.names import written_unit
from vecpoly.report.question.blanks import empty_table, is_framed
from vecpoly.report.question.columns import Framed
from vecpoly.report.question.framed.aligned import CLOSE, aligned
from vecpoly.report.question.framed.fields import KEY
from vecpoly.report.question.framed.frames import frames
from vecpoly.report.question.framed.origin import ORIGIN
from vecpoly.report.question.framed.readings import READ, lined, readings, valued
from vecpoly.report.question.ruled import NONE
from vecpoly.report.statement.asked import asked
from vecpoly.words import bare

Y = "$y$ ="  # the second coordinate of a place


@cache
def blank_of(name: str) -> tuple[Construction, tuple[Hung, ...]]:
    """The blank sheets of a problem."""
    return frames(drawn(name).construction, drawn(name).problem)


DRAWN = Later(lambda: [name for name in few(IDS, 6) if blank_of(name)[0].figures])


def told(frame: Figure) -> list[str]:
    return [mark.words.en for mark in frame.marks if isinstance(mark, Note) and mark.key == READ]


def rules(frame: Figure) -> list[Segment]:
    return [mark for mark in frame.marks if isinstance(mark, Segment) and mark.key == READ]


def test_a_length_that_is_asked_is_read_on_a_line_with_its_name_and_brought_to_its_value_by_the_scale() -> None:
    (frame, *_) = blank_of("three-positions")[0].figures
    asked_for = [(f"$l_{{{bar}}}$ =", "mm × $μ_l$ =", "mm") for bar in ("AB", "CD", "AD")]
    assert told(frame) == [text for one in asked_for for text in one], "as the data, and the table of results"
    assert len(rules(frame)) == 6


@each(Later(lambda: ["pin-in-two-slots", "3-14", *DRAWN]))
def test_what_is_computed_and_laid_off_has_its_value_before_its_length(name: str) -> None:
    """A Coriolis acceleration is 2 ω v, and laid off as a^k/μ_a: nothing of it is measured. All else is read first."""
    construction = drawn(name).construction
    for frame in blank_of(name)[0].figures:
        place = called(Pane(frame.view, frame.name) if frame.name else frame.view)
        laid = {act.key for act in construction.acts if isinstance(act, LayOff) and act.figure == place}
        texts = told(frame)
        for key, one in construction.readings.items():
            if (symbol := f"${one.symbol}$ =") in texts and one.mm is not None:
                first, last = texts[(at := texts.index(symbol) + 1) : at + 2]
                assert (last if key in laid else first).startswith("mm ×"), (key, first, last)


def test_a_line_names_a_length_by_its_letters_where_more_than_a_scale_brings_it_to_its_value() -> None:
    """v_C = ω_2 μ_l P_24C: it is P_24C that is measured. F_I2 = m_2 a_S2 has no length beside that of a_S2."""
    (frame, *_) = blank_of("3-2")[0].figures
    assert {"$P_{24} C$ =", "$P_{24} E_2$ ="} <= set(told(frame))
    lines = [text for one in blank_of("slider-crank-dynamic")[0].figures for text in told(one)]
    assert "$a_{S2}/μ_a$ =" in lines and not any("F_{I" in text for text in lines)


def test_an_angle_that_is_asked_has_its_degrees_and_no_scale() -> None:
    frame = next(one for one in blank_of("4-2")[0].figures if one.name == "limits")
    assert told(frame) == ["$φ_{lim}$ =", "°", "$φ'_{lim}$ =", "°"]


@pytest.mark.parametrize("name", ["3-1f", "3-1a"])
def test_a_frame_off_which_coordinates_are_read_shows_where_they_begin(name: str) -> None:
    for frame in blank_of(name)[0].figures:
        letters = [mark.words.en for mark in frame.marks if isinstance(mark, Note) and mark.key == ORIGIN]
        axes = [mark for mark in frame.marks if isinstance(mark, Vector) and mark.key == ORIGIN]
        assert letters == (["$x$", "$y$"] if Y in told(frame) else [])
        assert all(one.a == 0j for one in axes) and len(axes) == len(letters)


@each(DRAWN)
def test_a_quantity_has_one_line_in_one_frame(name: str) -> None:
    names = [text for frame in blank_of(name)[0].figures for text in told(frame) if text.startswith("$") and text != Y]
    assert len(names) == len(set(names))


@each(DRAWN)
def test_a_line_to_write_a_number_on_is_at_least_16_mm_long_and_in_its_frame(name: str) -> None:
    for frame in blank_of(name)[0].figures:
        low, high = bounds(frame.marks[:4])
        for line in rules(frame):
            assert line.b.real - line.a.real >= 15.9
            assert low.real < line.a.real and line.b.real < high.real and low.imag < line.a.imag


@each(DRAWN)
def test_lines_to_write_on_begin_under_each_other_and_their_units_stand_behind_them_in_a_column(name: str) -> None:
    """Each began behind its own name, and none under the one before it."""
    for frame in blank_of(name)[0].figures:
        lines = [*by_columns(frame)]
        first = {round(row[0].a.real - left, 3) for left, row in lines}
        assert len(first) <= 1, (frame.view, first)
        assert len({round(abs(rule.b - rule.a), 3) for _, row in lines for rule in row}) <= 1
        for count in {len(row) for _, row in lines}:
            behind = {round(row[-1].b.real - left, 3) for left, row in lines if len(row) == count}
            assert len(behind) == 1, (frame.view, behind)


def by_columns(frame: Figure) -> Iterator[tuple[float, list[Segment]]]:
    """The left end of each line of readings, and its rules: the name of a quantity begins one."""
    names = [mark for mark in frame.marks if isinstance(mark, Note) and mark.key == READ and "=" in mark.words.en]
    starts = [mark for mark in names if mark.words.en.startswith("$") and mark.words.en != Y]
    for start in starts:
        level = [one for one in rules(frame) if abs(one.a.imag - start.at.imag) < 3.0]
        after = [one.at.real for one in starts if one.at.imag == start.at.imag and one.at.real > start.at.real]
        row = [one for one in level if start.at.real < one.a.real < min(after, default=inf)]
        yield start.at.real, sorted(row, key=lambda one: one.a.real)


@each(DRAWN)
def test_no_pole_stands_nearer_to_an_edge_than_a_quarter_of_its_frame(name: str) -> None:
    """At an edge it tells to which side its polygon lies. One that takes half of its frame, where that spares sheets,
    leaves its pole a tenth."""
    blank, _ = blank_of(name)
    for frame in blank.figures:
        for mark in frame.marks[4:]:
            if isinstance(mark, Point) and mark.dot is Dot.POLE and frame.view is not HODOGRAPH:
                low, high = bounds(frame.marks[:4])
                across, up = (mark.at - low).real / (high - low).real, (mark.at - low).imag / (high - low).imag
                room = [
                    0.2 if one > 0.5 else 0.1 for one in _left(name, frame, mark.at)
                ]  # over it and under it are lines
                assert min(across, 1 - across) > room[0] and min(up, 1 - up) > room[1], frame.view


def _left(name: str, frame: Figure, pole: complex) -> tuple[float, float]:
    """What share of a frame its polygon leaves on the other side of its pole, across and up."""
    whole = drawn(name).construction.figure(Pane(frame.view, frame.name))
    assert whole is not None
    (first, last), (low, high) = bounds(whole.marks), bounds(frame.marks[:4])
    wide, tall = max((last - pole).real, (pole - first).real), max((last - pole).imag, (pole - first).imag)
    return 1 - wide / (high - low).real, 1 - tall / (high - low).imag


@each(DRAWN)
def test_edges_of_frames_on_one_sheet_miss_no_line_by_a_little(name: str) -> None:
    blank, pages = blank_of(name)
    waiting = list(blank.figures)
    for page in pages:
        here, waiting = waiting[: len(page.tops)], waiting[len(page.tops) :]
        sizes = [bounds(one.marks[:4])[1] - bounds(one.marks[:4])[0] for one in here]
        edges = sorted({round(top.imag, 3) for top in page.tops})
        feet = sorted({round(top.imag - size.imag, 3) for top, size in zip(page.tops, sizes, strict=True)})
        for some in (edges, feet):
            assert all(b - a > 2.0 for a, b in pairwise(some))


def test_edges_that_nearly_meet_are_moved_on_to_one_line_and_others_stay() -> None:
    boxes = [(0.0, 0.0, 50.0, 60.0), (0.0, 60.0, 50.0, 40.0), (50.0, 0.0, 50.0, 62.0), (50.0, 62.0, 50.0, 38.0)]
    found = aligned(boxes, [(50.0, 30.0)] * 4)
    assert found[0][3] == found[2][3] and found[1][1] == found[3][1] == pytest.approx(61.0)
    assert sum(wide * high for _, _, wide, high in found) == pytest.approx(100.0 * 100.0)
    tight = [(50.0, 60.0), (50.0, 40.0), (50.0, 62.0), (50.0, 38.0)]
    assert aligned(boxes, tight) == boxes
    far = [
        (0.0, 0.0, 50.0, 60.0),
        (0.0, 60.0, 50.0, 40.0),
        (50.0, 0.0, 50.0, 70.0 + CLOSE),
        (50.0, 70.0 + CLOSE, 50.0, 15.0),
    ]
    assert aligned(far, [(0.0, 0.0)] * 4) == far


def test_the_outline_of_a_wedge_stands_in_the_middle_of_its_frame() -> None:
    """Off it the forces that are to be drawn could be guessed."""
    for frame in blank_of("4-2")[0].figures:
        shapes = [mark for mark in frame.marks if isinstance(mark, Outline)]
        if shapes and not told(frame):
            (low, high), (start, end) = bounds(shapes), bounds(frame.marks[:4])
            assert abs(low + high - start - end) < 8.0  # a few millimetres, where the forces need the room


def test_a_polygon_of_couples_has_a_line_for_its_equation_though_that_has_no_number() -> None:
    frame = next(one for one in blank_of("6-4")[0].figures if one.view.name == "couples")
    assert [mark.words.en for mark in frame.marks if isinstance(mark, Note) and mark.key == KEY] == ["Equation:"]


def test_each_instant_centre_that_is_asked_has_a_line_for_both_of_its_coordinates() -> None:
    frame = next(one for one in blank_of("3-1f")[0].figures if told(one))
    assert told(frame) == [text for n in ("12", "13", "23") for text in (f"$P_{{{n}}}$: $x$ =", Y, "mm")]


@pytest.mark.parametrize(("name", "point"), [("A-27-d", "F"), ("4-7", "C"), ("hypocycloid-drive", "P"), ("4-5", "B")])
def test_the_place_of_a_point_is_asked_in_the_frame_of_the_mechanism(name: str, point: str) -> None:
    """F was asked under the polygon of accelerations, beside axes that stood at its pole."""
    assert f"p_{point}" in drawn(name).construction.readings
    there = [frame for frame in blank_of(name)[0].figures if f"${point}$: $x$ =" in told(frame)]
    assert [frame.view for frame in there] == [View.MECHANISM]


def test_the_circle_between_whose_numbers_centres_are_found_is_50_mm_wide_in_its_frame() -> None:
    frame = next(one for one in blank_of("3-1f")[0].figures if one.name)
    assert [mark.radius for mark in frame.marks if isinstance(mark, Arc)] == [pytest.approx(25.0)]


@pytest.mark.parametrize("name", ["K-crank-rocker-BC", "K-crank-rocker-AD", "8-15"])
def test_nothing_on_a_question_sheet_tells_that_there_is_a_second_solution(name: str) -> None:
    solution, frames_ = drawn(name).solution, blank_of(name)[0].figures
    assert "^{(2)}" not in asked(solution, "en") and "if there is one" in asked(solution, "en")
    heads = [row[0] for row in empty_table(solution, "en").rows if row[0].startswith("**Solution 2")]
    assert heads == ["**Solution 2 (if there is one)**"]
    for frame in frames_:
        own = "solution 2" in frame.title.en
        assert not own or frame.title.en.endswith("if there is one)")
        assert own or not any("(2)" in text for text in told(frame))


def test_a_problem_that_says_how_many_solutions_it_has_asks_for_them_by_number() -> None:
    assert "^{(1)}" in asked(drawn("8-4").solution, "en") and "^{(2)}" in asked(drawn("8-4").solution, "en")


def test_places_alone_have_a_table_with_a_column_for_each_coordinate() -> None:
    table = empty_table(drawn("3-1f").solution, "en")
    assert list(table.header) == ["Quantity", "$x$ /mm", "$y$ /mm"]
    assert [row[0] for row in table.rows] == ["$P_{12}$", "$P_{13}$", "$P_{23}$"]


@each(IDS)
def test_what_is_read_in_a_frame_has_the_unit_of_its_row_in_the_table_of_results(name: str) -> None:
    """l_AB = ___ mm × μ_l = ___ m stood over a table that asked for mm."""
    solution = drawn(name).solution
    table = empty_table(solution, "en")
    at = table.header.index("Unit") if table.header.count("Unit") == 1 else None
    units = {bare(row[0]).split()[-1]: row[at] for row in table.rows if row[at]} if at is not None else {}
    for figure in solution.construction.figures:
        read = readings(solution.construction, figure)
        for one in read.blanks if read is not None else ():
            row = units.get(bare(f"${one.symbol}$"))
            assert not (one.scale and row) or row == written_unit(one.unit), one


@pytest.mark.parametrize(("name", "column"), [("8-14", False), ("curv-3", False), ("3-9", True), ("4-3a", True)])
def test_a_length_that_has_its_line_in_a_frame_is_not_written_into_the_table_once_more(name: str, column: bool) -> None:
    """8-14 had each of its four lengths on paper twice; where one has no line (v_B on the way) the table has room."""
    table = empty_table(drawn(name).solution, "en", Framed(lined(blank_of(name)[0])))
    assert ("On paper /mm" in table.header) is column
    assert "On paper /mm" in empty_table(drawn(name).solution, "en").header


@each(Later(lambda: ["8-6-2", "cam-heart", "hand-lever", "3-4a", *DRAWN]))
def test_each_length_and_each_value_has_one_place_on_a_question_sheet(name: str) -> None:
    """8-6-2 asked for l_AB in mm under its frame, and in its table once more; cam-heart for α in degrees."""
    solution, sheets = drawn(name).solution, blank_of(name)[0]
    framed = Framed(lined(sheets), valued(sheets))
    if is_framed(solution, framed):
        assert {one.reading.symbol for one in solution.answers.values()} <= framed.valued
        return
    table = empty_table(solution, "en", framed)
    whole = {row[0]: row for row in empty_table(solution, "en").rows}
    assert {row[0] for row in table.rows} <= {*whole}
    heads = [one for one in table.header if one in ("On paper /mm", "Value")]
    for row in table.rows if len({*table.header}) == len(table.header) else ():
        symbol = bare(row[0]).split()[-1]
        for head in heads:
            framed_here = framed.lined if head == "On paper /mm" else framed.valued
            if symbol in {bare(f"${one}$") for one in framed_here} and whole[row[0]][1] != NONE:
                assert row[table.header.index(head)] == NONE, (symbol, head)


def test_a_question_whose_frames_have_room_for_all_values_has_no_table() -> None:
    for name, framed_all in (("8-6-2", True), ("cam-heart", False), ("3-4a", False)):
        sheets = blank_of(name)[0]
        assert is_framed(drawn(name).solution, Framed(lined(sheets), valued(sheets))) is framed_all
