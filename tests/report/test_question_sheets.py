"""Question sheets: room to work, and nothing that tells the answer."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from functools import cache
from io import BytesIO
from itertools import permutations

import pdfplumber
import pytest

from tests.drawn_library import IDS, drawn, given
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.acts import Compute, Measure, Meet
from vecpoly.board.chain import needed
from vecpoly.board.construction import Construction, Figure
from vecpoly.board.paper.extent import bounds, extent
from vecpoly.board.paper.marks import (
    AngleMark,
    Arc,
    Dot,
    FixedGuide,
    Ground,
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
from vecpoly.designs.straight_line import StraightLine
from vecpoly.devices.cams.cam import Cam
from vecpoly.devices.dynamics.flywheel import Flywheel
from vecpoly.devices.dynamics.run_up import RunUp
from vecpoly.devices.eccentric_clamp import EccentricClamp
from vecpoly.devices.gears.generation import GearGeneration
from vecpoly.drawing.scene import Rect
from vecpoly.drawing.sheets.lettering import title_width
from vecpoly.drawing.sheets.sheet import Hung, hung
from vecpoly.drawing.sheets.space import CAPTION, CLEAR, room_inside
from vecpoly.figures import View
from vecpoly.problem.load import load
from vecpoly.problem.problem import Problem
from vecpoly.report.content import statement
from vecpoly.report.document import markup, report_bytes
from vecpoly.report.flow.base import Tightness
from vecpoly.report.flow.blocks import Heading
from vecpoly.report.flow.furniture import COLUMN
from vecpoly.report.flow.paging.tight import DEGREES
from vecpoly.report.picture import to_scale
from vecpoly.report.question.blanks import empty_table
from vecpoly.report.question.equations import numbers
from vecpoly.report.question.framed.fields import FIELDS, KEY, SUMS
from vecpoly.report.question.framed.frames import WHITES, frames
from vecpoly.report.question.framed.grid import shares
from vecpoly.report.question.framed.known import by_data
from vecpoly.report.question.framed.origin import ORIGIN
from vecpoly.report.question.kinds import kind
from vecpoly.report.question.room import working_room
from vecpoly.report.question.sketch import sketched
from vecpoly.report.question.whole import whole
from vecpoly.report.question.working import BEGUN, SQUARE, Spare, working
from vecpoly.report.statement.asked import asked, in_order
from vecpoly.solution import solve
from vecpoly.typeset.box import MM
from vecpoly.words import Lang


@cache
def blank_of(name: str) -> tuple[Construction, tuple[Hung, ...]]:
    """The blank sheets of a problem."""
    return frames(drawn(name).construction, drawn(name).problem)


DRAWN = Later(lambda: [name for name in few(IDS, 6) if blank_of(name)[1]])


@each(DRAWN)
def test_pole_and_axes_stand_where_the_figure_fits_its_frame(name: str) -> None:
    """Who begins at the pole, or on the axes, has room for all that is to be drawn."""
    answer = drawn(name).construction
    for frame in blank_of(name)[0].figures:
        drawing = next(f for f in answer.figures if (f.view, f.name) == (frame.view, frame.name))
        low, high = bounds(drawing.marks)
        left, right = bounds(frame.marks[:4])
        assert left.real <= low.real and left.imag <= low.imag, frame.view
        assert right.real >= high.real and right.imag >= high.imag, frame.view


def border(figure: Figure) -> tuple[float, float]:
    """Width and height of the frame."""
    return extent([mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.DIRECTION])


@each(DRAWN)
def test_every_figure_that_is_to_scale_fits_its_frame(name: str) -> None:
    construction = drawn(name).construction
    blank, places = blank_of(name)
    measured = {(f.view, f.name) for f in construction.figures if to_scale(f) or f.aside or f.view is View.BODY}
    framed = {(f.view, f.name) for f in blank.figures}
    again = (View.MECHANISM, "centres") in framed  # where the mechanism is drawn once more, for these
    missing = {"centre polygon", *([""] if again else [])}  # that stands in the text
    assert framed <= measured and {name for _, name in measured - framed} <= missing
    assert sum(len(page.tops) for page in places) == len(blank.figures)
    for frame in blank.figures:
        answer = next(f for f in construction.figures if (f.view, f.name) == (frame.view, frame.name))
        assert all(own < room for own, room in zip(extent(answer.marks), border(frame), strict=True)), frame.name


@each(DRAWN)
def test_a_frame_shows_what_is_given_and_of_a_polygon_nothing_but_its_pole(name: str) -> None:
    """Of a diagram there are its axes, and a curve only where the problem gives it; of a free body one joint, or of a
    wedge its outline; of a synthesis the positions that are given, which rest on data alone."""
    problem, data = drawn(name).problem, by_data(drawn(name).construction.acts)
    curves = isinstance(problem.subject, Flywheel | RunUp)
    for frame in blank_of(name)[0].figures:
        inside = [mark for mark in frame.marks[4:] if mark.key not in (*FIELDS, ORIGIN)]
        assert not any(re.search(r"P_\{\d", mark.label) for mark in inside if isinstance(mark, Point))
        poses = [m for m in inside if isinstance(m, Outline) or getattr(m, "role", None) in (Role.GIVEN, Role.HIDDEN)]
        assert all(mark.act in data for mark in poses)
        inside = [mark for mark in inside if mark not in poses]
        if isinstance(problem.subject, EccentricClamp) and frame.view is not View.FORCE:  # its shape is given, and F
            assert {mark.label for mark in inside if isinstance(mark, Vector)} <= {"F"}
            assert all(mark.act in data for mark in inside)
        elif frame.view is View.MECHANISM:
            lines = [mark for mark in inside if isinstance(mark, Segment)]
            circles = [mark for mark in inside if isinstance(mark, Arc)]
            assert frame.name == "centre polygon" or all(is_given(mark, frame, problem) for mark in circles)
            others = [mark for mark in inside if not isinstance(mark, Arc)]
            assert all(isinstance(mark, (Ground, FixedGuide, RackMark, Point, Segment, Note)) for mark in others)
            assert all(mark.role is Role.CENTRE for mark in lines)
            assert not any(isinstance(mark, Point) and mark.dot is Dot.POLE for mark in inside)
        elif any(isinstance(mark, (Vector, Segment)) for mark in inside):
            assert frame.view.across is not None or frame.view.name in ("indicator", "loop", "end-view", "hodograph")
            assert curves or not any(getattr(mark, "role", None) is Role.RESULT for mark in inside)
        else:
            starts = (Dot.JOINT, Dot.POINT) if frame.view is View.BODY else (Dot.POLE,)
            assert all(isinstance(mark, Point) and mark.dot in starts for mark in inside)
            assert len(inside) <= 1


def is_given(mark: Arc, frame: Figure, problem: Problem) -> bool:
    """Whether it is the base circle that is given of a cam, on a figure apart, or the reference circle of a gear."""
    match problem.subject:
        case Cam(r0=r0) if r0 is not None and frame.name:
            return abs(mark.radius * frame.scale.value - r0.si) < 1e-9
        case GearGeneration(m=m, z=z):
            return abs(mark.radius * frame.scale.value - m.si * z / 2) < 1e-9
    return False


@each(DRAWN)
def test_a_pivot_that_is_found_does_not_stand_in_the_frame(name: str) -> None:
    """What meets, what is read and what is computed is the student's to find."""
    problem, answer = drawn(name).problem, drawn(name).construction
    if not isinstance(problem.subject, Design):
        return
    for frame in blank_of(name)[0].figures:
        shown = [mark for mark in frame.marks if isinstance(mark, Point) and mark.dot is Dot.JOINT]
        for mark in shown:
            needs = needed(answer.acts, [mark.act])
            assert not any(isinstance(act, (Meet, Measure)) for act in answer.acts if act.number in needs), mark.label


