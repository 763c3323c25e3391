"""Groups loaded on both links:
the drawn polygon, virtual power and the lever agree with a linear solve written here, and with the oracle."""

from __future__ import annotations

import cmath
from collections.abc import Callable
from dataclasses import replace
from math import pi

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, assume, given, settings
from hypothesis import strategies as st

from tests.at_once import scaled
from tests.laws import few, often
from vecpoly import oracle
from vecpoly.board.construction import Construction, View
from vecpoly.board.hand import hand
from vecpoly.board.paper.marks import Point
from vecpoly.errors import AssemblyError, EquilibriumError, NoSlipSenseError, VecpolyError
from vecpoly.mechanism.asked.forces import quantities
from vecpoly.mechanism.loads import GRAVITY, Force, Friction, Loads, Mass, Moment
from vecpoly.mechanism.model import FRAME, Drive, Joint, Link, Mechanism, Prismatic, Revolute, Side, SideOf
from vecpoly.methods.plan import construct
from vecpoly.names import parse_rel
from vecpoly.oracle.forces import forces
from vecpoly.problem.asked.asks import AskNamed
from vecpoly.problem.problem import Problem
from vecpoly.words import Words

CHECKED = settings(max_examples=often(3), suppress_health_check=[HealthCheck.filter_too_much, HealthCheck.too_slow])
angles = st.floats(-pi, pi)
rates = st.sampled_from([-12.0, 3.0, 10.0])
sizes = st.floats(0.6, 1.6)
forces_n = st.floats(-300.0, 300.0)
OFF = {"2": 0.03 + 0.02j, "3": -0.02 + 0.03j}


# -- mechanisms: crank 1 and one group of links 2 and 3, whose centres of mass are off their lines
# --------------------------------


def link(name: str, **points: complex) -> Link:
    return Link(name=name, points=points)


def crank_and(
    frame: dict[str, complex],
    two: Link,
    three: Link,
    joints: tuple[Joint, ...],
    phi: float,
    rate: float,
    branches: tuple[SideOf, ...] = (),
) -> Mechanism:
    one = link("1", A=0j, B=0.1 + 0j)
    return Mechanism(
        frame={"A": 0j, **frame},
        links=(one, two, three),
        joints=(Revolute(point="A", a="0", b="1"), *joints),
        drives=(Drive(link="1", position=phi, rate=rate, accel=7.0),),
        branches=branches,
    )


def rrr(phi: float, rate: float, k: float) -> Mechanism:
    return crank_and(
        {"D": 0.25 + 0.03j},
        link("2", B=0j, C=0.24 * k + 0j, S2=0.1 + OFF["2"]),
        link("3", D=0j, C=0.2 * k + 0j, S3=0.1 + OFF["3"]),
        (Revolute(point="B", a="1", b="2"), Revolute(point="C", a="2", b="3"), Revolute(point="D", a="0", b="3")),
        phi,
        rate,
        (SideOf(point="C", side=Side.LEFT, ref=("B", "D")),),
    )


def rrp(phi: float, rate: float, k: float) -> Mechanism:
    return crank_and(
        {},
        link("2", B=0j, C=0.25 * k + 0j, S2=0.1 + OFF["2"]),
        link("3", C=0j, S3=OFF["3"]),
        (
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="2", b="3"),
            Prismatic(guide="0", block="3", origin=0.01j, direction=0.1, pin="C"),
        ),
        phi,
        rate,
        (SideOf(point="C", side=Side.RIGHT, ref=("B",)),),
    )


def rpr_rocker(phi: float, rate: float, k: float) -> Mechanism:
    """Block 2 on the crank's pin runs in the slot of rocker 3."""
    return crank_and(
        {"C": complex(0, -0.2 * k)},
        link("2", B=0j, S2=OFF["2"]),
        link("3", C=0j, S3=0.12 + OFF["3"]),
        (
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="0", b="3"),
            Prismatic(guide="3", block="2", origin=0j, direction=0.0, pin="B", offset=0.02),
        ),
        phi,
        rate,
    )


