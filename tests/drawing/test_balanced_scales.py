"""A mechanism and its polygons of motion on one sheet: more than half of the width for the mechanism, no figure small
beside another, and no sheet more."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.drawn_library import drawn
from tests.drawn_sheets import laid
from tests.laws import few
from vecpoly.board.construction import View
from vecpoly.board.paper.extent import extent
from vecpoly.board.paper.scales import Sketched
from vecpoly.board.place import Place, view_of
from vecpoly.drawing.sheets.scales.balancing import EVEN, GROWS, balanced
from vecpoly.drawing.sheets.scales.composition import KNOT, Composing, Scales
from vecpoly.drawing.sheets.space import room_inside

SMALL_BEFORE = [
    "cam-roller",
    "3-10",
    "swinging-block-offset-rod",
    "3-7d",
    "whitworth-quick-return",
    "crank-rack-pinion",
]
KINDS = (View.MECHANISM, View.VELOCITY, View.ACCELERATION)
SIDES = st.floats(30.0, 150.0)
LITTLE = 1.06  # what rounding of scales and letters may add


def longest(name: str, view: View) -> float:
    return max(extent(drawn(name).figures(view)[0].marks))


@pytest.mark.parametrize("name", few(SMALL_BEFORE, 2))
def test_a_mechanism_beside_its_polygons_has_more_than_half_of_the_width_and_none_is_small_beside_it(name: str) -> None:
    assert len(laid(name)) == 1
    mechanism = longest(name, View.MECHANISM)
    assert mechanism > 0.5 * room_inside()[0]
    for view in KINDS[1:]:
        assert mechanism / (EVEN * LITTLE * 1.2) <= longest(name, view) <= EVEN * LITTLE * mechanism


@given(st.lists(st.tuples(SIDES, SIDES), min_size=3, max_size=3))
def test_balanced_figures_need_no_further_sheet_and_the_mechanism_or_the_smallest_is_larger(
    sizes: list[tuple[float, float]],
) -> None:
    figures = [
        Sketched(view=kind, of=kind, scale=1.0, size=size, around=(20.0, 25.0))
        for kind, size in zip(KINDS, sizes, strict=True)
    ]
    pages = [Composing(figures, set(KINDS), room_inside(across)) for across in (False, True)]
    best: Scales = dict.fromkeys(KINDS, 1.0)
    found = balanced(pages, best)
    if found == best:
        return
    assert min(page.needed(found) for page in pages) == min(page.needed(best) for page in pages) == 1
    before, after = ([pages[0].size(kind, scales) for kind in KINDS] for scales in (best, found))
    assert after[0] > GROWS * before[0] or min(after) > GROWS * min(before)


def test_scales_of_figures_on_which_forces_are_drawn_are_left_as_they_are() -> None:
    kinds: set[Place] = {View.MECHANISM, View.FORCE}
    figures = [Sketched(view=view_of(one), of=one, scale=1.0, size=(60.0, 40.0)) for one in kinds]
    best: Scales = dict.fromkeys(kinds, 1.0)
    assert balanced([Composing(figures, kinds, room_inside())], best) == best


@pytest.mark.parametrize("name", few(["best-gamma", "K-crank-rocker-gamma"], 2))
def test_a_construction_whose_letters_crowd_has_the_room_of_one_sheet_more_and_needs_no_detail(name: str) -> None:
    made = laid(name)
    assert len(made) == 2 and not any(group.details for sheet in made for group in sheet.groups)
    main = drawn(name).figures(View.MECHANISM)[0]
    assert max(extent(main.marks)) > KNOT * sum(1 for mark in main.marks if getattr(mark, "label", ""))