@each(DRAWN)
def test_frames_together_fill_the_sheet(name: str) -> None:
    blank, places = blank_of(name)
    waiting = list(blank.figures)
    for page, sheet in zip(places, hung(blank, places), strict=True):
        here, waiting = waiting[: len(page.tops)], waiting[len(page.tops) :]
        width, height = (side - CLEAR for side in room_inside(page.landscape))
        covered = sum((wide + CLEAR) * (high + CLEAR + CAPTION) for wide, high in map(border, here))
        assert covered == pytest.approx(width * height)
        for one in sheet.figures:
            assert all(one is other or not overlaps(one.extents, other.extents) for other in sheet.figures)


def in_fixed_rows(page: Hung, frames_: list[Figure]) -> bool:
    """Whether the frames of a sheet stand in rows, each part of it, or of a row, one of the few that there are."""
    width, height = (side - CLEAR for side in room_inside(page.landscape))
    rows = defaultdict[float, list[tuple[float, float]]](list)
    for top, frame in zip(page.tops, frames_, strict=True):
        rows[round(top.imag, 6)].append(border(frame))
    even = all(len({round(high, 6) for _, high in sizes}) == 1 for sizes in rows.values())
    fixed = all(is_fixed(len(sizes), [(wide + CLEAR) / width for wide, _ in sizes]) for sizes in rows.values())
    return even and fixed and is_fixed(len(rows), [(some[0][1] + CLEAR + CAPTION) / height for some in rows.values()])


