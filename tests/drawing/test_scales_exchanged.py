"""Scales exchanged: a mechanism is not small beside a polygon that helps, what is measured is long enough, and the
sheets are as many as before."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import drawn
from tests.drawn_sheets import laid
from vecpoly.board.acts.inkless import Measure
from vecpoly.board.construction import View
from vecpoly.board.paper.extent import extent
from vecpoly.board.paper.scales import Sketched
from vecpoly.board.place import Place, view_of
from vecpoly.drawing.sheets.packing import Layout
from vecpoly.drawing.sheets.paper import nearest_pins
from vecpoly.drawing.sheets.scales.balancing import GROWS
from vecpoly.drawing.sheets.scales.composition import Composing, Scales
from vecpoly.drawing.sheets.scales.exchanging import LONE, SEEN, SHRUNK, exchanged
from vecpoly.drawing.sheets.scales.holes import hole
from vecpoly.drawing.sheets.slicing import Size
from vecpoly.drawing.sheets.space import room_inside

KINDS = (View.MECHANISM, View.VELOCITY, View.FORCE)
SIDES = st.floats(30.0, 150.0)


class Box:
    """A figure of this size."""

    view, name = View.MECHANISM, ""

    def __init__(self, wide: float, high: float) -> None:
        self.size: Size = (wide, high)


def test_a_hole_is_the_largest_rectangle_that_no_figure_takes() -> None:
    page = (100.0, 200.0)
    assert hole([], Layout(page, (), 0.0)) == 1.0
    assert hole([Box(100.0, 50.0)], Layout(page, (0j,), 0.0)) == pytest.approx(0.75)
    assert hole([Box(100.0, 50.0)], Layout(page, (100j,), 0.0)) == pytest.approx(0.5)
    corner = Layout(page, (0j, 50 + 50j), 0.0)  # beside the one, over the other
    assert hole([Box(50.0, 50.0), Box(50.0, 100.0)], corner) == pytest.approx(0.5 * 0.75)


def _sketched(kind: View, size: Size, short: float = 0.0, arm: float = 0.0) -> Sketched:
    return Sketched(view=kind, of=kind, scale=1.0, size=size, around=(20.0, 25.0), short=short, arm=arm)


def _found(figures: list[Sketched]) -> tuple[list[Composing], Scales, Scales]:
    kinds: set[Place] = {one.of for one in figures if one.of is not None}
    pages = [Composing(figures, kinds, room_inside(across)) for across in (False, True)]
    before: Scales = dict[Place, float](dict.fromkeys(kinds, 1.0))
    return pages, before, exchanged([(page,) for page in pages], before, kinds)


@given(st.lists(st.tuples(SIDES, SIDES), min_size=3, max_size=3))
def test_scales_are_exchanged_for_a_larger_mechanism_alone_on_as_many_sheets_and_nothing_is_made_small(
    sizes: list[Size],
) -> None:
    pages, before, found = _found([_sketched(kind, size) for kind, size in zip(KINDS, sizes, strict=True)])
    if found == before:
        return
    assert min(page.needed(found) for page in pages) <= min(page.needed(before) for page in pages)
    for kind in KINDS:
        old, new = (pages[0].size(kind, scales) for scales in (before, found))
        assert new > GROWS * old if kind is View.MECHANISM else new >= min(SHRUNK * old, SEEN) - 1e-9


@pytest.mark.parametrize(("arm", "larger"), [(5.0, True), (0.0, False)])
def test_a_mechanism_on_which_a_short_arm_is_measured_is_larger_at_the_cost_of_a_polygon(
    arm: float, larger: bool
) -> None:
    figures = [_sketched(View.MECHANISM, (150.0, 75.0), arm=arm), _sketched(View.FORCE, (100.0, 80.0), short=40.0)]
    _, before, found = _found([*figures, _sketched(View.VELOCITY, (75.0, 70.0), short=40.0)])
    assert (found[View.MECHANISM] < before[View.MECHANISM]) is (found[View.FORCE] > before[View.FORCE]) is larger


def test_polygons_of_one_vector_give_their_room_to_the_mechanism() -> None:
    """The rods of a locomotive: a low mechanism, of which the crank is to be seen, and all points with one velocity."""
    construction, (sheet,) = drawn("parallelogram-locomotive"), laid("parallelogram-locomotive")
    figures = {view: construction.figures(view)[0] for view in (View.MECHANISM, View.VELOCITY, View.ACCELERATION)}
    sizes = {view: max(extent(figure.marks)) for view, figure in figures.items()}
    assert sizes[View.MECHANISM] > max(sizes[View.VELOCITY], sizes[View.ACCELERATION]) > LONE
    assert nearest_pins(figures[View.MECHANISM], 1.0) > 30.0 and len(sheet.groups) == 3


@pytest.mark.parametrize("name", ["4-3b", "4-3d", "compound-hinge-six-bar"])
def test_the_arm_of_a_couple_is_long_enough_to_be_measured_and_the_helping_polygon_no_longer_than_the_mechanism(
    name: str,
) -> None:
    construction = drawn(name).construction
    arms = [act.mm for act in construction.acts if isinstance(act, Measure) and act.key == "h"]
    assert arms and min(arms) > 11.0
    sizes = {view: max(extent(drawn(name).figures(view)[0].marks)) for view in (View.MECHANISM, View.VELOCITY)}
    assert sizes[View.VELOCITY] < sizes[View.MECHANISM]
    assert all(view_of(view) in {one.view for one in construction.figures} for view in sizes)
