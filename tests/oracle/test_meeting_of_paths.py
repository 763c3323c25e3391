"""Two paths of a gear's centre meet where both run; of two meetings the sign tells which, whichever stands first."""

from __future__ import annotations

import cmath

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from vecpoly.oracle.closed.off_centre import _meet, _Path

places = st.complex_numbers(max_magnitude=2.0, allow_nan=False, allow_infinity=False)
radii = st.floats(0.2, 3.0)
ways = st.floats(-3.1, 3.1).map(lambda angle: cmath.rect(1.0, angle))
signs = st.sampled_from([1.0, -1.0])


def off(path: _Path, at: complex) -> float:
    """How far from the path a place lies."""
    if path.radius:
        return abs(abs(at - path.at) - path.radius)
    return abs(((at - path.at) * path.along.conjugate()).imag)


@given(places, places, radii, radii, signs)
def test_circles_meet_on_both_and_on_the_side_that_is_told(
    a: complex, b: complex, r: float, s: float, sign: float
) -> None:
    one, two = _Path(a, r), _Path(b, s)
    assume(abs(b - a) > 0.05)
    at = _meet(one, two, sign)
    if not abs(r - s) < abs(b - a) < r + s:
        assert np.isnan(at) or abs(abs(b - a) - (r + s)) < 1e-9 or abs(abs(b - a) - abs(r - s)) < 1e-9
        return
    assert max(off(one, at), off(two, at)) < 1e-6
    assert sign * ((b - a).conjugate() * (at - a)).imag >= -1e-9


@given(places, places, radii, ways, signs)
def test_a_circle_and_a_line_meet_on_both_ahead_on_the_line_or_behind(
    a: complex, b: complex, r: float, way: complex, sign: float
) -> None:
    circle, line = _Path(a, r), _Path(b, 0.0, way)
    at = _meet(circle, line, sign)
    assert np.isnan(at) == np.isnan(_meet(line, circle, sign))
    if off(line, a) > r:
        assert np.isnan(at)
        return
    assert at == _meet(line, circle, sign)
    assert max(off(circle, at), off(line, at)) < 1e-6
    assert sign * (way.conjugate() * (at - a)).real >= -1e-9


@given(places, places, ways, ways)
def test_lines_meet_on_both(a: complex, b: complex, u: complex, v: complex) -> None:
    assume(abs((u.conjugate() * v).imag) > 0.01)
    one, two = _Path(a, 0.0, u), _Path(b, 0.0, v)
    at = _meet(one, two, 1.0)
    assert max(off(one, at), off(two, at)) < 1e-9


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_what_has_no_meeting_has_none(sign: float) -> None:
    assert np.isnan(_meet(_Path(0j, 1.0), _Path(0j, 1.0), sign))
    assert np.isnan(_meet(_Path(0j, 0.0, 1 + 0j), _Path(1j, 0.0, 1 + 0j), sign))
