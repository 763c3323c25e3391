"""Pairs of angles, function generators, dead centres, drag links."""

from __future__ import annotations

import numpy as np

from ..family import family
from .bodies import keeps_its_lengths
from .driven import half_a_turn, rests
from .written import task


def _pairs(rng: np.random.Generator, count: int) -> str:
    phi, psi = int(rng.integers(0, 120)), int(rng.integers(0, 120))
    sense, found = (1 if rng.random() < 0.7 else -1), []
    for _ in range(count):
        found.append(f"{phi} deg -> {psi} deg")
        phi, psi = phi + int(rng.integers(8, 50)), psi + sense * int(rng.integers(5, 45))
    return f"[{', '.join(found)}]"


@family("design-angle-pairs", also=keeps_its_lengths, often=1, first=1)
def angle_pairs(rng: np.random.Generator) -> str:
    """Two or three pairs of angles of crank and rocker."""
    count = int(rng.integers(2, 4))
    data = {"AB": f"{rng.integers(15, 60)} mm", "AD": f"{rng.integers(40, 130)} mm", "pairs": _pairs(rng, count)}
    return task("angle-pairs", data, "BC, CD" + (", delta_C" if count == 3 else ""))


@family("design-slider-pairs", also=keeps_its_lengths)
def slider_pairs(rng: np.random.Generator) -> str:
    """Three pairs of crank and slider."""
    phi, s, pairs = int(rng.integers(0, 90)), int(rng.integers(60, 140)), []
    for _ in range(3):
        pairs.append(f"{phi} deg -> {s} mm")
        phi, s = phi + int(rng.integers(10, 50)), s - int(rng.integers(4, 35))
    data = {
        "guide": f"on y = {rng.integers(-30, 30)} mm",
        "pairs": f"[{', '.join(pairs)}]",
        "onto": f"{rng.integers(1, 4)}",
    }
    return task("angle-pairs", data, "AB, BC, delta_B")


@family("design-function", also=keeps_its_lengths, often=1)
def function(rng: np.random.Generator) -> str:
    """Three pairs, or a function by Chebyshev's marks."""
    if rng.random() < 0.5:
        return task("function-generator", {"AD": f"{rng.integers(40, 120)} mm", "pairs": _pairs(rng, 3)}, "AB, BC, CD")
    phi, psi = int(rng.integers(0, 300)), int(rng.integers(0, 300))
    data = {
        "AD": "100 mm",
        "function": str(rng.choice(["log10(x)", "x**2", "sin(x)", "1/x", "sqrt(x)", "exp(x)"])),
        "x": str(rng.choice(["[1, 2]", "[0.5, 1.5]", "[1, 1.5]"])),
        "phi": f"[{phi} deg, {phi + rng.integers(30, 100)} deg]",
        "psi": f"[{psi} deg, {psi + rng.integers(-100, 100)} deg]",
    }
    return task("function-generator", data, "AB, BC, CD, delta_B, delta_C")


@family("design-dead-centre", also=rests)
def dead_centre(rng: np.random.Generator) -> str:
    """A rocker that comes to rest over a dead centre."""
    data = {
        "AD": f"{rng.integers(50, 150)} mm",
        "CD": f"{rng.integers(30, 100)} mm",
        "psi_1": f"{rng.integers(60, 170)} deg",
        "psi_2": f"{rng.integers(10, 120)} deg",
        "phi_12": f"{rng.integers(-355, 355)} deg",
    }
    return task("dead-centre", data, "AB, BC")


@family("design-drag-link", also=half_a_turn, first=5)
def drag_link(rng: np.random.Generator) -> str:
    """A double crank with the ratio K."""
    data = {
        "AD": f"{rng.integers(10, 50)} mm",
        "AB": f"{rng.integers(30, 120)} mm",
        "K": f"{round(float(rng.uniform(1.1, 2.5)), 2)}",
        "phi_1": f"{rng.integers(0, 360)} deg",
        "psi_1": f"{rng.integers(0, 360)} deg",
    }
    return task("drag-link", data, "BC, CD, gamma_min")
