"""A sheet holds its figures true to scale, with white around them, inside the frame."""

from __future__ import annotations

from io import BytesIO

import pdfplumber
import pytest

from vecpoly.board.construction import Construction, Figure, Scale, View
from vecpoly.board.paper.marks import Role, Segment
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.scene import Rect, rect_of
from vecpoly.drawing.sheets.mounting.spreading import sunk
from vecpoly.drawing.sheets.sheet import sheets
from vecpoly.drawing.sheets.space import FRAME, STRIP
from vecpoly.errors import VecpolyError
from vecpoly.words import Words

MM = 72 / 25.4


USUAL = (View.MECHANISM, View.VELOCITY, View.ACCELERATION, View.BODY, View.FORCE)


def construction(*sizes: tuple[float, float]) -> Construction:
    """Figures that are boxes of these sizes."""
    figures = tuple(_figure(view, w, h) for view, (w, h) in zip(USUAL, sizes, strict=False))
    return Construction(problem="3-1", hand="drafting", figures=figures, steps=(), readings={})


def _figure(view: View, w: float, h: float) -> Figure:
    corners = (0j, complex(w, 0), complex(w, h), complex(0, h))
    sides = tuple(Segment(a=a, b=b, role=Role.RESULT) for a, b in zip(corners, corners[1:] + corners[:1], strict=True))
    return Figure(view=view, title=Words("图", "Figure"), scale=Scale(symbol="μ_l", value=0.002, unit="m"), marks=sides)


def inside(inner: Rect, outer: Rect) -> bool:
    """Whether one rectangle lies within another."""
    return (
        inner.x0 >= outer.x0 - 1e-6
        and inner.y0 >= outer.y0 - 1e-6
        and inner.x1 <= outer.x1 + 1e-6
        and inner.y1 <= outer.y1 + 1e-6
    )


SIZES = [
    ((150, 90),),
    ((150, 80), (80, 90)),
    ((150, 90), (70, 85), (75, 80)),
    ((60, 90), (100, 40), (40, 100)),
    ((160, 200), (160, 200), (160, 200)),
    ((250, 120),),
]


@pytest.mark.parametrize("sizes", SIZES)
def test_nothing_lies_outside_the_frame_and_no_figures_overlap(sizes: tuple[tuple[float, float], ...]) -> None:
    made = sheets(construction(*sizes))
    assert [f.view for s in made for f in s.figures] == list(USUAL[: len(sizes)])
    for sheet in made:
        frame = sheet.scene.extents.grown(-FRAME)
        assert all(inside(rect_of(item), frame.grown(0.3)) for item in sheet.scene.items)
        room = Rect(frame.x0, frame.y0 + STRIP, frame.x1, frame.y1)
        boxes = [placed.extents for placed in sheet.figures]
        assert all(inside(box, room) for box in boxes)
        assert not any(a.overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])


def test_the_mechanism_comes_first_and_the_polygons_in_the_order_of_reading() -> None:
    (sheet,) = sheets(construction((150, 90), (70, 85), (75, 80)))
    first, second, third = (placed.extents for placed in sheet.figures)
    assert first.y0 > second.y1 or first.x1 < second.x0
    assert second.x1 < third.x0 or second.y0 > third.y1


def test_the_bar_measures_50_mm_and_the_figures_are_true_to_scale() -> None:
    (sheet,) = sheets(construction((123.456, 90)))
    with pdfplumber.open(BytesIO(to_pdf(sheet.scene))) as pdf:
        page = pdf.pages[0]
        lengths = [line["width"] / MM for line in page.lines if line["height"] < 1e-3]
        assert float(page.width) == pytest.approx(sheet.size[0] * MM, abs=0.01)
        assert "50 mm" in page.extract_text().replace("\xa0", " ")
    assert min(abs(length - 50) for length in lengths) < 0.01
    assert min(abs(length - 123.456) for length in lengths) < 0.01


def test_figures_that_do_not_fit_one_page_go_on_more() -> None:
    assert len(sheets(construction((160, 200), (160, 200), (160, 200)))) == 3


def test_a_wide_figure_turns_the_sheet() -> None:
    (sheet,) = sheets(construction((250, 120)))
    assert sheet.landscape and sheet.size == (297.0, 210.0)


def test_a_figure_larger_than_any_sheet_is_refused_with_its_extents() -> None:
    with pytest.raises(VecpolyError, match=r"mechanism figure measures 40\d × "):
        sheets(construction((400, 100)))


def test_both_languages_fill_the_strip_without_running_over() -> None:
    for lang in ("zh", "en"):
        long = Words(
            "一个非常非常非常非常非常长的题目名称写在标题栏里",
            "A very long title of a problem in the title block of a sheet",
        )
        (sheet,) = sheets(construction((100, 90)), lang=lang, title=long)
        strip = [
            rect_of(i) for i in sheet.scene.items if type(i).__name__ == "TextBox" and rect_of(i).y1 < FRAME + STRIP
        ]
        assert not any(a.overlaps(b) for i, a in enumerate(strip) for b in strip[:i])


def test_titles_of_figures_side_by_side_stand_on_one_line() -> None:
    boxes = [Rect(0, 0, 50, 100), Rect(60, 40, 100, 90), Rect(110, 20, 150, 60)]
    falls = sunk(boxes, [10, 50, 26], (), 2.0)
    assert falls == pytest.approx([0, 40, 16])


def test_a_figure_does_not_sink_onto_another_nor_onto_what_stands_still() -> None:
    tall, upper, lower = Rect(0, 0, 50, 100), Rect(60, 60, 100, 100), Rect(60, 5, 100, 50)
    assert sunk([tall, upper, lower], [10, 70, 15], (), 2.0) == pytest.approx([0, 0, 5])
    assert sunk([tall, upper], [10, 70], (Rect(60, 0, 100, 30),), 2.0) == pytest.approx([0, 0])
