"""The oracle's reactions, balancing loads, efficiencies and lines are those of the exercises of chapter 4."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from math import radians

import numpy as np
import pytest

from tests.oracle.test_oracle_forces_models import (
    CASES,
    CRANK,
    PUSH,
    ROUGH,
    case,
    crank,
    flat_lever,
    heavy,
    out_of_balance,
    slider_crank,
    slotted_rocker,
)
from tests.oracle.test_oracle_models import (
    a27,
    class_three,
    crank_and_slot,
    geared,
    guide_rod,
    hay_press,
    link,
    make,
    peaucellier,
    pins,
    rocker,
    sloped_slot,
)
from vecpoly.errors import EquilibriumError
from vecpoly.mechanism.asked.forces import quantities
from vecpoly.mechanism.loads import Force, Friction, Loads, Mass, Moment
from vecpoly.mechanism.model import Circle, Contact, Mechanism, Prismatic, Revolute, Rolling
from vecpoly.oracle import solve
from vecpoly.oracle.forces import forces

NAMES = [name for name in CASES if name != "about"]


@pytest.mark.parametrize("name", NAMES)
def test_every_number_of_the_exercise_comes_out(name: str) -> None:
    expected, result = CASES[name]["values"], forces(*case(name))
    for key, number in expected.items():
        want = complex(*number) if isinstance(number, list) else number
        assert abs(complex(result.value(key)) - want) <= 1e-9 * abs(want), key


@pytest.mark.parametrize("name", NAMES)
def test_every_reaction_lies_on_the_line_of_the_exercise(name: str) -> None:
    mech, loads = case(name)
    result = forces(mech, loads)
    for pair, place in CASES[name]["lines"].items():
        force, away = complex(result.value(f"R_{pair}")), complex(result.line(*pair)) - complex(*place)
        assert abs((away.conjugate() * force).imag) <= 1e-12 * abs(force), pair
        assert abs(away) <= 1e-12, pair


@pytest.mark.parametrize("name", NAMES)
def test_what_goes_in_comes_out_or_is_lost(name: str) -> None:
    mech, loads = case(name)
    result = forces(mech, loads)
    assert result.power_in == pytest.approx(result.power_out + result.loss, rel=1e-9)
    assert result.loss > 0.1 * result.power_in
    assert out_of_balance(result, mech, loads) < 1e-12


@pytest.mark.parametrize("name", NAMES)
def test_virtual_power_finds_the_frictionless_load(name: str) -> None:
    mech, loads = case(name)
    result, free = forces(mech, loads), loads.unknown.name
    assert result.value(f"{free}_power") == pytest.approx(result.value(f"{free}_0"), rel=1e-12)
    assert result.value(f"{free}_lever") == result.value(f"{free}_0")


def test_4_6_block_in_a_slot_is_in_equilibrium() -> None:
    """No answers are printed:
    circle at the block's pin and friction angle in the slot together give the shift of the normal force."""
    mech, loads = slotted_rocker()
    result = forces(mech, loads)
    assert out_of_balance(result, mech, loads) < 1e-12
    assert 0 < result.value("eta") < 1
    assert result.value("R_12") == pytest.approx(complex(-result.value("R_32")), rel=1e-12)
    inclined = np.angle(complex(result.value("R_32")) / solve(mech).bodies["3"].unit[0] / 1j)
    assert min(abs(inclined), abs(abs(inclined) - np.pi)) == pytest.approx(radians(9.0), rel=1e-12)
    away = complex(result.line("1", "2") - solve(mech).position("B"))
    assert abs(away) == pytest.approx(0.005, rel=1e-12)
    lean = complex(result.line("3", "2") - result.line("1", "2"))
    assert abs((lean.conjugate() * complex(result.value("R_12"))).imag) < 1e-12 * abs(result.value("R_12"))


