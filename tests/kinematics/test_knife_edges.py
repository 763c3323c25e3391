"""A knife edge is a disc without a radius, however its zero is written."""

from __future__ import annotations

import pytest

from vecpoly.errors import ProblemFileError
from vecpoly.problem.load import load, loads

KNIFE = load("cam-knife-load").text


@pytest.mark.parametrize("zero", ["0 mm", "0.00 mm", "0 m", "0e-3 m"])
def test_a_radius_of_zero_is_that_of_a_knife_edge_in_any_unit(zero: str) -> None:
    assert "radius: 0 mm" in KNIFE
    told = loads(KNIFE.replace("radius: 0 mm", f"radius: {zero}"))
    assert told.mechanism == load("cam-knife-load").mechanism


def test_a_negative_radius_is_none() -> None:
    with pytest.raises(ProblemFileError):
        loads(KNIFE.replace("radius: 0 mm", "radius: -1 mm"))
