"""Sheets as a lecturer would frame them: one band for the legend, titles on one line, numbers clear of their bars, a
figure for each of two solutions that crowd."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import DRAFTED, IDS, LIBRARY, drafted, drawn
from tests.drawn_sheets import laid, lettered
from tests.each import Later, each
from tests.laws import few
from vecpoly.board.construction import Figure, View
from vecpoly.board.paper.marks import Arc, Curve, Dot, Mark, Point, Role, Segment
from vecpoly.board.paper.scales import Sketched
from vecpoly.board.place import Place
from vecpoly.diagram.chains import HALF_GUIDE
from vecpoly.drawing.labels.want import Thing
from vecpoly.drawing.legend.alike import alike
from vecpoly.drawing.legend.legend import entries
from vecpoly.drawing.legend.on_sheet import with_legend
from vecpoly.drawing.parted import parted
from vecpoly.drawing.scene import Stroke
from vecpoly.drawing.sheets.scales.composition import Composing, Scales
from vecpoly.drawing.sheets.scales.refilling import refilled
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.drawing.sheets.space import room_inside
from vecpoly.drawing.style import THIN, Dash, Hue, pen

OFF, AT_LEAST = 1.4, 1.0  # mm between the number of a link and the edge of its bar: as a rule; at least
LINE, ROW = 1.0, 15.0  # mm: titles on one line differ less; those of one row as much
MORE = Later(lambda: (name for name in few(LIBRARY, 3) if drafted(name) is not None))


def _sheets() -> list[Sheet]:
    return [with_legend(sheet) for name in MORE for sheet in laid(name)]


def _blocks(sheet: Sheet) -> list[Stroke]:
    """Frames of blocks that stand among the figures."""
    strokes = (item for item in sheet.results if isinstance(item, Stroke))
    return [one for one in strokes if one.closed and one.width == THIN and abs(one.points[0] - one.points[2]) > 25.0]


def test_legends_stand_on_a_band_over_the_title_strip_but_for_one_sheet_in_twenty() -> None:
    made = _sheets()
    assert sum(bool(_blocks(sheet)) for sheet in made) <= 0.05 * len(made)


def test_titles_of_a_row_stand_on_one_line_but_for_one_sheet_in_thirty() -> None:
    made = _sheets()
    uneven = [sheet for sheet in made if any(LINE < gap < ROW for gap in _gaps(sheet))]
    assert len(uneven) <= len(made) / 30


def _gaps(sheet: Sheet) -> Iterator[float]:
    """How far titles stand over each other."""
    heights = sorted(one.extents.y0 + one.line for one in sheet.groups)
    yield from (high - low for low, high in pairwise(heights))


@each(IDS)
def test_no_two_samples_of_a_legend_are_lines_of_one_pattern_ink_and_width(name: str) -> None:
    figures = list(drawn(name).construction.figures)
    shown = [shared[0].sample for shared in alike(entries(figures, "zh"))]
    lines = [sample[0] for sample in shown if len(sample) == 1 and isinstance(sample[0], Stroke)]
    for a, b in combinations([line for line in lines if len(line.points) == 2], 2):
        assert (a.dash, a.hue) != (b.dash, b.hue) or abs(a.width - b.width) > 0.1, (a, b)


def test_what_shares_a_sample_is_named_in_one_entry_and_nothing_is_lost() -> None:
    found = entries(drawn("planet-drive").construction.figures, "en")
    shared = [group for group in alike(found) if len(group) > 1]
    assert [one for group in alike(found) for one in group] != [] and len(shared) == 1
    assert {one.words.zh for one in shared[0]} == {"节圆、节线", "齿轮的影像", "中心线、基准线"}
    assert sum(map(len, alike(found))) == len(found)


@pytest.mark.parametrize("role", [role for role in Role if role is not Role.SECOND])
def test_a_second_linkage_is_drawn_as_nothing_else_is(role: Role) -> None:
    assert pen(role, Hue.BLACK).dash is not pen(Role.SECOND, Hue.BLACK).dash


def test_three_linkages_with_one_coupler_curve_have_lines_of_their_own() -> None:
    (figure,) = drawn("cognates").figures(View.MECHANISM)
    pins = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point) and mark.dot is Dot.JOINT}
    for bars, role in (("AB BC CD", Role.LINK), ("AG GH", Role.GIVEN), ("DM MN", Role.OTHER)):
        for one, two in ((bar[0], bar[1]) for bar in bars.split()):
            between = [mark.role for mark in figure.marks if isinstance(mark, Segment) and _joins(mark, pins, one, two)]
            assert role in between, (one, two, between)
    path = next(mark for mark in figure.marks if isinstance(mark, Curve) and mark.role is Role.CENTRE)
    looks = [pen(role, Hue.BLACK).dash for role in (Role.LINK, Role.OTHER, path.role)]
    assert looks == [Dash.FULL, Dash.DASHED, Dash.DASH_DOT]  # the second is told from the path at sight


def _joins(mark: Segment, pins: dict[str, complex], one: str, two: str) -> bool:
    ends = pins[one], pins[two]
    return min(abs(mark.a - ends[0]) + abs(mark.b - ends[1]), abs(mark.a - ends[1]) + abs(mark.b - ends[0])) < 0.2


@pytest.mark.parametrize("name", ["K-crank-rocker-AD", "8-15", "best-gamma"])
def test_two_solutions_that_crowd_have_a_figure_each_with_the_letters_of_one(name: str) -> None:
    made = [one.figure for sheet in laid(name) for one in sheet.figures if one.figure is not None]
    one, two = (figure for figure in made if figure.title.en.startswith("Synthesis"))
    assert one.title.zh.endswith("（解 1）") and two.title.zh.endswith("（解 2）")
    first, second = ({mark.label for mark in figure.marks if isinstance(mark, Point)} for figure in (one, two))
    assert "A" in first - second and "A′" in second - first and {"C_1", "C_2", "D"} <= first & second
    for figure in (one, two):
        assert any(mark.role is Role.LINK for mark in figure.marks if isinstance(mark, Segment))
        assert not any(getattr(mark, "role", None) is Role.SECOND for mark in figure.marks)


def test_solutions_on_one_circle_stay_in_one_figure() -> None:
    (figure,) = (
        one.figure
        for sheet in laid("K-crank-rocker-gamma")
        for one in sheet.figures
        if one.figure is not None and one.figure.title.en.startswith("Synthesis")
    )
    assert any(getattr(mark, "role", None) is Role.SECOND for mark in figure.marks)


@pytest.mark.parametrize(("away", "count"), [(80.0, 1), (4.0, 2)])
def test_it_is_crowding_that_parts_two_solutions(away: float, count: int) -> None:
    bare = drawn("K-crank-rocker-AD").figures(View.MECHANISM)[0]
    known: list[Mark] = [Point(at=0j, label="D", dot=Dot.JOINT, step=1)]
    known += [Segment(a=0j, b=100 + 0j, role=Role.CONSTRUCTION, step=1)]
    for step in (2, 3):
        spots = (complex(20 * n, 10 + away * (step - 2)) for n in range(4))
        known += [Point(at=at, label=f"B_{n}", dot=Dot.JOINT, step=step) for n, at in enumerate(spots)]
    figure = Figure(view=bare.view, title=bare.title, scale=bare.scale, marks=tuple(known), parts=((2, 1), (3, 2)))
    assert len(parted((figure,))) == count


@each(DRAFTED)
def test_the_number_of_a_link_stands_a_millimetre_clear_of_its_bar(name: str) -> None:
    assert drafted(name) is None or all(gap > AT_LEAST for gap in _off_bars(name))


def test_nearly_all_numbers_of_links_stand_one_and_a_half_millimetres_clear() -> None:
    gaps = [gap for name in DRAFTED if drafted(name) is not None for gap in _off_bars(name)]
    assert len(gaps) > 50 and sum(gap < OFF for gap in gaps) <= 0.05 * len(gaps)


def _off_bars(name: str) -> Iterator[float]:
    """How far numbers beside bars are from the edges of these."""
    for label in (label for one in lettered(name) for label in one.labels):
        want = label.want
        if want.thing is Thing.LINK and want.clear and label.foot is None:
            box, (a, b) = label.rect, want.own
            bar = shapely.LineString([(a.real, a.imag), (b.real, b.imag)])
            yield float(shapely.box(box.x0, box.y0, box.x1, box.y1).distance(bar)) - want.radius


def test_the_letter_of_a_sliding_pair_stands_within_the_length_of_its_guide() -> None:
    figure = drawn("2-13").figures(View.MECHANISM)[0]
    (letter,) = (
        mark for mark in figure.marks if isinstance(mark, Point) and mark.label.startswith("G") and mark.label != "G"
    )
    (pin,) = (mark for mark in figure.marks if isinstance(mark, Point) and mark.label == "G")
    assert abs((letter.at - pin.at).imag) < HALF_GUIDE - 1.0


def test_a_hole_has_its_diameter_and_a_keyway_is_a_rectangle() -> None:
    (figure,) = (one for one in drawn("rotor-blind-hole").construction.figures if one.view.name == "end-view")
    mm = figure.scale.value
    at = {mark.label: mark.at for mark in figure.marks if isinstance(mark, Point)}
    hole, *more = (mark for mark in figure.marks if isinstance(mark, Arc) and abs(mark.centre - at["m_{1}"]) < 0.1)
    assert hole.radius == pytest.approx(0.02 / mm) and hole.role is Role.GIVEN and not more
    sides = [mark for mark in figure.marks if isinstance(mark, Segment) and mark.role is Role.GIVEN]
    assert len(sides) == 4 and all(abs((mark.a + mark.b) / 2 - at["m_{2}"]) < 3.0 for mark in sides)
    assert max(abs(mark.b - mark.a) for mark in sides) == pytest.approx(0.014 / mm)
    assert not any(isinstance(mark, Arc) and abs(mark.centre - at["m_{2}"]) < 1.0 for mark in figure.marks)


def test_a_joint_that_went_with_a_group_is_explained() -> None:
    figures = drawn("2-13").construction.figures
    assert any(mark.dot is Dot.POINT for one in figures for mark in one.marks if isinstance(mark, Point))
    assert "joint removed with an earlier group" in {one.words.en for one in entries(figures, "en")}


SIDES = st.floats(20.0, 90.0)


@given(st.lists(st.tuples(SIDES, SIDES), min_size=2, max_size=3))
def test_scales_grow_as_far_as_the_sheet_holds_and_no_farther(sizes: Sequence[tuple[float, float]]) -> None:
    kinds = (View.MECHANISM, View.VELOCITY, View.ACCELERATION)[: len(sizes)]
    figures = [
        Sketched(view=kind, of=kind, scale=1.0, size=size, around=(20.0, 25.0))
        for kind, size in zip(kinds, sizes, strict=True)
    ]
    pages = [Composing(figures, set(kinds), room_inside(across)) for across in (False, True)]
    start: Scales = dict[Place, float](dict.fromkeys(kinds, 1.0))
    before = min(page.needed(start) for page in pages)
    made = refilled([(page, page) for page in pages], start, set(kinds))
    assert min(page.needed(made) for page in pages) == before
    assert all(made[kind] <= 1.0 for kind in kinds)
