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


def of_the_rack(solution: Solution) -> str:
    """Circles, thickness and the limit of undercut of any basic rack, written out."""
    device, found = solution.problem.device, {key: one.exact for key, one in solution.answers.items()}
    m, z, x, angle, head, c = (
        float(getattr(value, "si", value))
        for value in map(device.__getattribute__, ("m", "z", "x", "alpha", "ha", "c"))
    )
    r = m * z / 2
    rb, ra = r * np.cos(angle), r + m * (head + x)
    s = m * (np.pi / 2 + 2 * x * np.tan(angle))
    worked = {"r": r, "rb": rb, "ra": ra, "rf": r - m * (head + c - x), "s": s}
    least = head - z * np.sin(angle) ** 2 / 2
    for key, value in worked.items():
        if key in found and abs(found[key] - 1e3 * value) > 1e-9 * 1e3 * abs(value):
            return f"{key} = {found[key]:g} mm, by the rack {1e3 * value:g} mm"
    if "x_min" in found and abs(found["x_min"] - least) > 1e-9:
        return f"x_min = {found['x_min']:g}, by the rack {least:g}"
    if "undercut" in found and abs(x - least) > 1e-6 and bool(found["undercut"]) is not bool(x < least):
        return f"undercut: {found['undercut']}, x = {x:g}, x_min = {least:g}"
    if "s_tip" in found and ra > rb:
        tip = np.arccos(rb / ra)
        thick = 2 * ra * (s / (2 * r) + (np.tan(angle) - angle) - (np.tan(tip) - tip))
        return off("s_tip", found["s_tip"], max(1e3 * float(thick), 0.0))  # a tooth that is pointed before ends there
    return ""


@family("device-gear", also=of_the_rack, often=2)
def any_gear(rng: np.random.Generator) -> str:
    """Any basic rack: steep or flat flanks, stub and full teeth."""
    angle, head = rng.choice([14.5, 15, 17.5, 20, 22.5, 25]), rng.choice([0.8, 1.0])
    data = {
        "m": f"{rng.choice([1, 2, 3, 4.5, 10])} mm",
        "z": f"{rng.integers(6, 60)}",
        "x": f"{rng.uniform(-0.5, 0.8):.2f}",
        "alpha": f"{angle} deg",
        "ha": f"{head}",
        "c": f"{rng.choice([0.25, 0.3, 0.35])}",
    }
    return task("gear-generation", data, "r, rb, ra, rf, x_min, z_min, undercut, s, s_tip, r_start", "device")
