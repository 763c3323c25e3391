"""Crank-rockers from the ratio K in every form of the data, from limit lines; limit positions of given ones."""

from __future__ import annotations

from collections.abc import Iterator
from math import acos, degrees, radians, sin

import numpy as np

from vecpoly.designs.crank_rocker import CrankRocker
from vecpoly.solution import Solution

from ..family import family
from .written import first, off, task, valid


def limits_of(a: float, b: float, c: float, d: float) -> tuple[float, float]:
    """θ and the swing (deg) of a crank-rocker by the law of cosines in both limit triangles."""
    at_a = [acos(_bound((d * d + s * s - c * c) / (2 * d * s))) for s in (b - a, b + a)]
    at_d = [acos(_bound((d * d + c * c - s * s) / (2 * d * c))) for s in (b - a, b + a)]
    return degrees(abs(at_a[1] - at_a[0])), degrees(abs(at_d[1] - at_d[0]))


def _bound(cosine: float) -> float:
    return max(-1.0, min(1.0, cosine))


def swings_as_asked(solution: Solution) -> str:
    """Every solution has the θ and the swing that are given."""
    design = solution.problem.subject
    assert isinstance(design, CrankRocker)
    return first(_against(solution, degrees(design.theta), design))


def _against(solution: Solution, theta: float, design: CrankRocker) -> Iterator[str]:
    for one in valid(solution):
        v = one.values
        found, swing = limits_of(v["AB"], v["BC"], v["CD"], v["AD"])
        flat = 1e-4  # a limit triangle that is nearly flat has no digits left
        yield "" if abs(found - theta) < flat else off("theta", found, theta)
        if design.swing is not None:
            yield "" if abs(swing - degrees(design.swing.si)) < flat else off("swing", swing, degrees(design.swing.si))


@family("design-crank-rocker", also=swings_as_asked, often=3)
def crank_rocker(rng: np.random.Generator) -> str:
    """K and swing with one more datum of any sort; or K with a limit position."""
    cd, swing = float(rng.integers(40, 120)), float(rng.integers(15, 100))
    k = round(float(rng.uniform(1.0, 1.9)), 2)
    data = {"K": f"{k}", "CD": f"{cd:g} mm", "swing": f"{swing:g} deg"}
    chord = 2 * cd * sin(radians(swing) / 2)
    more = {
        "AD": f"{rng.integers(20, 200)} mm",
        "AB": f"{round(float(rng.uniform(0.05, 0.6)) * chord, 1)} mm",
        "BC": f"{round(float(rng.uniform(0.3, 3.0)) * chord, 1)} mm",
        "gamma_min": f"{rng.integers(10, 60)} deg",
        "A": f"on y = {rng.integers(-60, 120)} mm",
        "best": "gamma_min",
    }
    key = str(rng.choice(list(more)))
    if rng.random() < 0.2:
        data = {
            "K": f"{k}",
            "CD": f"{cd:g} mm",
            "AD": f"{rng.integers(40, 200)} mm",
            "ADC": f"{rng.integers(20, 160)} deg",
        }
        return task("crank-rocker", data, "theta, AB, BC, psi")
    if key == "AD" and rng.random() < 0.15:
        more[key] = data["CD"]  # the arc about D passes through C₁
    return task("crank-rocker", data | {key: more[key]}, "theta, AB, BC, AD, gamma_min")


def limits_found(solution: Solution) -> str:
    """θ of the given four-bar."""
    design = solution.problem.subject
    a, b, c, d = (getattr(design, key).si for key in ("AB", "BC", "CD", "AD"))
    theta, swing = limits_of(a, b, c, d)
    answers = solution.answers
    return off("theta", answers["theta"].drawn, theta) or off("psi", answers["psi"].drawn, swing)


@family("design-rocker-limits", also=limits_found)
def rocker_limits(rng: np.random.Generator) -> str:
    """Limit positions of any four bars with a crank, now and then of four without."""
    shortest, middle, more = int(rng.integers(15, 60)), int(rng.integers(60, 120)), int(rng.integers(60, 120))
    longest = middle + more - shortest - (int(rng.integers(1, 40)) if rng.random() < 0.85 else -5)
    rest = rng.permutation([middle, more, longest])
    data = {"AB": f"{shortest} mm"} | {key: f"{x} mm" for key, x in zip(("BC", "CD", "AD"), rest, strict=True)}
    return task("crank-rocker-limits", data, "theta, K, psi, gamma_min")


@family("design-limit-lines")
def limit_lines(rng: np.random.Generator) -> str:
    """Both limit lines of the coupler and a pressure angle."""
    x, y = rng.integers(10, 60), rng.integers(-25, 25)
    data = {
        "C1": '"(0, 0) mm"',
        "line_1": f"{rng.integers(200, 340)} deg",
        "C2": f'"({x}, {y}) mm"',
        "line_2": f"{rng.integers(200, 340)} deg",
        "alpha_1": f"{rng.integers(5, 70)} deg",
    }
    return task("limit-lines", data, "theta, AB, BC, CD, AD, psi, gamma_min")


@family("design-grashof")
def grashof(rng: np.random.Generator) -> str:
    """Four bars, of any type."""
    ab = int(rng.integers(10, 120))
    data = {"AB": f"{ab} mm"} | {key: f"{ab + rng.integers(0, 200)} mm" for key in ("BC", "CD", "AD")}
    return task("grashof", data, "ends, middle, CD_min, CD_max")
