"""Directions are compared on the circle: 359.9° and 0.1° are neighbours, 90° and 270° are not."""

from __future__ import annotations

import numpy as np
import pytest

from vecpoly.board.construction import Reading
from vecpoly.methods.centres.compare import comparable


def compared(drawn: float, exact: float, places: set[str]) -> tuple[float, np.ndarray]:
    reading = Reading(key="x", symbol="x", unit="deg", scalar=drawn)
    _, true, spread = comparable({"x": reading}, {"x": exact}, {"x": np.array([drawn, drawn - 359.5])}, places)
    return float(true["x"].real), spread["x"]


@pytest.mark.parametrize(
    ("drawn", "exact", "off"), [(359.9, 0.1, 0.2), (0.1, 359.9, -0.2), (90.0, 270.0, 180.0), (45, 46, 1)]
)
def test_an_angle_comes_round_after_a_whole_turn(drawn: float, exact: float, off: float) -> None:
    true, spread = compared(drawn, exact, set())
    assert abs(true - drawn) == pytest.approx(abs(off)) and np.ptp(spread) == pytest.approx(0.5)


def test_the_direction_of_a_line_comes_round_after_half_a_turn() -> None:
    assert compared(179.9, 0.1, {"x"})[0] == pytest.approx(180.1)
