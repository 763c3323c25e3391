"""Epicyclic trains and gears that a rack generates; Willis's formula once more, written out."""

from __future__ import annotations

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from .written import off, task


def by_willis(solution: Solution) -> str:
    """(ω₁ − ω_H)/(ω₃ − ω_H) = −z₃/z₁ of plain planets, −z₂z₃/(z₁z₂′) of stepped ones."""
    device = solution.problem.device
    sun, ring = float(device.sun), float(device.ring)  # type: ignore[attr-defined]
    planet = device.planet  # type: ignore[attr-defined]
    outer, inner = (planet[0], planet[-1]) if isinstance(planet, tuple | list) else (planet, planet)
    ratio = -(float(outer) / sun) * (ring / float(inner))
    w1 = solution.answers["omega_1"].drawn if "omega_1" in solution.answers else device.omega_1.si  # type: ignore[attr-defined]
    arm = solution.answers["omega_H"].drawn
    w3 = device.omega_3.si  # type: ignore[attr-defined]
    return off("Willis", w1 - arm, ratio * (w3 - arm))


@family("design-train", also=by_willis)
def train(rng: np.random.Generator) -> str:
    """Sun, planets, ring, two speeds given."""
    sun, planet = (int(x) for x in rng.integers(17, 60, 2))
    module, ring, planets = int(rng.integers(1, 4)), sun + 2 * planet, f"{planet}"
    if rng.random() < 0.4:
        second = int(rng.integers(17, 60))
        ring, planets = sun + planet + second, f"[{planet}, {second}]"
    w3 = "0 rad/s" if rng.random() < 0.5 else f"{rng.integers(1, 20)} rad/s {rng.choice(['cw', 'ccw'])}"
    data = {
        "sun": f"{sun}",
        "planet": planets,
        "ring": f"{ring}",
        "m": f"{module} mm",
        "omega_1": f"{rng.integers(1, 60)} rad/s {rng.choice(['cw', 'ccw'])}",
        "omega_3": w3,
    }
    return task("epicyclic", data, "v_O2, omega_2, omega_H", "device")


@family("design-gear", often=2)
def gear(rng: np.random.Generator) -> str:
    """A gear in its rack."""
    data = {
        "m": f"{rng.integers(2, 13)} mm",
        "z": f"{rng.integers(7, 40)}",
        "x": f"{round(float(rng.uniform(-0.4, 0.7)), 2)}",
        "steps": "12",
    }
    return task("gear-generation", data, "r, rb, ra, rf, x_min, undercut, s, s_tip", "device")