def is_fixed(count: int, parts: list[float]) -> bool:
    """Whether each of these parts of a sheet, or of a row, is one of the few that there are."""
    return all(any(part == pytest.approx(share) for share in {*shares(), 1 / count}) for part in parts)


@each(DRAWN)
def test_of_two_frames_of_a_row_the_wider_one_has_the_wider_drawing_or_title(name: str) -> None:
    answer = drawn(name).construction
    blank, places = blank_of(name)
    waiting, rows = list(blank.figures), list[tuple[Figure, Figure]]()
    for page in places:
        here, waiting = waiting[: len(page.tops)], waiting[len(page.tops) :]
        if in_fixed_rows(page, here):  # else a column is as wide as the widest in it
            pairs = permutations(zip(page.tops, here, strict=True), 2)
            rows += [(one, other) for (top, one), (level, other) in pairs if top.imag == level.imag]
    wider = ((one, other) for one, other in rows if border(one)[0] > border(other)[0] + 1.0)
    assert all(taken(drawing_of(answer, one)) > taken(drawing_of(answer, other)) for one, other in wider)


def taken(figure: Figure) -> float:
    """How wide a drawing is with its white, or its title, which stands under its frame."""
    return max(extent(figure.marks)[0] + 2 * WHITES[0], title_width(figure))


def drawing_of(answer: Construction, frame: Figure) -> Figure:
    """The figure for which a frame is."""
    return next(f for f in answer.figures if (f.view, f.name) == (frame.view, frame.name))


@each(DRAWN)
def test_a_frame_tells_the_numbers_of_the_equations_that_are_drawn_in_it_and_nothing_else_of_them(name: str) -> None:
    answer, told = drawn(name).construction, list[int]()
    for frame in blank_of(name)[0].figures:
        written = [mark.words.en for mark in frame.marks if isinstance(mark, Note) and mark.key == KEY]
        bare = written == ["Equation:"] and frame.view in SUMS  # a sum for which there is no table
        assert len(written) == bool(numbers(answer, frame)) or bare
        for words in () if bare else written:
            assert re.fullmatch(r"Equations? \(\d+\)([–, ]+\(\d+\))*:?", words)
            runs = [[int(n) for n in re.findall(r"\d+", run)] for run in words.split(", ")]
            told += [n for run in runs for n in range(run[0], run[-1] + 1)]
    assert sorted(told) == [n for n, _ in enumerate((s for s in answer.steps if s.equation is not None), 1)]


def overlaps(a: Rect, b: Rect) -> bool:
    """Whether two rectangles share more than a line."""
    return min(a.x1, b.x1) - max(a.x0, b.x0) > 0.5 and min(a.y1, b.y1) - max(a.y0, b.y0) > 0.5


