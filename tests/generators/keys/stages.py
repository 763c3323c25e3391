"""Chains of stages of every sort: three positions, a line of two known pins, a position in which the link is kept, a
pin joined by two bars. The third party lays what was found into
every position with formulas of its own."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from vecpoly.solution import Solution

from ..designed.written import first, off
from ..family import family
from ..library import data_of

Random = np.random.Generator
STEPS, EDGE = 2001, 1e-4  # EDGE: mm on paper
UNITS = {"m": 1e3, "mm": 1.0, "deg": float(np.pi / 180)}


def lengths_of(solution: Solution) -> dict[str, float]:
    """Lengths in mm, angles in rad."""
    return {key: float(one.exact) * UNITS.get(one.reading.unit, 1.0) for key, one in solution.answers.items()}


def ray(degrees: str) -> complex:
    return complex(np.exp(1j * np.radians(float(degrees.removesuffix(" deg")))))


def spot(text: Any) -> complex:
    """A place as it is written here: [30 mm, 0 mm], or (30, 0) mm."""
    if isinstance(text, list):
        x, y = (float(one.removesuffix(" mm")) for one in text)
    else:
        x, y = (float(one) for one in text.removesuffix(" mm").strip("()").split(","))
    return complex(x, y)


def task(data: Mapping[str, Any], find: list[str]) -> str:
    return json.dumps({"id": "t", "title": "t", "synthesis": "stages", "data": data, "find": find})


def angles(rng: Random, count: int, step: int = 60, back: float = 0.0) -> list[str]:
    """back: how often a link turns back from one position to the next."""
    low, way = int(rng.integers(-170, 170)), int(rng.choice([-1, 1]))
    found = [low]
    for _ in range(count - 1):
        found.append(found[-1] + way * (-1 if rng.random() < back else 1) * int(rng.integers(8, step)))
    return [f"{angle} deg" for angle in found]


def pivot(rng: Random) -> list[str]:
    return [f"{rng.integers(40, 200)} mm", f"{rng.integers(-60, 60)} mm"]


def three_positions(solution: Solution) -> str:
    """CE keeps its length in all three positions, and so does BC; what serves goes from one to the next, the other does
    not."""
    turned = [float(one.removesuffix(" deg")) for one in data_of(solution.problem.text)["data"]["rays"]["AB"]]
    for one in solution.construction.candidates:
        told = {_slid(one.pins, turned, sense) for sense in (1, -1)}
        if "edge" not in told and ("" in told) != (one.reason is None):
            return f"candidate {one.number} is {one.verdict}, but {'goes through' if '' in told else told}"
    if solution.construction.conclusion is not None:
        return ""
    data, found = data_of(solution.problem.text)["data"], lengths_of(solution)
    d, e = spot(data["frame"]["D"]), [spot(one) for one in data["points"]["E"]]
    c = [d + found["DC"] * ray(one) * np.exp(1j * found["delta_C"]) for one in data["rays"]["DC"]]
    b = [found["AB"] * ray(one) * np.exp(1j * found["delta_B"]) for one in data["rays"]["AB"]]
    misses = [off(f"CE in position {n}", abs(c[n] - e[n]), found["CE"]) for n in range(3)]
    return first(iter([*misses, *(off(f"BC in position {n}", abs(b[n] - c[n]), found["BC"]) for n in range(3))]))


@family("keys-stages-three", also=three_positions, often=2, first=9)
def three(rng: Random) -> str:
    """Three positions of a slider, a rocker and a crank: the pins follow, on no ray."""
    start, turn = complex(*(int(one) for one in rng.integers(-60, 220, size=2))), ray(str(rng.choice([0, 90, 30])))
    e = [start + step * turn for step in (0, int(rng.integers(8, 60)), int(rng.integers(62, 120)))]
    data = {
        "frame": {"A": ["0 mm", "0 mm"], "D": pivot(rng)},
        "rays": {"AB": angles(rng, 3), "DC": angles(rng, 3, back=0.3)},
        "points": {"E": [f"({at.real!r}, {at.imag!r}) mm" for at in e]},
        "stages": [{"find": "C", "on": "DC", "from": "E"}, {"find": "B", "on": "AB", "from": "C"}],
    }
    return task(data, ["DC", "CE", "AB", "BC", "delta_C", "delta_B"])


def _circles(p: complex, r: float, q: complex, s: float, side: str) -> complex:
    """The point at r from p and at s from q, on this side of the ray from p to q."""
    span = abs(q - p)
    along = (r * r - s * s + span * span) / (2 * span)
    high = np.sqrt(max(r * r - along * along, 0.0)) * (1 if side == "left" else -1)
    return complex(p + (q - p) / span * complex(along, high))


def _slid(pins: Mapping[str, complex], phi: list[float], sense: int) -> str:
    """What keeps AB, turned this way in small steps, from leading C and the slider E through all three positions."""
    a, d, c, e = (pins[key] for key in ("A", "D", "C1", "E1"))
    b, way = pins["B1"], pins["E2"] - pins["E1"]
    gone = np.cumsum([0.0, *((sense * np.diff(phi)) % 360.0)])
    turn = np.exp(1j * sense * np.linspace(0.0, np.radians(gone[-1]), 3 * STEPS))
    path, spare = _dyad(a + (b - a) * turn, abs(c - b), d, abs(c - d), c)
    left = abs(e - c) - float(np.abs(((path - e) / way).imag * abs(way)).max())
    if min(abs(spare), abs(left)) < EDGE:
        return "edge"
    if min(spare, left) < 0:
        return "a dead point"
    there = path[[round(share * (3 * STEPS - 1)) for share in gone / gone[-1]]]
    near = max(abs(there[n] - pins[f"C{n + 1}"]) for n in range(3)) < 0.01 * abs(c - d)
    ahead = {np.sign(((pins[f"E{n}"] - pins[f"C{n}"]) / way).real) for n in (1, 2, 3)}
    return "" if near and len(ahead) == 1 and gone[-1] < 360.0 else "another place"


def _led(pins: Mapping[str, complex], phi: list[float]) -> str:
    """What keeps AB, turned in small steps, from leading C and E from position 1 to position 2; "" where nothing does,
    "edge" where a dead point is so near that steps cannot tell."""
    a, d, f, b, c, e = (pins[key] for key in ("A", "D", "F", "B1", "C1", "E1"))
    turn = np.exp(1j * np.linspace(0.0, np.radians(phi[1] - phi[0]), STEPS))
    first, spare = _dyad(a + (b - a) * turn, abs(c - b), d, abs(c - d), c)
    second, left = _dyad(first, abs(e - c), f, abs(e - f), e)
    if min(abs(spare), abs(left)) < EDGE:
        return "edge"
    if min(spare, left) < 0:
        return "a dead point"
    return "" if abs(second[-1] - pins["E2"]) < EDGE and abs(first[-1] - pins["C2"]) < EDGE else "another place"


def _dyad(p: Any, r: float, q: complex, s: float, start: complex) -> tuple[Any, float]:
    """The pin at r from a moving p and at s from a fixed q, on the side on which it starts; what is left to the next
    dead point (mm), below zero where it is passed."""
    span = np.abs(q - p)
    left = min(float((r + s - span).min()), float((span - abs(r - s)).min()))
    along = (r * r - s * s + span * span) / (2 * span)
    side = np.sign(((q - p[0]).conjugate() * (start - p[0])).imag)
    return p + (q - p) / span * (along + 1j * side * np.sqrt(np.maximum(r * r - along**2, 0.0))), left


def joined(solution: Solution) -> str:
    """C by two circles in both positions; from it E on its ray, CE the same, and E on the line that is asked. What is
    rejected does not go through from position to position, and what serves does."""
    turned = [float(one.removesuffix(" deg")) for one in data_of(solution.problem.text)["data"]["rays"]["AB"]]
    for one in solution.construction.candidates:
        fault = _led(one.pins, turned)
        if fault != "edge" and (fault == "") != (one.reason is None):
            return f"candidate {one.number} is {one.verdict}, but {fault or 'goes through'}"
    if solution.construction.conclusion is not None:
        return ""
    data, found = data_of(solution.problem.text)["data"], lengths_of(solution)
    links = {key: float(text.removesuffix(" mm")) for key, text in data["links"].items()}
    d, f = spot(data["frame"]["D"]), spot(data["frame"]["F"])
    b = [links["AB"] * ray(one) for one in data["rays"]["AB"]]
    join, find = data["stages"]
    p, q = (b, [d, d]) if join["to"] == "BD" else ([d, d], b)
    r, s = (links["BC"], links["CD"]) if join["to"] == "BD" else (links["CD"], links["BC"])
    c = [_circles(*one) for one in zip(p, [r] * 2, q, [s] * 2, [join["side"]] * 2, strict=True)]
    told = []
    for sense in (1, -1) if "line" not in find else (1,):
        turn = np.exp(1j * found["delta_E"]) if "line" in find else sense
        e = [f + found["EF"] * ray(one) * turn for one in data["rays"]["FE"]]
        misses = [off(f"CE in position {n + 1}", abs(c[n] - e[n]), found["CE"]) for n in range(2)]
        if "line" in find:
            n = int(find.get("onto", 1)) - 1
            lie = {"A": 0j, "B": b[n], "C": c[n], "D": d}
            start, end = (lie[letter] for letter in find["line"])
            aside = ((end - start).conjugate() * (e[n] - start)).imag / abs(end - start)
            misses.append(off("aside of the line", 1 + aside / 100, 1.0))
        told.append(first(iter(misses)))
    return "" if "" in told else told[0]


@family("keys-stages-joined", also=joined, often=3)
def join(rng: Random) -> str:
    """A four-bar that is known, and a rocker that is hung on it; E on the ray of the rocker, or on a line of pins."""
    ab, bc, cd = int(rng.integers(30, 80)), int(rng.integers(90, 200)), int(rng.integers(80, 180))
    find: dict[str, str] = {"find": "E", "on": "FE", "from": "C"}
    if rng.random() < 0.6:
        find["onto"] = str(rng.integers(1, 3))
    if rng.random() < 0.5:
        find["line"] = str(rng.choice(["AC", "DC", "BC", "BD", "AD"]))
    data = {
        "frame": {"A": ["0 mm", "0 mm"], "D": pivot(rng), "F": pivot(rng)},
        "links": {"AB": f"{ab} mm", "BC": f"{bc} mm", "CD": f"{cd} mm"},
        "rays": {"AB": angles(rng, 2), "FE": angles(rng, 2)},
        "stages": [
            {"join": "C", "to": str(rng.choice(["BD", "DB"])), "side": str(rng.choice(["left", "right"]))},
            find,
        ],
    }
    return task(data, ["CE", "EF", *(["delta_E"] if "line" in find else [])])
