"""Machines of the cases, as problem files: the numbers behind `tests/data/machines.json`."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from textwrap import dedent
from typing import Any

from vecpoly.problem.load import loads as read
from vecpoly.problem.problem import Problem

DATA: dict[str, Any] = json.loads((Path(__file__).parents[1] / "data" / "machines.json").read_text("utf-8"))

ENGINE = """
    id: engine
    title: {zh: 曲柄滑块机构, en: A slider-crank}
    frame: {A: [0 mm, 0 mm]}
    links: {1: {AB: 60 mm}, 2: {BC: 220 mm}, 3: {block: C}}
    joints: [3 slides on y = 0 mm]
    branch: [C right of B]
    masses:
      1: {mass: 1 kg, inertia: 0.02 kg*m^2, centre: A}
      2: {mass: 1.2 kg, inertia: 0.008 kg*m^2, centre: {along: BC, at: 75 mm}}
      3: {mass: 0.9 kg}
"""
PISTON = "F: {on: 3, at: C, size: 3000 N, direction: 180 deg}"


def engine(
    find: Sequence[str], *, phi: float = 50.0, omega: str = "ccw", loads: Sequence[str] = (), more: str = ""
) -> Problem:
    """The slider-crank of the cases, with these loads and questions."""
    acting = "loads: {" + ", ".join(loads) + "}\n" if loads else ""
    head = f"input: {{link: 1, phi: {phi} deg, omega: {omega}}}\nfind: [{', '.join(find)}]\n"
    return read(dedent(ENGINE) + acting + head + more)


PRESS = """
    id: press
    title: {zh: 曲柄摇杆压力机, en: A crank-rocker press}
    frame: {A: [0 mm, 0 mm], D: [280 mm, 0 mm]}
    links: {1: {AB: 100 mm}, 2: {BC: 300 mm}, 3: {CD: 200 mm}}
    branch: [C left of BD]
    masses:
      1: {mass: 1 kg, inertia: 0.05 kg*m^2, centre: A}
      2: {mass: 4 kg, inertia: 0.04 kg*m^2, centre: {along: BC, at: 150 mm}}
      3: {mass: 6 kg, inertia: 0.05 kg*m^2, centre: {along: DC, at: 90 mm}}
    loads:
      M_r: {on: 3, size: 900 N*m cw, during: [60 deg, 150 deg], role: resisting}
      M_d: {on: 1, size: constant, role: driving}
    input: {link: 1, phi: 120 deg, omega: 120 r/min ccw}
"""
SHAPER = """
    id: shaper
    title: {zh: 牛头刨床, en: A shaper}
    frame: {A: [0 mm, 0 mm], D: [0 mm, -380 mm]}
    links:
      1: {AB: 110 mm}
      2: {block: B}
      3: {slot: D, C: {along: D, at: 540 mm}}
      4: {CE: 135 mm}
      5: {block: E}
    joints: [2 slides in 3, 5 slides on y = 148 mm]
    branch: [E left of C]
    masses:
      1: {mass: 1 kg, inertia: 0.5 kg*m^2, centre: A}
      3: {mass: 20 kg, inertia: 1.1 kg*m^2, centre: {along: D, at: 270 mm}}
      4: {mass: 3 kg, inertia: 0.005 kg*m^2, centre: {along: CE, at: 67.5 mm}}
      5: {mass: 70 kg}
    loads:
      F_r: {on: 5, at: E, size: 7000 N, direction: 0 deg, while: E moves left, between: [5 %, 95 %], role: resisting}
      M_d: {on: 1, size: constant, role: driving}
    input: {link: 1, phi: 120 deg, omega: 60 r/min ccw}
"""


def machine(text: str, find: Sequence[str], run: str) -> Problem:
    """The press, or the shaper, that runs so; with these questions."""
    return read(dedent(text) + f"machine: {{{run}}}\nfind: [{', '.join(find)}]\n")
