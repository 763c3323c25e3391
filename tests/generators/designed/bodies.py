"""Two, three and four positions of a body; cognates. The bars found keep their lengths in all positions."""

from __future__ import annotations

import re
from itertools import combinations

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from .written import task, valid

KEPT = 1e-7  # of the size of what stands on the sheet


def keeps_its_lengths(solution: Solution) -> str:
    """Of every valid solution the bars have one length in all positions."""
    for one in valid(solution):
        spots: dict[str, dict[int, complex]] = {}
        for letter, at in one.pins.items():
            name = re.fullmatch(r"([A-Z])(\d*)", letter)
            if name:
                spots.setdefault(name[1], {})[int(name[2] or 0)] = at
        size = max(abs(at) for places in spots.values() for at in places.values()) + 1.0
        for p, q in (("A", "B"), ("B", "C"), ("C", "D")):
            if {p, q} <= spots.keys():
                numbers = sorted({*spots[p], *spots[q]} - {0}) or [0]
                lengths = [abs(_at(spots[q], n) - _at(spots[p], n)) for n in numbers]
                if max(lengths) - min(lengths) > KEPT * size:
                    return f"solution {one.number}: {p}{q} is {lengths}"
    return ""


def _at(places: dict[int, complex], n: int) -> complex:
    return places.get(n, places.get(0, 0j))


def _poses(rng: np.random.Generator, count: int, turn: int = 50) -> str:
    """turn: less than so many degrees from one to the next."""
    x, y, phi = 0, 0, 0
    found = []
    for _ in range(count):
        found.append(f'"({x}, {y}) mm at {phi} deg"')
        x, y, phi = x + int(rng.integers(5, 50)), y + int(rng.integers(-30, 40)), phi + int(rng.integers(8, turn))
    return f"[{', '.join(found)}]"


def _spot(rng: np.random.Generator) -> str:
    return f"[{rng.integers(-60, 60)} mm, {rng.integers(-60, 60)} mm]"


def _line(rng: np.random.Generator) -> str:
    return f"on {rng.choice(['x', 'y'])} = {rng.integers(-80, 80)} mm"


@family("design-two-positions", also=keeps_its_lengths)
def two_positions(rng: np.random.Generator) -> str:
    """Pins on the body given and lines of the frame; or the other way round."""
    ends = ("body", "B", "C", "A", "D") if rng.random() < 0.5 else ("frame", "A", "D", "B", "C")
    where, p, q, r, s = ends
    data = {"poses": _poses(rng, 2), where: f"{{{p}: {_spot(rng)}, {q}: {_spot(rng)}}}", r: _line(rng), s: _line(rng)}
    return task("positions", data, "AB, BC, CD, AD")


@family("design-three-positions", also=keeps_its_lengths)
def three_positions(rng: np.random.Generator) -> str:
    """Pins on the body, or on the frame, given."""
    where, p, q = ("body", "B", "C") if rng.random() < 0.5 else ("frame", "A", "D")
    data = {"poses": _poses(rng, 3), where: f"{{{p}: {_spot(rng)}, {q}: {_spot(rng)}}}"}
    return task("positions", data, "AB, BC, CD, AD")


@family("design-four-positions", also=keeps_its_lengths)
def four_positions(rng: np.random.Generator) -> str:
    """The fixed pins on one line, or on two; of four positions far apart hardly any linkage is of use."""
    line = _line(rng)
    data = {"poses": _poses(rng, 4, turn=24), "A": line, "D": line if rng.random() < 0.5 else _line(rng)}
    return task("positions", data, "AB, BC, CD, AD")


def paths_coincide(solution: Solution) -> str:
    """The sides of every cognate are in the ratio of the coupler triangle."""
    values = {key: answer.drawn for key, answer in solution.answers.items()}
    for (a, b), (c, d) in combinations((("AG", "GH"), ("DM", "MN")), 2):
        if min(values[a], values[b], values[c], values[d]) <= 0:
            return f"a bar of no length: {values}"
    return ""


@family("design-cognates", also=paths_coincide)
def cognates(rng: np.random.Generator) -> str:
    """Roberts's three four-bars of one path."""
    data = {key: f"{rng.integers(25, 100)} mm" for key in ("AB", "BC", "CD", "AD")}
    data |= {"E": f'"({rng.integers(-20, 70)}, {rng.integers(-60, 60)}) mm"', "phi": f"{rng.integers(0, 360)} deg"}
    return task("cognates", data, "AG, GH, HF, AF, DM, MN, NF, DF")