def rpr_block(phi: float, rate: float, k: float) -> Mechanism:
    """Rod 2 on the crank's pin runs through the swinging block 3."""
    return crank_and(
        {"C": complex(0.22 * k)},
        link("2", B=0j, S2=0.12 + OFF["2"]),
        link("3", C=0j, S3=OFF["3"]),
        (
            Revolute(point="B", a="1", b="2"),
            Revolute(point="C", a="0", b="3"),
            Prismatic(guide="2", block="3", origin=0j, direction=0.0, pin="C", offset=0.015),
        ),
        phi,
        rate,
    )


def rpp(phi: float, rate: float, k: float) -> Mechanism:
    """Sine mechanism: block 2 on the crank's pin in the slot of link 3, which slides in the frame."""
    return crank_and(
        {},
        link("2", B=0j, S2=OFF["2"]),
        link("3", H=0j, S3=0.05 + OFF["3"]),
        (
            Revolute(point="B", a="1", b="2"),
            Prismatic(guide="3", block="2", origin=0j, direction=pi / 2 + 0.2 * (k - 1), pin="B"),
            Prismatic(guide="0", block="3", origin=0.01j, direction=0.0, pin="H"),
        ),
        phi,
        rate,
    )


def prp(phi: float, rate: float, k: float) -> Mechanism:
    """Tangent mechanism: block 2 slides along the crank and is pinned to link 3, which slides in the frame."""
    return crank_and(
        {},
        link("2", C=0j, S2=OFF["2"]),
        link("3", C=0j, S3=OFF["3"]),
        (
            Prismatic(guide="1", block="2", origin=0j, direction=0.0, pin="C"),
            Revolute(point="C", a="2", b="3"),
            Prismatic(guide="0", block="3", origin=complex(0.15 * k), direction=pi / 2, pin="C"),
        ),
        phi,
        rate,
    )


Kind = Callable[[float, float, float], Mechanism]
KINDS: list[Kind] = [rrr, rrp, rpr_rocker, rpr_block, rpp, prp]


def both_loaded(
    mech: Mechanism, f2: float, f3: float, couple: float, *, friction: Friction | None = None, unknown: str = "1"
) -> Loads:
    """Forces at S2 and S3, a couple on 3 where it can turn, masses on both; the crank's moment balances."""
    return Loads(
        forces=(
            Force(name="F", link="3", point="S3", direction=-2.0, size=f3),
            Force(name="Q", link="2", point="S2", direction=0.7, size=f2),
        ),
        moments=(Moment(name=f"M_{unknown}", link=unknown), Moment(name="M_3", link="3", size=couple)),
        masses=(
            Mass(link="2", mass=1.5, inertia=0.004, centre="S2"),
            Mass(link="3", mass=2.5, inertia=0.02, centre="S3"),
        ),
        friction=friction or Friction(),
        weight=True,
    )


def drawn(mech: Mechanism, loads: Loads, by: str = "exact", repeats: int = 0) -> Construction:
    still = {f"h_{mass.link}" for mass in loads.masses if mass.centre in mech.frame}  # no inertia force to displace
    asks = tuple(
        AskNamed(rel=named)
        for key, named in quantities(mech, loads).items()
        if key not in still and (loads.friction or not key.endswith("_0"))
    )
    problem = Problem(id="random", title=Words("", ""), subject=mech, asks=asks, loads=loads)
    return construct(scaled(problem), hand(by, repeats=repeats))[0]


# -- this file's own statics: three equations a link, frictionless, kinematics from the oracle
# ----------------------------------------


