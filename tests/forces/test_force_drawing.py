"""Forces on paper: friction circles, bodies, narrow angles,
and many figures on few sheets, readable in both languages."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from io import BytesIO

import numpy as np
import pdfplumber
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

from tests import force_figures as ff
from tests.label_faults import faults
from tests.laws import few, often
from vecpoly.board.construction import Construction, Figure, Scale, View
from vecpoly.board.paper.extent import bounds
from vecpoly.board.paper.marks import (
    AngleMark,
    Block,
    Cell,
    Disc,
    Dot,
    FrictionCircle,
    Mark,
    Note,
    Outline,
    Point,
    Role,
    Segment,
    TurnArrow,
    Vector,
)
from vecpoly.drawing.backends.pdf import to_pdf
from vecpoly.drawing.backends.png import to_png
from vecpoly.drawing.backends.svg import to_svg
from vecpoly.drawing.figure import draw_figure, drawing
from vecpoly.drawing.order import reading_order
from vecpoly.drawing.scene import Fill, Layer, Rect, Scene, Stroke, TextBox
from vecpoly.drawing.sheets.paging import Drawn, arranged, paged
from vecpoly.drawing.sheets.sheet import Sheet, sheets
from vecpoly.drawing.sheets.space import room, usable
from vecpoly.drawing.style import Dash, Hue
from vecpoly.figures import views
from vecpoly.methods.forces.bodies.arrows import LEAST_AWAY, Arrow, _closer
from vecpoly.words import Lang, Words

MM = 72 / 25.4
EN_ZH: tuple[Lang, Lang] = ("zh", "en")


def items(*marks: Mark, lang: Lang = "zh") -> tuple[Stroke | Fill | TextBox, ...]:
    """What a free body of these marks consists of, lettering included."""
    return draw_figure(ff.body("2", *marks), lang=lang, caption=False).items


def text(scene: Scene) -> str:
    """All that is lettered in a scene, as it is read back from its PDF."""
    page = Scene(scene.items, scene.extents.grown(2.0))
    with pdfplumber.open(BytesIO(to_pdf(page))) as pdf:
        return str(pdf.pages[0].extract_text()).replace("\xa0", " ")


@pytest.mark.parametrize("lang", EN_ZH)
@pytest.mark.parametrize("name", list(ff.SINGLE))
def test_no_label_of_a_free_body_stands_on_a_line_a_head_or_another_label(name: str, lang: Lang) -> None:
    assert faults(drawing(ff.SINGLE[name](), lang=lang)) == []


@pytest.mark.parametrize("turn", few(range(0, 360, 24), 3))
@pytest.mark.parametrize("name", ["rod", "slide", "crank", "wedge", "tight_polygon"])
def test_labels_find_free_places_however_the_body_is_turned(name: str, turn: int) -> None:
    figure = ff.SINGLE[name]()
    assert faults(drawing(replace(figure, marks=tuple(turned(m, ff.cis(turn)) for m in figure.marks)))) == []


def turned(mark: Mark, u: complex) -> Mark:
    """The mark turned about the origin."""
    new = {f: getattr(mark, f) * u for f in ("a", "b", "at", "centre", "down") if hasattr(mark, f)}
    if hasattr(mark, "start"):
        new["start"] = mark.start + cmath.phase(u)
    if hasattr(mark, "points"):
        new["points"] = tuple(p * u for p in mark.points)
    return replace(mark, **new)


def test_a_friction_circle_is_dashed_has_its_radius_and_lies_over_what_it_surrounds() -> None:
    (ring,) = (
        i
        for i in items(FrictionCircle(centre=3 + 4j, radius=2.5), Disc(centre=3 + 4j, radius=9))
        if isinstance(i, Stroke) and i.dash is not Dash.FULL
    )
    assert ring.closed and ring.layer is Layer.JOINT and 0.18 <= ring.width <= 0.25
    assert max(abs(abs(z - 3 - 4j) - 2.5) for z in ring.points) < 1e-9


def test_an_enlarged_friction_circle_says_how_much_larger_it_is() -> None:
    scene = draw_figure(ff.body("2", FrictionCircle(centre=0j, radius=2.0, label="ρ", enlarged=3)))
    assert "×3" in text(scene).replace(" ", "")
    assert "×" not in text(draw_figure(ff.body("2", FrictionCircle(centre=0j, radius=2.0, label="ρ"))))


def test_a_pin_within_a_narrow_friction_circle_is_drawn_smaller_than_the_circle() -> None:
    for radius in (1.0, 1.5, 3.0):
        circle = FrictionCircle(centre=0j, radius=radius)
        pin = next(
            i
            for i in items(circle, Point(at=0j, label="", dot=Dot.JOINT))
            if isinstance(i, Stroke) and i.dash is Dash.FULL
        )
        assert max(abs(z) for z in pin.points) < radius - 0.3


def test_a_disc_and_a_moving_body_lie_under_every_line_drawn_on_them() -> None:
    marks = (Segment(a=0j, b=20j, role=Role.LINK), Disc(centre=0j, radius=12), Outline(points=(0j, 20 + 0j, 10j)))
    layers = [i.layer for i in items(*marks)]
    assert layers[0] == Layer.LINE and max(layers[1:]) < Layer.LINE
    assert [i.hue for i in items(*marks[1:]) if isinstance(i, Fill)] == [Hue.PLATE, Hue.PLATE]


@pytest.mark.parametrize(
    "points", [(0j, 40 + 0j, 40 + 8j, 8j), (0j, 40 + 0j, 40 + 30j, 32 + 30j, 32 + 8j, 8j), (0j, 20 + 0j, 7 + 18j)]
)
def test_the_hatching_of_a_fixed_body_stays_inside_it_at_45_degrees(points: tuple[complex, ...]) -> None:
    area = shapely.Polygon([(z.real, z.imag) for z in points])
    hatch = [i for i in items(Outline(points=points, fixed=True)) if isinstance(i, Stroke) and not i.closed]
    assert len(hatch) > 5 and not any(isinstance(i, Fill) for i in items(Outline(points=points, fixed=True)))
    for line in hatch:
        a, b = line.points
        assert area.buffer(1e-6).contains(shapely.LineString([(a.real, a.imag), (b.real, b.imag)]))
        assert abs(((b - a) / abs(b - a)).real - math.sqrt(0.5)) < 1e-9
    covered = shapely.union_all([shapely.LineString([(z.real, z.imag) for z in i.points]).buffer(1.7) for i in hatch])
    assert covered.intersection(area).area > 0.9 * area.area


def test_an_outline_that_crosses_itself_is_hatched_without_complaint() -> None:
    assert (
        items(Outline(points=(0j, 20 + 20j, 20 + 0j, 20j), fixed=True))
        and items(Outline(points=(1j, 2j)))
        and items(Outline(points=(1j,))) == ()
    )


@pytest.mark.parametrize("lang", EN_ZH)
@pytest.mark.parametrize(
    "words",
    [
        Words("机器 1\n$η_1$ = 0.95", "machine 1\n$η_1$ = 0.95"),
        Words("十二个字的很长很长的名称", "a name that is too long for its box"),
    ],
)
def test_the_words_of_a_box_stay_in_it(words: Words, lang: Lang) -> None:
    cell = Cell(at=5 + 5j, width=26, height=14, words=words)
    (box,) = (i.rect for i in items(cell, lang=lang) if isinstance(i, TextBox))
    assert box.x0 > -8 and box.x1 < 18 and box.y0 > -2 and box.y1 < 12
    assert abs(box.centre - (5 + 5j)) < 1e-6


def test_words_on_a_drawing_speak_the_language_of_the_sheet() -> None:
    marks = (
        Note(at=0j, words=Words("楔块左移", "wedge moves left")),
        Cell(at=40 + 0j, width=30, height=12, words=Words("电动机", "motor")),
    )
    zh, en = (text(draw_figure(ff.body("1", *marks), lang=lang)) for lang in EN_ZH)
    assert "楔块左移" in zh and "电动机" in zh and "wedge moves left" in en and "motor" in en


@pytest.mark.parametrize("degrees", [5, 8.53, 10, -5, -10])
def test_a_narrow_angle_is_pointed_at_from_outside_and_its_letter_stands_outside(degrees: float) -> None:
    mark = AngleMark(at=0j, radius=16, start=0.7, sweep=math.radians(degrees), label="φ")
    drawn = drawing(ff.body("3", mark), caption=False)
    tips = sorted(cmath.phase(i.points[0]) for i in drawn.obstacles if isinstance(i, Fill))
    low, high = sorted((mark.start, mark.start + mark.sweep))
    assert tips == pytest.approx([low, high], abs=1e-9)
    assert all(not low < cmath.phase(z) < high for i in drawn.obstacles if isinstance(i, Fill) for z in i.points[1:])
    (box,) = drawn.label_boxes
    wedge = shapely.Polygon([(0, 0), *((z.real, z.imag) for z in (cmath.rect(16, low), cmath.rect(16, high)))])
    assert not wedge.intersects(shapely.box(box.x0, box.y0, box.x1, box.y1))


def test_forces_are_drawn_in_their_own_ink_and_velocities_on_a_body_in_theirs() -> None:
    inks = {
        label: next(i.hue for i in items(Vector(a=0j, b=20j, role=Role.RESULT, label=label)) if isinstance(i, Fill))
        for label in ("R_{12}", "F_{I2}", "Q", "v_{34}", "")
    }
    force, velocity = View.FORCE.ink, View.VELOCITY.ink
    assert inks == {"R_{12}": force, "F_{I2}": force, "Q": force, "v_{34}": velocity, "": force}
    bows = [
        next(i.hue for i in items(TurnArrow(at=0j, radius=8, start=0, ccw=True, label=label)))
        for label in ("M_1", "ω_{21}")
    ]
    assert bows == [View.FORCE.ink, Hue.BLACK]


def test_a_force_on_the_velocity_polygon_used_as_a_lever_keeps_the_ink_of_forces() -> None:
    marks = (
        Vector(a=0j, b=20j, role=Role.RESULT, label="v_B"),
        Vector(a=20j, b=20 + 20j, role=Role.RESULT, label="F_{I2}"),
    )
    lever = replace(ff.velocity(), marks=marks)
    assert [i.hue for i in draw_figure(lever, caption=False).items if isinstance(i, Fill)] == [
        View.VELOCITY.ink,
        View.FORCE.ink,
    ]


def test_a_force_is_seen_over_the_block_on_which_it_acts() -> None:
    marks = (Vector(a=-20 + 0j, b=0j, role=Role.RESULT, label="F"), Block(at=0j, along=1 + 0j))
    order = [type(i).__name__ for i in Scene.of(items(*marks)) if i.layer < Layer.TEXT]
    assert order == ["Fill", "Stroke", "Stroke", "Fill"]  # the block, its outline, the shaft, the head


def test_a_figure_without_a_scale_has_its_title_and_no_scale_under_it() -> None:
    plain = Scale(symbol="", value=1.0, unit="")
    for scale, count in ((ff.MU_L, 2), (plain, 1), (replace(ff.MU_L, value=0.0), 1)):
        figure = replace(ff.rod(), scale=scale, marks=(Segment(a=0j, b=30 + 0j, role=Role.LINK),))
        assert sum(isinstance(i, TextBox) for i in draw_figure(figure).items) == count


def test_a_title_too_long_for_its_figure_takes_two_lines_and_nothing_overlaps_it() -> None:
    long = Words(
        "构件 2 的受力图（连杆受压，反力切于两摩擦圆，且与构件的相对转向相反）",
        "Free body of link 2: the rod is pressed, the reactions are tangent to both friction circles",
    )
    for lang in EN_ZH:
        figure = replace(ff.slide(), title=long)
        one, two = draw_figure(ff.slide(), lang=lang), draw_figure(figure, lang=lang)
        assert two.extents.width < 110 and two.extents.height > one.extents.height + 4
        under = [i.rect for i in two.items if isinstance(i, TextBox)][-2:]
        assert not under[0].overlaps(under[1])


def test_the_extents_of_marks_count_bodies_circles_and_boxes() -> None:
    def box(mark: Mark) -> tuple[complex, complex]:
        return bounds((mark,))

    assert box(Disc(centre=1 + 1j, radius=5)) == (-4 - 4j, 6 + 6j)
    assert box(FrictionCircle(centre=0j, radius=2)) == (-2 - 2j, 2 + 2j)
    assert box(Outline(points=(0j, 9 + 1j, 3 + 7j))) == (0j, 9 + 7j)
    assert box(Cell(at=10j, width=20, height=8, words=Words.same("1"))) == (-10 + 6j, 10 + 14j)


# -- sheets ----------------------------------------------------------------------------------------------------------


def placed(made: tuple[Sheet, ...]) -> list[tuple[int, View, str, Rect]]:
    """Every figure: its page, view, name and extents."""
    return [(n, p.view, p.name, p.extents) for n, sheet in enumerate(made) for p in sheet.figures]


def test_a_force_polygon_stands_beside_the_free_body_of_its_name() -> None:
    where = placed(sheets(ff.slider_crank()))
    for name in ("1", "2", "3"):
        (page_b, *_, body), (page_f, *_, polygon) = (w for w in where if w[2] == name)
        assert page_b == page_f and body.x1 < polygon.x0 and abs(body.y0 - polygon.y0) < 1e-6


def test_eight_figures_take_two_pages_kinematics_before_forces() -> None:
    made = sheets(ff.slider_crank())
    assert [[p.view for p in s.figures] for s in made] == [[View.MECHANISM, View.VELOCITY], [View.BODY, View.FORCE] * 3]


def test_shelves_of_as_many_figures_stand_in_columns() -> None:
    pairs = [boxed(v, str(i), 60 + 5 * i, 50) for i in range(3) for v in (View.BODY, View.FORCE)]
    boxes = [p.extents for p in sheets(record(*pairs))[0].figures]
    for column in (boxes[::2], boxes[1::2]):
        assert len({round(b.centre.real, 3) for b in column}) == 1


def test_eight_figures_are_placed_each_once() -> None:
    drawn = tuple(Drawn(f.view, f.name, draw_figure(f)) for f in reading_order(ff.slider_crank().figures))
    assert len(drawn) == 8 and tuple(one for figures, _ in paged(drawn) or () for one in figures) == drawn


def test_small_figures_share_a_page() -> None:
    small = tuple(boxed(View.BODY, str(i), 45, 25) for i in range(8))
    assert len(sheets(record(*small))) == 1


def test_three_bodies_and_three_polygons_that_fill_their_room_share_a_page() -> None:
    for count in (2, 3):
        pairs = [boxed(v, str(i), *room(v, count)) for v in (View.BODY, View.FORCE) for i in range(count)]
        assert len(sheets(record(*pairs))) == 1


@pytest.mark.parametrize("view", list(views()))
@pytest.mark.parametrize("count", [1, 2, 3, 6])
def test_the_room_of_every_figure_lies_within_the_page(view: View, count: int) -> None:
    assert room(view, count)[0] < usable()[0] and 50 < room(view, count)[1] < usable()[1]


def test_no_page_of_several_holds_one_small_drawing_alone() -> None:
    def pages(*wanted: tuple[float, float]) -> list[int]:
        drawn = tuple(Drawn(View.BODY, str(i), Scene((), Rect(0, 0, *size))) for i, size in enumerate(wanted))
        return [len(page) for page, _ in paged(drawn) or []]

    assert pages((170, 120), (170, 110), (60, 30), (170, 230)) == [1, 2, 1]
    assert pages((170, 120), (170, 110), (60, 30)) == [1, 2]  # the last page neither


sizes = st.tuples(st.floats(20, 150), st.floats(15, 110))


@settings(max_examples=often(20))
@given(st.lists(sizes, min_size=1, max_size=9))
def test_however_many_figures_all_are_placed_in_order_inside_the_frame_and_apart(
    wanted: list[tuple[float, float]],
) -> None:
    views = [View.MECHANISM, *(View.BODY, View.FORCE) * 4]
    drawn = tuple(
        Drawn(v, str(i // 2), Scene((), Rect(0, 0, *size)))
        for i, (v, size) in enumerate(zip(views, wanted, strict=False), start=1)
    )
    pages = paged(drawn)
    assert pages is not None and [one for page, _ in pages for one in page] == list(drawn)
    for page, layout in pages:
        boxes = [
            Rect(c.real, c.imag, c.real + one.size[0], c.imag + one.size[1])
            for one, c in zip(page, layout.corners, strict=True)
        ]
        assert all(
            b.x0 > 2.4 and b.y0 > 2.4 and b.x1 < layout.page[0] - 2.4 and b.y1 < layout.page[1] - 2.4 for b in boxes
        )
        assert not any(a.grown(2.4).overlaps(b) for i, a in enumerate(boxes) for b in boxes[:i])


@settings(max_examples=often(15))
@given(st.lists(sizes, min_size=2, max_size=7))
def test_no_page_could_be_saved_by_breaking_elsewhere(wanted: list[tuple[float, float]]) -> None:
    drawn = tuple(Drawn(View.BODY, str(i), Scene((), Rect(0, 0, *size))) for i, size in enumerate(wanted))
    pages = paged(drawn)
    assert pages is not None

    def fewest(start: int) -> int:
        if start == len(drawn):
            return 0
        return min(
            1 + fewest(end) for end in range(start + 1, len(drawn) + 1) if arranged(drawn[start:end]) is not None
        )

    assert len(pages) == fewest(0)


def record(*figures: Figure) -> Construction:
    """A construction of these figures."""
    return Construction(problem="4-3", hand="drafting", figures=figures, steps=(), readings={})


def boxed(view: View, name: str, w: float, h: float) -> Figure:
    """A figure that is a frame of this size."""
    corners = (0j, complex(w, 0), complex(w, h), complex(0, h))
    sides = tuple(Segment(a=a, b=b, role=Role.RESULT) for a, b in zip(corners, corners[1:] + corners[:1], strict=True))
    return Figure(view=view, title=Words("图", "Figure"), scale=ff.MU_L, marks=sides, name=name)


# -- backends --------------------------------------------------------------------------------------------------------


def test_a_force_measured_on_the_page_has_its_length_and_place() -> None:
    made = sheets(ff.slider_crank())
    where = next(p for p in made[1].figures if p.view is View.FORCE and p.name == "3")
    with pdfplumber.open(BytesIO(to_pdf(made[1].scene))) as pdf:
        page = pdf.pages[0]
        tips = [complex(x, page.height - y) / MM for curve in page.curves for x, y in curve["pts"][:1]]
    for mark in ff.tight_polygon().marks:
        if isinstance(mark, Vector):
            assert min(abs(tip - (mark.b + where.origin)) for tip in tips) < 0.01


@pytest.mark.parametrize("name", few(list(ff.SINGLE), 4))
def test_every_backend_draws_the_marks_of_forces(name: str) -> None:
    from vecpoly.drawing.backends.mpl import to_mpl

    scene = draw_figure(ff.SINGLE[name]())
    strokes = sum(isinstance(i, Stroke) for i in scene.items)
    assert to_svg(scene).count("<path") >= strokes
    assert to_png(scene, 60)[:4] == b"\x89PNG" and to_pdf(scene)[:4] == b"%PDF"
    (axes,) = to_mpl(scene).axes
    assert len(axes.lines) == strokes and len(axes.patches) >= sum(isinstance(i, Fill) for i in scene.items)


@pytest.mark.parametrize("away", [9.0, 14.5, 40.0, 300.0])
def test_an_arrow_farther_out_comes_near_its_point_and_never_beyond_it(away: float) -> None:
    at, out = 3 + 2j, 0.6 + 0.8j
    arrow = Arrow(start=at + away * out, end=at + (away + 20) * out, symbol="F", far=True)
    near = _closer(arrow, at, [], np.array([at - 50 * out]))
    stands = ((near.start - at) / out).real
    assert LEAST_AWAY - 1e-9 <= stands <= min(away, LEAST_AWAY + 1.0) + 1e-9
    assert near.end - near.start == pytest.approx(arrow.end - arrow.start)
