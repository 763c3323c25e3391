"""The printed model of gears on couplers, racks and trains: it moves as the oracle does through the whole cycle, also
where arctangents jump by a turn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from tests.course.test_course_models_hold import modelled
from tests.laws import few
from vecpoly.analytic.equations import Model
from vecpoly.cycle import cycle
from vecpoly.findings.study.from_pivots import from_pivots
from vecpoly.mechanism.model import Mechanism
from vecpoly.problem.load import load, loads
from vecpoly.problem.problem import Problem

ON_A_COUPLER = """
frame: {A: [0 mm, 0 mm], D: [150 mm, 0 mm], K: [240 mm, 40 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 140 mm, gear: C, radius: 30 mm}
  3: {DC: 90 mm}
  4: {gear: D, radius: 60 mm, E: {DE: 40 mm, angle: 75 deg}}
  5: {EF: 120 mm}
  6: {KF: 90 mm}
joints: [4 rolls on 2 at H]
input: {link: 1, phi: 130 deg, omega: 10 rad/s ccw}
branch: [C left of BD, F left of EK]
find: [omega_6]
"""
RACK_DRIVES = """
frame: {A: [0 mm, 30 mm], D: [150 mm, 70 mm]}
links:
  1: {gear: A, radius: 30 mm, E: {AE: 25 mm, angle: 50 deg}}
  2: {block: P, rack: P}
  3: {slot: D}
  4: {block: E}
joints: [2 slides on y = 0 mm, 1 rolls on 2 at H, 4 slides in 3]
input: {link: 2, s: 40 mm, v: -0.3 m/s, a: 1 m/s^2}
find: [omega_3]
"""
STEPPED = """
frame: {A: [0 mm, 0 mm], D: [90 mm, 0 mm]}
links:
  1: {gear: A, radius: 30 mm, B: {AB: 22 mm, angle: 200 deg}}
  2: {gear: D, radius: 60 mm, C: {DC: 25 mm, angle: 40 deg}}
  3: {block: P, rack: P, s: -20 mm}
  4: {CE: 130 mm}
  5: {BE: 140 mm}
joints: [2 rolls on 1 at H, 2 of 20 mm rolls below 3 at K, 3 slides on y = 20 mm]
input: {link: 1, phi: 200 deg, omega: 10 rad/s cw, alpha: 5 rad/s^2}
branch: [E right of BC]
find: [v_P]
"""
# gears that nothing but their partners and each other hold
TWO_PLANETS = """
frame: {A: [0 mm, 0 mm], D: [110 mm, 0 mm]}
links:
  1: {AB: 20 mm, gear: B, radius: 25 mm}
  2: {gear: C, radius: 30 mm, E: {CE: 20 mm, angle: 40 deg}}
  3: {gear: C, radius: 35 mm}
joints: [2 rolls on 1 at H, 3 rolls on circle about D of 45 mm at K]
input: {link: 1, phi: 30 deg, omega: 10 rad/s ccw, alpha: 3 rad/s^2}
branch: [C above AD]
find: [omega_2, omega_3]
"""
WRITTEN = {"coupler": ON_A_COUPLER, "rack": RACK_DRIVES, "stepped": STEPPED, "planets": TWO_PLANETS}
GEARED = ("planetary-reactions", "stepped-planet", "travel-doubler", "crank-rack-pinion", "rack-on-a-rocker")


def problem(name: str) -> Problem:
    return loads(f"id: {name}\ntitle: t\n{WRITTEN[name]}") if name in WRITTEN else load(name)


def off(problem: Problem, mech: Mechanism, printed: Model) -> Iterator[tuple[str, float]]:
    """How far ω and α of each link are from the oracle's, of the greatest, over the cycle."""
    found = cycle(replace(problem, subject=mech), n=73)
    env = printed.values(found.phi[2:-2])
    for link in mech.links:
        for symbol, key in (("ω", "omega"), ("α", "alpha")):
            if (name := f"{symbol}_{{{link.name}}}") in env:
                exact = found.real(f"{key}_{link.name}")[2:-2]
                yield name, float(np.max(np.abs(env[name] - exact))) / max(1.0, float(np.max(np.abs(exact))))


@pytest.mark.parametrize("name", few([*WRITTEN, *GEARED], 4))
def test_gears_roll_by_the_formulas_as_by_the_oracle_through_the_whole_cycle(name: str) -> None:
    one = problem(name)
    mech = from_pivots(one.mechanism)
    found = dict(off(one, mech, modelled(mech)))
    assert len(found) >= 2
    assert {what: size for what, size in found.items() if not size < 1e-9} == {}


@pytest.mark.parametrize("name", ["rack", "stepped", "travel-doubler"])
def test_a_gear_or_rack_with_one_unknown_has_a_closed_formula(name: str) -> None:
    assert modelled(from_pivots(problem(name).mechanism)).closed
