"""Where no type can be set a title has no signs of its symbols: of a PDF, an SVG, a GeoGebra file."""

from __future__ import annotations

from io import BytesIO

from pypdf import PdfReader

from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.scene import Rect, Scene
from vecpoly.export.geogebra.document import document
from vecpoly.export.recording import record
from vecpoly.problem.load import load
from vecpoly.report.document import report_bytes
from vecpoly.solution import solve


def test_the_title_of_a_report_holds_the_letters_of_its_symbols_alone() -> None:
    found = PdfReader(BytesIO(report_bytes([solve(load("8-4"), repeats=0, precise=False)], lang="zh"))).metadata
    assert found is not None and found.title == "题 8-4\u3000按 K、机架和一个极限位置设计曲柄摇杆机构"


def test_so_do_those_of_an_svg_and_of_a_geogebra_file() -> None:
    assert "<title>at φ_1 = 60°</title>" in to_svg(Scene((), Rect(0.0, 0.0, 9.0, 9.0)), "at $φ_1$ = 60°")
    assert b'title="Oscillating-block linkage with coupler point D"' in document(record(load("ex10")), "en")
