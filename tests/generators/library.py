"""Every problem of the library with its sizes changed a little: whatever a file may say, somebody says it there."""

from __future__ import annotations

import json
import re
from functools import lru_cache
from typing import Any

import numpy as np
from ruamel.yaml import YAML

from vecpoly.foundation.data import data_dir
from vecpoly.solution import Solution

from .acting.laws import balanced_by_hand
from .family import family

Data = dict[str, Any]  # every scalar as its text
QUANTITY = re.compile(
    r"(?<![\w.])(-?\d+(?:\.\d+)?) "
    r"(mm|cm|m|deg|rad/s\^2|rad/s|r/min|m/s\^2|m/s|N\*m|N\*mm|N|kN|kg|kg\*m\^2|kW)(?![\w/*^])"
)
_SIZED = ("frame", "links", "joints", "input", "loads", "friction", "masses", "data")


def data_of(text: str) -> Data:
    """The values of a problem file, every scalar as its text."""
    return dict(YAML(typ="base", pure=True).load(text))


@lru_cache(maxsize=1)
def problems() -> dict[str, Data]:
    """Id → data, what they extend taken over; what is printed in books, and tables, left out."""
    read = [data_of(path.read_text(encoding="utf-8")) for path in sorted(data_dir("problems").rglob("*.yaml"))]
    known = {str(data["id"]): data for data in read if "id" in data}
    return {
        name: {
            key: value
            for key, value in _whole(data, known).items()
            if key not in ("printed", "errata", "tables", "scales")
        }
        for name, data in known.items()
    }


def _whole(data: Data, known: dict[str, Data]) -> Data:
    if "extends" not in data:
        return data
    rest = {key: value for key, value in data.items() if key != "extends"}
    return over(_whole(known[str(data["extends"])], known), rest)


def over(old: Data, new: Data) -> Data:
    """Mappings are joined, everything else is replaced, null takes away: what `extends` promises."""
    joined = dict(old)
    for key, value in new.items():
        if value in ("null", ""):
            joined.pop(key, None)
        else:
            joined[key] = over(old[key], value) if isinstance(value, dict) and isinstance(old.get(key), dict) else value
    return joined


def varied(rng: np.random.Generator, value: Any, share: float) -> Any:
    """A tree of texts, its quantities changed by up to this share."""
    match value:
        case dict():
            return {key: varied(rng, inner, share) for key, inner in value.items()}
        case list():
            return [varied(rng, inner, share) for inner in value]
        case str():
            return QUANTITY.sub(lambda m: f"{float(m[1]) * rng.uniform(1 - share, 1 + share):.6g} {m[2]}", value)
        case _:
            return value


def different(rng: np.random.Generator, data: Data) -> Data:
    """All sizes a little different; or only the drive's place, or the loads, much."""
    match int(rng.integers(4)):
        case 0:
            return data | {key: varied(rng, data[key], 0.01) for key in _SIZED if key in data}
        case 1:
            return data | {key: varied(rng, data[key], 0.1) for key in _SIZED if key in data}
        case 2 if "input" in data:
            return data | {"input": varied(rng, data["input"], 0.5)}
        case _:
            return data | {
                key: varied(rng, data[key], 0.6) for key in ("loads", "friction", "masses", "data") if key in data
            }


def right_forces(solution: Solution) -> str:
    """Bodies in equilibrium, where forces were found, springs and loads by a law with them."""
    return (
        balanced_by_hand(solution)
        if "forces" in solution.as_json() and getattr(solution.problem, "loads", None) is not None
        else ""
    )


@family("library", also=right_forces, often=4, first=3)
def library(rng: np.random.Generator) -> str:
    """One of them."""
    known = problems()
    name = list(known)[int(rng.integers(len(known)))]
    return json.dumps(different(rng, known[name]), ensure_ascii=False, indent=1)
