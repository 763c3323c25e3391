"""What a student wrote of a vector is drawn over the exact one, its direction as it was written: in degrees or by an
arrow."""

from __future__ import annotations

import cmath
from math import degrees
from pathlib import Path
from typing import TypeGuard

import pytest
import shapely
from pypdf import PdfReader

from tests.marked.classes import NUMBERS, answers, graded, register, wide
from vecpoly.board.paper.marks import Arc
from vecpoly.drawing.figure import draw_figure
from vecpoly.drawing.scene import Item, Layer, Rect, Stroke, TextBox
from vecpoly.drawing.style import Dash
from vecpoly.marked.out.feedback import side_by_side
from vecpoly.marked.out.overlay import overlays
from vecpoly.solution import solve


@pytest.mark.parametrize(("behind", "right"), [("", True), ("AS IS", True), ("ROUGHLY", True), ("BACK", False)])
def test_an_arrow_is_drawn_where_it_points(tmp_path: Path, behind: str, right: bool) -> None:
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    exact = sheet.parts[0].key["v_E"]
    assert exact.degrees is not None
    rough = "→↗↑↖←↙↓↘"[round(exact.degrees / 45) % 8]
    back = "→↗↑↖←↙↓↘"[(round(exact.degrees / 45) + 4) % 8]
    told = {"": "", "AS IS": f" ∠{exact.degrees:.1f}°", "ROUGHLY": f" {rough}", "BACK": f" {back}"}[behind]
    mine = answers(NUMBERS[0]) | {"v_E": f"{exact.exact:.4g} m/s{told}"}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: mine}))
    marked = done.results[0].marks["3-9"]
    assert marked["v_E"].is_right is right
    construction = solve(register().variant(sheet.parts[0]), repeats=0).construction
    drawn = [one.scene for one in overlays(construction, marked, "en")]
    ways = [
        degrees(cmath.phase(item.points[1] - item.points[0]))
        for scene in drawn
        for item in scene.items
        if isinstance(item, Stroke) and item.dash is Dash.DASHED and len(item.points) == 2
    ]
    gap = min(abs((way - exact.degrees + 180) % 360 - 180) for way in ways)
    assert (gap < 1.0) or not right


def test_letters_of_an_overlay_keep_clear_of_the_circles_of_what_is_allowed_and_figures_stand_in_rows(
    tmp_path: Path,
) -> None:
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: answers(NUMBERS[0])}))
    sheet, marked = register().sheet(NUMBERS[0]), done.results[0].marks["3-9"]
    assert sheet is not None
    found = overlays(solve(register().variant(sheet.parts[0]), repeats=0).construction, marked, "en")
    drawn = [(one.figure, one.scene) for one in found]
    for figure, scene in drawn:
        allowed = [mark for mark in figure.marks if isinstance(mark, Arc)]
        rings = [shapely.Point(ring.centre.real, ring.centre.imag).buffer(ring.radius).boundary for ring in allowed]
        letters = [item.rect for item in scene.items if isinstance(item, TextBox)]
        assert rings and letters
        assert not any(ring.intersects(shapely.box(r.x0, r.y0, r.x1, r.y1)) for ring in rings for r in letters)
    (row,) = side_by_side([(figure.title.en, scene) for figure, scene in drawn])
    assert len(drawn) == 2 and row[0] == "Velocity polygon; Acceleration polygon"
    assert row[1].extents.width > sum(scene.extents.width for _, scene in drawn)


@pytest.mark.parametrize("way", ["←", "↑", "→", "↓"])
def test_the_title_and_the_scale_of_an_overlay_stand_below_what_the_student_drew(tmp_path: Path, way: str) -> None:
    """A vector that points elsewhere ran through them."""
    mine = answers(NUMBERS[0]) | {"v_E": f"0.3 {way}", "a_E": f"9 {way}"}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: mine}))
    sheet, marked = register().sheet(NUMBERS[0]), done.results[0].marks["3-9"]
    assert sheet is not None
    drawn = list(overlays(solve(register().variant(sheet.parts[0]), repeats=0).construction, marked, "zh"))
    assert len(drawn) > 1
    for scene in (one.scene for one in drawn):
        own = [item for item in scene.items if isinstance(item, Stroke) and item.dash is Dash.DASHED]
        caption = sorted((item.rect for item in scene.items if isinstance(item, TextBox)), key=lambda rect: rect.y0)[:2]
        assert own and max(rect.y1 for rect in caption) < min(z.imag for item in own for z in item.points)


@pytest.mark.parametrize("way", [90, 330])
def test_letters_of_an_overlay_keep_clear_of_what_the_student_drew(tmp_path: Path, way: int) -> None:
    """A vector that goes off the page ran through a letter of the exact polygon."""
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    mine = answers(NUMBERS[0]) | {"v_E": f"90 ∠{way}°"}
    done = graded(tmp_path / "out", wide(tmp_path / "a.csv", {NUMBERS[0]: mine}))
    moved = False
    construction = solve(register().variant(sheet.parts[0]), repeats=0).construction
    for one in overlays(construction, done.results[0].marks["3-9"], "en"):
        before, after = (
            [item.rect for item in scene.items if isinstance(item, TextBox)]
            for scene in (draw_figure(one.figure, lang="en", caption=False), one.scene)
        )
        for line in (item for item in one.scene.items if _is_own(item)):
            moved |= any(_through(line, rect) for rect in before)
            assert not any(_through(line, rect) for rect in after), one.figure.title.en
    assert moved


def _is_own(item: Item) -> TypeGuard[Stroke]:
    return isinstance(item, Stroke) and item.dash is Dash.DASHED and len(item.points) == 2 and item.layer is Layer.OVER


def _through(line: Stroke, rect: Rect) -> bool:
    bar = shapely.LineString([(z.real, z.imag) for z in line.points])
    return bool(bar.intersects(shapely.box(rect.x0, rect.y0, rect.x1, rect.y1)))


@pytest.mark.parametrize(("times", "cut"), [(1.5, False), (10.0, True), (1000.0, True)])
def test_a_vector_that_goes_off_the_page_is_drawn_in_part_and_told(tmp_path: Path, times: float, cut: bool) -> None:
    """A power of ten made the whole polygon vanish from the feedback."""
    sheet = register().sheet(NUMBERS[0])
    assert sheet is not None
    exact = sheet.parts[0].key["v_E"]
    file = wide(tmp_path / "a.csv", {NUMBERS[0]: {"v_E": f"{times * exact.exact:.4g} m/s"}})
    done = graded(tmp_path / "out", file, feedback=True)
    construction = solve(register().variant(sheet.parts[0]), repeats=0).construction
    (one,) = overlays(construction, done.results[0].marks["3-9"], "en")
    assert one.cut == ((exact.symbol,) if cut else ())
    assert one.scene.extents.width <= 168 and one.scene.extents.height <= 150
    dashed = [item for item in one.scene.items if isinstance(item, Stroke) and item.dash is Dash.DASHED]
    (own,) = [item for item in dashed if len(item.points) == 2 and item.layer is Layer.OVER]
    heads = [item for item in one.scene.items if isinstance(item, Stroke) and item.layer is Layer.HEAD]
    ends = [item for item in heads if own.points[1] in item.points]
    assert len(ends) == (0 if cut else 2)
    (pdf,) = (tmp_path / "out" / "feedback").iterdir()
    text = "".join(page.extract_text() for page in PdfReader(pdf).pages)
    assert ("超出图面" in text) is cut and "速度多边形" in text