def own_solve(mech: Mechanism, loads: Loads) -> tuple[dict[str, complex], float]:
    """Reactions (N, force of the first link on the second by printed numbers),
    the balancing moment, and the system's condition."""
    motion = oracle.solve(mech)
    at = {p: complex(motion.value(parse_rel(f"p_{p}"))) for li in mech.links for p in li.points} | dict(mech.frame)
    names = [li.name for li in mech.links]
    columns: list[np.ndarray] = []
    labels: list[tuple[str, str, complex]] = []

    def column(on: str, by: str, force: complex, place: complex, couple: float = 0.0) -> np.ndarray:
        c = np.zeros(3 * len(names))
        for name, sign in ((on, 1.0), (by, -1.0)):
            if name != FRAME:
                i = 3 * names.index(name)
                c[i : i + 3] += sign * np.array(
                    [force.real, force.imag, ((place.conjugate() * force).imag + couple) / 0.1]
                )
        return c

    for joint in mech.joints:
        if isinstance(joint, Revolute):
            for unit in (1 + 0j, 1j):
                columns.append(column(joint.b, joint.a, unit, at[joint.point]))
                labels.append((joint.a, joint.b, unit))
        elif isinstance(joint, Prismatic):
            heading = joint.direction + (0.0 if joint.guide == FRAME else turned(motion, mech, joint.guide))
            normal = 1j * np.exp(1j * heading)
            columns.append(column(joint.block, joint.guide, normal, at[joint.pin]))
            labels.append((joint.guide, joint.block, normal))
            columns.append(column(joint.block, joint.guide, 0j, 0j, 0.1))
            labels.append((joint.guide, joint.block, 0j))
    columns.append(column(loads.unknown.link, FRAME, 0j, 0j, 0.1))
    given = np.zeros(3 * len(names))
    for load in loads.all:
        if load.size is not None:
            force = load.size * np.exp(1j * load.direction) if isinstance(load, Force) else 0j
            given += column(
                load.link,
                FRAME,
                force,
                at[load.point] if isinstance(load, Force) else 0j,
                0.0 if isinstance(load, Force) else load.size,
            )
    for mass in loads.masses:
        force = -mass.mass * motion.value(parse_rel(f"a_{mass.centre}")) - 1j * mass.mass * GRAVITY * loads.weight
        given += column(
            mass.link,
            FRAME,
            complex(force),
            at[mass.centre],
            -mass.inertia * float(motion.value(parse_rel(f"alpha_{mass.link}"))),
        )
    matrix = np.stack(columns, axis=1)
    solution = np.linalg.solve(matrix, -given)
    found: dict[str, complex] = {}
    for (by, on, unit), value in zip(labels, solution, strict=False):
        key = f"R_{mech.number(by)}{mech.number(on)}"
        found[key] = found.get(key, 0j) + unit * value
    found[loads.unknown.name] = complex(solution[-1] * 0.1)
    return found, float(np.linalg.cond(matrix))


def turned(motion: oracle.Motion, mech: Mechanism, name: str) -> float:
    """Angle of a link's x axis, from two of its points."""
    (p, p0), (q, q0) = list(mech.link(name).points.items())[:2]
    there = motion.value(parse_rel(f"p_{q}")) - motion.value(parse_rel(f"p_{p}"))
    return float(np.angle(there / (q0 - p0)))


def close_to(construction: Construction, key: str, truth: complex, size: float) -> None:
    reading = construction.readings[key]
    value = reading.vector if reading.vector is not None else reading.scalar
    assert abs(value - truth) <= 1e-9 * size, key


# -- without friction
# ------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", few(KINDS, 2))
@CHECKED
@given(angles, rates, sizes, forces_n, forces_n, st.floats(-20.0, 20.0))
def test_polygon_lever_and_virtual_power_agree_with_a_linear_solve(
    kind: Kind, phi: float, rate: float, k: float, f2: float, f3: float, couple: float
) -> None:
    mech = kind(phi, rate, k)
    loads = both_loaded(mech, f2, f3, couple)
    try:
        truth, condition = own_solve(mech, loads)
    except AssemblyError:
        assume(False)
    assume(condition < 1e4)  # not beside a dead point
    construction = drawn(mech, loads)
    size = max(abs(v) for v in truth.values()) + 1.0
    for key, value in truth.items():
        close_to(construction, key, value, size)
    for key in ("M_1_lever", "M_1_power"):
        close_to(construction, key, truth["M_1"], size)


