"""Places in other words: right for left, a centre of mass by an angle, a round bar between other points, a rack at an
angle to its guide."""

from __future__ import annotations

from math import cos, pi, radians, sin, tan
from typing import Any

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from ..library import Data, data_of
from ..retold.original import Change, against, compared, original, told
from .loads import number
from .written import solved

SIDED = ("linkage-rpr", "linkage-rpp", "linkage-cam", "linkage-prp", "gears-rolling", "offset-slot-drives", "forces")


def unchanged(solution: Solution) -> str:
    """The answers are the original's."""
    return compared(solution, Change())


def _mirrored(rng: np.random.Generator, value: Any) -> Any:
    """Some offsets to the left as negative ones to the right, and the other way round."""
    if isinstance(value, list):
        return [_mirrored(rng, one) for one in value]
    if not isinstance(value, dict):
        return value
    found = {}
    for key, inner in value.items():
        if key in ("left", "right") and isinstance(inner, str) and rng.random() < 0.8:
            found[{"left": "right", "right": "left"}[key]] = inner[1:] if inner.startswith("-") else f"-{inner}"
        else:
            found[key] = _mirrored(rng, inner)
    return found


@family("keys-sides", also=unchanged, often=1)
def sides(rng: np.random.Generator) -> str:
    """A member of another family that has an offset, set out to the other side."""
    while True:
        mark, text = original(rng, SIDED)
        if "left:" in text or "right:" in text:
            data = data_of(text)
            return told(data | {"links": _mirrored(rng, data["links"])}, mark)


def by_offsets(solution: Solution) -> str:
    """With the centre set out along and across, and the bar's mass and inertia worked out, the answers are the same."""
    data = data_of(solution.problem.text)
    masses: Data = data["masses"]
    centre, length = masses["2"]["centre"], number(masses["2"]["centre"]["BS2"])
    angle = radians(number(centre["angle"]))
    at, left = length * cos(angle), length * sin(angle)
    rod, e = masses["3"]["rod"], data["links"]["3"]["E"]
    x, y = number(e["at"]), number(e["left"])
    pins = {"DC": complex(number(data["links"]["3"]["DC"])), "DE": complex(x, y)}
    ends = (0j, pins["DE"]) if rod["along"] == "DE" else (pins["DC"], pins["DE"])
    span, middle = abs(ends[1] - ends[0]) * 1e-3, sum(ends) / 2
    mass = number(rod["density"]) * pi * (number(rod["diameter"]) * 1e-3) ** 2 / 4 * span
    other = {
        "2": masses["2"] | {"centre": {"along": "BC", "at": f"{at!r} mm", "left": f"{left!r} mm"}},
        "3": {
            "mass": f"{mass!r} kg",
            "inertia": f"{mass * span**2 / 12!r} kg*m^2",
            "centre": {"along": "DC", "at": f"{middle.real!r} mm", "left": f"{middle.imag!r} mm"},
        },
    }
    return against(solution, solved(told(data | {"masses": other}, "other")), Change())


@family("keys-mass-places", also=by_offsets, often=2)
def mass_places(rng: np.random.Generator) -> str:
    """A four-bar; the coupler's centre by an angle, the rocker's bar between two points that are not its first."""
    a, b, c = rng.integers(60, 110), rng.integers(260, 420), rng.integers(250, 380)
    data = {
        "id": "t",
        "frame": {"A": ["0 mm", "0 mm"], "D": [f"{rng.integers(300, 380)} mm", "0 mm"]},
        "links": {
            "1": {"AB": f"{a} mm"},
            "2": {"BC": f"{b} mm"},
            "3": {
                "DC": f"{c} mm",
                "E": {"along": "DC", "at": f"{rng.integers(30, 200)} mm", "left": f"{rng.integers(-90, 90)} mm"},
            },
        },
        "input": {"link": "1", "phi": f"{rng.integers(0, 360)} deg", "omega": f"{rng.choice([-9, 6])} rad/s"},
        "branch": [f"C {rng.choice(['left', 'right'])} of BD"],
        "loads": {"M_1": {"on": "1", "size": "?"}},
        "masses": {
            "2": {
                "mass": "2 kg",
                "inertia": "0.01 kg*m^2",
                "centre": {
                    "BS2": f"{rng.integers(40, 150)} mm",
                    "angle": f"{rng.integers(-170, 170)} deg from {rng.choice(['BC', 'BC'])}",
                },
            },
            "3": {
                "rod": {
                    "diameter": f"{rng.integers(10, 40)} mm",
                    "density": "7800 kg/m^3",
                    "along": str(rng.choice(["DE", "CE"])),
                }
            },
        },
        "weight": str(rng.choice(["yes", "no"])),
        "find": ["M_1", "a_S2", "a_S3", "F_I2", "R_12", "R_43"],
    }
    return told(data, "mass-places")


def as_a_wedge(solution: Solution) -> str:
    """The wheel is lifted as by a wedge, and turns with what it covers on the slope."""
    data = data_of(solution.problem.text)
    slope = radians(number(data["links"]["1"]["rack"]["angle"]))
    v, a = number(data["input"]["v"]), number(data["input"]["a"])
    r = number(data["links"]["2"]["radius"]) * 1e-3 * (-1 if "right of" in data["joints"][2] else 1)
    wanted = {"v_C": -1j * v * tan(slope), "a_C": -1j * a * tan(slope)}
    wanted |= {"omega_2": v / (r * cos(slope)), "alpha_2": a / (r * cos(slope))}
    for key, value in wanted.items():
        answer = solution.answers[key]
        found = answer.exact if answer.exact_vector is None else answer.exact_vector
        if abs(found - value) > 1e-9 * max(1.0, abs(value)):
            return f"{key} is {found}, of a wedge {value}"
    return ""


@family("keys-inclined-rack", also=as_a_wedge, often=3)
def inclined_rack(rng: np.random.Generator) -> str:
    """A rack at an angle to the guide on which it slides lifts a wheel that rolls on it."""
    side, aside = str(rng.choice(["on", "right of"])), f"{rng.choice(['left', 'right'])}: {rng.integers(-40, 40)} mm"
    return f"""
id: rack
title: rack
frame: {{A: [0 mm, 0 mm]}}
links:
  1: {{block: P, rack: {{through: P, {aside}, angle: {rng.integers(5, 40) * rng.choice([-1, 1])} deg from line}}}}
  2: {{gear: C, radius: {rng.integers(20, 60)} mm}}
  3: {{block: C}}
joints: [1 slides on y = {rng.integers(-30, 30)} mm, 3 slides on x = {rng.integers(80, 160)} mm, 2 rolls {side} 1 at H]
input: {{link: 1, s: {rng.integers(-50, 50)} mm, v: {rng.choice([-0.3, 0.5])} m/s, a: {rng.choice([0, 2, -3])} m/s^2}}
find: [v_C, a_C, omega_2, alpha_2]
"""
