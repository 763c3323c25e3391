"""The window in which a GeoGebra file opens: every figure is in it, side by side, and they fill it."""

from __future__ import annotations

from itertools import combinations
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.board.construction import View
from vecpoly.drawing.rect import Rect
from vecpoly.export.geogebra.document import GAP, PIXELS, TITLE, _anchors, _window

SIDES, PLACES = st.integers(5, 300).map(float), st.integers(-200, 200).map(float)
Extents = dict[View, tuple[complex, complex]]


def figure(x: float, y: float, wide: float, high: float) -> tuple[complex, complex]:
    """Its lower left and upper right corner."""
    return complex(x, y), complex(x + wide, y + high)


FIGURES = st.builds(figure, PLACES, PLACES, SIDES, SIDES)
SEVERAL = st.lists(FIGURES, min_size=1, max_size=3).map(
    lambda some: dict(zip((View.MECHANISM, View.VELOCITY, View.ACCELERATION), some, strict=False))
)


def standing(extents: Extents) -> list[Rect]:
    """The figures where they stand on the page (mm)."""
    at = _anchors(extents)
    corners = [(at[view] + low, at[view] + high) for view, (low, high) in extents.items()]
    return [Rect(low.real, low.imag, high.real, high.imag) for low, high in corners]


def seen(extents: Extents) -> Rect:
    """The part of the page that is seen (mm)."""
    root = ET.Element("geogebra")
    _window(root, extents)
    size, system = root.find("euclidianView/size"), root.find("euclidianView/coordSystem")
    assert size is not None and system is not None
    given = {key: float(value) for one in (size, system) for key, value in one.attrib.items()}
    assert given["scale"] == given["yscale"] and (given["width"], given["height"]) == PIXELS
    low = complex(-given["xZero"], given["yZero"] - given["height"]) / given["scale"]
    high = complex(given["width"] - given["xZero"], given["yZero"]) / given["scale"]
    return Rect(low.real, low.imag, high.real, high.imag)


@given(extents=SEVERAL)
def test_all_figures_with_their_titles_are_in_the_window_and_fill_it_across_or_upwards(extents: Extents) -> None:
    window, figures = seen(extents), standing(extents)
    least = figures[0]
    for one in figures:
        assert window.x0 < one.x0 and one.x1 < window.x1
        assert window.y0 < one.y0 - TITLE and one.y1 + TITLE < window.y1
        least |= one
    assert window.width - least.width < GAP or window.height - least.height < 5 * TITLE


@pytest.mark.parametrize(("wide", "high"), [(300.0, 20.0), (20.0, 300.0)])
def test_a_long_figure_fills_the_window_along_and_a_high_one_upwards(wide: float, high: float) -> None:
    window = seen({View.MECHANISM: figure(-7.0, 9.0, wide, high)})
    assert (window.width - wide < GAP) is (wide > high)
    assert (window.height - high < 5 * TITLE) is (high > wide)


@given(extents=SEVERAL)
def test_figures_stand_apart_in_one_row_with_their_middles_level_and_the_mechanism_where_it_is(
    extents: Extents,
) -> None:
    figures = standing(extents)
    assert (figures[0].x0, figures[0].y0) == pytest.approx((extents[View.MECHANISM][0].real, figures[0].y0))
    assert all(abs(one.centre.imag - figures[0].centre.imag) <= 0.5 for one in figures)
    assert all(right.x0 - left.x1 >= GAP - 0.5 for left, right in combinations(figures, 2))