@pytest.mark.parametrize("kind", KINDS)
def test_the_powers_of_all_loads_sum_to_zero(kind: Kind) -> None:
    mech = kind(0.9, 10.0, 1.1)
    loads = both_loaded(mech, 120.0, -90.0, 8.0)
    motion, balance = oracle.solve(mech), drawn(mech, loads).readings["M_1"].scalar
    total, largest = balance * 10.0, abs(balance * 10.0)
    for load in loads.all:
        if load.size is not None:
            power = (
                (np.conj(load.size * np.exp(1j * load.direction)) * motion.value(parse_rel(f"v_{load.point}"))).real
                if isinstance(load, Force)
                else load.size * float(motion.value(parse_rel(f"omega_{load.link}")))
            )
            total, largest = total + power, max(largest, abs(power))
    for mass in loads.masses:
        v, a = (complex(motion.value(parse_rel(f"{stem}_{mass.centre}"))) for stem in "va")
        omega, alpha = (float(motion.value(parse_rel(f"{stem}_{mass.link}"))) for stem in ("omega", "alpha"))
        total += ((-mass.mass * (a + 1j * GRAVITY)).conjugate() * v).real - mass.inertia * alpha * omega
    assert abs(total) <= 1e-9 * largest


@pytest.mark.parametrize("kind", KINDS)
def test_the_drawn_reactions_hold_every_link_in_equilibrium(kind) -> None:  # type: ignore[no-untyped-def]
    """Summed from the exported vectors and points of the lines of action, moments included."""
    mech = kind(0.9, 10.0, 1.1)
    loads = both_loaded(mech, 120.0, -90.0, 8.0)
    readings, motion = drawn(mech, loads).readings, oracle.solve(mech)
    for li in mech.links:
        force, moment, largest = 0j, 0.0, 1.0
        acting = [
            (r.vector, r.acts.point)
            for key, r in readings.items()
            if key.startswith("R_") and key.endswith(li.name) and r.acts is not None and r.vector is not None
        ]
        for load in loads.on(li.name):
            if isinstance(load, Force):
                assert load.size is not None
                acting.append(
                    (load.size * cmath.exp(1j * load.direction), complex(motion.value(parse_rel(f"p_{load.point}"))))
                )
            else:
                moment += readings["M_1"].scalar if load.size is None else load.size
        mass = loads.mass(li.name)
        if mass is not None:
            centre = complex(motion.value(parse_rel(f"p_{mass.centre}")))
            acting.append((-1j * mass.mass * GRAVITY, centre))
            inertia = readings[f"F_I{li.name}"]
            assert inertia.acts is not None and inertia.vector is not None
            arm_kept = inertia.acts.point != centre
            acting.append((inertia.vector, centre))
            moment += readings[f"M_I{li.name}"].scalar
            if arm_kept and readings[f"M_I{li.name}"].scalar:  # the displaced force alone does the same
                turn = ((inertia.acts.point - centre).conjugate() * inertia.vector).imag
                assert (
                    turn == pytest.approx(readings[f"M_I{li.name}"].scalar, rel=1e-6)
                    or abs(readings[f"h_{li.name}"].scalar) > mech.scale
                )
        for vector, point in acting:
            force, moment, largest = (
                force + vector,
                moment + (point.conjugate() * vector).imag,
                max(largest, abs(vector)),
            )
        assert abs(force) <= 1e-9 * largest
        assert abs(moment) <= 1e-9 * largest


