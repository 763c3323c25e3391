"""Claims about sizes in the player: scales, panes, letters, the places of the drive, all from figures of known size."""

from __future__ import annotations

from itertools import pairwise
from math import pi

import pytest

from tests.texts import CRANK
from vecpoly.board.construction import Figure, Scale, View
from vecpoly.board.paper.marks import Role, Segment
from vecpoly.drawing.scene import Rect, Scene
from vecpoly.drawing.style import LETTER
from vecpoly.player.figures import LANGS, box, caption, key_of
from vecpoly.player.fitting import SIDE, coarsened, fitted
from vecpoly.player.panes import AROUND, BESIDE, FAR, magnified, pane
from vecpoly.player.setting.ink import Ink, path
from vecpoly.player.turned import Cycle, cycle
from vecpoly.problem.load import load
from vecpoly.problem.load import loads as load_text
from vecpoly.solution import scales_of, solve
from vecpoly.words import Words


def turned(text: str, count: int) -> Cycle:
    return cycle(solve(load_text(text), by="exact", repeats=0), count)


def figure(
    *,
    view: View = View.MECHANISM,
    links: tuple[complex, complex] = (0j, 100 + 60j),
    lines: tuple[complex, complex] | None = None,
) -> Figure:
    """A link between two points, and a ruled line that may run far beyond it."""
    marks = [Segment(a=links[0], b=links[1], role=Role.LINK)] + (
        [Segment(a=lines[0], b=lines[1], role=Role.CONSTRUCTION)] if lines else []
    )
    return Figure(view=view, title=Words.same("t"), scale=Scale(symbol="μ", value=0.001, unit="m"), marks=tuple(marks))


def taken(one: Figure) -> Rect:
    ends = [z for mark in one.marks if isinstance(mark, Segment) for z in (mark.a, mark.b)]
    return Rect(
        min(z.real for z in ends), min(z.imag for z in ends), max(z.real for z in ends), max(z.imag for z in ends)
    )


def test_polygons_that_fit_keep_the_given_scale_and_those_that_do_not_take_the_next_round_one() -> None:
    small = [{"": Rect(0, 0, 100, 50)}] * 10
    assert coarsened(small, small[0], 0.003) == [0.003] * 10
    large = [{"": Rect(0, 0, 2 * SIDE, 50)}] * 10
    assert coarsened(large, small[0], 0.003) == pytest.approx([0.006] * 10)
    assert coarsened([*small, {"": Rect(0, 0, 3.5 * SIDE, 50)}], small[0], 0.002) == pytest.approx(
        [0.002] * 10 + [0.01]
    )
    assert coarsened([*small, {"": Rect(0, 0, 90 * SIDE, 50)}], small[0], 0.002) == pytest.approx([0.002] * 10 + [0.2])


def test_a_pane_may_be_a_third_larger_than_the_given_polygon() -> None:
    own = {"": Rect(0, 0, 200, 10)}
    assert coarsened([own] * 9 + [{"": Rect(0, 0, 259, 10)}], own, 0.002) == [0.002] * 10
    assert coarsened([own] * 9 + [{"": Rect(0, 0, 265, 10)}], own, 0.002) == [0.002] * 9 + [pytest.approx(0.005)]


def test_polygons_that_fit_singly_must_fit_their_common_pane_as_well() -> None:
    left, right = {"": Rect(-100, 0, 0, 10)}, {"": Rect(0, 0, 100, 10)}
    assert coarsened([left, right] * 5, left, 1.0) == pytest.approx([2.0] * 10)
    apart = [{"a": Rect(-100, 0, 0, 10)}, {"b": Rect(0, 0, 100, 10)}] * 5
    assert coarsened(apart, apart[0], 1.0) == [1.0] * 10


def test_the_scales_of_a_drawing_are_those_of_its_figures() -> None:
    construction = solve(load("3-9"), by="exact", repeats=0).construction
    scales = scales_of(construction)
    by_view = {figure.view: figure.scale.value for figure in construction.figures}
    assert scales.given == {
        "mu_l": by_view[View.MECHANISM],
        "mu_v": by_view[View.VELOCITY],
        "mu_a": by_view[View.ACCELERATION],
    }
    assert fitted([construction], 0) == [scales] and fitted([], 0) == []


def test_the_pane_of_a_polygon_holds_all_its_places_up_to_twice_a_side_beyond_it() -> None:
    given, far = figure(view=View.VELOCITY), figure(view=View.VELOCITY, links=(-1000 + 0j, 130 + 60j))
    assert pane(taken(given), [taken(given), Rect(-20, -5, 110, 70)], [given]) == Rect(-20, -5, 110, 70)
    assert pane(taken(given), [taken(given), taken(far)], [given, None, far]) == Rect(-2 * SIDE, 0, 130, 60)


def test_the_pane_of_a_mechanism_holds_its_links_at_every_place_and_room_beside_them() -> None:
    places = [figure(links=(0j, end)) for end in (100 + 60j, -40 + 60j, 100 - 50j)]
    seen = [taken(one).grown(AROUND) for one in places]
    assert pane(taken(places[0]), seen, places) == Rect(-40 - AROUND, -50 - AROUND, 100 + AROUND, 60 + AROUND)
    wide = [taken(one).grown(3 * BESIDE) for one in places]
    room, links = pane(taken(places[0]), wide, places), Rect(-40, -50, 100, 60)
    assert room | links.grown(BESIDE) == room, "letters, arrows and guides have room beside the links"
    assert room | links.grown(BESIDE + FAR * 140) == links.grown(BESIDE + FAR * 140), "and constructions little more"


