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
