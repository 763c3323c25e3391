"""What a plot says beside its curves: peaks in numbers, what it shows, which vector is which."""

from __future__ import annotations

import re
from functools import cache

import numpy as np
import pytest
from matplotlib.axes import Axes

from tests.studies import studied
from vecpoly.curves import curves, given_values, hodograph, trace
from vecpoly.curves.flat import plane
from vecpoly.curves.peaks import SIZE, exact, extremes, figures, told
from vecpoly.curves.place import Placer
from vecpoly.cycle import Cycle, Extremes, Spot, cycle
from vecpoly.figures.hue import TONES, Hue
from vecpoly.problem.load import load
from vecpoly.report.course.results.plots import inks
from vecpoly.typeset import layout_words
from vecpoly.words import Words

TOLD = re.compile(r"(−?[\d.]+) \((−?[\d.]+)°\)")


@cache
def turned(name: str) -> Cycle:
    return cycle(load(name))


@pytest.mark.parametrize("key", ["M_r", "R_12"])
def test_a_curve_that_runs_away_towards_locking_leaves_its_frame_and_is_seen_elsewhere(key: str) -> None:
    turn = turned("4-6")
    low, high = curves(turn, (key,)).figure.axes[0].get_ylim()
    sizes = np.abs(turn.column(key))
    assert np.nanmax(sizes) > 5 * (high - low)
    assert np.nanpercentile(sizes, 75) > (high - low) / 20
    assert np.nanpercentile(turn.real(key if key == "M_r" else f"{key}.abs"), (10, 90)) == pytest.approx(
        np.clip(np.nanpercentile(turn.real(key if key == "M_r" else f"{key}.abs"), (10, 90)), low, high)
    )


def numbers(text: str) -> float:
    return float(text.replace("−", "-"))


@pytest.mark.parametrize(
    ("name", "key"), [("A-27", "alpha_5"), ("A-27", "omega_4"), ("3-9", "alpha_2"), ("3-9", "v_E")]
)
def test_the_greatest_and_the_least_are_told_with_their_places(name: str, key: str) -> None:
    it = studied(name)
    plot = curves(it.turn, (key,))
    told = {found.groups() for text in plot.figure.axes[0].texts if (found := TOLD.fullmatch(text.get_text()))}
    exact, factor = it.extremes(key), it.whole.info(key).factor
    assert len(told) == 2 and exact.highest is not None and exact.lowest is not None
    for spot in (exact.highest, exact.lowest):
        assert any(
            numbers(value) == pytest.approx(factor * spot.value, rel=6e-3)
            and abs((numbers(place) - np.degrees(it.reduced(spot.phi)) + 180) % 360 - 180) < 0.6
            for value, place in told
        )


def _seen(at: Axes) -> tuple[set[tuple[float, ...]], set[tuple[float, ...]]]:
    """The inks of the dots, and of the numbers."""
    dots = {tuple(line.get_markeredgecolor()) for line in at.get_lines() if line.get_marker() == "o"}
    return dots, {tuple(text.get_color()) for text in at.texts if TOLD.fullmatch(text.get_text())}


@pytest.mark.parametrize(
    ("name", "keys"),
    [("A-27-c", ("omega_2", "omega_3", "omega_5")), ("A-27-c", ("alpha_2", "alpha_3", "alpha_5")), ("3-9", ("v_E",))],
)
def test_every_dot_has_its_number_in_the_ink_of_its_curve(name: str, keys: tuple[str, ...]) -> None:
    it = studied(name)
    at = curves(it.turn, keys, known=it.extremes).figure.axes[0]
    dots, numbers_ = _seen(at)
    assert dots and dots == numbers_
    count = sum(np.size(line.get_xdata()) for line in at.get_lines() if line.get_marker() == "o")
    assert count == sum(text.get_text().count("°") for text in at.texts if re.search(r"\(−?\d", text.get_text()))


def test_the_highest_point_of_a_diagram_has_its_number() -> None:
    it = studied("A-27-c")
    at = curves(it.turn, ("omega_2", "omega_3", "omega_5"), known=it.extremes).figure.axes[0]
    assert any(text.get_text().startswith("24.15 (96.6°") for text in at.texts)