@pytest.mark.parametrize(("name", "lang"), few([("3-5", "zh"), ("7-3", "en"), ("2-7", "en"), ("8-5", "zh")], 2))
def test_the_squares_leave_no_page_of_text_empty_and_the_results_stand_at_the_foot(name: str, lang: str) -> None:
    """The last page may hold the results alone."""
    data = report_bytes([solve(given(name), repeats=0, precise=False)], lang=lang, style="question")  # type: ignore[arg-type]
    with pdfplumber.open(BytesIO(data)) as document:
        text = [page for page in document.pages if "50 mm" not in page.extract_text()]
        for page in text:
            squares = [line for line in page.lines if abs(line["width"]) < 0.1 and line["height"] > 5 * SQUARE]
            lowest = max([c["bottom"] for c in page.chars if c["bottom"] < page.height - 50] + [0.0])
            reach = max([line["bottom"] for line in squares] + [lowest])
            assert reach > (0.3 if page is text[-1] else 0.75) * page.height, page.page_number
        last = text[-1]
        rows = [c["top"] for c in last.chars if c["text"] in "量Q"]
        grid = [line["bottom"] for line in last.lines if abs(line["width"]) < 0.1 and line["height"] > 5 * SQUARE]
        assert rows and min(rows) > max(grid, default=0.0)


def test_squares_are_parted_by_no_page_break_where_the_work_has_room_in_two_columns() -> None:
    """They took another page whenever a line each did not fit (`ex10`: a page and a half of squares)."""
    (block,) = working("Working", 300.0, (), "en")
    assert block.wrap(COLUMN, 200.0 * MM)[1] <= 200.0 * MM
    assert block.wrap(COLUMN, 150.0 * MM)[1] > 150.0 * MM


@pytest.mark.parametrize(("name", "computed"), [("curv-6", False), ("straight-chebyshev", False), ("7-3", True)])
def test_there_are_squares_to_work_on_where_something_is_computed(name: str, computed: bool) -> None:
    assert bool(working_room(drawn(name).solution)) is computed
    foot = [Heading("Readings", 3, "en")]
    (block,) = working("Working", 0.0, foot, "en")
    assert isinstance(block, Spare) and block.split(COLUMN, 1.0) == foot


def test_a_range_is_told_as_each_language_tells_it() -> None:
    given_ = {lang: statement(drawn("straight-chebyshev").solution, lang)["given"] for lang in _TONGUES}
    assert "36.87°～90°" in given_["zh"] and "36.87° to 90°" in given_["en"]


@pytest.mark.parametrize("degree", DEGREES)
def test_squares_that_a_page_break_parts_take_no_more_room_than_they_were_given(degree: Tightness) -> None:
    (whole,) = working("Working", 199.0, (), "en")
    whole.tighten(degree)
    assert not whole.split(COLUMN, BEGUN)  # a strip stays white
    for room in (91.5 * MM, 95.2 * MM, 95.3 * MM, 140.0 * MM):
        first, rest = whole.split(COLUMN, room)
        assert first.wrap(COLUMN, room)[1] <= room + 0.02
        assert (first.getSpaceBefore(), rest.getSpaceAfter()) == (whole.getSpaceBefore(), whole.getSpaceAfter())
        assert (first.getSpaceAfter(), rest.getSpaceBefore()) == (0.0, 0.0)


_TONGUES: tuple[Lang, ...] = ("zh", "en")
SHEETS = few(tuple((name, lang) for name in IDS for lang in _TONGUES), 41)  # in both languages by turns


@each(SHEETS)
def test_every_question_sheet_is_made(case: tuple[str, Lang]) -> None:
    """Whole, in every language; one that could not be paged ended in a traceback that nobody saw."""
    name, lang = case
    data = report_bytes([drawn(name).solution], lang=lang, style="question")
    assert data.startswith(b"%PDF") and data.rstrip().endswith(b"%%EOF")


