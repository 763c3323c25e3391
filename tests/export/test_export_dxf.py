"""DXF files, read back by ezdxf: mm for mm the construction, on layers by what a line is for, with its letters."""

from __future__ import annotations

import io
import sys
from functools import cache
from math import radians
from pathlib import Path
from typing import Any

import ezdxf.filemanagement
import pytest
from ezdxf.document import Drawing
from typer.testing import CliRunner

from tests.drawn_library import LIBRARY
from tests.each import each
from tests.laws import few
from vecpoly import load, solve
from vecpoly.board.construction import Construction, Figure, View
from vecpoly.board.paper.marks import AngleMark, Arc, Role, Segment, Vector
from vecpoly.cli.app import app
from vecpoly.drawing.cleared import cleared
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.errors import VecpolyError
from vecpoly.export.dxf.document import figure_dxf, library, sheet_dxf
from vecpoly.foundation.slotted import replace
from vecpoly.solution import Solution
from vecpoly.words import Words

SEVERAL = ("3-9", "3-12", "4-3a", "5-2", "geared-five-bar")
CLOSE = 1e-9


@cache
def solved(problem: str) -> Solution:
    return solve(load(problem), by="exact", repeats=0, precise=False)


def read(data: bytes) -> Drawing:
    doc = ezdxf.filemanagement.read(io.StringIO(data.decode("utf-8")))
    assert not doc.audit().errors
    return doc


def lines(doc: Drawing, layer: str) -> list[tuple[complex, complex]]:
    return [
        (complex(*e.dxf.start.vec2), complex(*e.dxf.end.vec2))
        for e in doc.modelspace().query(f'LINE[layer=="{layer}"]')
    ]


def has(found: list[tuple[complex, complex]], a: complex, b: complex, by: complex = 0j) -> bool:
    return any(abs(p - a - by) + abs(q - b - by) < CLOSE for p, q in found)


@each([*few(LIBRARY, 24), "A-27-c", "B-29.5"])
def test_every_sheet_of_the_library_is_written(problem: str) -> None:
    """Heads of the shortest vectors among them, which are all wall and have no white."""
    solution = solved(problem)
    for sheet in sheets(solution.construction, title=solution.problem.title):
        assert read(sheet_dxf(sheet)).modelspace()


@pytest.mark.parametrize("problem", few(SEVERAL, 4))
def test_every_vector_and_line_of_a_figure_is_there_in_mm_on_the_layer_of_its_role(problem: str) -> None:
    for figure in solved(problem).construction.figures:
        doc = read(figure_dxf(figure))
        for role in Role:
            found = lines(doc, role.value)
            for mark in figure.marks:
                if isinstance(mark, Segment | Vector) and mark.role is role and abs(mark.b - mark.a) > 1e-3:
                    assert has(found, mark.a, mark.b)


def test_vectors_stand_on_the_sheet_as_long_as_they_were_measured() -> None:
    solution = solved("3-9")
    sheet = sheets(solution.construction, title=solution.problem.title)[0]
    origin = next(one.origin for one in sheet.figures if one.view is View.VELOCITY)
    doc, figure = read(sheet_dxf(sheet)), velocity(solution.construction)
    speed = next(mark for mark in figure.marks if isinstance(mark, Vector) and mark.key == "v_E")
    assert has(lines(doc, "result"), speed.a, speed.b, origin)
    assert abs(speed.b - speed.a) == pytest.approx(solution.answers["v_E"].reading.mm)


def velocity(construction: Construction) -> Figure:
    found = construction.figure(View.VELOCITY)
    assert found is not None
    return found


def test_a_stroke_of_the_compass_is_as_long_as_on_paper() -> None:
    (figure,) = (one for one in solved("3-4a").construction.figures if one.view is View.MECHANISM)
    strokes = [
        entity.dxf.radius * radians((entity.dxf.end_angle - entity.dxf.start_angle) % 360)
        for entity in read(figure_dxf(figure)).modelspace().query('ARC[layer=="construction"]')
    ]
    assert len(strokes) >= 4 and strokes == pytest.approx([9.0] * len(strokes))


def test_lengths_are_mm_and_layers_have_the_widths_of_the_house() -> None:
    doc = read(figure_dxf(solved("3-9").construction.figures[0]))
    assert doc.units == 4
    assert [doc.layers.get(name).dxf.lineweight for name in ("link", "result", "given", "direction", "hidden")] == [
        70,
        50,
        35,
        25,
        25,
    ]
    assert doc.layers.get("centre").dxf.linetype == "VECPOLY_DASH_DOT"
    assert {"construction", "dimension", "frame", "text", "sheet", "tint", "point"} <= {
        layer.dxf.name for layer in doc.layers
    }


