"""What the moments of a screw jack are called."""

from __future__ import annotations

import pytest

from vecpoly import load
from vecpoly.report.statement.meant import meant_by
from vecpoly.solution import solve


@pytest.mark.parametrize(("varied", "key", "other"), [("p", "M2_over_Q", "M1_over_Q"), ("D", "M1_over_Q", "M2_over_Q")])
def test_the_moments_of_a_screw_jack_are_called_after_what_they_depend_on(varied: str, key: str, other: str) -> None:
    """M_1, of the ring, was called that of the thread, and M_2 that of the ring."""
    plain = load("5-5")
    changed = plain.vary(**{varied: "5 mm" if varied == "p" else "36 mm"})
    values = [solve(one, repeats=0, precise=True).answers for one in (plain, changed)]
    moved = {one: abs(values[0][one].exact - values[1][one].exact) > 1e-9 for one in (key, other)}
    assert moved == {key: True, other: False}
    words = meant_by(plain.subject, key, "M")
    assert words is not None and ("thread" if varied == "p" else "ring") in words.en
