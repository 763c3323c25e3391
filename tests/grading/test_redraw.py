"""A problem drawn anew at the scales of its key: on the same sheet, so that lengths on paper are the same lengths."""

from __future__ import annotations

import numpy as np
import pytest

from tests.grading.cases import key_of, problem_of
from tests.laws import few
from vecpoly.board.hand import steady
from vecpoly.figures import scales
from vecpoly.grading.key import Kind
from vecpoly.grading.redraw import act_of, as_keyed, drawn_by, values_of


@pytest.mark.parametrize(
    "name",
    [
        *few(["curv-1", "curv-2", "curv-5", "D-2", "D-3", "balance-shaper", "balance-slider-crank", "3-9", "3-12"], 3),
        "D-1",
        "class-iii",
    ],
)
def test_a_sheet_that_is_drawn_anew_has_the_lengths_of_its_key(name: str) -> None:
    """A second figure of the mechanism, and a polygon of each link, keep the scales that they were given."""
    key = key_of(name)
    again = drawn_by(as_keyed(problem_of(name), key), steady(1))
    read = [one for one in key.quantities if one.kind is Kind.READING]
    assert read
    for one in read:
        act = act_of(again, one)
        assert act is not None
        assert np.atleast_1d(values_of(again, act))[0] == pytest.approx(one.exact, rel=1e-9), one.key


def test_scales_that_are_given_stay_given() -> None:
    problem = problem_of("golden")
    kept = problem.scales.kept({**problem.scales.given, "mu_F": 10.0})
    assert kept.wished(scales()["mu_l"]) == 0.002
    assert kept.of(scales()["mu_F"]) == 10.0 and kept.wished(scales()["mu_F"]) is None


@pytest.mark.parametrize("name", ["5-1", "5-2"])
def test_what_only_checks_another_quantity_is_drawn_anew_too(name: str) -> None:
    assert act_of(drawn_by(problem_of(name), steady(1)), key_of(name)["F_sine"]) is not None
