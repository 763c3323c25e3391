"""Files as programs write them are read to mm, and what is damaged or meant badly is refused in one sentence."""

from __future__ import annotations

import io
from base64 import a85encode
from pathlib import Path
from zlib import compress

import ezdxf
import pytest
from reportlab.pdfgen.canvas import Canvas

from tests.grading.drawings.made import as_dxf, drawn, key_of, marked, zipped
from tests.laws import few
from vecpoly import limits, load, solve
from vecpoly.board.construction import View
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.figure import draw_figure
from vecpoly.errors import FaultError, ProblemFileError
from vecpoly.export.dxf.document import figure_dxf
from vecpoly.export.geogebra.document import to_ggb
from vecpoly.export.recording import record
from vecpoly.grading.drawings.judging.mark import Verdict
from vecpoly.grading.drawings.readers import dxf as dxf_reader
from vecpoly.grading.drawings.readers import found
from vecpoly.grading.drawings.readers.door import parsed, read_drawing
from vecpoly.grading.drawings.segment import Drawing

SVG = 'xmlns="http://www.w3.org/2000/svg"'
INKSCAPE = 'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'


def lines(drawing: Drawing) -> list[tuple[complex, complex]]:
    return [(_rounded(one.start), _rounded(one.end)) for one in drawing.segments]


def _rounded(at: complex) -> complex:
    return complex(round(at.real, 6) + 0.0, round(at.imag, 6) + 0.0)


def dxf(text: str, header: str = "  9\n$INSUNITS\n 70\n     4\n") -> bytes:
    head = f"  0\nSECTION\n  2\nHEADER\n{header}  0\nENDSEC\n"
    return f"{head}  0\nSECTION\n  2\nENTITIES\n{text}  0\nENDSEC\n  0\nEOF\n".encode()


LINE = "  0\nLINE\n  8\nv_B\n 10\n1.0\n 20\n2.0\n 30\n0.0\n 11\n4.0\n 21\n6.0\n 31\n0.0\n"


# -- our own exports -------------------------------------------------------------------------------------------


@pytest.mark.parametrize("problem", few(["3-9", "A-27"], 2))
def test_our_own_exports_are_read_as_right_drawings(problem: str) -> None:
    construction = solve(load(problem), by="exact", repeats=0, precise=False).construction
    figure = construction.figure(View.VELOCITY)
    assert figure is not None
    scene, key = draw_figure(figure), key_of(problem)
    files = {"dxf": figure_dxf(figure), "svg": to_svg(scene).encode(), "pdf": to_pdf(scene)}
    for kind, data in files.items():
        mark = marked(key, parsed(f"v.{kind}", data))["velocity"]
        assert {one.verdict for one in mark.vectors} == {Verdict.RIGHT}, kind
        assert mark.extra == () and mark.remarks == (), kind
    whole = marked(key, parsed("all.ggb", to_ggb(record(load(problem)))))
    assert {one.verdict for one in whole.vectors} == {Verdict.RIGHT}


# -- dialects --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("version", ["R12", "R2000", "R2007", "R2018"])
def test_dxf_of_every_age_is_read(version: str) -> None:
    key = key_of("3-9")
    assert marked(key, parsed("a.dxf", as_dxf(drawn(key.exact), version))).right


def test_a_dxf_as_librecad_writes_it_by_hand_has_layers_as_names() -> None:
    drawing = parsed("a.dxf", dxf(LINE))
    assert lines(drawing) == [(1 + 2j, 4 + 6j)] and drawing.segments[0].layer == "v_B" and drawing.remarks == ()


def test_a_dxf_in_inches_or_without_a_unit_says_so() -> None:
    inches = parsed("a.dxf", dxf(LINE, "  9\n$INSUNITS\n 70\n     1\n"))
    assert lines(inches) == [(25.4 + 50.8j, 101.6 + 152.4j)] and "inches" in inches.remarks[0].en
    assert inches.remarks[0].zh == "DXF 的单位是英寸，已换算为 mm"
    assert "mm" in parsed("a.dxf", dxf(LINE, "")).remarks[0].zh