def test_equal_extremes_that_are_nought_but_for_rounding_are_told_together() -> None:
    """J_e vanishes at both ends of the stroke: the diagram named one of them and the text the other."""
    it = studied("six-bar-dynamic")
    at = curves(it.turn, ("J_e",), known=it.extremes).figure.axes[0]
    assert "0 (196.8°, 343.2°)" in {text.get_text() for text in at.texts}


def test_a_bare_plot_tells_none() -> None:
    plot = curves(turned("3-9"), ("alpha_2",), marks=False)
    assert not any(TOLD.fullmatch(text.get_text()) for text in plot.figure.axes[0].texts)


def test_the_higher_and_the_lower_of_many_spots_are_chosen_and_one_alone_is_high() -> None:
    spots = [(10.0, 1.0), (80.0, 5.0), (200.0, -3.0), (300.0, 4.0)]
    assert extremes(spots) == [([(80.0, 5.0)], 1), ([(200.0, -3.0)], -1)]
    assert extremes([(10.0, 1.0)]) == [([(10.0, 1.0)], 1)] and extremes([]) == []


def test_peaks_that_are_equally_high_are_told_by_both_their_places() -> None:
    drive = turned("3-9").drive
    ((high, _), _) = extremes([(218.6, 1.045), (90.0, -2.062), (321.4, 1.045)])
    assert told(high, drive) == "1.045 (218.6°, 321.4°)"
    assert told([(0.0, 68.0), (180.0, 68.0), (360.0, 68.0)], drive) == "68.00 (0°, 180°)"
    assert told([(0.0, 1.0), (120.0, 1.0), (240.0, 1.0)], drive) == "1.000 (0°)", "of many the first"
    assert told([(343.98, 1.0)], drive) == "1.000 (344.0°)", "as the table has it, which is rounded there"


def test_numbers_at_peaks_have_four_figures_as_the_tables_have() -> None:
    values = (0.0, 44.168, -736.04, 0.95871, 12345.0, 4.0)
    assert [figures(value) for value in values] == ["0", "44.17", "−736.0", "0.9587", "12345", "4.000"]


def test_a_text_that_would_cover_curves_or_stand_beyond_one_is_left_out() -> None:
    def placed(lines: list[np.ndarray], most: float) -> int:
        _, at = plane(0j, 100 + 100j, 120.0, 120.0, ("x", "y"))
        placer = Placer(at, lines)
        placer.put(50 + 50j, "12.3 (45.6°)", 1j, 3.0, most=most)
        return len(placer.boxes)

    grid = [np.array([complex(0, y), complex(100, y)]) for y in np.arange(0.0, 100.0, 1.5)]
    ring = [50 + 50j + 2.0 * np.exp(1j * np.linspace(0, 2 * np.pi, 60))]
    assert placed([], 6.0) == 1
    assert placed(grid, 6.0) == 0 and placed(grid, float("inf")) == 1
    assert placed(ring, 6.0) == 0 and placed(ring, float("inf")) == 1


def test_a_vector_keeps_its_ink_and_its_parts_are_black_and_differ_by_dashes() -> None:
    it = studied("3-9")
    found = inks(it, ["v_E", "v_E.x", "v_E.y"])
    assert set(found) == {"v_E"} and found["v_E"] in TONES
    axes = curves(it.turn, ("v_E", "v_E.x", "v_E.y"), inks=found).figure.axes[0]
    lines = [line for line in axes.get_lines() if np.size(line.get_xdata()) > 80]
    assert [tuple(line.get_color()) for line in lines] == [found["v_E"].value, Hue.BLACK.value, Hue.BLACK.value]
    assert len({str(vars(line)["_dash_pattern"]) for line in lines}) == 3
    assert inks(it, ["omega_2", "alpha_2"]) == {}
    way = hodograph(it.turn, "v_E", ink=found["v_E"]).figure.axes[0]
    assert any(
        tuple(line.get_color()) == found["v_E"].value for line in way.get_lines() if np.size(line.get_xdata()) > 80
    )


