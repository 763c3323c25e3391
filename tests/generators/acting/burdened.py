"""Cylinders that are no two-force members: their links have masses and loads of their own, and something rubs."""

from __future__ import annotations

import numpy as np

from ..equilibrium import in_equilibrium
from ..family import family


def _burdens(rng: np.random.Generator, barrel: int, line: str, piston: int) -> tuple[str, str]:
    """Masses of barrel and piston, and a force on one of them, or neither."""
    masses = (
        f"  {barrel}: {{mass: {rng.integers(2, 60)} kg, inertia: {rng.uniform(0, 2):.2f} kg*m^2, centre: {line}}}\n"
    )
    if rng.random() < 0.6:
        masses += f"  {piston}: {{mass: {rng.integers(2, 40)} kg, inertia: {rng.uniform(0, 1):.2f} kg*m^2}}\n"
    told = f"masses:\n{masses}weight: {rng.choice(['yes', 'no'])}\n" if rng.random() < 0.75 else ""
    couple = f"  M_b: {{on: {barrel}, size: {rng.integers(-60, 60)} N*m}}\n" if rng.random() < 0.4 else ""
    return told, couple


def _rubbing(rng: np.random.Generator, pins: str, slide: str) -> str:
    told = [f"{pin}: {{rho: {rng.uniform(0.5, 4):.2f} mm}}" for pin in pins if rng.random() < 0.6]
    if rng.random() < 0.5:
        told.append(f"{slide}: {{f: {rng.choice([0.003, 0.05, 0.1, 0.2])}}}")
    return f"friction: {{{', '.join(told)}}}\n" if told else ""


@family("forces-cylinder-lifting", also=in_equilibrium, often=1, first=1)
def lifting(rng: np.random.Generator) -> str:
    """A lever on a cylinder with masses; the thrust drives and is sought."""
    d = complex(*rng.integers(-300, 300, 2))
    reach, e = rng.integers(100, 300), rng.integers(50, 400)
    c = reach * np.exp(1j * rng.uniform(0, 2 * np.pi))
    side = "left" if (d.conjugate() * c).imag > 0 else "right"
    rate = f"v: {rng.choice([0.1, -0.05])} m/s, a: {rng.choice([0, 0.2])} m/s^2"
    masses, couple = _burdens(rng, 2, f"{{along: D, at: {rng.integers(20, 150)} mm}}", 3)
    return f"""
id: lifting
title: lifting
frame: {{A: [0 mm, 0 mm], D: [{d.real} mm, {d.imag} mm]}}
links:
  1: {{AC: {reach} mm, E: {{along: AC, at: {e} mm, left: {rng.integers(-60, 60)} mm}}}}
  2: {{cylinder: D}}
  3: {{piston: C}}
joints: [3 slides in 2]
input: {{cylinder: 2-3, length: {abs(c - d):.9g} mm, {rate}}}
branch: [C {side} of AD]
loads:
  Q: {{on: 1, at: E, size: {rng.integers(100, 9000)} N, direction: {rng.integers(-179, 180)} deg}}
{couple}  F_c: {{cylinder: 2-3, size: "?"}}
{masses}{_rubbing(rng, "ACD", "2-3") if rng.random() < 0.5 else ""}"""


@family("forces-cylinder-carried", also=in_equilibrium, often=1, first=1)
def carried(rng: np.random.Generator) -> str:
    """A four-bar with a cylinder from the rocker to the frame or to the coupler: its thrust given, or sought."""
    a, b, c = rng.integers(60, 120), rng.integers(300, 450), rng.integers(250, 400)
    away, aside = rng.integers(60, 240), rng.integers(20, 90)
    foot = f"[{rng.integers(150, 300)} mm, {rng.integers(-350, -200)} mm]"
    on_coupler = rng.random() < 0.5
    coupler = f"{{BC: {b} mm, G: {{along: BC, at: {rng.integers(40, 160)} mm, left: {rng.integers(20, 60)} mm}}}}"
    pin = "G" if on_coupler else "O"
    place = "" if on_coupler else f", O: {foot}"
    rate = f"omega: {rng.choice([-6, 3])} rad/s, alpha: {rng.choice([0, 10])} rad/s^2"
    masses, couple = _burdens(rng, 4, f"{{along: {pin}, at: {rng.integers(20, 120)} mm}}", 5)
    sought = rng.random() < 0.4
    size, moment = ('"?"', f"{rng.integers(-80, 80)} N*m") if sought else (f"{rng.integers(-900, 900)} N", '"?"')
    return f"""
id: carried
title: carried
frame: {{A: [0 mm, 0 mm], D: [{rng.integers(330, 420)} mm, {rng.integers(-40, 40)} mm]{place}}}
links:
  1: {{AB: {a} mm}}
  2: {coupler if on_coupler else f"{{BC: {b} mm}}"}
  3: {{DC: {c} mm, F: {{along: DC, at: {away} mm, right: {aside} mm}}}}
  4: {{cylinder: {pin}}}
  5: {{piston: F}}
joints: [5 slides in 4]
input: {{link: 1, phi: {rng.uniform(0, 360):.2f} deg, {rate}}}
branch: [C left of BD]
loads:
  F_c: {{cylinder: 4-5, size: {size}}}
{couple}  M_1: {{on: 1, size: {moment}}}
{masses}{_rubbing(rng, "ABCDF" + pin, "4-5") if rng.random() < 0.5 else ""}"""
