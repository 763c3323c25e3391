"""A period may be more turns of the drive than one: a pinion that drives the wheel of a crank, a kite."""

from __future__ import annotations

from textwrap import dedent

import numpy as np
import pytest

from tests.at_once import exactly
from tests.laws import few
from vecpoly.check import never
from vecpoly.errors import AssemblyError, EquilibriumError, NoMethodError
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle.forces.laws import returning
from vecpoly.oracle.machine.answers import machine_values
from vecpoly.oracle.machine.started import started_values
from vecpoly.problem.load import loads
from vecpoly.problem.problem import Problem

PRESS = """
    id: press
    title: t
    frame: {{O: [0 mm, 0 mm], A: [{apart} mm, 0 mm]}}
    links:
      1: {{gear: O, radius: {pinion} mm}}
      2: {{AB: 50 mm, gear: A, radius: 80 mm{stands}}}
      3: {{BC: 180 mm}}
      4: {{block: C}}
    joints: [2 rolls on 1 at H, 4 slides on y = 0 mm]
    input: {{{drive}}}
    branch: [C right of A]
    masses: {{2: {{mass: 4 kg, inertia: 0.03 kg*m^2, centre: A}}, 4: {{mass: 6 kg}}}}
    loads:
      F_r: {{on: 4, at: C, size: 900 N, direction: 180 deg, while: C moves right, between: [10 %, 90 %]}}
      F_s: {{spring: A-C4, k: 1 N/mm, l_0: 100 mm}}
      {more}
    machine: {{{machine}}}
    find: [{find}]
"""
CONSTANT = "M_d: {{on: {}, size: constant}}"


def at_the_pinion(find: str, machine: str = "n: 300 r/min, delta: 0.04", more: str = "", pinion: float = 40) -> Problem:
    """The press with its pinion driving."""
    text = PRESS.format(
        apart=80 + pinion, pinion=pinion, stands=", phi: 70 deg", drive="link: 1, phi: 0 deg, omega: ccw",
        more=more or CONSTANT.format(1), machine=machine, find=find,
    )  # fmt: skip
    return loads(dedent(text))


def at_the_crank() -> Problem:
    """The press with the wheel of its crank driving."""
    text = PRESS.format(
        apart=120, pinion=40, stands="", drive="link: 2, phi: 70 deg, omega: cw",
        more=CONSTANT.format(2), machine="n: 150 r/min, delta: 0.04", find="M_d, dW_max, J_F",
    )  # fmt: skip
    return loads(dedent(text))


def values(problem: Problem, keys: tuple[str, ...] = ("M_d", "dW_max", "J_F")) -> dict[str, float]:
    """What the oracle tells of the machine."""
    assert isinstance(problem.subject, Mechanism) and problem.machine is not None
    return machine_values(problem.subject, problem.machine, keys)


def test_a_flywheel_on_the_pinion_is_that_of_the_crank_over_the_ratio_squared() -> None:
    pinion, crank = values(at_the_pinion("M_d, dW_max, J_F")), values(at_the_crank())
    assert abs(pinion["M_d"]) == pytest.approx(abs(crank["M_d"]) / 2, rel=1e-7)
    assert pinion["dW_max"] == pytest.approx(crank["dW_max"], rel=1e-7)
    assert pinion["J_F"] == pytest.approx(crank["J_F"] / 4, rel=1e-7)


def test_a_ratio_of_no_small_whole_numbers_has_no_period() -> None:
    with pytest.raises(EquilibriumError, match="take as input a link after whose turn all is as it was"):
        values(at_the_pinion("M_d", pinion=39.9713), ("M_d",))


PLANET = """
        id: planet
        title: t
        frame: {{C: [0 mm, 0 mm]}}
        links: {{1: {{CV: 47 mm}}, 2: {{gear: V, radius: {planet} mm, W: {{VW: 20 mm, angle: -2 deg}}}}}}
        joints: [2 rolls inside circle about C of {ring} mm at Y]
        input: {{link: 1, phi: 305 deg, omega: ccw}}
        loads: {{M_w: {{on: 2, size: 14 N*m, while: {while_}}}, M_1: {{on: 1, size: "?"}}}}
        find: [M_1]
    """


def of_a_planet(planet: float, while_: str) -> Mechanism:
    subject = loads(dedent(PLANET.format(planet=planet, ring=47 + planet, while_=while_))).subject
    assert isinstance(subject, Mechanism)
    return subject


