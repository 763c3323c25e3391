"""A crank that is called driving, near its dead points: it helps the load on the slide over the friction, or the load
alone overcomes it."""

from __future__ import annotations

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import family


@family("helped-over-friction", also=in_equilibrium, often=1)
def helped(rng: np.random.Generator) -> str:
    """A slider-crank, offset or not, whose load pushes with the motion or against it."""
    crank = int(rng.integers(30, 70))
    rod, offset = int(rng.integers(3 * crank, 5 * crank)), int(rng.integers(-10, 11))
    phi = float(rng.choice([0.0, 180.0])) + float(rng.uniform(-12, 12))
    way, load = str(rng.choice(["ccw", "cw"])), int(rng.integers(100, 900))
    pins = "".join(f", {letter}: {{rho: {rng.integers(1, 5)} mm}}" for letter in "ABC" if rng.random() < 0.8)
    return (
        f"id: helped\ntitle: helped\nframe: {{A: [0 mm, 0 mm]}}\n"
        f"links: {{1: {{AB: {crank} mm}}, 2: {{BC: {rod} mm}}, 3: {{block: C}}}}\n"
        f"joints: [3 slides on y = {offset} mm]\n"
        f"input: {{link: 1, phi: {phi:.3f} deg, omega: 10 rad/s {way}}}\nbranch: [C right of A]\n"
        f"loads:\n  F: {{on: 3, at: C, size: {load} N, direction: {rng.choice([0, 180])} deg}}\n"
        '  M_1: {on: 1, size: "?", role: driving}\n'
        f"friction: {{3-4: {{f: {rng.choice([0.05, 0.1, 0.15])}}}{pins}}}\n"
        "find: [M_1, M_1_0, R_12, R_41, R_34]\n"
    )
