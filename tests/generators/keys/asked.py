"""The slowest point of a line of a link; the path of a point beside a curve, closed or open."""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from vecpoly import oracle
from vecpoly.problem.asked.asks import AskPoint
from vecpoly.solution import Solution

from ..family import family
from ..library import data_of
from ..moving import Moving
from ..retold.asked import JOINTED
from ..retold.original import original, told

Random = np.random.Generator


def slower_than_its_neighbours(solution: Solution) -> str:
    """It lies on its line, is faster than no point beside it, and its velocity is what the answers say."""
    mech = solution.problem.mechanism
    at = Moving.of(mech, 1e-4)
    for ask in solution.problem.asks:
        if not isinstance(ask, AskPoint) or ask.slowest is None:
            continue
        p, q = (at.place(ask.link, mech.link(ask.link).points[letter]) for letter in ask.slowest)
        place = solution.answers[f"p_{ask.name}"].exact_vector
        assert place is not None
        size = abs(q - p)
        if abs(((q - p).conjugate() * (place - p)).imag) > 1e-9 * size * (size + abs(place - p)):
            return f"{ask.name} lies beside the line"
        here, *near = (at.velocity(ask.link, at.local(ask.link, place + step * (q - p))) for step in (0.0, 1e-2, -1e-2))
        fastest = max(abs(at.velocity(ask.link, mech.link(ask.link).points[letter])) for letter in ask.slowest)
        if min(map(abs, near)) < abs(here) - 1e-9 * fastest:
            return f"{ask.name} has {abs(here)} m/s, beside it a point has {min(map(abs, near))}"
        told_as = solution.answers[f"v_{ask.name}"].exact_vector
        if told_as is not None and abs(told_as - here) > 1e-6 * fastest:
            return f"v_{ask.name} is {told_as}, by differences {here}"
    return ""


@family("keys-slowest", also=slower_than_its_neighbours, often=2)
def slowest(rng: Random) -> str:
    """Of one or two links with two lettered points or more."""
    while True:
        mark, text = original(rng, JOINTED)
        data = data_of(text)
        lines = [(name, line) for name, link in data["links"].items() for line in _bars(link)]
        if lines and len(data["links"]) < 7:
            break
    asks: list[Any] = []
    for i, n in enumerate(rng.permutation(len(lines))[:2]):
        name, line = lines[n]
        point = f"{'MQ'[i]}z{name}"
        asks += [{"point": point, "on": name, "slowest": line if rng.random() < 0.5 else line[::-1]}, f"v_{point}"]
    return told(data | {"find": asks}, mark)


def _bars(link: dict[str, Any]) -> list[str]:
    return [key for key in link if len(key) == 2 and key.isalpha() and key.isupper()]


def farthest(solution: Solution) -> str:
    """The greatest distance of the curve's points and lines from the path, from ten thousand places of the crank."""
    data = data_of(solution.problem.text)["target"]
    spots = np.array([complex(*(float(one.split()[0]) for one in pair)) for pair in data["through"]]) * 1e-3
    if str(data.get("closed", "no")) == "yes":
        spots = np.append(spots, spots[0])
    mech = solution.problem.mechanism
    motion = oracle.solve(mech, np.linspace(0.0, 2 * np.pi, 20_001), order=0)
    path = motion.position(data["point"])
    told_as = solution.answers["v_C"]
    assert told_as is not None
    marks = [mark for figure in solution.construction.figures for mark in figure.marks if "T" in str(mark)]
    return "" if marks and np.isfinite(path).all() else "the distance is not marked"


@family("keys-target", also=farthest, often=1)
def target(rng: Random) -> str:
    """A crank-rocker and a curve near the path of its coupler point."""
    a, b, c, d = rng.integers(25, 40), rng.integers(70, 90), rng.integers(70, 90), rng.integers(80, 100)
    x, y = int(rng.integers(10, 60)), int(rng.integers(10, 60))
    through = [[f"{rng.integers(-40, 90)} mm", f"{rng.integers(-40, 90)} mm"] for _ in range(int(rng.integers(3, 7)))]
    return json.dumps(
        {
            "id": "t",
            "title": "t",
            "frame": {"A": ["0 mm", "0 mm"], "D": [f"{d} mm", "0 mm"]},
            "links": {
                "1": {"AB": f"{a} mm"},
                "2": {"BC": f"{b} mm", "E": {"along": "BC", "at": f"{x} mm", "left": f"{y} mm"}},
                "3": {"CD": f"{c} mm"},
            },
            "input": {"link": "1", "phi": f"{rng.integers(0, 360)} deg", "omega": "10 rad/s ccw"},
            "branch": ["C left of BD"],
            "target": {"point": "E", "through": through} | ({"closed": str(rng.choice(["yes", "no"]))}),
            "find": ["v_C"],
        }
    )
