"""Four-bars with a further point of the coupler: the family that shows how one is written."""

from __future__ import annotations

import numpy as np

from .family import family


@family("four-bar")
def four_bar(rng: np.random.Generator) -> str:
    """Any four lengths, any position; the branch by the side of the diagonal."""
    ab, bc, cd, ad = rng.integers(20, 200, 4)
    phi, side, left = rng.integers(0, 360), rng.choice(["left", "right"]), rng.integers(-60, 60)
    return f"""
id: four-bar
title: four-bar
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm]}}
links:
  1: {{AB: {ab} mm}}
  2: {{BC: {bc} mm, E: {{along: BC, at: {rng.integers(-50, 200)} mm, left: {left} mm}}}}
  3: {{DC: {cd} mm}}
input: {{link: 1, phi: {phi} deg, omega: {rng.choice([-8, 3, 10])} rad/s, alpha: {rng.choice([0, 5, -20])} rad/s^2}}
branch: [C {side} of BD]
find: [v_B, v_C, v_CB, v_E, a_B, a_C, an_CB, at_CB, a_E, omega_2, omega_3, alpha_2, alpha_3]
"""