def test_letters_stand_as_text_where_the_svg_has_them() -> None:
    from vecpoly.drawing.figure import draw_figure
    from vecpoly.drawing.scene import TextBox
    from vecpoly.typeset import Glyphs

    for figure in solved("3-12").construction.figures:
        texts = {
            (e.dxf.text, round(e.dxf.insert.x, 6), round(e.dxf.insert.y, 6))
            for e in read(figure_dxf(figure)).modelspace().query("TEXT")
        }
        wanted = {
            (run.text, round(item.x + run.x, 6), round(item.y + run.y, 6))
            for item in draw_figure(figure).items
            if isinstance(item, TextBox)
            for run in item.box.items
            if isinstance(run, Glyphs) and run.text.strip()
        }
        assert texts == wanted
        assert {"A", "B", "C"} <= {text for text, _, _ in texts} or figure.view is not View.MECHANISM


def test_circles_are_circles_and_arcs_are_arcs() -> None:
    figure = solved("3-4b").construction.figures[0]
    doc = read(figure_dxf(figure))
    for mark in (one for one in cleared(figure.view, figure.marks) if isinstance(one, Arc)):
        assert any(
            abs(complex(*e.dxf.center.vec2) - mark.centre) < CLOSE and abs(e.dxf.radius - mark.radius) < 1e-6
            for e in doc.modelspace().query("ARC CIRCLE")
        )
    assert doc.modelspace().query("ARC")


@pytest.mark.parametrize("problem", ["3-9", "4-3a"])
def test_the_command_writes_a_sheet_of_which_every_page_reads(problem: str, tmp_path: Path) -> None:
    assert CliRunner().invoke(app, ["draw", problem, "-o", str(tmp_path / "x.dxf")]).exit_code == 0
    pages = sorted(tmp_path.iterdir())
    paper = load(problem).paper
    assert len(pages) == len(
        sheets(solve(load(problem), repeats=0, precise=False).construction, title=load(problem).title, on=paper)
    )
    for page in pages:
        doc = read(page.read_bytes())
        border: Any = next(iter(doc.modelspace().query('LWPOLYLINE[layer=="sheet"]')))
        assert max(x for x, y, *_ in border.get_points()) - min(x for x, y, *_ in border.get_points()) in (
            pytest.approx(190.0, abs=5),
            pytest.approx(277.0, abs=5),
        )


def test_one_figure_is_written_about_its_own_origin(tmp_path: Path) -> None:
    out = tmp_path / "v.dxf"
    assert (
        CliRunner().invoke(app, ["draw", "3-9", "--figure", "velocity", "--hand", "exact", "-o", str(out)]).exit_code
        == 0
    )
    assert has(
        lines(read(out.read_bytes()), "result"),
        *next(
            (m.a, m.b) for m in velocity(solved("3-9").construction).marks if isinstance(m, Vector) and m.key == "v_E"
        ),
    )


def test_a_step_leaves_out_what_is_drawn_later() -> None:
    figure = velocity(solved("3-9").construction)
    first, last = (min(mark.step for mark in figure.marks), max(mark.step for mark in figure.marks))
    counts = [len(read(figure_dxf(figure, upto=step)).modelspace().query("LINE")) for step in (first, last)]
    assert counts[0] < counts[1] == len(read(figure_dxf(figure)).modelspace().query("LINE"))


def test_without_its_package_nothing_is_written_and_the_refusal_says_what_to_install(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(VecpolyError, match=r"pip install vecpoly\[cad\]") as refused:
        library()
    assert refused.value.code == "package"


def test_angles_have_the_rays_that_they_have_on_paper() -> None:
    (figure,) = solved("dead-centre").construction.figures
    pivot = next(mark.at for mark in figure.marks if isinstance(mark, AngleMark) and mark.label.startswith("ψ"))
    rays = [ends for ends in lines(read(figure_dxf(figure)), "centre") if abs(ends[0] - pivot) < CLOSE]
    assert rays and all((end - start).imag == pytest.approx(0.0, abs=CLOSE) for start, end in rays)


def test_a_sheet_that_is_drawn_under_an_alarm_has_it_in_red_in_the_file_too() -> None:
    (sheet, *_) = sheets(solved("5-2").construction, title=solved("5-2").problem.title)
    told, plain = (
        {(one.dxf.text, one.dxf.true_color) for one in read(sheet_dxf(page)).modelspace().query("TEXT")}
        for page in (replace(sheet, warning=Words("不可用", "of no use")), sheet)
    )
    ((text, colour),) = told - plain
    assert text == "不可用" and colour >> 16 > 128 and not colour & 0xFFFF, "red, no green, no blue"
