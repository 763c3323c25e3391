"""Whoever has the question sheet alone has every number that its file gives."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import pdfplumber
import pytest

from tests.drawn_library import IDS, given
from tests.each import each
from tests.laws import few
from vecpoly import loads
from vecpoly.board.paper.marks import FixedGuide, Point
from vecpoly.devices.structure import Structure
from vecpoly.problem.problem import Problem
from vecpoly.report.document import write_report
from vecpoly.solution import solve

_SIZE = re.compile(
    r"(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) ?(mm|cm|m|deg|rad/s\^2|rad/s|r/min|m/s\^2|m/s|N\*m|N\*mm|N/mm|N|kN|kg|g|kW|s|"
    r"kg\*m\^2|kg/m\^3|g\*mm)(?![\w/*^])"
)
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_TOLD_OTHERWISE = (  # text; what is printed elsewhere; where to look for an assembly; shapes for the sketch alone
    *("id", "title", "source", "statement", "chapter", "printed", "errata", "guesses", "scales", "sheet", "bodies"),
    *("extends", "vary", "gate", "rules", "rubric", "points", "tables", "target"),
)
_UNITS = (1.0, 1e3, 1e-3, 10.0, 0.1, 1e6, 1e-6, math.degrees(1), math.radians(1), 30 / math.pi, math.pi / 30, 0.5, 2.0)
_ROUNDED, _PLACES = 6e-4, 0.06  # of a number, and of a coordinate: so much is lost where it is printed
_NONE = 1e-9  # of any unit: a zero, as another program wrote it


def _sizes(value: object, key: str = "") -> Iterator[tuple[str, str]]:
    """Every size with its unit, and the key under which it stands."""
    match value:
        case dict():
            for name, inner in value.items():
                if name not in _TOLD_OTHERWISE:
                    yield from _sizes(inner, f"{key}.{name}")
        case list() | tuple():
            for inner in value:
                yield from _sizes(inner, key)
        case _:
            yield from ((key, found[0]) for found in _SIZE.finditer(str(value)))


def _untold(problem: Problem, path: Path) -> list[tuple[str, str]]:
    """The sizes of its file that are printed nowhere in its question, in no unit."""
    assert problem.written is not None
    write_report([solve(problem, by="exact", repeats=0, precise=False)], path, lang="en", style="question")
    with pdfplumber.open(path) as pdf:
        printed = {float(one) for page in pdf.pages[:3] for one in _NUMBER.findall(page.extract_text())}
    told = problem.written.tree().data
    if isinstance(problem.subject, Structure):  # its places and directions are those of the sketch, which is printed
        told = {key: value for key, value in told["data"].items() if key != "joints"}
    return [size for size in _sizes(told) if not _is_among(printed, size[1])]


def _is_among(printed: set[float], size: str) -> bool:
    value, unit = abs(float(size.split()[0].rstrip("degm"))), size.lstrip("-.0123456789 ")
    asked = [value * factor for factor in _UNITS]
    asked += [abs(value - turn) for turn in (90.0, 180.0, 360.0)] if unit == "deg" else []
    close = (abs(one - value) <= _PLACES for one in printed if unit == "mm")
    return value < _NONE or any(close) or any(abs(one - each) <= _ROUNDED * each for one in printed for each in asked)


@each(few(IDS, 4))
def test_every_size_of_the_file_stands_on_the_question_sheet(name: str, tmp_path: Path) -> None:
    problem = given(name)
    assert not _untold(problem, tmp_path / "q.pdf")


_SLOTTED = """
id: slotted
title: slotted
frame: {A: [0 mm, 0 mm], D: [94 mm, -26 mm]}
links:
  1: {slot: {through: A, SLOT}, E: {AE: 50 mm, angle: 30 deg from line}}
  2: {DB: 76.24 mm}
