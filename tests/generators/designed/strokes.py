"""Slider-cranks, shapers, Whitworth's mechanism by K and stroke; limit positions of sliders and guide bars."""

from __future__ import annotations

from math import acos, asin, cos, degrees, radians, sqrt

import numpy as np

from vecpoly.designs.quick_return import Shaper, Whitworth
from vecpoly.designs.slider_crank import SliderCrank
from vecpoly.solution import Solution

from ..family import family
from .written import off, task, valid


def stroke_of(a: float, b: float, e: float) -> tuple[float, float]:
    """Stroke and θ (deg) of a slider-crank by Pythagoras in both limit triangles."""
    far, near = sqrt((b + a) ** 2 - e * e), sqrt(max(0.0, (b - a) ** 2 - e * e))
    return far - near, degrees(abs(acos(min(1.0, e / (a + b))) - acos(min(1.0, e / abs(b - a)))))


def slides_as_asked(solution: Solution) -> str:
    """H and θ of every solution."""
    data = solution.problem.subject
    assert isinstance(data, SliderCrank)
    for one in valid(solution):
        a, b = one.values["AB"], one.values["BC"]
        e = one.values["e"] if data.e is None else 1e3 * data.e.si
        stroke, theta = stroke_of(a, b, e)
        wrong = off("H", stroke, 1e3 * data.H.si) or off("theta", theta, degrees(data.theta))
        if wrong:
            return wrong
    return ""


@family("design-slider-crank", also=slides_as_asked, often=2)
def slider_crank(rng: np.random.Generator) -> str:
    """K and stroke with the offset, the crank or the coupler."""
    h, k = float(rng.integers(30, 150)), round(float(rng.uniform(1.02, 1.9)), 2)
    more = {
        "e": f"{round(float(rng.uniform(0.02, 0.9)) * h, 1)} mm",
        "AB": f"{round(float(rng.uniform(0.2, 0.52)) * h, 1)} mm",
        "BC": f"{round(float(rng.uniform(0.4, 2.5)) * h, 1)} mm",
    }
    key = str(rng.choice(list(more)))
    find = {"e": "theta, AB, BC, alpha_max", "AB": "theta, BC, e, alpha_max", "BC": "theta, AB, e, alpha_max"}[key]
    return task("slider-crank", {"K": f"{k}", "H": f"{h:g} mm", key: more[key]}, find)


def moves_the_slider(solution: Solution) -> str:
    """Stroke and θ of the given slider-crank."""
    design = solution.problem.design
    a, b, e = (1e3 * getattr(design, key).si for key in ("AB", "BC", "e"))
    stroke, theta = stroke_of(a, b, e)
    return off("H", solution.answers["H"].drawn, stroke) or off("theta", solution.answers["theta"].drawn, theta)


@family("design-slider-limits", also=moves_the_slider)
def slider_limits(rng: np.random.Generator) -> str:
    """Limit positions of an offset slider-crank."""
    a = int(rng.integers(10, 80))
    data = {"AB": f"{a} mm", "BC": f"{a + rng.integers(1, 120)} mm", "e": f"{rng.integers(0, 60)} mm"}
    return task("slider-crank-limits", data, "theta, K, H, alpha_max, gamma_min")


def bar_swings(solution: Solution) -> str:
    """The swing of a guide bar whose line passes C at e, as tangents of the crank circle."""
    design = solution.problem.design
    a, d, e = (1e3 * getattr(design, key).si for key in ("AB", "AC", "e"))
    if a + e > d:
        return ""  # it turns right round
    return off("psi", solution.answers["psi"].drawn, degrees(asin((a + e) / d) + asin((a - e) / d)))


@family("design-guide-limits", also=bar_swings)
def guide_limits(rng: np.random.Generator) -> str:
    """Limit positions of a guide bar with an offset."""
    data = {"AB": f"{rng.integers(10, 80)} mm", "AC": f"{rng.integers(30, 140)} mm", "e": f"{rng.integers(0, 40)} mm"}
    return task("guide-bar-limits", data, "theta, K, psi, alpha_max, gamma_min")


def shapes(solution: Solution) -> str:
    """AC and CD of a shaper from θ: tangents to the crank circle, chord of the arc."""
    design, found = solution.problem.subject, solution.answers
    assert isinstance(design, Shaper)
    theta = radians(found["theta"].drawn)
    crank = 1e3 * design.AB.si if design.AB is not None else found["AB"].drawn
    wrong = off("AC sin(θ/2)", found["AC"].drawn * cos(np.pi / 2 - theta / 2), crank)
    wrong = wrong or off("CD", 2 * found["CD"].drawn * cos(np.pi / 2 - theta / 2), 1e3 * design.H.si)
    return wrong or ("" if design.DE is None else _ram(design, found["CD"].drawn, found["h"].drawn, theta))


def _ram(design: Shaper, lever: float, height: float, theta: float) -> str:
    """Led by small steps of the lever from limit to limit, the ram must go one way and as far as H."""
    assert design.DE is not None
    at = lever * np.exp(1j * (np.pi / 2 + np.linspace(theta / 2, -theta / 2, 2001)))
    ram = at.real + np.sqrt((1e3 * design.DE.si) ** 2 - (height - at.imag) ** 2)
    back = float(np.diff(ram).min())
    if not back > -1e-6 * lever:
        return f"the ram goes back by {-back:.3g} mm before the lever does"
    return off("H of the ram", float(ram[-1] - ram[0]), 1e3 * design.H.si)


@family("design-shaper", also=shapes)
def shaper(rng: np.random.Generator) -> str:
    """A swinging guide with a ram, from K, stroke and crank."""
    data = {
        "K": f"{round(float(rng.choice([rng.uniform(1.05, 2.5), rng.uniform(2.5, 12)])), 2)}",
        "H": f"{rng.integers(100, 500)} mm",
        "AB": f"{rng.integers(30, 150)} mm",
        "DE": f"{rng.integers(40, 200)} mm",
    }
    return task("shaper", data, "theta, AC, CD, h, alpha_max")


def bar_turns(solution: Solution) -> str:
    """K and H of a bar that turns right round: B on the line of the slider twice, and a rod that reaches it always."""
    design, found = solution.problem.subject, solution.answers
    assert isinstance(design, Whitworth)
    crank = 1e3 * design.AB.si if design.AB is not None else found["AB"].drawn
    quick, arm = 2 * acos(found["AC"].drawn / crank), found["CD"].drawn
    if design.DE is not None and 1e3 * design.DE.si <= arm:
        return f"the rod of {design.DE.text} does not reach the slider's line from D at {arm:.4g} mm"
    return off("K", (2 * np.pi - quick) / quick, design.K.si) or off("H", 2 * arm, 1e3 * design.H.si)


@family("design-whitworth", also=bar_turns)
def whitworth(rng: np.random.Generator) -> str:
    """Whitworth's quick return from K, stroke and crank."""
    data = {
        "K": f"{round(float(rng.uniform(1.05, 2.6)), 2)}",
        "H": f"{rng.integers(80, 500)} mm",
        "AB": f"{rng.integers(50, 200)} mm",
        "DE": f"{rng.integers(100, 500)} mm",
    }
    return task("whitworth", data, "theta, AC, CD")
