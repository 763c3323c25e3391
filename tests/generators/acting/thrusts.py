"""Cylinders that lift loads: the thrust asked, or given and a moment or a force asked."""

from __future__ import annotations

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import family


@family("forces-thrust", also=in_equilibrium)
def thrust(rng: np.random.Generator) -> str:
    """A lever or a slider on a cylinder that is pinned to the frame."""
    d = complex(*rng.integers(-300, 300, 2))
    reach, lean, e = rng.integers(60, 300), rng.uniform(0, 2 * np.pi), rng.integers(50, 400)
    way = np.exp(1j * lean)
    c = reach * way
    near, far = [("cylinder", "piston"), ("piston", "cylinder")][int(rng.integers(2))]
    slides = "3 slides in 2" if near == "cylinder" else "2 slides in 3"
    if rng.random() < 0.6:
        link, more, told = (
            f"{{AC: {reach} mm, E: {{along: AC, at: {e} mm, left: {rng.integers(-60, 60)} mm}}}}",
            "",
            f"branch: [C {_side(d, c)} of AD]",
        )
        centre = "{along: AC, at: 80 mm}"
    else:
        link, more, told = (
            f"{{block: C, E: {{CE: {e} mm, angle: {rng.integers(-170, 170)} deg from line}}}}",
            f"1 slides on line through A at {np.degrees(lean):.9f} deg, ",
            "",
        )
        told, centre = f"guesses: {{C: [{c.real:.1f} mm, {c.imag:.1f} mm]}}", "E"
    load = f"  Q: {{on: 1, at: E, size: {rng.integers(100, 9000)} N, direction: {rng.integers(-179, 180)} deg}}\n"
    mass = (
        f"masses: {{1: {{mass: {rng.integers(5, 900)} kg, centre: {centre}}}}}\nweight: yes\n"
        f"inertia: {rng.choice(['yes', 'no'])}\n"
        if rng.random() < 0.5
        else ""
    )
    friction = (
        f"friction: {{A: {{rho: 3 mm}}, C: {{rho: {rng.uniform(1, 4):.2f} mm}}, D: {{f: 0.1, r: 20 mm}}}}\n"
        if rng.random() < 0.25 and not more
        else ""
    )
    return f"""
id: thrust
title: thrust
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm]}}
links:
  1: {link}
  2: {{{near}: D}}
  3: {{{far}: C}}
joints: [{more}{slides}]
input:
  cylinder: 2-3
  length: {abs(c - d):.9g} mm
  v: {rng.choice([0.1, -0.05])} m/s
  a: {rng.choice([0, 0.2])} m/s^2
{told}
loads:
{load}  F_c: {{cylinder: 2-3, size: "?"}}
{mass}{friction}"""


def _side(d: complex, c: complex) -> str:
    return "left" if (d.conjugate() * c).imag > 0 else "right"