def test_inertia_displaces_the_force_against_the_acceleration_and_the_angular_acceleration() -> None:
    mech = rrr(0.9, 10.0, 1.1)
    loads = both_loaded(mech, 0.0, 0.0, 0.0)
    readings, motion = drawn(mech, loads).readings, oracle.solve(mech)
    for name, mass in (("2", loads.masses[0]), ("3", loads.masses[1])):
        a, alpha = motion.value(parse_rel(f"a_S{name}")), float(motion.value(parse_rel(f"alpha_{name}")))
        force, couple, arm = readings[f"F_I{name}"], readings[f"M_I{name}"], readings[f"h_{name}"]
        assert force.vector == pytest.approx(-mass.mass * a, rel=1e-9)
        assert couple.scalar == pytest.approx(-mass.inertia * alpha, rel=1e-9)
        assert arm.scalar == pytest.approx(abs(mass.inertia * alpha) / abs(mass.mass * a), rel=1e-9)
        assert force.acts is not None
        assert abs(force.acts.point - motion.value(parse_rel(f"p_S{name}"))) == pytest.approx(arm.scalar, rel=1e-9)


def test_a_couple_without_an_inertia_force_stays_a_couple() -> None:
    """A rocker whose centre of mass is its pivot: F_I = 0, M_I ≠ 0."""
    mech = rrr(0.9, 10.0, 1.1)
    loads = Loads(moments=(Moment(name="M_1", link="1"),), masses=(Mass(link="3", mass=2.0, inertia=0.05, centre="D"),))
    construction = drawn(mech, loads)
    motion = oracle.solve(mech)
    work = -0.05 * float(motion.value(parse_rel("alpha_3"))) * float(motion.value(parse_rel("omega_3")))
    assert construction.readings["F_I3"].scalar == 0.0
    assert construction.readings["M_1"].scalar == pytest.approx(-work / 10.0, rel=1e-9)
    assert construction.readings["M_1_lever"].scalar == pytest.approx(-work / 10.0, rel=1e-9)


def test_a_balancing_force_on_a_slider_is_found_three_ways() -> None:
    mech = rrp(0.9, 10.0, 1.0)
    loads = Loads(
        forces=(Force(name="F_b", link="3", point="C", direction=0.1),),
        moments=(Moment(name="M_1", link="1", size=12.0),),
        masses=(
            Mass(link="2", mass=1.5, inertia=0.004, centre="S2"),
            Mass(link="1", mass=0.8, inertia=0.001, centre="A"),
        ),
    )
    readings = drawn(mech, loads).readings
    truth = float(forces(mech, loads).value("F_b"))
    for key in ("F_b", "F_b_lever", "F_b_power"):
        assert readings[key].scalar == pytest.approx(truth, rel=1e-9)


def test_a_balancing_load_that_does_no_work_is_refused_by_name() -> None:
    mech = rrp(0.9, 10.0, 1.0)
    loads = Loads(
        forces=(
            Force(name="F_b", link="3", point="C", direction=0.1 + pi / 2),
            Force(name="Q", link="2", point="S2", direction=1.0, size=50.0),
        )
    )
    with pytest.raises(EquilibriumError):
        drawn(mech, loads)


# -- with friction
# ---------------------------------------------------------------------------------------------------------------------

RUBBED = settings(
    CHECKED, max_examples=often(2), phases=(Phase.explicit, Phase.reuse, Phase.generate)
)  # each example costs a dozen passes
RUBBING: dict[Kind, Friction] = {
    rrr: Friction(pins={"A": 0.004, "B": 0.003, "C": 0.003, "D": 0.005}),
    rrp: Friction(pins={"A": 0.004, "B": 0.003, "C": 0.003}, slides={("3", "0"): 0.1}),
    rpr_rocker: Friction(pins={"A": 0.004, "B": 0.003, "C": 0.004}, slides={("2", "3"): 0.12}),
    rpr_block: Friction(pins={"A": 0.004, "B": 0.003, "C": 0.004}, slides={("3", "2"): 0.12}),
    rpp: Friction(pins={"A": 0.004, "B": 0.003}, slides={("2", "3"): 0.1, ("3", "0"): 0.12}),
    prp: Friction(pins={"A": 0.004, "C": 0.003}, slides={("2", "1"): 0.1, ("3", "0"): 0.12}),
}


