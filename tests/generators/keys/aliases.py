"""Keys by their other names: φ, ω, α and n of the input, m, J, J_S and S of masses, φ and ρ of friction, `method:
polygons`, `inertia: yes` where nothing need be said. The answers are the original's."""

from __future__ import annotations

from typing import Any

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from ..retold.original import Change, compared, original, told

OTHERWISE = {
    "input": {"phi": "φ", "omega": "ωn", "alpha": "α"},
    "masses": {"mass": "m", "inertia": ("J", "J_S"), "centre": "S"},
    "friction": {"phi": "φ", "rho": "ρ"},
}
BURDENED = ("forces-masses", "forces-friction", "forces-written", "four-bar", "linkage-rpr", "forces-laws-friction")


def unchanged(solution: Solution) -> str:
    """The answers are the original's."""
    return compared(solution, Change())


def _renamed(rng: np.random.Generator, part: str, value: Any) -> Any:
    """Some of the keys of a part, at any depth where a part has entries of their own, by another name."""
    names = OTHERWISE[part]
    if part == "input":
        if isinstance(value, list):
            return [_renamed(rng, part, one) for one in value]
        return {_other(rng, names, key): inner for key, inner in value.items()}
    return {name: {_other(rng, names, key): inner for key, inner in one.items()} for name, one in value.items()}


def _other(rng: np.random.Generator, names: Any, key: str) -> str:
    ways = tuple(names.get(key, ()))
    return str(rng.choice(ways)) if ways and rng.random() < 0.8 else key


@family("keys-aliases", also=unchanged, often=2)
def aliases(rng: np.random.Generator) -> str:
    """A member of another family with the letters of books for keys."""
    mark, text = original(rng, BURDENED)
    data = data_of(text)
    data |= {part: _renamed(rng, part, data[part]) for part in OTHERWISE if part in data}
    if rng.random() < 0.5:
        data["method"] = "polygons"
    if "masses" in data and "inertia" not in data and rng.random() < 0.5:
        data["inertia"] = "yes"
    return told(data, mark)
