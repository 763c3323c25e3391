"""What a GeoGebra file leaves away, and how its objects are called."""

from __future__ import annotations

import pytest

from vecpoly import load
from vecpoly.export.geogebra.labels import caption, length, named
from vecpoly.export.recording import moving


@pytest.mark.parametrize("problem", ["engine-flywheel", "7-1", "balance-shaper", "4-3a"])
def test_what_is_asked_of_loads_is_left_away_with_them(problem: str) -> None:
    """A machine reduced to its crank, or counterweights, broke the drawing that follows."""
    left = moving(load(problem))
    assert (left.loads, left.machine, left.counterweights, left.asks) == (None, None, None, ())


def test_captions_are_the_letters_that_are_printed() -> None:
    """A length p'd' was pd'', a point J_B was JB, ω_2 was omega_2."""
    assert (length("p'd'"), length("n'2c'2"), length("bc2")) == ("$p'd'$", "$n'_{2}c'_{2}$", "$bc_{2}$")
    assert (caption("J_B"), caption("c_2'"), named("omega_2")) == ("$J_{B}$", "$c'_{2}$", "ω_2")