@pytest.mark.parametrize("lang", few(["zh", "en"], 2))
def test_a_question_whose_squares_are_set_tightly_is_printed(lang: Lang) -> None:
    """A part of them was given the white of a text that is not tight: it had no room, and no sheet was made."""
    assert report_bytes([drawn("class-iii").solution], lang=lang, style="question").startswith(b"%PDF")


@pytest.mark.parametrize("lang", ["zh", "en"])
def test_an_equation_to_be_written_is_called_by_its_kind_once(lang: Lang) -> None:
    steps = [step for name in ("3-12", "4-3a") for step in drawn(name).construction.steps if step.equation is not None]
    heads = [kind(step, lang) for step in steps]
    kinds = ("速度", "加速度") if lang == "zh" else ("elocity", "cceleration")
    assert len(heads) == 7 and all(head.count(kinds[0]) < 2 and head.count(kinds[1]) < 2 for head in heads)


def test_what_a_counting_problem_asks_is_not_given_as_a_list() -> None:
    with pdfplumber.open(
        BytesIO(report_bytes([solve(load("2-7"), repeats=0, precise=False)], lang="en", style="question"))
    ) as pdf:
        assert "Given" not in pdf.pages[0].extract_text()


CAMS = Later(lambda: (name for name in IDS if isinstance(given(name).subject, Cam)))


@each(CAMS)
def test_what_is_asked_of_a_cam_is_told_in_words(name: str) -> None:
    """No drawing that a student is given tells b_1 or r_60."""
    for lang, sign in (("zh", "、"), ("en", ", ")):
        for one in asked(drawn(name).solution, lang).split(sign):  # type: ignore[arg-type]
            assert not re.fullmatch(r"\$[^$]*\$", one.strip()), one


@pytest.mark.parametrize(("name", "poles"), [("cam-flat-face", False), ("3-9", True), ("rotor-dalby", True)])
def test_poles_are_spoken_of_only_where_a_polygon_has_one(name: str, poles: bool) -> None:
    for lang, word in (("zh", "极点"), ("en", "pole")):
        text, _ = markup([drawn(name).solution], lang, "question", {}, None, None)  # type: ignore[arg-type]
        assert (word in text) is poles


@each(DRAWN)
def test_who_writes_by_hand_has_rows_of_eight_millimetres(name: str) -> None:
    for lang in ("zh", "en"):
        table = empty_table(drawn(name).solution, lang)
        heights = zip(table.rows, table.set_in(COLUMN).heights, strict=True)
        assert min(high for row, high in heights if not row[0].startswith("**") or any(row[1:])) >= 8 * MM


@each(IDS)
def test_what_is_asked_has_its_kinds_in_the_order_of_the_question(name: str) -> None:
    solution = drawn(name).solution
    keys = [key for _, some in in_order(solution) for key in some]
    assert sorted(keys) == sorted(solution.answers)
    text, places = asked(solution, "en"), list[int]()
    symbols = Counter(f"${one.reading.symbol}$" for one in solution.answers.values())
    for symbol in (f"${solution.answers[key].reading.symbol}$" for key in keys):
        if text.count(symbol) == symbols[symbol] == 1:
            places.append(text.index(symbol))
    assert places == sorted(places)


def test_a_moment_of_inertia_has_no_blank_for_its_direction() -> None:
    rows = {row[0].rpartition(" ")[2]: row for row in empty_table(drawn("7-1").solution, "en").rows}
    assert rows["$J_{e}$"][-1] == "—" and rows["$M_{e}$"][-1] == ""
    assert rows["$J_{e}$"][0].startswith("equivalent moment of inertia")  # told in words: no drawing shows it


DESIGNS = Later(lambda: [name for name in IDS if isinstance(given(name).subject, Design)])


@each(DESIGNS)
def test_the_sketch_of_a_synthesis_shows_data_and_nothing_that_is_found(name: str) -> None:
    problem, answer = drawn(name).problem, drawn(name).construction
    found = sketched(problem, answer, 125.0, 62.0)
    if whole(problem, 125.0, 62.0) is not None:
        return  # it has a position of its own, which is none of those that are sought
    given_ = isinstance(problem.subject, StraightLine | Cognates)  # all its lengths are data: arcs alone find its pins
    sought = (Measure, Compute) if given_ else (Meet, Measure, Compute)
    for mark in found.marks if found is not None else ():
        needs = needed(answer.acts, [mark.act])
        assert not any(isinstance(act, sought) for act in answer.acts if act.number in needs), mark