joints: [B runs in 1]
input: {link: 1, phi: 267.2 deg, omega: 3 rad/s}
guesses: {B: [20.7 mm, -47.1 mm]}
find: [v_B]
"""
_DRIVEN = """
id: turned
title: turned
frame: {A: [0 mm, 0 mm], D: [120 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {block: B}, 3: {DC: 150 mm, slot: {through: D, angle: 11.5 deg from DC, left: -7.25 mm}}}
joints: [2 slides in 3]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
find: [omega_3]
"""
_ROTOR = """
id: rotor
title: rotor
device: rotor
data:
  disc: {b: 56 mm, density: 2700 kg/m^3}
  masses:
    1: {keyway: 5 mm, depth: 6.5 mm, r: 162 mm, b: 33 mm, at: 215.1 deg}
    2: {hole: 14 mm, r: 183 mm, at: 266.1 deg, density: 7850 kg/m^3}
  correct:
    L: {r: 63 mm}
"""


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (_SLOTTED.replace("SLOT", "left: 23 mm"), "构件 1 的滑道在 $A$ 左侧 23 mm"),
        (_SLOTTED.replace("SLOT", "right: -23 mm"), "构件 1 的滑道在 $A$ 左侧 23 mm"),
        (_DRIVEN, "构件 3 的滑道与 $DC$ 成 11.5°（自 $DC$ 逆时针量），沿此方向看在 $D$ 右侧 7.25 mm"),
    ],
)
def test_the_line_of_a_slot_that_a_reader_could_not_know_is_told(text: str, said: str, tmp_path: Path) -> None:
    problem = loads(text)
    assert said in [one.of("zh") for one in problem.given.data]
    assert not _untold(problem, tmp_path / "q.pdf")


_PIN = """
id: pinned
title: pinned
frame: {A: [0 mm, 0 mm], D: [-100 mm, 60 mm]}
links: {1: {AB: 40 mm}, 2: {BC: 120 mm}}
joints: [C runs in GUIDE]
branch: [C left of AB]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
find: [v_C]
"""


@pytest.mark.parametrize(
    ("guide", "said"),
    [
        ("y = 55 mm", "$C$ 的导路 $y_C$ = 55 mm"),
        ("line through D at -15 deg", "过 $D$ 的导路与水平方向成 15°（自水平方向顺时针量）"),
        ("AD", ""),
    ],
)
def test_the_fixed_slot_in_which_a_pin_runs_is_told_and_drawn(guide: str, said: str, tmp_path: Path) -> None:
    problem = loads(_PIN.replace("GUIDE", guide))
    assert not said or said in [one.of("zh") for one in problem.given.data]
    assert not _untold(problem, tmp_path / "q.pdf")
    diagram = solve(problem, by="exact", repeats=0, precise=False).construction.figures[0]
    at = next(mark.at for mark in diagram.marks if isinstance(mark, Point) and mark.label == "C")
    one, other = (mark for mark in diagram.marks if isinstance(mark, FixedGuide))
    assert abs((one.a + one.b + other.a + other.b) / 4 - at) < 1e-9


def test_a_keyway_of_another_length_and_a_hole_in_another_material_are_told(tmp_path: Path) -> None:
    problem = loads(_ROTOR)
    assert not _untold(problem, tmp_path / "q.pdf")


_ONE_PIN = """
id: one-pin
title: one pin
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 170 mm}, 3: {DC: 130 mm}}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD]
loads: {M_1: {on: 1, size: "?"}}
masses:
  2: {mass: 2 kg, inertia: 0.03 kg*m^2, centre: C}
  3: {mass: 3 kg, inertia: 0.05 kg*m^2, centre: C}
find: [M_1]
"""


def test_two_moments_of_inertia_about_one_pin_have_a_symbol_each_and_may_be_varied() -> None:
    problem = loads(_ONE_PIN)
    told = {one.symbol: one.text for one in problem.given.data if one.symbol.startswith("J")}
    assert told == {"J_{C2}": "0.03 kg·m²", "J_{C3}": "0.05 kg·m²"}
    assert problem.vary(J_3="0.06 kg*m^2").parameters["J_3"] == "0.06 kg*m^2"
