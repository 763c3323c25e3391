"""Claims about plots: where the dots of a curve stand, where letters go,
how wide the paper is, what is drawn of a path."""

from __future__ import annotations

from math import pi

import numpy as np
import pytest

from tests.texts import CRANK
from vecpoly.curves import curves, style
from vecpoly.curves.flat import plane, stations
from vecpoly.curves.place import Placer
from vecpoly.curves.poses import poses
from vecpoly.curves.skeleton import blocks, skeleton
from vecpoly.curves.trace import trace
from vecpoly.curves.turning import turning
from vecpoly.cycle import cycle
from vecpoly.drawing.scene import TextBox
from vecpoly.figures.hue import Hue
from vecpoly.problem.load import load, loads
from vecpoly.report.flow.style import CAPTION

X = np.linspace(0.0, 360.0, 721)


def test_the_dots_of_a_sine_stand_at_its_crest_and_its_trough() -> None:
    crest, trough = sorted(turning(X, 3 + 2 * np.sin(np.radians(X - 10.1)), True))
    assert crest == pytest.approx((100.1, 5.0), abs=1e-4) and trough == pytest.approx((280.1, 1.0), abs=1e-4)


def test_a_crest_at_the_seam_of_a_closed_curve_is_marked_once() -> None:
    found = turning(X, np.cos(np.radians(X)), True)
    assert sorted(round(place) for place, _ in found) == [0, 180] and all(place >= 0.0 for place, _ in found)
    assert [round(place) for place, _ in turning(X, np.cos(np.radians(X)), False)] == [180]


def test_a_small_ripple_about_the_middle_of_a_curve_is_not_marked() -> None:
    wave = np.cos(np.radians(X)) + 0.2 * np.exp(-(((X - 90) / 3) ** 2))
    assert wave[180] > max(wave[160], wave[184]), "a crest near the middle"
    assert sorted(round(place) for place, _ in turning(X, wave, True)) == [0, 180]
    tall = np.sin(np.radians(X)) ** 3 + 0.9 * np.sin(np.radians(3 * X))
    assert len(turning(X, tall, True)) == 4, "its other crests are nearly as far from the middle"


def test_a_jump_is_marked_where_it_is_and_not_between_its_sides() -> None:
    saw = (X % 180.0) / 180.0
    assert all(value in (0.0, pytest.approx(saw.max())) for _, value in turning(X, saw, True)) and turning(X, saw, True)


def test_what_does_not_vary_or_is_not_known_has_no_dots() -> None:
    assert turning(X, np.full(721, 7.0), True) == [] and turning(X, np.full(721, np.nan), True) == []
    assert turning(X, 1e6 + 1e-5 * np.sin(np.radians(X)), True) == []


def drawn_plane() -> tuple[object, Placer]:
    _, at = plane(0j, 100 + 100j, 120.0, 120.0, ("x", "y"))
    return at, Placer(at, [np.array([0j, 100 + 0j])])


def corners(placer: Placer) -> tuple[complex, complex]:
    low, high = placer.boxes[-1]
    return low, high


def test_a_letter_stands_on_the_outer_side_of_its_point() -> None:
    for outward in (1 + 0j, -1 + 0j, 1j, -1j, 1 + 1j):
        _, placer = drawn_plane()
        placer.put(50 + 50j, "$C$", outward, 3.5)
        low, high = corners(placer)
        here = placer.mm(np.array([50 + 50j]))[0]
        middle = (low + high) / 2 - here
        assert (np.conj(outward) * middle).real > 0.9 * abs(outward) * abs(middle)
        assert not (low.real < here.real < high.real and low.imag < here.imag < high.imag) and abs(middle) < 6.0


