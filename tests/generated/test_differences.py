"""What the third party for forces knows from positions alone, and where positions tell nothing."""

from __future__ import annotations

import pytest

from tests.generators.moving import Moving
from vecpoly import loads, oracle
from vecpoly.errors import AssemblyError

# 0.06° before this position the loop of links 2 to 5 cannot be closed; 0.11° before it can, in another assembly.
BESIDE_A_GAP = """
id: x
title: beside a gap of its range
frame: {A: [0 mm, 0 mm], I: [49.995657774 mm, 93.347519589 mm], J: [159.063416852 mm, 110.821844112 mm]}
links:
  1: {AB: 59.681908787 mm, F: {along: AB, at: 228.031303306 mm, left: -65.501400302 mm},
      G: {along: AB, at: 50.325640896 mm, left: -62.721622979 mm}}
  2: {CD: 20.827039285 mm, E: {along: CD, at: -47.699054664 mm, left: -2.159729131 mm},
      H: {along: CD, at: 45.139586022 mm, left: -9.163279981 mm},
      K: {along: CD, at: -36.466438417 mm, left: -63.075825026 mm}}
  3: {block: E}
  4: {IH: 47.014189170 mm}
  5: {slot: J}
joints: [3 slides on FG with E 9.6115 mm right, K of 2 slides in 5 with K 13.0847 mm left turned -163.838623121 deg]
input: {link: 1, phi: 29 deg, omega: 8 rad/s cw}
guesses: {C: [125.546 mm, 57.093 mm], D: [109.648 mm, 70.548 mm], E: [163.350 mm, 27.927 mm],
          H: [97.010 mm, 93.249 mm], K: [194.130 mm, 81.682 mm]}
find: [omega_2]
"""
FOUR_BAR = """
id: x
title: a four-bar linkage, %s degrees of its crank from where it cannot be closed
frame: {A: [0 mm, 0 mm], D: [100 mm, 0 mm]}
links: {1: {AB: 60 mm}, 2: {BC: 70 mm}, 3: {DC: 60 mm}}
branch: [C left of BD]
input: {link: 1, phi: %s deg, omega: 8 rad/s ccw}
find: [omega_3]
"""


def test_beside_a_gap_there_are_no_differences() -> None:
    """ω_2 = 357 rad/s; 0.11° before, beyond the gap, there would be another assembly, which is never stepped into."""
    mech = loads(BESIDE_A_GAP).mechanism
    assert oracle.solve(mech).omega("2") == pytest.approx(357.145, rel=1e-4)
    with pytest.raises(AssemblyError):
        Moving.of(mech)
    assert not Moving.of(mech, 1e-5).leaps


@pytest.mark.parametrize("near", [20.0, 1.0, 0.24])
def test_beside_the_end_of_a_range_differences_still_tell_the_sense(near: float) -> None:
    end = 105.962014  # deg: cos φ = (60² + 100² − 130²) / (2 · 60 · 100)
    mech = loads(FOUR_BAR % (near, end - near)).mechanism
    moving = Moving.of(mech)
    assert not moving.leaps
    assert moving.omega("3") * oracle.solve(mech).omega("3") > 0