def test_a_furnace_door_is_pictured_closed_and_open() -> None:
    found = sketched(drawn("8-6").problem, drawn("8-6").construction, 125.0, 62.0)
    assert found is not None
    assert {mark.label for mark in found.marks if isinstance(mark, Point)} == {
        "B_1",
        "C_1",
        "B_2",
        "C_2",
        "A, D",
        "x",
        "y",
    }


@pytest.mark.parametrize(
    ("name", "zh", "en"),
    [
        ("function-log", "lg $x$", "log₁₀ $x$"),
        ("8-9", "$φ_{1}$ = 30°，$x_{C1}$ = 78 mm", "$φ_{1}$ = 30°, $x_{C1}$ = 78 mm"),
        ("8-6", "(55, −79) mm、动坐标轴 $x′$", "at (55, −79) mm, its axis $x′$ at 90°"),
        ("7-4", "367.7 W（120°），", "367.7 W (120°), "),
    ],
)
def test_data_are_printed_as_a_textbook_does_and_not_as_they_are_keyed_in(name: str, zh: str, en: str) -> None:
    for lang, wanted in (("zh", zh), ("en", en)):
        text, _ = markup([drawn(name).solution], lang, "question", {}, None, None)  # type: ignore[arg-type]
        assert wanted in text.replace("&gt;", ">")
        assert not re.search(r"-&gt;|log10|N\*m", text)


@pytest.mark.parametrize(
    ("name", "view", "numbers"),
    [
        ("two-stroke-flywheel", "torque", {"45°", "180°", "360°", "100", "200", "−100"}),
        ("shaper-flywheel", "inertia", {"45°", "360°", "2", "4"}),
        ("cam-rocker", "swing", {"120°", "360°", "20"}),
        ("shaper-flywheel", "energy-mass", {"−400", "2"}),
    ],
)
def test_the_axes_of_a_blank_diagram_have_names_units_and_numbers(name: str, view: str, numbers: set[str]) -> None:
    frame = next(f for f in blank_of(name)[0].figures if f.view.name == view)
    notes = [mark.words.en for mark in frame.marks if isinstance(mark, Note)]
    assert numbers <= set(notes)
    assert sum(note.startswith("$") for note in notes) == 2  # both axes are named
    assert any(f"/{unit}" in note for note in notes for unit in ("(N·m)", "(kg·m^2)", "°", "J"))


@pytest.mark.parametrize("name", ["8-7", "8-8", "8-13"])
def test_an_angle_in_the_picture_of_a_question_has_its_name_and_not_its_size(name: str) -> None:
    figure = sketched(drawn(name).problem, drawn(name).construction, 150.0, 80.0)
    angles = [mark.label for mark in figure.marks if isinstance(mark, AngleMark)] if figure is not None else []
    assert angles and not any("=" in label for label in angles)


@pytest.mark.parametrize("name", ["hoist", "motor-run-up", "run-down", "flywheel-rim", "7-2a", "7-4", "7-6", "8-1"])
def test_data_stand_once_the_statement_has_their_symbols(name: str) -> None:
    for lang in _TONGUES:
        assert not re.search(r"\d (mm|kg|N·m|W|r/min|J)\b", given(name).statement.of(lang))


@pytest.mark.parametrize("name", ["K-crank-rocker-line", "K-crank-rocker-BC", "8-15"])
def test_the_chord_between_both_limits_of_a_rocker_is_no_line_of_the_sketch(name: str) -> None:
    figure = sketched(drawn(name).problem, drawn(name).construction, 150.0, 80.0)
    assert figure is not None
    places = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    ends = {frozenset((mark.a, mark.b)) for mark in figure.marks if isinstance(mark, Segment)}
    assert frozenset((places["C_1"], places["C_2"])) not in ends
