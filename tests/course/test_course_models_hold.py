"""The printed mathematical model of every mechanism, and of random ones, moves as the oracle does."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.each import Later, each
from tests.generators.family import families, member
from tests.laws import few, often
from vecpoly import oracle
from vecpoly.analytic.build import model
from vecpoly.analytic.equations import Model
from vecpoly.errors import AssemblyError, NoMethodError
from vecpoly.findings.study.from_pivots import from_pivots
from vecpoly.mechanism.model import Mechanism
from vecpoly.names import At
from vecpoly.problem.library import library
from vecpoly.problem.load import load, loads
from vecpoly.report.course.checks.chapter import until


@cache
def mechanisms() -> dict[str, Mechanism]:
    """Those of the library."""
    return {entry.id: one for entry in library() if isinstance(one := load(entry.id).subject, Mechanism)}


IDS = Later(lambda: few([name for name, one in mechanisms().items() if not one.cams], 5))
PROFILES = Later(lambda: (name for name, one in mechanisms().items() if one.cams))
FAMILIES = (
    "linkage-cam",
    "linkage-prp",
    "linkage-rpp",
    "linkage-rpr",
    "linkage-rrp",
    "linkage-rrr",
    "linkage-slide",
    "class-iii",
    "class-iii-slider",
    "cylinder-inside",
    "cylinder-lever",
    "cylinder-offset",
    "cylinder-slider",
    "motor-in-hinge",
    "offset-slot-drives",
    "pin-in-two-slots",
    "roller",
    "forces-slots",
)
Vectors = tuple[str, np.ndarray, np.ndarray]


def modelled(mech: Mechanism) -> Model:
    """Its formulas, set up at the given position."""
    here = oracle.solve(mech)
    at = {letter: complex(here.position(At(letter))) for link in mech.links for letter in link.points} | dict(
        mech.frame
    )
    return model(mech, at, {link.name: float(here.angle(link.name)) for link in mech.links})


def near(mech: Mechanism) -> np.ndarray:
    """The given position of the drive and two beside it."""
    return mech.drive.position + np.array([0.0, 1.0, -1.0]) * (mech.scale / 2000 if mech.drive.slide else 0.002)


def vectors(mech: Mechanism, printed: Model) -> Iterator[Vectors]:
    """(what, by the formulas, by the oracle) of every letter's place and rates,
    and of every link's, that the formulas tell."""
    env, exact = printed.values(near(mech)), oracle.solve(mech, near(mech))
    for letter in {letter for link in mech.links for letter in link.points} - {*mech.frame}:
        for x, y, there in (
            (f"x_{{{letter}}}", f"y_{{{letter}}}", exact.position),
            (f"v_{{{letter}x}}", f"v_{{{letter}y}}", exact.velocity),
            (f"a_{{{letter}x}}", f"a_{{{letter}y}}", exact.acceleration),
        ):
            if x in env:
                yield x, env[x] + 1j * np.asarray(env[y]), np.asarray(there(At(letter)))
    for link in mech.links:
        for stem, told in (("ω", exact.omega), ("α", exact.alpha)):
            if (symbol := f"{stem}_{{{link.name}}}") in env:
                yield symbol, np.asarray(env[symbol]), np.asarray(told(link.name))


def off(mech: Mechanism, printed: Model) -> dict[str, float]:
    """What the formulas tell otherwise than the oracle, and what is missing of the conditions."""
    found = {
        what: float(np.max(np.abs(one - two))) / max(1.0, mech.drive.rate**2, float(np.abs(two).max()))
        for what, one, two in vectors(mech, printed)
    }
    assert len(found) >= 3
    gaps = {str(equation.node): float(np.max(gap)) for equation, gap in printed.gaps(near(mech))}
    return {what: size for what, size in (found | gaps).items() if not size < 1e-7 * max(1.0, mech.drive.rate**2)}


@cache
def held(text: str) -> dict[str, float]:
    """What is off in the problem of this text."""
    mech = from_pivots(loads(text).mechanism)
    return off(mech, modelled(mech))


@each(PROFILES)
def test_a_cam_with_a_profile_has_no_model_in_formulas(name: str) -> None:
    with pytest.raises(NoMethodError, match="profile of cam 1"):
        modelled(mechanisms()[name])


@cache
def of_library(name: str) -> tuple[Mechanism, Model]:
    """A mechanism of the library with its formulas."""
    mech = from_pivots(mechanisms()[name])
    return mech, modelled(mech)


@each(IDS)
def test_the_model_of_every_mechanism_moves_as_the_oracle_does(name: str) -> None:
    assert off(*of_library(name)) == {}


@pytest.mark.parametrize("name", few(FAMILIES, 8))
def test_the_model_of_random_mechanisms_moves_as_the_oracle_does(name: str) -> None:
    one, told = next(family for family in families() if family.name == name), 0
    for number in range(12 if name.startswith("linkage") else 4):
        try:
            wrong = held(member(one, 0, number))
        except (AssemblyError, NoMethodError):
            continue
        assert not wrong, (number, wrong)
        told += 1
    assert told >= (10 if name.startswith("linkage") else 1)


