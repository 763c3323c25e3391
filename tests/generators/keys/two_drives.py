"""Five-bars with two drives: where two circles about turning pins meet tells all of it, and differences its rates."""

from __future__ import annotations

import json

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from .loads import number

Random = np.random.Generator
STEP = 1e-4  # s
OFFSETS = np.array([-2.0, -1.0, 0.0, 1.0, 2.0])
FIRST, SECOND = np.array([1.0, -8.0, 0.0, 8.0, -1.0]) / 12, np.array([-1.0, 16.0, -30.0, 16.0, -1.0]) / 12
CLOSE = 1e-5


def by_circles(solution: Solution) -> str:
    """p, v and a of C from five times, both cranks turning as is said."""
    data = data_of(solution.problem.text)
    t, pins = STEP * OFFSETS, []
    for drive, (name, pivot) in zip(data["input"], (("AB", 0j), ("DE", None)), strict=True):
        said = {
            {"φ": "phi", "ω": "omega", "n": "omega", "α": "alpha"}.get(key, key): text for key, text in drive.items()
        }
        rate = number(said["omega"]) * (np.pi / 30 if "r/min" in said["omega"] else 1.0)
        angle = np.radians(number(said["phi"])) + rate * t + number(said["alpha"]) * t * t / 2
        at = number(data["frame"]["D"][0]) if pivot is None else 0.0
        pins.append(at + number(data["links"][drive["link"]][name]) * np.exp(1j * angle))
    b, e = pins
    r, s, span = number(data["links"]["2"]["BC"]), number(data["links"]["3"]["EC"]), np.abs(e - b)
    along = (r * r - s * s + span * span) / (2 * span)
    side = 1 if "left" in data["branch"][0] else -1
    c = (b + (e - b) / span * (along + 1j * side * np.sqrt(r * r - along**2))) * 1e-3
    wanted = {"p_C": c[2], "v_C": c @ FIRST / STEP, "a_C": c @ SECOND / STEP**2}
    for key, value in wanted.items():
        found = solution.answers[key].exact_vector
        if found is None or abs(found - value) > CLOSE * max(1.0, abs(value)):
            return f"{key} is {found}, by circles {value}"
    return ""


@family("keys-two-drives", also=by_circles, often=2)
def two_drives(rng: Random) -> str:
    """Both cranks turn, the keys of either as books write them."""
    drives = []
    for link in ("1", "4"):
        keys = [str(rng.choice(ways)) for ways in (("phi", "φ"), ("omega", "ω", "n"), ("alpha", "α"))]
        speed = f"{rng.choice([-40, 60, 90])} r/min" if keys[1] == "n" else f"{rng.choice([-8, 3, 6])} rad/s"
        told = (f"{rng.integers(0, 360)} deg", speed, f"{rng.integers(-9, 9)} rad/s^2")
        drives.append({"link": link} | dict(zip(keys, told, strict=True)))
    return json.dumps(
        {
            "id": "t",
            "title": "t",
            "frame": {"A": ["0 mm", "0 mm"], "D": [f"{rng.integers(120, 200)} mm", "0 mm"]},
            "links": {
                "1": {"AB": f"{rng.integers(30, 60)} mm"},
                "2": {"BC": f"{rng.integers(180, 240)} mm"},
                "3": {"EC": f"{rng.integers(180, 240)} mm"},
                "4": {"DE": f"{rng.integers(30, 60)} mm"},
            },
            "input": drives,
            "branch": [f"C {rng.choice(['left', 'right'])} of BE"],
            "find": ["p_C", "v_C", "a_C", "omega_2", "alpha_3"],
        },
        ensure_ascii=False,
    )
