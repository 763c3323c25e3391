"""An unbalanced wheel that swings: a place that it comes by is told as it first does, another is refused."""

from __future__ import annotations

import json
from math import cos, radians, sqrt

import numpy as np

from vecpoly import loads
from vecpoly.check.truth import exact_values
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.loads import GRAVITY

from ..family import OnText, family
from ..library import data_of
from .loads import number

CLOSE = 1e-7


def as_a_pendulum(text: str) -> str:
    """By energy alone: how far it swings to either side, how fast it is at a place, and which way it first comes by."""
    data = data_of(text)
    run, mass, r = data["machine"], data["masses"]["1"], number(data["links"]["1"]["AB"]) * 1e-3
    m, inertia = number(mass["mass"]), number(mass["inertia"]) + number(mass["mass"]) * r * r
    at = radians(number(run["start"]["phi"]) + 90.0)  # from the lowest place
    omega = number(run["start"]["omega"])

    def square(way: float) -> float:
        return omega**2 - 2 * m * GRAVITY * r / inertia * (cos(at) - cos(at + way))

    sense = 1.0 if omega > 0 else -1.0
    wanted = {}
    for one in run["at"]:
        way = radians(number(one))
        for side in (sense, -sense):  # it turns back before it comes by on the other side
            if all(square(side * gone) > 0 for gone in np.linspace(0.0, way, 400)):
                wanted[f"omega_at_{one.removesuffix(' deg')}"] = side * sqrt(square(side * way))
                break
    return _told(data, wanted)


def _told(data: dict[str, object], wanted: dict[str, float]) -> str:
    for key in data["find"]:  # type: ignore[attr-defined]
        try:
            values = exact_values(loads(json.dumps(data | {"find": [key]})))
        except VecpolyError as error:
            if key in wanted:
                return f"{key} is {wanted[key]}, and refused: {error}"
            continue
        if key not in wanted:
            return f"{key} is {values[key]}, where it never comes"
        if abs(complex(values[key]).real - wanted[key]) > CLOSE * max(1.0, abs(wanted[key])):
            return f"{key} is {values[key]}, by energy {wanted[key]}"
    return ""


@family("keys-swinging", also=OnText(as_a_pendulum), often=2)
def swinging(rng: np.random.Generator) -> str:
    """From anywhere below, too slow to come over the top; places nearer and farther than it swings, one twice."""
    places = [f"{one} deg" for one in rng.integers(5, 150, size=3)]
    return json.dumps(
        {
            "id": "t",
            "title": "t",
            "frame": {"A": ["0 mm", "0 mm"]},
            "links": {"1": {"AB": f"{rng.integers(60, 300)} mm"}},
            "input": {"link": "1", "phi": "30 deg", "omega": "ccw"},
            "masses": {"1": {"mass": "4 kg", "inertia": f"{rng.uniform(0.01, 0.3):.3f} kg*m^2", "centre": "B"}},
            "weight": "yes",
            "machine": {
                "start": {
                    "phi": f"{rng.integers(-150, -30)} deg",
                    "omega": f"{rng.uniform(0.5, 3.5) * rng.choice([-1, 1]):.3f} rad/s",
                },
                "at": [*places, places[0]],
                "until": "170 deg",
            },
            "find": [f"omega_at_{one.removesuffix(' deg')}" for one in dict.fromkeys(places)],
        }
    )
