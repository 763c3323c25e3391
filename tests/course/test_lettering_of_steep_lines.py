"""A line that runs far beyond its axes, as beside a dead point, is looked at within them alone."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly.curves.place import STEP, _between, _dense

LOW, HIGH = -10 - 20j, 100 + 60j


def test_a_line_beyond_all_bounds_has_as_many_places_as_the_axes_are_wide() -> None:
    line = np.array([0j, 50 + 1e12j, 60 - 3e11j, 90 + 0j])
    places = _dense(line, LOW, HIGH)
    assert len(places) < 4 + 4 * (HIGH - LOW).imag / STEP
    within = places[np.abs(places.imag) < 70]
    assert (within.imag.min(), within.imag.max()) == pytest.approx((LOW.imag, HIGH.imag), abs=STEP)


@pytest.mark.parametrize(
    ("p", "q", "share"),
    [
        (0j, 10 + 0j, (0.0, 1.0)),
        (0j, 200 + 0j, (0.0, 0.5)),
        (-110 + 0j, 90 + 0j, (0.5, 1.0)),
        (0j, -40j, (0.0, 0.5)),
        (0 + 100j, 50 + 20j, (0.5, 1.0)),
    ],
)
def test_the_share_of_a_piece_that_lies_within_is_told(p: complex, q: complex, share: tuple[float, float]) -> None:
    assert _between(p, q, LOW, HIGH) == pytest.approx(share)


@pytest.mark.parametrize(("p", "q"), [(0 + 70j, 90 + 70j), (0 + 70j, 90 + 61j), (101 + 0j, 101 + 50j)])
def test_of_what_lies_outside_there_is_none(p: complex, q: complex) -> None:
    start, end = _between(p, q, LOW, HIGH)
    assert start >= end
