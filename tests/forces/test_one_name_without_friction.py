"""M_1,0 is M_1 without friction; where there is none, every way finds M_1."""

from __future__ import annotations

import pytest

from vecpoly.mechanism.asked.forces import quantities
from vecpoly.problem.load import load


@pytest.mark.parametrize(
    ("name", "keys", "symbol"),
    [
        ("slider-crank-dynamic", ("M_1", "M_1_lever", "M_1_power"), "M_{1}"),
        ("shaper-cut", ("M_b", "M_b_lever", "M_b_power"), "M_{b}"),
        ("4-4", ("M_1_0", "M_1_lever", "M_1_power"), "M_{1,0}"),
    ],
)
def test_the_balancing_moment_has_one_symbol_by_all_ways(name: str, keys: tuple[str, ...], symbol: str) -> None:
    problem = load(name)
    assert problem.loads is not None and bool(problem.loads.friction) == symbol.endswith(",0}")
    found = quantities(problem.mechanism, problem.loads)
    assert {found[key].symbol for key in keys} == {symbol}
