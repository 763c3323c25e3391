"""Friction settles for a hand that repeats the drawing as for one that draws it once."""

from __future__ import annotations

import numpy as np
import pytest

from tests.generators.family import families, member
from vecpoly import loads, solve


@pytest.mark.parametrize(("kind", "seed", "number"), [("forces-two-trains-friction", 6, 72)])
def test_pins_that_bear_nothing_at_first_settle_for_every_hand(kind: str, seed: int, number: int) -> None:
    """Their couples were single numbers beside positions of two hundred hands: a traceback."""
    (family,) = (one for one in families() if one.name == kind)
    drawn = solve(loads(member(family, seed, number)))
    assert np.isfinite([answer.expected_error for answer in drawn.answers.values()]).all()
    assert all(abs(one.deviation) <= one.expected_error + 1e-12 for one in drawn.answers.values())