def test_a_letter_gives_way_to_lines_other_letters_and_the_edge() -> None:
    _, placer = drawn_plane()
    placer.put(50 + 1j, "$C$", -1j, 3.5)
    line = placer.mm(np.array([50 + 0j]))[0].imag
    low, high = corners(placer)
    assert high.imag < line or low.imag > line
    _, placer = drawn_plane()
    placer.put(50 + 50j, "$C$", 1 + 0j, 3.5)
    placer.put(50 + 50j, "$D$", 1 + 0j, 3.5)
    (a, b), (c, d) = placer.boxes
    assert b.real <= c.real or d.real <= a.real or b.imag <= c.imag or d.imag <= a.imag
    _, placer = drawn_plane()
    placer.put(108.9 + 50j, "$C$", 1 + 0j, 3.5)
    assert corners(placer)[1].real <= placer.high.real


def test_a_mark_that_is_kept_clear_is_not_covered() -> None:
    _, placer = drawn_plane()
    placer.keep_clear(np.array([53 + 50j]), 2.0)
    placer.put(50 + 50j, "$C$", 1 + 0j, 3.5)
    low, high = corners(placer)
    mark = placer.mm(np.array([53 + 50j]))[0]
    assert placer.boxes[0] == (mark - (2 + 2j), mark + (2 + 2j))
    assert (
        high.real < mark.real - 2 or low.real > mark.real + 2 or high.imag < mark.imag - 2 or low.imag > mark.imag + 2
    )


def test_a_plane_has_one_measure_in_both_directions_and_fits_its_paper() -> None:
    for high in (100 + 20j, 20 + 100j, 60 + 60j):
        figure, at = plane(0j, high, 120.0, 90.0, ("x", "y"))
        (x0, x1), (y0, y1) = at.get_xlim(), at.get_ylim()
        wide, tall = np.abs(at.transAxes.transform((1, 1)) - at.transAxes.transform((0, 0)))
        assert wide / (x1 - x0) == pytest.approx(tall / (y1 - y0), rel=1e-6)
        assert x0 < 0 < high.real < x1 and y0 < 0 < high.imag < y1
        assert x0 == pytest.approx(-0.09 * max(high.real, high.imag)) == pytest.approx(y0)
        assert wide < 120.0 and tall < 90.0 and (wide > 95.0 or tall > 65.0)
        marks = np.diff(at.xaxis.get_major_locator().tick_values(x0, x1))
        assert (
            marks * wide / (x1 - x0) == pytest.approx(marks[0] * wide / (x1 - x0))
            and 10.0 - 1e-9 <= marks[0] * wide / (x1 - x0) <= 25.1
        )
        assert f"{marks[0]:e}"[0] in "125" and figure is not None


def test_stations_stand_every_thirty_degrees_of_a_turn_and_inside_a_range() -> None:
    phi, places = stations(cycle(loads(CRANK)), "p_B")
    assert np.degrees(phi) == pytest.approx(np.arange(0, 360, 30)) and places == pytest.approx(0.03 * np.exp(1j * phi))
    slid = cycle(
        loads(
            CRANK.replace("link: 1, phi: 50 deg, omega: 10 rad/s ccw", "link: 3, s: 110 mm, v: 0.1 m/s").replace(
                "C right of A", "B above AC"
            )
        )
    )
    q, _ = stations(slid, "p_C")
    assert (
        len(q) == 11
        and q[0] == pytest.approx(slid.low + (slid.high - slid.low) / 12)
        and np.diff(q) == pytest.approx(np.diff(q)[0])
    )


def test_the_skeleton_has_every_link_in_millimetres_and_a_plate_closed() -> None:
    lines = skeleton(cycle(loads(CRANK)), np.radians([0.0, 90.0]))
    assert [line.shape for line in lines] == [(2, 2), (2, 2)]
    assert lines[0] == pytest.approx(np.array([[0, 0], [30, 30j]])) and np.abs(
        lines[1][1] - lines[1][0]
    ) == pytest.approx([100, 100])
    plate = skeleton(cycle(load("3-9")), np.array([0.5]))
    assert all(len(line) == 2 or (line[0] == line[-1]).all() for line in plate)