@pytest.mark.parametrize(
    "rough",
    [Friction(contacts={"B": radians(12.0)}), Friction(pins={"A": 0.004, "C": 0.0035}, contacts={"B": radians(12.0)})],
    ids=["contact", "pins too"],
)
def test_4_5_flat_face_is_in_equilibrium(rough: Friction) -> None:
    mech = flat_lever(0.02, 0.046, -0.126 + 0.008j, 0.009, 0.19, radians(33.0), 1.0)
    assert abs(complex(solve(mech).position("G")) - (0.0564767684597407 + 0.060936083841649896j)) < 1e-12
    loads = Loads(
        forces=(
            Force(name="Q", link="2", point="G", direction=radians(-83.0), size=260.0),
            Force(name="F_i1", link="1", point="O", direction=radians(33.0), size=140.0),
        ),
        moments=(CRANK,),
        friction=rough,
    )
    result = forces(mech, loads)
    assert out_of_balance(result, mech, loads) < 1e-12
    leaning = np.angle(complex(result.value("R_21")) / complex(-1j * solve(mech).bodies["2"].unit[0]))
    assert abs(leaning) == pytest.approx(radians(12.0), rel=1e-12)
    assert result.power_in == pytest.approx(result.power_out + result.loss, rel=1e-9)


def test_every_quantity_that_may_be_asked_for_has_a_value() -> None:
    mech = slider_crank(0.08, 0.23, -0.015, radians(52.0), 30.0, S=0.1 + 0.01j)
    loads = Loads(forces=(PUSH,), moments=(CRANK,), masses=heavy(0.08), friction=ROUGH, weight=True)
    result = forces(mech, loads)
    for key, named in quantities(mech, loads).items():
        assert np.isfinite(result.value(key)), key
        assert np.iscomplexobj(result.value(key)) == named.is_vector, key
    assert out_of_balance(result, mech, loads) < 1e-12
    assert result.value("h_2") == pytest.approx(abs(result.value("M_I2")) / abs(result.value("F_I2")))


OTHERS: dict[str, Callable[[], Mechanism]] = {
    "multiple joints": lambda: peaucellier(0.05, 0.07, 0.15, 0.062, 0.14, 0.078, 0.066, -0.085 - 0.01j, 62.0),
    "hay press": lambda: hay_press(0.4),
    "gears on a rack": geared,
    "gear held by an arm": lambda: make(
        {"A": 0},
        [link("1", A=0, B=0.06), link("2", B=0)],
        (
            *pins("A 0 1, B 1 2"),
            Rolling(
                point="H", gear=Circle(link="2", centre="B", radius=0.02), on=Circle(link="0", centre="A", radius=0.04)
            ),
        ),
        (50.0, 10.0),
    ),
    "driving guide rod": guide_rod,
    "slider-crank and slotted rocker": crank_and_slot,
    "slotted link 25 mm from its pivot": lambda: rocker(0.045, 0.115 - 0.02j, 63.0, 12.0, 0.025),
    "sloped slot": lambda: sloped_slot(0.4, 45.0, 100.0, 60.0),
    "class III group": class_three,
    "A 27": lambda: a27(),
}


@pytest.mark.parametrize("name", OTHERS)
def test_every_kind_of_joint_carries_its_reactions_in_equilibrium(name: str) -> None:
    mech = OTHERS[name]()
    last = mech.link(mech.bodies[-1])
    slides = [joint for joint in mech.joints if isinstance(joint, Prismatic)]
    rough = Friction(
        pins={joint.point: 0.002 for joint in mech.joints if isinstance(joint, Revolute)},
        slides={(joint.block, joint.guide): 0.1 for joint in slides},
    )
    masses = tuple(
        Mass(link=name, mass=1.0, inertia=0.001, centre=next(iter(mech.link(name).points))) for name in mech.bodies
    )
    loads = Loads(
        forces=(Force(name="F", link=last.name, point=list(last.points)[-1], direction=2.2, size=900.0),),
        moments=(Moment(name="M_1", link=mech.drive.link),),
        masses=masses,
        friction=rough,
        weight=True,
    )
    result = forces(mech, loads)
    assert out_of_balance(result, mech, loads) < 1e-10
    assert result.power_in == pytest.approx(result.power_out + result.loss, rel=1e-9) and result.loss > 0
    assert result.value("M_1_power") == pytest.approx(result.value("M_1_0"), rel=1e-9)


