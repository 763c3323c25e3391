"""A length that lies all but on a line of the rule: few hands read another, and yet its rounding scatters."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly.board.hand import BY_LINE, hand, scatter, seldom
from vecpoly.check.alarm import alarm_at

HANDS = ("drafting", "pencil")


@pytest.mark.parametrize("name", HANDS)
@pytest.mark.parametrize("beside", [0.002, 0.01, 0.034])
def test_what_the_rounding_of_such_a_length_scatters_by_is_what_very_many_hands_find(name: str, beside: float) -> None:
    many = hand(name, repeats=100_000)
    mm = (926 - beside) * many.repeated.reading
    assert seldom(name, mm) == pytest.approx(scatter(np.asarray(many.read(mm))[1:]), rel=0.2)


@pytest.mark.parametrize("name", HANDS)
@pytest.mark.parametrize("nth", range(40))
def test_no_reading_is_suspect_for_being_rounded_however_few_hands_read_another_line(name: str, nth: int) -> None:
    some = hand(name, repeats=200, seed=nth)
    step = some.repeated.reading
    beside = 10.0 ** -(2 + nth % 4) * BY_LINE * 30
    mm = (926 - beside) * step
    found = np.asarray(some.read(mm))
    reached = max(3.0 * scatter(found[1:]), 3.0 * seldom(name, mm))
    assert abs(926 * step - mm) <= alarm_at(reached, found, scatters=False) + 1e-9


@pytest.mark.parametrize("name", HANDS)
def test_on_a_line_and_between_two_nothing_is_added(name: str) -> None:
    step = hand(name).repeated.reading
    assert seldom(name, 926 * step) == seldom(name, 926.5 * step) == seldom(name, 926.1 * step) == 0.0
