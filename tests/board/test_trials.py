"""Curves drawn by trial: where they cross zero, and where they only jump over it."""

from __future__ import annotations

from math import isnan, nan, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from vecpoly.methods.roots import crossings

GRID = [n * pi / 90 for n in range(181)]


@given(st.floats(0.1, 6.2), st.floats(0.05, 0.4), st.floats(0.05, 1.4))
def test_a_jump_over_zero_is_no_crossing(place: float, before: float, after: float) -> None:
    """Where the links change their assembly the input leaps; secants from there would run to another zero."""
    assert crossings(lambda x: before if x < place else -after, GRID, 1e-3) == []


@given(st.floats(0.3, 2.8))
def test_a_crossing_beside_a_jump_is_found_once_and_to_the_last_digits(zero: float) -> None:
    def curve(x: float) -> float:
        if x > 5.5:
            return nan
        return (x - zero) * 0.7 if x < pi + 1 else -0.4 + 0.1 * (x - 4.2)

    found = crossings(curve, GRID, 1e-3)
    assert found == [pytest.approx(zero, abs=1e-14)] and not any(map(isnan, found))