@pytest.mark.parametrize("kind", few(KINDS, 3))
@RUBBED
@given(angles, rates, sizes, forces_n, forces_n, st.floats(-20.0, 20.0))
def test_with_friction_the_drawing_agrees_with_the_oracle_or_both_refuse(
    kind: Kind, phi: float, rate: float, k: float, f2: float, f3: float, couple: float
) -> None:
    mech = kind(phi, rate, k)
    loads = both_loaded(mech, f2, f3, couple, friction=RUBBING[kind])
    try:
        _, condition = own_solve(mech, loads)
    except AssemblyError:
        assume(False)
    assume(condition < 1e3)
    try:
        result = forces(mech, loads)
    except NoSlipSenseError:
        assume(False)  # within a hair of rest either may still see a motion
    except VecpolyError:
        with pytest.raises(VecpolyError):
            drawn(mech, loads)
        return
    construction = drawn(mech, loads)
    keys = [key for key in construction.readings if key[:2] == "R_" or key == "M_1"]
    size = max(abs(complex(np.ravel(result.value(key))[0])) for key in keys) + 1.0
    for key in keys:
        close_to(construction, key, complex(np.ravel(result.value(key))[0]), size)


def test_a_slide_with_friction_that_does_not_slide_is_refused() -> None:
    """Crank and rod in line: the rod does not move through the swinging block."""
    mech = rpr_block(0.0, 10.0, 1.0)
    slide = mech.joints[3]
    assert isinstance(slide, Prismatic)
    mech = replace(mech, joints=(*mech.joints[:3], replace(slide, offset=0.0)))
    with pytest.raises(NoSlipSenseError):
        drawn(mech, both_loaded(mech, 120.0, -90.0, 8.0, friction=RUBBING[rpr_block]))


# -- hands and steps
# -------------------------------------------------------------------------------------------------------------------


def test_an_unsteady_hand_scatters_about_the_exact_answer() -> None:
    mech = rrr(0.9, 10.0, 1.1)
    loads = both_loaded(mech, 120.0, -90.0, 8.0)
    data = tuple(
        AskNamed(rel=named)
        for key, named in quantities(mech, loads).items()
        if key.startswith(("M_1", "R_", "F_I", "h_")) and not key.endswith("_0")
    )
    problem = Problem(id="random", title=Words("", ""), subject=mech, asks=data, loads=loads)
    sheet = construct(problem, hand("pencil", repeats=200))
    construction, repeats = sheet.construction, sheet.repeats
    exact = drawn(mech, loads).readings
    for key in ("M_1", "M_1_lever", "M_1_power", "R_12", "R_43", "F_I2"):
        assert np.isfinite(repeats[key]).all()
        first, *others = np.asarray(repeats[key])
        spread = float(np.std(others))
        assert 0 < spread < 0.2 * abs(exact[key].scalar)
        assert abs(float(np.mean(others)) - exact[key].scalar) < 3 * spread
        assert construction.readings[key].scalar == pytest.approx(float(first))


def test_the_lever_is_the_velocity_polygon_turned_by_a_right_angle() -> None:
    construction = drawn(rrr(0.9, 10.0, 1.1), both_loaded(rrr(0.9, 10.0, 1.1), 120.0, -90.0, 8.0))
    velocity, lever = (
        next(f for f in construction.figures if f.view is View.VELOCITY and f.name == name) for name in ("", "lever")
    )
    tips, turned_tips = ({m.label: m.at for m in figure.marks if isinstance(m, Point)} for figure in (velocity, lever))
    for letter in ("b", "c", "s_2", "s_3"):
        assert turned_tips[letter] == pytest.approx(-1j * tips[letter], abs=1e-9)


def test_the_steps_name_the_moment_equations_and_every_reaction_in_both_languages() -> None:
    construction = drawn(rrr(0.9, 10.0, 1.1), both_loaded(rrr(0.9, 10.0, 1.1), 120.0, -90.0, 8.0))
    zh = "".join(step.words.zh for step in construction.steps)
    en = "".join(step.words.en for step in construction.steps)
    for text in (zh, en):
        for symbol in ("R^t_{12}", "R^n_{12}", "R^t_{43}", "R_{32}", "ΣM"):
            assert symbol in text, symbol
