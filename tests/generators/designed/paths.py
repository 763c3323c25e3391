"""Straight parts of coupler curves, and linkages found pin after pin; third parties walk along the curve, and lay the
lengths that were found into every position."""

from __future__ import annotations

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from .written import first, off, task

Random = np.random.Generator
PLACES = 20_001


def path_of(solution: Solution) -> str:
    """Length and width of the path between the two angles of the crank, from twenty thousand places."""
    given = {key: float(value) for key, value in (part.split("=") for part in _told(solution))}
    phi = np.radians(np.linspace(given["low"], given["high"], PLACES))
    b = given["AB"] * np.exp(1j * phi)
    way = given["AD"] - b
    along = (abs(way) ** 2 + given["BC"] ** 2 - given["CD"] ** 2) / (2 * abs(way))
    high = np.sqrt(np.maximum(given["BC"] ** 2 - along**2, 0.0))
    c = b + way / abs(way) * (along + 1j * given["side"] * high)
    e = b + (c - b) / given["BC"] * complex(given["x"], given["y"])
    for key, true in (("L", float(np.ptp(e.real))), ("delta", float(np.ptp(e.imag)))):
        found = solution.answers[key].exact * (1e3 if solution.answers[key].reading.unit == "m" else 1.0)
        if abs(found - true) > 1e-5 * max(true, 1.0):
            return f"{key} = {found}, but {true} mm along the path"
    return ""


def _told(solution: Solution) -> list[str]:
    assert solution.problem.source is not None
    return str(solution.problem.source.en).split()


@family("design-straight-line", also=path_of, often=1)
def straight_line(rng: Random) -> str:
    """Any crank-rocker, any coupler point, any part of the turn."""
    ab = int(rng.integers(20, 60))
    bc, cd = (int(rng.integers(2 * ab, 4 * ab)) for _ in range(2))
    ad = int(rng.integers(abs(bc - cd) + ab + 3, bc + cd - ab - 3))
    x, y = (int(rng.integers(-120, 200)) for _ in range(2))
    low = int(rng.integers(0, 300))
    high, side = low + int(rng.integers(10, 300)), str(rng.choice(["left", "right"]))
    data = {
        "AB": f"{ab} mm",
        "BC": f"{bc} mm",
        "CD": f"{cd} mm",
        "AD": f"{ad} mm",
        "E": f"[{x} mm, {y} mm]",
        "side": side,
        "phi": f"[{low} deg, {high} deg]",
    }
    told = {"AB": ab, "BC": bc, "CD": cd, "AD": ad, "x": x, "y": y, "low": low, "high": high}
    told["side"] = 1 if side == "left" else -1
    source = " ".join(f"{key}={value}" for key, value in told.items())
    return f"{task('straight-line', data, 'L, delta')}source: {source}\n"


def both_positions(solution: Solution) -> str:
    """C and B with the lengths found: CE and BC are what they should be in both positions."""
    if solution.construction.conclusion is not None:
        return ""
    given = {key: complex(value) for key, value in (part.split("=") for part in _told(solution))}
    scale = {"m": 1e3, "mm": 1.0}
    found = {key: one.exact * scale[one.reading.unit] for key, one in solution.answers.items()}
    ways = ((one, two) for one in (1, -1) for two in (1, -1))  # a pin may lie behind its pivot, against the ray
    told = [_misses(given, found, *way) for way in ways]
    return "" if "" in told else told[0]


def _misses(given: dict[str, complex], found: dict[str, float], ahead_b: int, ahead_c: int) -> str:
    misses = []
    for n in "12":
        c = given["D"] + ahead_c * found["DC"] * given[f"c{n}"]
        b = ahead_b * found["AB"] * given[f"b{n}"]
        misses += [off(f"CE in position {n}", abs(c - given[f"e{n}"]), found["CE"])]
        misses += [off(f"BC in position {n}", abs(c - b), found["BC"])]
    return first(iter(misses))


@family("design-stages", also=both_positions, often=3, first=6)
def stages(rng: Random) -> str:
    """A slider's two places give C on a ray of DC, and C gives B on a ray of AB."""
    d = complex(int(rng.integers(30, 150)), int(rng.integers(-40, 40)))
    phi, psi = ([int(x) for x in rng.integers(-170, 170, size=2)] for _ in range(2))
    e = [complex(int(rng.integers(60, 250)), int(rng.integers(-60, 60))) for _ in range(2)]
    data = {
        "frame": f"{{A: [0 mm, 0 mm], D: [{d.real:g} mm, {d.imag:g} mm]}}",
        "rays": f"{{AB: [{phi[0]} deg, {phi[1]} deg], DC: [{psi[0]} deg, {psi[1]} deg]}}",
        "points": "{E: [" + ", ".join(f'"({place.real:g}, {place.imag:g}) mm"' for place in e) + "]}",
        "stages": "[{find: C, on: DC, from: E}, {find: B, on: AB, from: C}]",
    }
    told = {"D": d} | {f"e{n}": place for n, place in enumerate(e, 1)}
    for name, angles in (("b", phi), ("c", psi)):
        told |= {f"{name}{n}": complex(np.exp(1j * np.radians(angle))) for n, angle in enumerate(angles, 1)}
    source = " ".join(f"{key}={value!r}".replace("(", "").replace(")", "") for key, value in told.items())
    return f"{task('stages', data, 'DC, CE, AB, BC')}source: {source}\n"
