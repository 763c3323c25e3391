"""The legend of a sheet: what its lines, arrows, symbols and letters stand for."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from tests.drawn_library import IDS, drafted, drawn
from tests.drawn_sheets import laid
from tests.each import Later, each
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Dot, ImageOf, Mark, Point, Role, Vector, Weld
from vecpoly.board.paper.tones import key_of, whose
from vecpoly.drawing.hues import ink_of, is_hollow
from vecpoly.drawing.legend.kinds import FOUND, KINDS, KNOWN
from vecpoly.drawing.legend.legend import band, blocks, cells, entries
from vecpoly.drawing.legend.letters import letters_met
from vecpoly.drawing.legend.on_sheet import _inks, _sets, _with_blocks, with_legend
from vecpoly.drawing.legend.vectors import _symbol, key_of_vectors
from vecpoly.drawing.scene import Fill, Rect, Scene, Stroke, TextBox, rect_of
from vecpoly.drawing.sheets.sheet import Sheet
from vecpoly.drawing.sheets.space import FRAME, STRIP, TALLEST
from vecpoly.drawing.style import THIN, Hue
from vecpoly.words import Words

SOME = ("3-9", "5-1", "curv-10")  # a plate, bands, a block


def _figures(name: str) -> list[Figure]:
    solution = drafted(name)
    assert solution is not None
    return list(solution.construction.figures)


def test_what_is_no_image_of_a_link_is_not_called_one() -> None:
    """The triangle of the three circles was an 'image of a link', its trial weights concentrated masses."""
    told = _told("field-four-runs")
    assert {"triangle of error between the arcs", "trial weight"} <= told
    assert not told & {"image of a link", "concentrated mass"}
    assert "image of a link" in _told("3-9") and "triangle of error between the arcs" not in _told("3-9")


def _told(name: str) -> set[str]:
    return {one.words.en for one in entries(_figures(name), "en")}


def test_every_motion_of_the_polygons_has_a_sample_in_its_ink_and_with_its_shaft() -> None:
    figures = _figures("A-30")
    tones = figures[0].tones
    drawn = {
        whose(key_of(mark)): (ink_of(key_of(mark), tones), is_hollow(key_of(mark), tones))
        for figure in figures
        for mark in figure.marks
        if figure.view.images and isinstance(mark, Vector)
    }
    found = [[item for item in one.sample if isinstance(item, Stroke)] for one in key_of_vectors(figures, "zh")]
    assert len(found) == len(drawn) > 8
    assert {(strokes[0].hue, len(strokes) == 2) for strokes in found} == set(drawn.values())
    assert any(hollow for _, hollow in drawn.values())


def test_a_motion_is_named_by_its_whole_and_a_sum_of_parts_by_these() -> None:
    names = [one.words.en for one in key_of_vectors(_figures("3-9"), "en")]
    assert "$v_{C2B}$, $a_{C2B}$" in names and "$v_{C2C3}$, $a^k_{C2C3}$, $a^r_{C2C3}$" in names
    assert _symbol("(at_CB + at_S3C)") == "a^t_{CB} + a^t_{S3C}" and _symbol("an_CB") == "a_{CB}"
    assert _symbol("ak_C2C3") == "a^k_{C2C3}"  # of Coriolis: no part of a vector that is drawn


def test_a_vector_that_shows_the_motions_of_several_points_is_named_by_all_of_them() -> None:
    """Of a coupling rod that does not turn only v_B had a vector: the legend was silent about v_C and v_M."""
    names = [one.words.en for one in key_of_vectors(_figures("parallelogram-locomotive"), "en")]
    assert names == ["$v_{B} = v_{C} = v_{M}$, $a_{B} = a_{C} = a_{M}$"]
    assert not any("=" in one.words.en for one in key_of_vectors(_figures("3-9"), "en"))


@pytest.mark.parametrize("name", SOME)
def test_a_kind_is_told_exactly_where_a_figure_of_the_sheet_has_it(name: str) -> None:
    for sheet in laid(name):
        figures = [one.figure for one in sheet.figures if one.figure is not None]
        marks: list[tuple[Figure, Mark]] = [(figure, mark) for figure in figures for mark in figure.marks]
        told = {one.words for one in entries(figures, "zh")}
        known = {kind.words for kind in KINDS if any(kind.met(*pair) for pair in marks)}
        both = {kind.words for kind in KINDS[:2]}
        assert told & {kind.words for kind in KINDS} == (known if both <= known else known - both)


def test_friction_is_told_of_sheets_with_friction_alone() -> None:
    assert "force without friction" in _told("5-1")
    assert not {one for one in _told("3-9") if "friction" in one or "action" in one}


def test_letters_of_a_curvature_drawing_are_told_what_they_stand_for() -> None:
    assert {"inflection pole", "pole tangent", "pole normal", "Ball's point"} <= _told("curv-10")
    assert "pole normal" not in _told("5-1")  # where n is the normal of a contact


@pytest.mark.parametrize("name", SOME)
def test_a_legend_stands_on_nothing_in_the_frame_and_moves_figures_together_or_lays_them_anew(name: str) -> None:
    for bare in laid(name):
        sheet = with_legend(bare)
        assert sheet.results
        legend, frame = Scene.of(sheet.results).extents, Rect(0.0, 0.0, *sheet.size).grown(-FRAME)
        assert legend.y0 > FRAME + STRIP - 0.2 and legend.y1 < frame.y1
        assert legend.x0 > frame.x0 - 0.2 and legend.x1 < frame.x1 + 0.2
        assert not any(_stands_in(sheet, legend))
        shifts = {
            complex(round(by.real, 6), round(by.imag, 6))
            for by in (b.origin - a.origin for a, b in zip(bare.figures, sheet.figures, strict=True))
        }
        figures = [one.extents for one in sheet.figures if "detail" not in one.name]
        assert len(shifts) == 1 or not any(a.overlaps(b) for n, a in enumerate(figures) for b in figures[:n])
        assert all(one.extents.y1 < sheet.size[1] - FRAME for one in sheet.figures)


def _stands_in(sheet: Sheet, legend: Rect) -> list[bool]:
    """Whether type, or an end of a line, stands in the legend."""
    inside = legend.grown(1.0)
    texts = [item.rect.overlaps(inside) for item in sheet.drawn if isinstance(item, TextBox)]
    ends = [z for item in sheet.drawn if not isinstance(item, TextBox) for z in item.points]
    return texts + [inside.x0 < z.real < inside.x1 and inside.y0 < z.imag < inside.y1 for z in ends]


def test_a_plate_grows_by_its_legend_and_a_page_stays_as_large_as_it_is() -> None:
    (plate,), (page, *_) = laid("3-9"), laid("3-5")
    assert with_legend(plate).room[1] > plate.room[1] and with_legend(page).room == page.room


def test_no_plate_grows_by_its_legend_beyond_a_page_of_text() -> None:
    """Rows stand closer, or what is plain is left out: 4-7 at the scales of a class was a sheet that no page held."""
    (plate,) = laid("3-9")
    wide, high = plate.room
    more = with_legend(plate).room[1] - high
    for short in (0.5, more - 0.5, more):
        told = with_legend(replace(plate, room=(wide, TALLEST - more + short)))
        assert told.results and told.room[1] <= TALLEST
    assert with_legend(replace(plate, room=(wide, TALLEST - more))).room[1] == pytest.approx(TALLEST)


def test_a_full_sheet_tells_the_inks_of_its_vectors_in_one_block_and_the_rest_in_another() -> None:
    bare = laid("six-bar-dynamic")[0]
    sheet = _blocked(bare)
    one, other = (
        rect_of(item) for item in sheet.results if isinstance(item, Stroke) and item.closed and _is_frame(item)
    )
    assert not one.overlaps(other) and sheet.drawn == bare.drawn
    assert not any(part for block in (one, other) for part in _stands_in(sheet, block))


@pytest.mark.parametrize("name", ["plate-on-crank", "six-bar-dynamic"])
def test_a_full_sheet_tells_all_kinds_of_vector_and_line_in_blocks_that_overlap_nowhere(name: str) -> None:
    sheet = _blocked(laid(name)[0])
    told = [one for one in entries([one.figure for one in sheet.figures if one.figure], sheet.lang) if not one.plain]
    words = {item.box for item in sheet.results if isinstance(item, TextBox)}
    assert {KNOWN.words, FOUND.words} <= {one.words for one in told}
    assert {cell.box for cell in cells(told, sheet.lang)} <= words
    frames = [rect_of(item) for item in sheet.results if isinstance(item, Stroke) and _is_frame(item)]
    assert len(frames) > 1 and not any(a.overlaps(b) for a, b in combinations(frames, 2))


def _blocked(sheet: Sheet) -> Sheet:
    """With its legend as where no band has room."""
    return _with_blocks(sheet, _sets(sheet), _inks(sheet))


def _is_frame(item: Stroke) -> bool:
    return item.closed and item.width == THIN and len(item.points) == 4


def test_a_sheet_on_which_all_is_plain_has_no_legend() -> None:
    sheet = laid("3-9")[0]
    (diagram,) = (one for one in sheet.figures if one.view is View.MECHANISM)
    assert diagram.figure is not None
    bare = tuple(mark for mark in diagram.figure.marks if not isinstance(mark, Weld))
    alone = replace(sheet, figures=(replace(diagram, figure=replace(diagram.figure, marks=bare)),))
    assert with_legend(alone) is alone and with_legend(replace(sheet, figures=(diagram,))) is not sheet


def test_samples_and_words_of_a_legend_overlap_nowhere() -> None:
    found = cells(entries(_figures("A-30"), "zh"), "zh")
    for grid in (band(found, "zh", 190.0), *blocks(found, "zh", 190.0)):
        texts = [item.rect for item in grid.items if isinstance(item, TextBox)]
        samples = [rect_of(item) for item in grid.items if isinstance(item, Stroke) and item.hue is not Hue.WHITE]
        assert not any(a.overlaps(b) for n, a in enumerate(texts) for b in texts[:n])
        assert not any(a.overlaps(b) for a in texts for b in samples)
        assert all(r.x0 > 0 and r.x1 < grid.width and r.y0 > 0 and r.y1 < grid.height for r in texts)


def test_images_of_velocities_and_of_accelerations_are_shown_in_both_their_tints() -> None:
    def tints(*views: str) -> int:
        figures = [one for one in drawn("3-9").construction.figures if one.view.name in views]
        (entry,) = (one for one in entries(figures, "en") if one.words.en == "image of a link")
        return len({item.hue for item in entry.sample if isinstance(item, Fill)})

    assert tints("velocity") == tints("acceleration") == 1 and tints("velocity", "acceleration") == 2


def _width(image: tuple[complex, ...]) -> float:
    """The least distance between two parallels that hold it (mm)."""
    turned = np.array(image)[None, :] * np.exp(-1j * np.radians(np.arange(0.0, 180.0, 0.25)))[:, None]
    return float(np.min(np.ptp(turned.imag, axis=1)))


@each(Later(lambda: [name for name in IDS if _images(name)]))
def test_images_of_links_are_explained_where_one_is_wide_enough_to_be_seen(name: str) -> None:
    told = any(one.words.en == "image of a link" for one in entries(drawn(name).construction.figures, "en"))
    widest = max(_width(mark.points) for mark in _images(name))
    assert widest > 0.5 if told else widest < 4.0


def _images(name: str) -> list[ImageOf]:
    return [mark for figure in drawn(name).construction.figures for mark in figure.marks if isinstance(mark, ImageOf)]


@pytest.mark.parametrize(
    ("view", "label", "told"),
    [
        (View.MECHANISM, "F", True),
        (View.BODY, "R_{12}", True),
        (View.MECHANISM, "v_{B}", False),
        (View.FORCE, "R_{12}", False),
    ],
)
def test_an_arm_is_one_of_a_force_where_a_force_acts_on_a_body(view: View, label: str, told: bool) -> None:
    marks = (Vector(a=0j, b=10 + 0j, label=label, role=Role.RESULT), Point(at=5j, label="h", dot=Dot.NONE))
    figure = Figure(view=view, title=Words.same("t"), scale=Scale(symbol="μ", value=1.0, unit="N"), marks=marks)
    words = [one.words.en for one in letters_met([figure], "en")]
    assert words == ["arm of a force"] * told