def test_a_line_that_runs_far_at_a_few_places_only_leaves_the_pane_of_a_mechanism() -> None:
    near, far = figure(), figure(lines=(0j, 900 + 0j))
    seldom = pane(taken(near), [taken(near)] * 19 + [taken(far)], [near] * 19 + [far])
    often = pane(taken(near), [taken(near)] * 10 + [taken(far)] * 10, [near] * 10 + [far] * 10)
    assert seldom == Rect(0, 0, 100 + BESIDE, 60) and often == Rect(0, 0, 100 + BESIDE + FAR * 100, 60)


def test_links_that_run_away_towards_a_dead_point_are_let_out_of_the_pane() -> None:
    near, away = figure(), figure(links=(0j, 900 + 0j))
    assert pane(taken(near), [taken(near)] * 19 + [taken(away)], [near] * 19 + [away]) == Rect(0, 0, 100 + BESIDE, 60)


def test_letters_grow_with_the_room_of_all_figures_but_neither_shrink_nor_grow_without_end() -> None:
    assert (
        magnified([[figure(links=(0j, 10 + 10j))]], 0) == 1.0
        and magnified([[figure(links=(0j, 900 + 900j))]], 0) == 1.6
    )
    for side in (180.0, 200.0):
        one = magnified([[figure(links=(0j, complex(side, side)))]], 0)
        assert one == pytest.approx(0.022 * (side + 2 * AROUND) / LETTER) and 1.0 < one < 1.6
    two = magnified([[figure(links=(0j, 130 + 130j))]] * 2, 0)
    assert two == pytest.approx(0.022 * 2**0.5 * (130 + 2 * AROUND) / LETTER)
    assert magnified([[None]], 0) == 1.0


def test_a_box_is_told_in_hundredths_of_a_millimetre_from_its_upper_left_corner() -> None:
    assert box(Rect(-1.0, 2.0, 3.5, 10.25)) == (-100, -1025, 450, 825)


def test_a_title_stands_in_the_middle_under_its_figure_and_grows_from_there() -> None:
    over, one = Rect(0, 0, 100, 60), solve(load("3-9"), by="exact", repeats=0).construction.figures[0]
    (small, low), (large, lower) = (caption(one, Ink(), over, size) for size in (1.0, 2.0))
    assert small.startswith('<g transform="matrix(1 0 0 1 0 0)">') and large.startswith(
        '<g transform="matrix(2 0 0 2 -5000 0)">'
    )
    assert (low.x0, low.x1, low.y1) == (0, 100, 60) and low.y0 < 0 and lower.y0 == pytest.approx(2 * low.y0)
    assert [small.count(f'<g class="{lang}">') for lang in LANGS] == [1, 1] and small.count('<g class="mu">') == 2
    assert key_of(one) == one.view.name and Scene.of(()).items == ()


@pytest.mark.parametrize(
    ("sense", "shown"), [("ccw", ["50°", "140°", "230°", "320°"]), ("cw", ["50°", "320°", "230°", "140°"])]
)
def test_a_crank_is_turned_in_its_own_sense_from_where_it_stands(sense: str, shown: list[str]) -> None:
    through = turned(CRANK.replace("ccw", sense), 4)
    assert [turn.shown for turn in through.turns] == shown and (through.start, through.whole, through.round) == (
        0,
        True,
        True,
    )
    angles = [turn.solution.problem.mechanism.drive.position for turn in through.turns]
    assert [(b - a) / (pi / 2) for a, b in pairwise(angles)] == pytest.approx([1.0 if sense == "ccw" else -1.0] * 3)


@pytest.mark.parametrize("velocity", ["0.2 m/s", "-0.2 m/s"])
def test_a_slide_is_moved_from_one_end_of_its_travel_to_the_other(velocity: str) -> None:
    text = (
        CRANK.replace("link: 1, phi: 50 deg, omega: 10 rad/s ccw", f"link: 3, s: 110 mm, v: {velocity}")
        .replace("C right of A", "B above AC")
        .replace("v_C", "v_B")
    )
    through = turned(text, 9)
    places = [turn.solution.problem.mechanism.drive.position for turn in through.turns]
    assert places == sorted(places, reverse=velocity.startswith("-")) and not through.whole and not through.round
    assert places[through.start] == pytest.approx(0.11) and through.turns[through.start].shown == "110 mm"
    assert 0.07 <= min(places) < 0.08 and 0.12 < max(places) <= 0.13, "the block goes from BC - AB to BC + AB"


def test_one_place_alone_is_no_cycle() -> None:
    assert turned(CRANK, 1) == Cycle(())


def test_an_arc_is_written_with_its_sense_and_whether_it_is_the_long_way_round() -> None:
    from cmath import exp

    def arc(start: float, sweep: float) -> str:
        return path(tuple(10 * exp(1j * (start + sweep * k / 40)) for k in range(41)), False)

    assert arc(0, pi / 2) == "M1000 0A1000 1000 0 0 0 0-1000" and arc(0, -pi / 2) == "M1000 0A1000 1000 0 0 1 0 1000"
    assert arc(0, 1.5 * pi) == "M1000 0A1000 1000 0 1 0 0 1000" and "A" not in path(
        tuple(complex(k, k * k) for k in range(20)), False
    )
    assert "A" not in path(tuple(complex(k, 2 * k) for k in range(20)), False)