def test_after_how_many_turns_of_its_arm_a_planet_is_back_is_told_by_the_ratio_alone(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """n_2/n_H = 1 − 78/31: back after 31 turns; 1 − 78.3/31.3 never, which is told without a position."""
    walked: list[object] = []

    def places(mech: Mechanism, q: object) -> object:
        walked.append(q)
        return np.zeros(1)

    monkeypatch.setattr(returning, "_places", places)
    assert returning.laps.__wrapped__(of_a_planet(31, "2 turns cw"), 0.0) == 31
    assert len(walked) == 2  # at the beginning, and where the ratio says that all is back
    with pytest.raises(EquilibriumError, match="is never back where it was"):
        returning.laps.__wrapped__(of_a_planet(31.3, "2 turns cw"), 0.0)
    assert len(walked) == 2


@pytest.mark.parametrize(("while_", "told"), [("2 turns cw", 0), ("W moves left", 0), ("1 turns cw", 1)])
def test_what_a_load_waits_for_is_looked_for_in_the_first_turn(
    monkeypatch: pytest.MonkeyPatch, while_: str, told: int
) -> None:
    """31 turns of the arm bring this planet back; of a load that acts in the first they tell nothing."""
    monkeypatch.setattr(never, "over_a_period", lambda mech, steps: pytest.fail("31 turns"))
    problem = loads(dedent(PLANET.format(planet=31, ring=78, while_=while_)))
    assert isinstance(problem.subject, Mechanism) and problem.loads is not None
    assert len(list(never.never_acting(problem.subject, problem.loads))) == told


@pytest.mark.parametrize("pinion", few([40, 80], 2))
def test_a_press_is_drawn_through_as_many_turns_of_its_pinion_as_its_period_has(pinion: float) -> None:
    found = exactly(at_the_pinion("M_d, dW_max, J_F", pinion=pinion)).answers
    for answer in found.values():
        assert answer.drawn == pytest.approx(answer.exact, rel=1e-7)


def test_a_period_too_long_to_be_drawn_is_left_to_the_exact_answers() -> None:
    problem = at_the_pinion("M_d", pinion=10)
    assert values(problem, ("M_d",))["M_d"]
    with pytest.raises(NoMethodError, match="within 6 turns of the drive the mechanism is not back"):
        exactly(problem)


KITE = """
        id: kite
        title: t
        frame: {A: [0 mm, 0 mm], D: [40 mm, 0 mm]}
        links: {1: {AB: 40 mm}, 2: {BC: 100 mm}, 3: {DC: 100 mm}}
        input: {link: 1, phi: 70 deg, omega: ccw}
        branch: [C left of BD]
        masses: {3: {mass: 2 kg, inertia: 0.02 kg*m^2, centre: D}}
        loads: {M_r: {on: 3, size: 20 N*m cw, during: [30 deg, 200 deg]}, M_d: {on: 1, size: constant}}
        machine: {n: 100 r/min, delta: 0.05}
        find: [M_d]
    """


def test_a_kite_brings_its_long_link_round_in_two_turns() -> None:
    """Both assemblies together turn DC by as much as AB: 20 N·m over 170° of two turns, shared over 720°."""
    kite = loads(dedent(KITE))
    assert values(kite)["M_d"] == pytest.approx(20 * 170 / 720, rel=1e-9)
    with pytest.raises(AssemblyError, match="a kite that folds"):  # in one place of the turn B lies on D
        exactly(kite)


def test_a_pinion_let_go_swings_beyond_one_turn() -> None:
    """The turning points are those of a Runge-Kutta integration of the crank alone."""
    plain = PRESS.replace(", while: C moves right, between: [10 %, 90 %]", "")
    text = plain.format(
        apart=120, pinion=40, stands=", phi: 70 deg", drive="link: 1, phi: 0 deg, omega: ccw", more="",
        machine="start: {phi: 0 deg, omega: 30 rad/s}, until: 500 deg", find="T_cycle, phi_end",
    )  # fmt: skip
    problem = loads(dedent(text))
    assert isinstance(problem.subject, Mechanism) and problem.machine is not None
    found = started_values(problem.subject, problem.machine, ("T_cycle", "phi_end"))
    assert (found["T_cycle"], found["phi_end"]) == pytest.approx((0.237582, 11.65866), rel=1e-5)