def test_blocks_polylines_and_leaders_of_a_dxf_are_taken_apart() -> None:
    doc = ezdxf.new("R2010", units=4)  # type: ignore[attr-defined]
    block = doc.blocks.new("arrow")
    block.add_line((0, 0), (10, 0))
    block.add_solid([(10, 0), (7, 0.5), (7, -0.5)])
    page = doc.modelspace()
    page.add_blockref("arrow", (100, 0), dxfattribs={"rotation": 90, "xscale": 2, "yscale": 2, "layer": "v_B"})
    page.add_lwpolyline([(0, 0, 0, 0), (20, 0, 1, 0), (25, 0, 0, 0)])  # AutoCAD's arrow: a tapering last piece
    page.add_lwpolyline([(0, 50, 0.5), (20, 50, 0.0), (20, 80, 0.0)], format="xyb")  # a bulge is no straight line
    into = io.StringIO()
    doc.write(into)
    drawing = parsed("a.dxf", into.getvalue().encode())
    assert lines(drawing) == [
        (100 + 0j, 100 + 20j), (0j, 20 + 0j), (20 + 0j, 25 + 0j), (20 + 50j, 20 + 80j)
    ]  # fmt: skip
    assert [one.headed for one in drawing.segments] == [True, False, True, False]
    assert drawing.segments[0].layer == "v_B"


def test_an_svg_as_inkscape_writes_it_is_read_through_transforms_and_layers() -> None:
    text = (
        f'<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">'
        f'<svg {SVG} {INKSCAPE} width="210mm" height="297mm" viewBox="0 0 420 594">'
        '<g inkscape:groupmode="layer" inkscape:label="速度" transform="translate(20,40)">'
        '<g transform="rotate(90) scale(2)">'
        '<path inkscape:label="v_C" style="stroke:#000;marker-end:url(#a)" d="m 0,0 10,0"/></g>'
        '<text x="4" y="6" font-size="8">c<tspan dy="2">2</tspan></text></g>'
        '<g style="display:none"><line x1="0" y1="0" x2="9" y2="9" stroke="black"/></g>'
        '<defs><marker id="a"><path d="M0,0 L4,2 L0,4 z"/></marker></defs></svg>'
    )
    drawing = parsed("a.svg", text.encode())
    (one,) = drawing.segments
    assert lines(drawing) == [(10 - 20j, 10 - 30j)]
    assert (one.name, one.layer, one.headed) == ("v_C", "速度", True)
    assert [label.text for label in drawing.labels] == ["c2"]


@pytest.mark.parametrize("kind", ["svg", "pdf"])
@pytest.mark.parametrize(("bent", "count"), [(0.0, 1), (0.3, 0)])
def test_a_spline_that_runs_straight_is_a_line_and_one_that_does_not_is_none(
    kind: str, bent: float, count: int
) -> None:
    """The shaft of an arrow, as matplotlib draws it: no polygon was found on such a sheet."""
    between = [(20.0, 10.0 + bent), (30.0, 15.0 + bent)]
    if kind == "svg":
        (a, b), (c, d) = between
        paths = f'<path d="M 0,0 C {a},{b} {c},{d} 40,20"/><path d="M 0,0 H 9"/>'
        data = f'<svg {SVG} width="60mm" height="40mm" viewBox="0 0 60 40"><g stroke="black">{paths}</g></svg>'.encode()
    else:
        canvas = Canvas(stream := io.BytesIO())
        canvas.bezier(0, 0, *between[0], *between[1], 40, 20)
        canvas.line(0, 0, 9, 0)
        canvas.save()
        data = stream.getvalue()
    assert len(parsed(f"a.{kind}", data).segments) == count + 1


def test_an_svg_without_a_size_in_mm_says_so() -> None:
    drawing = parsed("a.svg", f'<svg {SVG}><line x1="0" y1="0" x2="96" y2="0" stroke="#000"/></svg>'.encode())
    assert lines(drawing) == [(0j, 25.4 + 0j)] and "mm" in drawing.remarks[0].zh