def test_what_changes_its_sign_is_seen_against_a_line_of_zero() -> None:
    turn, x = turned("3-9"), np.linspace(0.0, 360.0, 91)
    for values, lines in ((np.sin(np.radians(x)), 1), (2 + np.sin(np.radians(x)), 0)):
        at = given_values(turn, x, values, ("E", "J"), Words.same("E")).figure.axes[0]
        level = [line for line in at.get_lines() if np.size(line.get_ydata()) == 2 and not np.any(line.get_ydata())]
        assert len(level) == lines and all(tuple(line.get_color()) == Hue.GREY.value for line in level)


@pytest.mark.parametrize(
    ("keys", "zh", "en"),
    [
        (
            ("alpha_2",),
            "构件 2 的角加速度 $α_{2}$ 随 $φ_{1}$ 的变化曲线",
            "Angular acceleration of link 2 ($α_{2}$) versus",
        ),
        (("v_E", "v_E.x"), "$E$ 点的速度及其分量 $v_{E}$、$v_{Ex}$ 随", "Velocity and components of $E$ ($v_{E}$"),
        (("omega_1", "omega_2"), "构件的角速度 $ω_{1}$、$ω_{2}$ 随", "Angular velocities of the links ($ω_{1}$"),
        (("p_E.x", "p_E.y"), "$E$ 点的坐标", "Coordinates of $E$"),
        (("p_E.y",), "点 $E$ 的坐标 $y_{E}$ 随 $φ_{1}$", "Coordinate $y_{E}$ of point $E$ versus"),
    ],
)
def test_a_caption_says_what_is_shown(keys: tuple[str, ...], zh: str, en: str) -> None:
    title = curves(turned("3-9"), keys).title
    assert title.zh.startswith(zh) and title.en.startswith(en), title


@pytest.mark.parametrize(("width", "step"), [(150.0, 30.0), (83.0, 60.0)])
def test_a_whole_turn_is_parted_into_round_steps_whose_numbers_have_room(width: float, step: float) -> None:
    at = curves(turned("3-9"), ("omega_2",), width=width).figure.axes[0]
    ticks = [tick for tick in at.get_xticks() if 0 <= tick <= 360]
    assert np.allclose(np.diff(ticks), step) and ticks[0] == 0 and ticks[-1] == 360


def test_the_number_of_a_point_is_a_subscript_in_captions() -> None:
    turn = turned("engine-card")
    for title in (trace(turn, ("S2",)).title, curves(turn, ("v_S2", "v_S2.x")).title):
        assert "S_2" in title.zh and "S_2" in title.en and "$S2$" not in title.zh + title.en, title


def test_a_value_that_is_rounding_beside_the_greatest_is_labelled_nought() -> None:
    """A transmission angle of an antiparallelogram was 0.0000000000004862°."""
    turn = turned("3-9")
    low, high = Spot(0.0, 8e-15), Spot(3.0, 1.5)
    known = Extremes("omega_2", (high,), (low,), (), high, low)
    shown = exact([(0.0, 4.9e-13)], known, turn.drive, turn.info("omega_2"), 1.0)
    assert shown == [(0.0, 0.0)] and told(shown, turn.drive) == "0 (0°)"


@pytest.mark.parametrize("name", ["curv-3", "balance-four-bar"])
def test_the_name_of_the_usual_bound_stands_on_no_curve(name: str) -> None:
    it = studied(name)
    at = curves(it.turn, ("gamma_23",), known=it.extremes).figure.axes[0]
    (text,) = (one for one in at.texts if one.get_text().startswith("[$γ$]"))
    box = layout_words(text.get_text(), SIZE)
    right, low = at.transData.transform(text.get_position())
    curve = max(at.get_lines(), key=lambda line: np.size(line.get_xdata()))
    x, y = at.transData.transform(curve.get_xydata()).T
    assert not np.any((x > right - box.width) & (x < right) & (y > low) & (y < low + box.ascent))


def test_the_letters_of_a_bar_in_a_caption_are_symbols() -> None:
    told = turned("3-12").info("phi_2").words
    assert "（$BC$ 的方向）" in told.zh and "(direction $BC$)" in told.en