def test_a_path_that_is_run_to_and_fro_is_drawn_once() -> None:
    figure = trace(cycle(loads(CRANK)), ("C", "B")).figure
    lines = [line for axes in figure.axes for line in axes.lines]
    paths = [np.asarray(line.get_xydata()) for line in lines if len(np.asarray(line.get_xydata())) > 100]
    straight, round_ = sorted(paths, key=lambda path: np.ptp(path[:, 1]))
    assert np.ptp(straight[:, 1]) < 1e-6 and np.abs(np.diff(straight[:, 0])).sum() == pytest.approx(
        60.0, abs=1e-3
    ) == np.ptp(straight[:, 0])
    assert np.hypot(*round_.T) == pytest.approx(np.full(len(round_), 30.0))


def test_four_positions_of_the_mechanism_are_drawn_in_inks_of_their_own_and_the_given_one_thick_and_black() -> None:
    plot = poses(cycle(loads(CRANK)), "C")
    lines = [np.asarray(line.get_xydata()) for axes in plot.figure.axes for line in axes.lines]
    cranks = {
        tuple(np.round(line[1], 6))
        for line in lines
        if len(line) == 2 and np.allclose(line[0], 0) and abs(np.hypot(*line[1]) - 30) < 1e-6
    }
    assert {round(np.degrees(np.arctan2(y, x))) % 360 for x, y in cranks} == {0, 90, 180, 270, 50}
    every = [line for axes in plot.figure.axes for line in axes.lines if line.get_marker() == "None"]
    drawn = [(float(line.get_linewidth()), line.get_color()) for line in every]
    assert max(drawn)[1] == Hue.BLACK.value and len({colour for _, colour in drawn}) == 5
    told = [text for axes in plot.figure.axes for text in axes.texts if text.get_text().endswith("°")]
    assert [text.get_text() for text in told] == ["0°", "90°", "180°", "270°"]
    assert len({text.get_color() for text in told}) == 4
    texts = [item for item in plot.scene.items if isinstance(item, TextBox)]
    assert len(texts) >= 3 + 2 and plot.width <= 150.5 and plot.height <= 105.5
    assert style.number(2 * pi) and plot.width > 60.0


def test_where_a_curve_is_cut_at_its_axes_no_dot_stands_beyond_them() -> None:
    at = style.axes(style.sheet(100.0, 60.0), 15.0, 15.0, 70.0, 35.0)
    at.set_xlim(0.0, 360.0)
    at.set_ylim(-2.0, 2.0)
    style.dots(at, [0.0, 90.0, 180.0, 360.0, 361.0], [2.0, 1e6, -2.0 - 1e-9, 0.5, 0.0], style.PENS[0].hue)
    assert [line.get_xdata().tolist() for line in at.lines] == [[0.0, 180.0, 360.0]]


def test_graphs_under_each_other_have_one_left_edge() -> None:
    turn = cycle(load("3-5").mechanism)
    lefts = [curves(turn, (key,), "zh").figure.axes[0].get_position().x0 for key in ("phi_3", "omega_3", "alpha_3")]
    assert max(lefts) - min(lefts) < 1e-9


def test_a_block_is_drawn_on_its_pivot_and_an_offset_rod_beside_its_pin() -> None:
    turn = cycle(load("swinging-block-offset-rod"))
    phi = np.array([turn.mech.drive.position])
    (block,) = blocks(turn, float(phi[0]))
    assert block.at == pytest.approx(100.0)
    rod = next(line[:, 0] for line in skeleton(turn, phi) if len(line) == 3)
    assert abs(rod[1] - rod[0]) == pytest.approx(20.0)
    assert abs(((rod[2] - rod[1]) * np.conj(rod[1] - rod[0])).real) < 1e-6 and rod[2] == pytest.approx(100.0)
    assert abs((block.along * np.conj(rod[2] - rod[1])).imag) < 1e-9


def test_the_title_of_an_axis_is_no_larger_than_a_caption() -> None:
    assert style.TICK <= style.LABEL <= CAPTION.em
