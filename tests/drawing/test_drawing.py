"""Lines on paper are where the construction has them, and look as a drawing office wants them."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from io import BytesIO
from itertools import pairwise

import pdfplumber
import pytest

from vecpoly.algebra.formula import Row, plain
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Arc, Block, Dot, Ground, Plate, Point, Role, Segment, Slot, Vector
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.backends.png import to_png
from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.figure import draw_figure, drawing, drawn_anew, unit_per_mm
from vecpoly.drawing.labels import kept
from vecpoly.drawing.scene import Fill, Layer, Scene, Stroke
from vecpoly.drawing.style import HEAD_LENGTH, HEAD_WIDTH, Hue
from vecpoly.drawing.symbols import shapes
from vecpoly.foundation.frozen import FrozenMap
from vecpoly.foundation.slotted import replace
from vecpoly.words import Words

MM = 72 / 25.4


def figure(*marks: object, view: View = View.VELOCITY) -> Figure:
    """A figure of these marks."""
    scale = Scale(symbol="μ_v", value=0.006, unit="m/s")
    return Figure(view=view, title=Words("速度多边形", "Velocity polygon"), scale=scale, marks=tuple(marks))  # type: ignore[arg-type]


SAMPLE = figure(
    Point(at=0j, label="p", dot=Dot.POLE, step=1),
    Vector(a=0j, b=31.234 + 47.891j, role=Role.GIVEN, label="v_B", step=1),
    Segment(a=31.234 + 47.891j, b=70.5 - 3.25j, role=Role.DIRECTION, step=2),
    Vector(a=0j, b=68.1 + 0.5j, role=Role.RESULT, label="v_C", step=3),
    Point(at=68.1 + 0.5j, label="c", dot=Dot.POINT, step=3),
)


def test_line_ends_in_the_pdf_are_where_the_construction_has_them() -> None:
    scene = draw_figure(SAMPLE)
    with pdfplumber.open(BytesIO(to_pdf(scene))) as pdf:
        page = pdf.pages[0]
        drawn = [
            (complex(x0, y0), complex(x1, y1))
            for line in page.lines
            for (x0, y0), (x1, y1) in [
                [(x / MM + scene.extents.x0, (page.height - y) / MM + scene.extents.y0) for x, y in line["pts"]]
            ]
        ]
    wanted = 31.234 + 47.891j, 70.5 - 3.25j
    assert min(abs(a - wanted[0]) + abs(b - wanted[1]) for a, b in drawn) < 0.01


def test_an_arrowhead_points_exactly_at_the_end_of_its_vector() -> None:
    heads = [item for item in draw_figure(SAMPLE).items if isinstance(item, Fill) and len(item.points) == 3]
    tips = [head.points[0] for head in heads if head.hue is not Hue.WHITE]
    assert tips == [31.234 + 47.891j, 68.1 + 0.5j]


@pytest.mark.parametrize("length", [0.5, 2.0, 5.0, 9.0, 80.0])
def test_an_arrowhead_is_3_mm_long_and_never_more_than_a_third_of_its_vector(length: float) -> None:
    assert shapes.head_length(length) == pytest.approx(min(HEAD_LENGTH, length / 3))
    assert shapes.head_width(length, shapes.shaft_width(length, 0.5)) <= HEAD_WIDTH + 1e-9


def test_an_arrowhead_is_always_wider_than_its_line() -> None:
    for length in (0.2, 1.0, 3.0, 6.0, 30.0):
        line = shapes.shaft_width(length, 0.5)
        assert shapes.head_width(length, line) >= 2 * line - 1e-9


def test_line_widths_follow_the_role() -> None:
    roles = {Role.LINK: 0.7, Role.DIRECTION: 0.25, Role.CONSTRUCTION: 0.18, Role.CENTRE: 0.25, Role.HIDDEN: 0.25}
    for role, width in roles.items():
        (line,) = drawing(figure(Segment(a=0j, b=9j, role=role)), caption=False).scene.items
        assert isinstance(line, Stroke) and line.width == width


def test_a_curve_is_nowhere_further_than_a_hundredth_of_a_millimetre_from_round() -> None:
    points = shapes.circle(3 + 4j, 60.0)
    middles = [(a + b) / 2 for a, b in pairwise(points)]
    assert max(60.0 - abs(z - (3 + 4j)) for z in middles) < 0.01


def test_joints_hide_the_line_ends_under_them() -> None:
    scene = draw_figure(figure(Segment(a=0j, b=30j, role=Role.LINK), Ground(at=0j, down=-1j), view=View.MECHANISM))
    order = [item.layer for item in scene]
    assert order == sorted(order) and any(i.layer is Layer.JOINT and i.hue is Hue.WHITE for i in scene)


@pytest.mark.parametrize("role", [Role.CONSTRUCTION, Role.DIRECTION, Role.HIDDEN, Role.CENTRE])
def test_fine_lines_pass_under_the_bars_of_the_mechanism(role: Role) -> None:
    arc = Arc(centre=0j, radius=9.0, start=0.0, sweep=1.0, role=role)
    marks = (Segment(a=0j, b=30j, role=Role.LINK), Segment(a=0j, b=30j, role=role), arc)
    items = drawing(figure(*marks, view=View.MECHANISM), caption=False).scene.items
    bar, *fine = sorted((i for i in items if isinstance(i, Stroke)), key=lambda i: -i.width)
    assert len(fine) == 2 and all(line.layer < bar.layer for line in fine)


def test_a_rod_passes_under_its_sleeve_but_a_crank_pinned_to_the_block_lies_over_it() -> None:
    marks = (
        Block(at=0j, along=1 + 0j, on_rod=True),
        Segment(a=-30 + 0j, b=30 + 0j, role=Role.LINK),
        Segment(a=0j, b=30j, role=Role.LINK),
        Plate(points=(0j, 20 - 20j, 5 - 30j)),
        Slot(a=-20 + 0j, b=20 + 0j),
    )
    links = [
        i
        for i in drawing(figure(*marks, view=View.MECHANISM), caption=False).scene.items
        if isinstance(i, Stroke) and i.width == 0.7
    ]
    assert [link.layer for link in links] == [Layer.LINE, Layer.OVER, Layer.OVER]


def test_a_crank_lies_over_the_slot_in_which_its_pin_runs_but_the_slotted_link_under_it() -> None:
    marks = (
        Slot(a=-20 + 0j, b=20 + 0j, owner="link 2"),
        Segment(a=20 + 0j, b=60 + 0j, role=Role.LINK, owner="link 2"),
        Segment(a=5 - 30j, b=5 + 0j, role=Role.LINK, owner="link 1"),
        Segment(a=-40 - 30j, b=-40 + 0j, role=Role.LINK, owner="link 3"),
    )
    items = drawing(figure(*marks, view=View.MECHANISM), caption=False).scene.items
    links = [item for item in items if isinstance(item, Stroke) and item.width == 0.7]
    assert [link.layer for link in links] == [Layer.LINE, Layer.OVER, Layer.LINE]


def test_hatching_lies_to_the_right_of_the_guide() -> None:
    assert all(b.imag < 0 for _, b in shapes.hatching(0j, 20 + 0j))


def test_the_scale_names_its_unit_for_a_millimetre() -> None:
    units = {unit: plain(Row(tuple(unit_per_mm(unit)))) for unit in ("m", "m/s", "m/s^2")}
    assert units == {"m": "m/mm", "m/s": "(m/s)/mm", "m/s^2": "(m/s^2)/mm"}


def test_the_board_after_a_step_shows_no_later_mark_and_keeps_its_lettering_in_place() -> None:
    whole, part = draw_figure(SAMPLE), draw_figure(SAMPLE, upto_step=1)
    assert part.extents == whole.extents and set(part.items) < set(whole.items)
    assert max(item.step for item in part.items) == 1


def test_highlighting_fades_all_other_steps() -> None:
    bright = [i for i in draw_figure(SAMPLE, highlight=3).items if i.hue is not Hue.GHOST and not i.hue.is_tint]
    assert bright and all(item.step == 3 for item in bright)


def test_drawing_is_deterministic_to_the_byte() -> None:
    assert to_pdf(draw_figure(SAMPLE)) == to_pdf(draw_figure(SAMPLE))
    assert to_svg(draw_figure(SAMPLE)) == to_svg(draw_figure(SAMPLE))


def test_svg_is_in_millimetres_and_groups_each_step() -> None:
    root = ET.fromstring(to_svg(draw_figure(SAMPLE), "v"))
    assert root.attrib["width"].endswith("mm")
    assert {g.attrib["data-step"] for g in root if "data-step" in g.attrib} == {"0", "1", "2", "3"}


def test_png_has_the_size_of_the_scene() -> None:
    scene = draw_figure(SAMPLE)
    data = to_png(scene, dpi=100)
    width = int.from_bytes(data[16:20], "big")
    assert data[:4] == b"\x89PNG" and abs(width - scene.extents.width / 25.4 * 100) <= 1.5


def test_matplotlib_figure_has_the_true_size() -> None:
    from vecpoly.drawing.backends.mpl import to_mpl

    scene = draw_figure(SAMPLE)
    picture = to_mpl(scene)
    assert math.isclose(picture.get_size_inches()[0] * 25.4, scene.extents.width)


def test_an_empty_figure_draws_only_its_title() -> None:
    assert isinstance(draw_figure(figure()), Scene)


def test_letters_that_were_placed_once_stand_there_again() -> None:
    drawn_anew()
    paper, again = drawing(SAMPLE, lang="zh"), drawing(replace(SAMPLE, tones=FrozenMap({})), lang="en")
    hits = kept._placed.cache_info().hits
    drawn_anew()
    assert hits == 1 and [one.centre for one in paper.labels] == [one.centre for one in again.labels]
    assert again.scene == drawing(replace(SAMPLE, tones=FrozenMap({})), lang="en").scene
    assert {item.hue for item in paper.scene.items} > {item.hue for item in again.scene.items}


def test_letters_are_placed_anew_where_a_line_has_come_nearer() -> None:
    drawn_anew()
    before = drawing(SAMPLE)
    crossed = replace(SAMPLE, marks=(*SAMPLE.marks, Segment(a=25 - 2.3j, b=43 - 2.3j, role=Role.DIRECTION, step=2)))
    after = drawing(crossed)
    assert kept._placed.cache_info().hits == 0 and before.labels != after.labels