def test_a_geogebra_file_has_segments_vectors_captions_and_the_unit_of_its_axes() -> None:
    text = (
        '<geogebra><euclidianView><axis id="0" unitLabel="cm"/></euclidianView><construction>'
        '<element type="point" label="p"><show object="true" label="true"/><coords x="1" y="2" z="1"/></element>'
        '<element type="point" label="b"><show object="true" label="true"/><coords x="8" y="4" z="2"/></element>'
        '<command name="Vector"><input a0="p" a1="b"/><output a0="u"/></command>'
        '<element type="vector" label="u"><show object="true" label="true"/><caption val="$v_{B}$"/></element>'
        '<command name="Segment"><input a0="p" a1="(3, 2)"/><output a0="f"/></command>'
        '<element type="segment" label="f"><show object="true" label="false"/></element>'
        '<command name="Segment"><input a0="p" a1="b"/><output a0="h"/></command>'
        '<element type="segment" label="h"><show object="false" label="false"/></element>'
        "</construction></geogebra>"
    )
    drawing = parsed("a.ggb", zipped(text.encode()))
    assert lines(drawing) == [(10 + 20j, 40 + 20j), (10 + 20j, 30 + 20j)]
    assert [(one.name, one.headed) for one in drawing.segments] == [("$v_{B}$", True), ("f", False)]
    assert {label.text for label in drawing.labels} == {"p", "b"}


# -- refusals --------------------------------------------------------------------------------------------------

BOMB = b'<!DOCTYPE s [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]><svg xmlns="http://www.w3.org/2000/svg">&b;</svg>'


@pytest.mark.parametrize(
    ("name", "data", "code"),
    [
        ("a.doc", b"", "format"),
        ("a.dxf", b"\x00\x01 no drawing", "unreadable"),
        ("a.svg", b"<svg><line></svg>", "xml"),
        ("a.svg", b"<html/>", "no-svg"),
        ("a.svg", BOMB, "xml-entities"),
        ("a.svg", f"<svg {SVG}/>".encode(), "no-lines"),
        ("a.svg", f'<svg {SVG}><line x2="1e9" stroke="red"/></svg>'.encode(), "coordinate"),
        ("a.svg", f'<svg {SVG}><line x2="5" transform="spin(3)"/></svg>'.encode(), "unreadable"),
        ("a.pdf", b"%PDF-1.4 nothing", "unreadable"),
        ("a.ggb", b"no zip", "no-ggb"),
        ("a.ggb", zipped(b"x", "other.xml"), "no-ggb"),
        ("a.ggb", zipped(BOMB), "xml-entities"),
    ],
)
def test_what_cannot_be_read_is_refused_with_its_reason(name: str, data: bytes, code: str) -> None:
    with pytest.raises(FaultError) as refused:
        parsed(name, data)
    assert refused.value.code == code
    assert refused.value.words.zh != refused.value.words.en


def test_what_unpacks_beyond_all_measure_is_refused_unread(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in ("readers.ggb", "readers.pdf", "readers.refuse"):
        monkeypatch.setattr(f"vecpoly.grading.drawings.{module}.DRAWING_UNPACKED", 2_000)
    with pytest.raises(FaultError, match="unpacks to more"):
        parsed("a.ggb", zipped(b" " * 3_000))
    for packed in (bomb := compress(b" " * 3_000), a85encode(bomb) + b"~>"):
        with pytest.raises(FaultError, match="unpacks to more"):
            parsed("a.pdf", b"%PDF-1.4\nstream\n" + packed + b"\nendstream")


def test_blocks_within_blocks_are_counted_before_they_are_all_unfolded(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (dxf_reader, found):
        monkeypatch.setattr(module, "DRAWN", 2_000)  # of ten million
    doc = ezdxf.new("R2010", units=4)  # type: ignore[attr-defined]
    doc.blocks.new("b0").add_line((0, 0), (1, 0))
    for level in range(1, 8):
        block = doc.blocks.new(f"b{level}")
        for n in range(10):
            block.add_blockref(f"b{level - 1}", (n, level))
    doc.modelspace().add_blockref("b7", (0, 0))
    into = io.StringIO()
    doc.write(into)
    with pytest.raises(FaultError) as refused:
        parsed("a.dxf", into.getvalue().encode())
    assert refused.value.code == "too-many"


def test_a_refusal_names_the_file_and_a_file_that_is_too_large_is_not_opened(tmp_path: Path) -> None:
    bad = tmp_path / "学生.svg"
    bad.write_bytes(b"<svg>")
    with pytest.raises(ProblemFileError, match=r"学生\.svg"):
        read_drawing(bad)
    huge = tmp_path / "huge.dxf"
    with huge.open("wb") as file:
        file.truncate(limits.DRAWING_BYTES + 1)
    with pytest.raises(ProblemFileError, match="MB"):
        read_drawing(huge)
