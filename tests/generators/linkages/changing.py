"""Four-bars with change points, and what hangs on them:
the motion is smooth all the way round, through every change point."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from vecpoly import oracle
from vecpoly.mechanism.model import Mechanism
from vecpoly.solution import Solution

from ..family import family

STEPS = 1440
SMOOTH = 2e-3  # of the largest rate: central differences with a quarter of a degree


def smooth_all_round(solution: Solution) -> str:
    """Where positions of C and G do not pass into each other as their velocities,
    and these as their accelerations, tell."""
    mech = solution.problem.subject
    assert isinstance(mech, Mechanism)
    q = mech.drive.position + np.linspace(0.0, 4 * np.pi, 2 * STEPS + 1)
    motion = oracle.solve(mech, q, strict=False)
    for letter in ("C", "G"):
        rows = (
            motion.position(letter),
            motion.velocity(letter) / mech.drive.rate,
            motion.acceleration(letter) / mech.drive.rate**2,
        )
        for value, rate in pairwise(rows):
            told = np.abs(np.gradient(value, q) - rate)[1:-1]
            if np.nanmax(told) > SMOOTH * np.nanmax(np.abs(rate)):
                return f"{letter} jumps at {np.degrees(q[1:-1][np.nanargmax(told)]):.3f} deg"
    return ""


@family("change-points", smooth_all_round)
def changing(rng: np.random.Generator) -> str:
    """Parallelogram, antiparallelogram, kite, or the sum of the shortest and the longest side that of the others;
    a dyad on the coupler."""
    short, long = int(rng.integers(30, 60)), int(rng.integers(90, 140))
    kind = rng.choice(["parallelogram", "antiparallelogram", "kite", "sum"])
    side = rng.choice(["left", "right"])
    match kind:
        case "kite":
            (ab, bc, cd, ad), branch = (short, long, long, short), f"C {side} of BD"
        case "sum":
            other = int(rng.integers(short + 5, long))
            (ab, bc, cd, ad), branch = (short, other, short + long - other, long), f"C {side} of BD"
        case figure:
            (ab, bc, cd, ad), branch = (short, long, short, long), f"ABCD {figure}"
    phi = rng.integers(20, 160) + rng.choice([0, 180])
    return f"""
id: change-points
title: change points
frame: {{A: [0 mm, 0 mm], D: [{ad} mm, 0 mm], F: [{ad / 2} mm, -400 mm]}}
links:
  1: {{AB: {ab} mm}}
  2: {{BC: {bc} mm, E: {{along: BC, at: {rng.integers(10, 80)} mm, left: {rng.integers(-50, 50)} mm}}}}
  3: {{DC: {cd} mm}}
  4: {{EG: 300 mm}}
  5: {{FG: 330 mm}}
input: {{link: 1, phi: {phi} deg, omega: {rng.choice([10, -5])} rad/s}}
branch: [{branch}, G left of FE]
find: [v_C, v_CB, a_C, an_C, at_C, an_CB, at_CB, v_G, a_G,
       omega_2, omega_3, omega_4, omega_5, alpha_2, alpha_3, alpha_4, alpha_5]
"""
