"""Equivalents over a whole turn: columns, extremes, what they cost."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from tests.machine.engines import DATA, engine
from vecpoly.cycle import cycle
from vecpoly.cycle.extremes import extremes

B03 = DATA["B03"]["results"]["table"]
LOADS = ("F: {on: 3, at: C, size: 3000 N, direction: 180 deg}", "M_1: {on: 1, size: 60 N*m cw}")


def test_the_columns_of_a_turn_have_the_equivalents_of_every_position() -> None:
    turn = cycle(engine(["J_e"], loads=LOADS), 361)
    assert {"J_e", "M_e"} <= {column.key for column in turn.columns}
    for row in B03:
        i = round(row["phi_deg"])
        assert turn.real("J_e")[i] == pytest.approx(row["J_e"], rel=5e-9)
        assert turn.real("M_e")[i] == pytest.approx(row["M_e"], rel=5e-9)


def test_a_loaded_mechanism_has_equivalents_beside_what_balances_it() -> None:
    turn = cycle(vecpoly.load("six-bar-dynamic"), 73)
    assert "J_e" not in {column.key for column in turn.columns}
    inertia, pushed = turn.real("J_e"), turn.real("M_e")
    assert np.isfinite(inertia).all() and inertia.min() >= 0
    assert pushed.min() < 0 < pushed.max()


def test_the_least_equivalent_inertia_is_found_between_the_positions() -> None:
    turn = cycle(engine(["J_e"], loads=LOADS), 37)
    low = extremes(turn, "J_e").lowest
    assert low is not None
    assert low.value <= turn.real("J_e").min() + 1e-15
    assert low.value == pytest.approx(0.0224716529, rel=5e-9)  # at the dead centres