CROSSED = """
id: crossed
title: crossed
frame: {A: [0 mm, 0 mm], D: [120 mm, 20 mm]}
links: {1: {AB: 140 mm}, 2: {block: D}, 3: {slot: E}}
joints: [2 slides in 3, 3 slides on AB turned %s deg]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
find: [v_E]
"""
HUNG = """
id: hung
title: hung
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 40 mm}, 2: {slot: B}, 3: {block: K}}
joints: [3 slides in 2 turned %s deg, 3 slides on y = 90 mm]
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw, alpha: 3 rad/s^2}
find: [v_K]
"""
# the slot runs through a letter that is not located before the link is
THROUGH = HUNG.replace("{slot: B}", "{BI: 60 mm, slot: {through: I, angle: 50 deg from IB}}")


@pytest.mark.parametrize("turned", [-75, -30, 40, 100])
@pytest.mark.parametrize("text", [CROSSED, HUNG, THROUGH])
def test_slides_that_keep_an_angle_between_links_keep_it_on_its_own_side(text: str, turned: int) -> None:
    assert held(text % turned) == {}


def test_every_condition_of_a_model_says_something() -> None:
    """x_C = x_C is no equation: Newton's method would have nothing to go by."""
    for name in IDS:
        for group in of_library(name)[1].groups:
            conditions = [equation for equation in group.equations if not equation.gives]
            assert all(equation.left != equation.right for equation in conditions), name
            if group.loops is not None:
                assert len(group.loops.conditions) == len(group.loops.unknowns) > 0, name


PLANET = """
id: planet
title: a crank pin on a planet
frame: {A: [0 mm, 0 mm]}
links:
  1: {AB: %s mm}
  2: {gear: B, radius: %s mm, E: {BE: 10 mm, angle: %s deg}}
  3: {EC: 190 mm}
  4: {block: C}
joints: [2 rolls %s circle about A of %s mm at H, 4 slides on y = 0 mm]
input: {link: 1, phi: %s deg, omega: 10 rad/s ccw, alpha: 20 rad/s^2}
branch: [C right of E]
find: [v_C]
"""


@settings(max_examples=often(8))
@given(
    planet=st.floats(12, 40),
    sun=st.floats(45, 70),
    phase=st.floats(-180, 180),
    phi=st.floats(5, 350),
    inside=st.booleans(),
)
def test_the_crank_pin_of_a_gear_moves_by_the_formulas_as_by_the_oracle(
    planet: float, sun: float, phase: float, phi: float, inside: bool
) -> None:
    arm, how = (sun - planet, "inside") if inside else (sun + planet, "on")
    mech = loads(PLANET % (arm, planet, phase, how, sun, phi)).mechanism
    assert off(mech, modelled(mech)) == {}


SLOT_ON_THE_FRAME = """
id: slot-on-the-frame
title: t
frame: {A: [0 mm, 0 mm], M: [57.287185487 mm, 131.727613629 mm]}
links:
  1: {AB: 54.26595414 mm, F: {along: AB, at: -14.07770199 mm, left: -201.356796656 mm}, G: {along: AB, at: 87.547627691 mm, left: 3.081232141 mm}, I: {along: AB, at: 47.532354503 mm, left: -154.671808075 mm}, J: {along: AB, at: 127.775445308 mm, left: -65.447112066 mm}}
  2: {CD: 114.640657578 mm, E: {along: CD, at: 99.28501132 mm, left: 57.806715324 mm}, K: {along: CD, at: 99.663782754 mm, left: 43.295186689 mm}, L: {along: CD, at: 56.570220842 mm, left: -68.700103041 mm}, N: {along: CD, at: 130.011782583 mm, left: 11.807919224 mm}}
  3: {block: E}
  4: {block: H}
  5: {slot: M}
joints: [3 slides on FG with E 9.7156 mm left, 4 slides on IJ, 4 slides on KL of 2 turned 43.623147004 deg, N of 2 slides in 5 turned 21.076752795 deg]
input: {link: 1, phi: 137 deg, omega: -8 rad/s}
guesses: {E: [71.803 mm, 98.835 mm], H: [10.954 mm, 140.272 mm], N: [18.682 mm, 83.403 mm]}
find: [omega_2]
"""  # noqa: E501


def test_a_slot_that_is_reached_along_its_slide_closes_a_loop_in_its_pin_on_the_frame() -> None:
    mech = loads(SLOT_ON_THE_FRAME).mechanism
    printed = modelled(mech)
    assert not off(mech, printed)
    (loops,) = [group.loops for group in printed.groups if group.loops is not None]
    assert len(loops.conditions) == len(loops.unknowns) == 4


@pytest.mark.parametrize(
    ("start", "way", "count"), [(2, -1, 1), (2, 1, 3), (8, 1, 3), (8, -1, 1), (11, -1, 4), (11, 1, 0), (6, 1, 0)]
)
def test_the_model_is_compared_up_to_the_change_points_on_either_side_round_the_cycle(
    start: int, way: int, count: int
) -> None:
    near = np.isin(np.arange(12), (0, 6))
    assert until(near, start, way) == count
