"""Chains of stages with the limits of a rocker, and with a ray from the pin of a slider; a third party lays out all."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from vecpoly.solution import Solution

from ..designed.written import first, off
from ..family import family
from ..library import data_of
from .stages import Random, angles, lengths_of, pivot, ray, spot, task

NEAR = 1e-6  # mm on paper, or rad


def in_both_limits(solution: Solution) -> str:
    """The crank in one line with the coupler in both limits, θ between them from K, C as far from D in both; what hangs
    on the rocker keeps its length."""
    data = data_of(solution.problem.text)["data"]
    if "F" in data.get("points", {}):
        for one in solution.construction.candidates:
            kept = [abs(one.pins[f"F{n}"] - one.pins[f"E{n}"]) for n in (1, 2)]
            turns = [(one.pins[f"E{n}"] - one.pins["D"]) / (one.pins[f"C{n}"] - one.pins["D"]) for n in (1, 2)]
            if abs(kept[0] - kept[1]) > NEAR * max(kept) or abs(turns[0] - turns[1]) > NEAR * abs(turns[0]):
                return f"candidate {one.number}: EF is {kept}, E by C {turns}"
    if solution.construction.conclusion is not None:
        return ""
    return first(iter(_limits(data, lengths_of(solution))))


def _limits(data: Mapping[str, Any], found: dict[str, float]) -> list[str]:
    a, d = spot(data["frame"]["A"]), spot(data["frame"]["D"])
    step = data["stages"][0]
    c1, k = spot(step["first"]), float(step["K"])
    near, far = sorted((abs(found["AB"] - found["BC"]), found["AB"] + found["BC"]))
    here, there = (near, far) if abs(abs(c1 - a) - near) < abs(abs(c1 - a) - far) else (far, near)
    theta = np.pi * (k - 1) / (k + 1)
    ends = [a + there * (c1 - a) / abs(c1 - a) * np.exp(1j * sign * theta) for sign in (1, -1)]
    sense = 1 if step["limit"] == "left" else -1
    other = [end for end in ends if off("CD", abs(end - d), found["CD"]) == "" and sense * (end - c1).real > 0]
    return [
        off("AC1", abs(c1 - a), here),
        off("CD", found["CD"], abs(c1 - d)),
        "" if other else f"no other limit that makes C1 the {step['limit']} one",
    ]


@family("keys-stages-limits", also=in_both_limits, often=3)
def limits(rng: Random) -> str:
    """The other limit of a rocker, and its crank, from K and one limit; in some a slider hangs on the rocker."""
    x, y = int(rng.integers(60, 400)), int(rng.integers(-300, 300))
    step = {
        "limits": "C",
        "on": "DC",
        "crank": "AB",
        "K": f"{rng.uniform(1.02, 1.6):.3f}",
        "first": f"({x}, {y}) mm",
        "limit": str(rng.choice(["left", "right"])),
    }
    data: dict[str, Any] = {"frame": {"A": ["0 mm", "0 mm"], "D": pivot(rng)}, "rays": {}, "stages": [step]}
    if rng.random() < 0.5:
        h, places = int(rng.integers(-400, 400)), [int(one) for one in rng.choice(800, 2, replace=False)]
        data["points"] = {"F": [f"({at}, {h}) mm" for at in places]}
        data["stages"].append({"find": "E", "on": "DC", "from": "F"})
        return task(data, ["AB", "BC", "CD", "EF"])
    return task(data | {"rays": {"DE": angles(rng, 2)}}, ["AB", "BC", "CD"])


def on_its_ray(solution: Solution) -> str:
    """B turns with the coupler about the slider's pin, is as far from A in both positions, and on the line asked."""
    data = data_of(solution.problem.text)["data"]
    step = data["stages"][0]
    rays = [ray(one) for one in data["rays"]["CI"]]
    for one in solution.construction.candidates:
        pins, a = one.pins, one.pins["A"]
        b, c = [pins.get(f"B{n}", pins.get("B", 0j)) for n in (1, 2)], [pins["C1"], pins["C2"]]
        size = max(abs(at - a) for at in (*b, *c))
        turned = [(b[n] - c[n]) / rays[n] for n in range(2)]
        n = int(step.get("onto", 1)) - 1
        way = c[n] - a if "line" in step else rays[n]
        aside = (way.conjugate() * (b[n] - c[n])).imag / abs(way)
        if max(abs(turned[0] - turned[1]), abs(abs(b[0] - a) - abs(b[1] - a)), abs(aside)) > NEAR * size:
            return f"candidate {one.number}: B {b}, C {c}"
    return ""


@family("keys-stages-slider", also=on_its_ray, often=2)
def slider(rng: Random) -> str:
    """A slider and its coupler in two positions: the crank is sought, B on the ray of the coupler or on the line AC."""
    h, places = int(rng.integers(-60, 60)), [int(one) for one in rng.choice(200, 2, replace=False)]
    step = {"find": "B", "on": "CI", "from": "A"} | ({"line": "AC"} if rng.random() < 0.5 else {})
    if rng.random() < 0.6:
        step["onto"] = str(rng.integers(1, 3))
    data = {
        "frame": {"A": ["0 mm", "0 mm"]},
        "points": {"C": [f"({at}, {h}) mm" for at in places]},
        "rays": {"CI": angles(rng, 2)},
        "stages": [step],
    }
    return task(data, ["AB", "BC"])
