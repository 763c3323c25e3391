"""A driver says how the other links move, however little it moves itself."""

from __future__ import annotations

import vecpoly

# With the crank held fast the least singular value is 1.4·10⁻⁵ of the largest: the motion was called undetermined.
LAZY = """
id: x
title: a driver and three groups, two of them of class III
device: structure
data:
  joints:
    A0: R(0, 1) at (-158, 140)
    A1: R(2, 3) at (-108, 79)
    A2: R(3, 1) at (-143, 105)
    A3: R(2, 4) at (-119, 60)
    A4: R(4, 0) at (88, -111)
    A5: R(2, 5) at (-136, 160)
    A6: R(5, 0) at (141, 28)
    A7: R(6, 7) at (-135, 165)
    A8: R(7, 4) at (-153, 163)
    A9: R(6, 8) at (174, -29)
    B0: R(8, 3) at (-91, -160)
    B1: R(6, 9) at (147, 182)
    B2: R(9, 2) at (-107, -97)
    B3: R(5, 10) at (174, 52)
    B4: R(10, 11) at (-185, 2)
    B5: P(11, 1) at (147, 128) along 135 deg
  drivers: [1]
find: [F, determined]
"""


def test_a_driver_that_hardly_moves_says_how_the_others_move() -> None:
    solution = vecpoly.solve(vecpoly.loads(LAZY), by="exact", repeats=0)
    assert solution.construction.warning is None
    assert {key: (answer.drawn, answer.exact) for key, answer in solution.answers.items()} == {
        "F": (1.0, 1.0),
        "determined": (1.0, 1.0),
    }
