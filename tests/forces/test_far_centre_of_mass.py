"""Found by damaging files: a centre of mass so far off that nothing else of the mechanism can be drawn beside it."""

from __future__ import annotations

import pytest

import vecpoly
from vecpoly.errors import NotAskedError


def test_a_centre_of_mass_beyond_all_bounds_is_refused_in_words() -> None:
    text = vecpoly.load("slider-crank-dynamic").text.replace("along: BC, at: 75 mm", "along: BC, at: 757575 mm")
    assert "757575" in text
    with pytest.raises(NotAskedError, match="too unlike"):
        vecpoly.solve(vecpoly.loads(text))
