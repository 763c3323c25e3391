"""A bar from a hinge that stands on a fixed pivot to the frame holds nothing that does not stand already."""

from __future__ import annotations

import pytest

from vecpoly import loads, solve

TEXT = """
id: mine
title: mine
device: structure
data:
  joints:
    A: R(0, 1) at (0, 0)
    B: R(1, 2) at (18, 33)
    C: R(2, 3) at (70, 40)
    D: R(3, 0) at (80, 0)
    E: R(3, 4) at (EX, 0)
    F: R(4, 0) at (120, 30)
  drivers: [1]
"""


def counted(x: float) -> dict[str, tuple[float, float]]:
    solution = solve(loads(TEXT.replace("EX", f"{x:g}")))
    return {key: (one.drawn, one.exact) for key, one in solution.answers.items()}


def test_a_bar_between_two_places_of_the_frame_is_redundant() -> None:
    """The rank of the constraints found p′ = 1, the drawing F = 0, and the two were suspect."""
    found = counted(80)
    assert all(drawn == exact for drawn, exact in found.values())
    assert found["p_redundant"] == (1, 1) and found["F"] == (1, 1) and found["groups_1"] == (1, 1)


@pytest.mark.parametrize("x", [76, 84])
def test_a_bar_from_elsewhere_on_the_link_holds_it(x: float) -> None:
    found = counted(x)
    assert all(drawn == exact for drawn, exact in found.values())
    assert found["p_redundant"] == (0, 0) and found["F"] == (0, 0)