def test_balancing_moment_is_the_rate_of_the_kinetic_energy() -> None:
    """M_1 ω_1 = dT/dt + dV/dt - F·v, with T and V from positions and velocities alone, differentiated numerically."""
    mech, masses, rate = slider_crank(0.08, 0.23, -0.015, 0.0, 30.0, S=0.1 + 0.01j), heavy(0.08), 30.0
    q, h = np.radians(np.arange(5.0, 360.0, 10.0)), 1e-3
    loads = Loads(forces=(PUSH,), moments=(CRANK,), masses=masses, weight=True)

    def energy(at: np.ndarray) -> np.ndarray:
        motion = solve(mech, at, order=1)
        kinetic = sum(
            m.mass * np.abs(motion.velocity(f"{m.centre}{m.link}")) ** 2 / 2 + m.inertia * motion.omega(m.link) ** 2 / 2
            for m in masses
        )
        return np.asarray(kinetic + sum(m.mass * 9.81 * motion.position(m.centre).imag for m in masses))

    gained = (
        rate
        * sum(w * energy(q + k * h) for k, w in zip(range(-3, 4), (-1, 9, -45, 0, 45, -9, 1), strict=True))
        / (60 * h)
    )
    given = -1000.0 * solve(mech, q, order=1).velocity("C").real
    assert np.allclose(forces(mech, loads, q).value("M_1") * rate, gained - given, rtol=1e-8, atol=1e-6)


def test_one_row_of_positions_holds_the_answers_of_each() -> None:
    q = np.radians([20.0, 52.0, 138.0])
    loads = Loads(forces=(PUSH,), moments=(CRANK,), friction=ROUGH)
    row = forces(crank(), loads, q)
    for i, at in enumerate(q):
        one = forces(crank(), loads, at)
        for key in ("M_1", "R_41", "R_12", "eta", "h", "M_1_power"):
            assert row.value(key)[i] == pytest.approx(complex(one.value(key)), rel=1e-12)
        assert row.line("1", "2")[i] == pytest.approx(complex(one.line("1", "2")), rel=1e-12)
        assert np.shape(one.value("M_1")) == np.shape(one.loss) == () and row.loss.shape == (3,)


@pytest.mark.parametrize("name", ["4-3a", "4-4", "4-7"])
def test_a_long_row_of_positions_is_solved_as_short_ones_are(name: str) -> None:
    """One elimination for all of many positions, LAPACK for few: the same numbers."""
    mech, loads = case(name)
    q = mech.drive.position + np.linspace(0.0, 1.2, 400)
    row, free = forces(mech, loads, q, strict=False), loads.unknown.name
    assert np.isfinite(row.value(free)).sum() > 200
    for part in (slice(i, i + 50) for i in range(0, 400, 50)):
        few = forces(mech, loads, q[part], strict=False)
        for key in (free, f"{free}_0", "R_12", "R_21", "eta"):
            assert np.allclose(few.value(key), row.value(key)[part], rtol=1e-9, atol=0, equal_nan=True), key


@pytest.mark.parametrize("internal", [False, True])
def test_it_does_not_matter_which_of_two_discs_is_named_first(internal: bool) -> None:
    """Outside each other, or a disc running inside a ring of the lever: contact of 1 on 2 or of 2 on 1."""
    small, large = Circle(link="1", centre="O", radius=0.03), Circle(link="2", centre="E", radius=0.05)
    found = []
    for disc, on in ((small, large), (large, small)):
        contact = Contact(point="K", disc=disc, on=on, substitute="OE", internal=internal)
        mech = make(
            {"A": 0, "P": 0.12 + 0.01j},
            [link("1", A=0, O=0.015), link("2", P=0, E=0.11, G=0.15), link("OE", O=0, E=0.02 if internal else 0.08)],
            pins("A 0 1, P 0 2, O 1 OE, E OE 2"),
            (40.0, 2.0),
            "E left O P",
        )
        mech = replace(mech, contacts=(contact,))
        for toward in (1.4, 1.4 + np.pi):
            loads = Loads(
                forces=(Force(name="Q", link="2", point="G", direction=toward, size=200.0),),
                moments=(Moment(name="M_1", link="1"),),
                friction=Friction(pins={"A": 0.002, "P": 0.003}, contacts={"K": 0.1}),
            )
            try:
                result = forces(mech, loads)
            except EquilibriumError:
                continue
            assert out_of_balance(result, mech, loads) < 1e-12
            assert result.power_in == pytest.approx(result.power_out + result.loss, rel=1e-9)
            found.append((complex(result.value("R_12")), complex(result.line("1", "2")), float(result.value("M_1"))))
    assert len(found) == 2 and found[0] == pytest.approx(found[1], rel=1e-9)
