"""Claims about what is shown elsewhere than on the sheet: notebooks, captions that grow, rooms of figures, titles,
warnings."""

from __future__ import annotations

import re

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import drawn
from vecpoly.board.construction import View
from vecpoly.curves.style import degrees_ticks
from vecpoly.cycle.facts.found import facts
from vecpoly.cycle.whole_cycle import cycle
from vecpoly.drawing.figure import draw_figure
from vecpoly.drawing.scene import Rect, TextBox
from vecpoly.drawing.sheets.space import CAPTION, CLEAR, LETTERING, room, usable
from vecpoly.figures.kind import views
from vecpoly.player.figures import caption
from vecpoly.player.setting.ink import UNIT, Ink
from vecpoly.player.setting.type import Faces, symbol_html
from vecpoly.problem.load import load, loads
from vecpoly.report.flow.formula import lines
from vecpoly.report.titles import subject
from vecpoly.solution import solve
from vecpoly.typeset.box import Glyphs
from vecpoly.typeset.layout import layout

MATRIX = re.compile(r"matrix\((\S+) 0 0 (\S+) (\S+) (\S+)\)")


def test_every_text_of_a_figure_stands_in_its_notebook_picture_at_its_place_and_in_its_colour() -> None:
    from vecpoly.drawing.backends.mpl import to_mpl

    scene = draw_figure(drawn("3-9").figures(View.VELOCITY)[0])
    (axes,) = to_mpl(scene).axes
    runs = [
        (text.x + part.x, text.y + part.y, part.text, text.hue.value)
        for text in scene
        if isinstance(text, TextBox)
        for part in text.box.items
        if isinstance(part, Glyphs)
    ]
    assert len(runs) > 10
    assert [(*text.get_position(), text.get_text(), text.get_color()) for text in axes.texts] == runs


@pytest.mark.parametrize("view", list(views()))
def test_one_or_two_figures_fill_half_a_page_and_three_pairs_a_third_each(view: View) -> None:
    def filled(count: int, rows: int) -> float:
        return rows * (room(view, count)[1] + CAPTION + LETTERING) + (rows - 1) * CLEAR

    assert filled(1, 2) == filled(2, 2) == pytest.approx(usable()[1])
    assert filled(6, 3 if view.paired else 2) == pytest.approx(usable()[1])


@given(st.floats(0.6, 3.0), st.floats(-80, 80), st.floats(10, 60))
def test_a_caption_in_larger_letters_hangs_from_the_same_middle_of_the_figure_s_lower_edge(
    size: float, left: float, width: float
) -> None:
    figure = drawn("3-9").figures(View.VELOCITY)[0]
    over = Rect(left, -12.0, left + width, 25.0)
    markup, _ = caption(figure, Ink(), over, size)
    found = MATRIX.search(markup)
    assert found is not None
    grown, same, right, down = map(float, found.groups())
    assert grown == same == pytest.approx(size, rel=6e-3)
    middle, low = UNIT * over.centre.real, -UNIT * over.y0
    assert size * middle + right == pytest.approx(middle, abs=1) and size * low + down == pytest.approx(low, abs=1)


@pytest.mark.parametrize(
    ("find", "title"),
    [("Q", "力分析"), ("eta, Q", "效率和自锁"), ("eta", "效率和自锁"), ("self_locking", "效率和自锁")],
)
def test_a_sheet_about_efficiency_or_self_locking_says_so_and_one_about_forces_does_not(find: str, title: str) -> None:
    text = re.sub(r"find: \[.*\]", f"find: [{find}]", load("5-5").text)
    assert title in subject([solve(loads(re.sub(r"(?ms)^printed:.*?(?=^\w|\Z)", "", text)), repeats=0)]).zh


@pytest.mark.parametrize("lines", [0, 3])
def test_what_is_hardly_meant_is_told_with_the_line_where_it_stands(lines: int) -> None:
    text = load("3-9").text.replace("frame:", "\n" * lines + "frame:", 1).replace("phi: 45 deg", "phi: 75 rad", 1)
    line = next(i for i, one in enumerate(text.splitlines(), 1) if "75 rad" in one)
    (words,) = loads(text).warnings
    assert f"line {line}," in words.en and f"第 {line} 行" in words.zh


def test_a_transmission_angle_told_to_reach_90_degrees_has_them_where_it_is_told() -> None:
    turn = cycle(load("3-5"), n=73)
    told = [one for one in facts(turn).transmissions if abs(one.greatest.value - np.pi / 2) < 1e-9]
    assert told
    for one in told:
        assert np.asarray(turn.at(one.key, np.array([one.greatest.phi]))) == pytest.approx(np.pi / 2)


@given(st.floats(-720, 720), st.floats(3, 1400))
def test_an_axis_of_degrees_has_round_ticks_from_end_to_end(low: float, span: float) -> None:
    from matplotlib.figure import Figure

    axes = Figure().add_axes((0, 0, 1, 1))
    degrees_ticks(axes, low, low + span)
    ticks = axes.xaxis.get_major_locator()()
    steps = set(np.diff(ticks).round(9))
    assert len(steps) == 1 and len(ticks) <= 14
    (step,) = steps
    assert 360 % step == 0 or step % 360 == 0
    assert low - 1e-6 <= ticks[0] < low + step + 1e-6 and low + span - step - 1e-6 < ticks[-1] <= low + span + 1e-6
    assert all(abs(tick / step - round(tick / step)) < 1e-9 for tick in ticks)


@given(st.floats(45.0, 160.0))
def test_a_formula_set_on_several_lines_keeps_within_the_width(width: float) -> None:
    nodes = [node for step in drawn("3-9").construction.steps for node in step.formulas]
    longest = max(nodes, key=lambda node: layout(node, 3.5).width)
    whole, broken = layout(longest, 3.5).width, lines(longest, 3.5, width)
    assert (len(broken) == 1) is (whole <= width)
    assert all(indent + box.width <= width + 1e-9 for indent, box in broken) and len(broken) <= 1 + 2 * whole / width


def test_a_symbol_of_the_player_is_as_wide_to_its_height_as_what_it_shows() -> None:
    faces = Faces()
    for node in [node for step in drawn("3-9").construction.steps for node in step.formulas][:6]:
        markup = symbol_html(node, faces, "zh")
        view = re.search(r'viewBox="(\S+) (\S+) (\S+) (\S+)"', markup)
        style = re.search(r"height:([\d.]+)em;width:([\d.]+)em;vertical-align:-([\d.]+)em", markup)
        assert view is not None and style is not None
        _, top, wide, high = map(float, view.groups())
        height, width, below = map(float, style.groups())
        assert (wide, high) == pytest.approx((1000 * width, 1000 * height), abs=2)
        assert top + high == pytest.approx(1000 * below, abs=2) and wide > 1000 * layout(node, 1.0).width
