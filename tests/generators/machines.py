"""Random machines: equivalents judged by places that are differenced, flywheels by the speed that they leave."""

from __future__ import annotations

import re

import numpy as np

from vecpoly import loads
from vecpoly.errors import VecpolyError
from vecpoly.mechanism.asked.machine import equivalents
from vecpoly.mechanism.loads import GRAVITY, Loads
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import solve
from vecpoly.solution import Solution

from .family import families, family

BASES = ("linkage-rrr", "linkage-rrp", "linkage-rpr", "linkage-rpp", "linkage-slide", "gears-trains", "class-iii")
STEP = 1e-4  # rad, or m over the mechanism's size
FINE = 7200  # places of a turn at which the finished machine is looked at
CLOSE = 2e-5  # central differences
SPREAD = 2e-3  # sums over those places


def energy_and_power_by_places(solution: Solution) -> str:
    """J_e = Σ m |dr/dq|² + Σ J (dφ/dq)² and M_e = Σ F · dr/dq + Σ M dφ/dq of the drive, from places near by."""
    problem = solution.problem
    assert problem.machine is not None
    mech, acting = problem.mechanism, problem.machine.loads
    try:
        near, far = (_differences(mech, acting, step) for step in (STEP, 2 * STEP))
    except VecpolyError:
        return ""  # too near the end of the range
    to = equivalents(mech)[0]
    sign = float(np.sign(mech.drive.rate)) if to.slide else 1.0
    big = max(abs(near[1]), *(abs(load.size or 0) * mech.scale for load in acting.all), 1e-6)
    for key, (one, other), scale in zip(
        (to.inertia.key, to.load.key), zip(near, far, strict=True), (max(near[0], 1e-9), big), strict=True
    ):
        better, drawn = (4 * one - other) / 3, float(np.real(solution.answers[key].exact))
        better *= sign if key == to.load.key else 1.0
        if abs(drawn - better) > CLOSE * scale + abs(one - other):
            return f"{key} = {drawn}, but {better} by differences"
    return ""


def _differences(mech: Mechanism, acting: Loads, part: float) -> tuple[float, float]:
    """J_e and M_e of the drive by central differences."""
    step = part * (mech.scale if mech.drive.slide else 1.0)
    motion = solve(mech, mech.drive.position + step * np.array([-1.0, 1.0]), order=0)

    def place(point: str, link: str) -> complex:
        before, after = np.broadcast_to(motion.bodies[link].point(mech.link(link).points[point]), (2,))
        return complex((after - before) / (2 * step))

    def turn(link: str) -> float:
        before, after = np.broadcast_to(motion.bodies[link].unit, (2,))
        return float(np.angle(after / before) / (2 * step))

    energy = sum(m.mass * abs(place(m.centre, m.link)) ** 2 + m.inertia * turn(m.link) ** 2 for m in acting.masses)
    pushed = [
        ((one.size or 0) * np.exp(-1j * one.direction) * place(one.point, one.link)).real for one in acting.forces
    ]
    turned = [(one.size or 0) * turn(one.link) for one in acting.moments]
    fallen = [-m.mass * GRAVITY * place(m.centre, m.link).imag for m in acting.masses if acting.weight]
    return float(energy), float(sum([*pushed, *turned, *fallen]))


@family("machine-equivalents", also=energy_and_power_by_places, often=3)
def equivalent(rng: np.random.Generator) -> str:
    """Any linkage, gears and class III with masses and loads, some with weights."""
    made = [one for one in families() if one.name in BASES]
    text = made[int(rng.integers(len(made)))].make(rng)
    mech = loads(text).mechanism
    names = [name for name in mech.numbered if mech.link(name).points]
    masses, told = "", ""
    for name in rng.permutation(names)[: int(rng.integers(1, 4))]:
        point = str(rng.choice(list(mech.link(str(name)).points)))
        size, inertia = rng.uniform(0.5, 20), rng.uniform(0, 0.2)
        masses += f"  {name}: {{mass: {size:.3f} kg, inertia: {inertia:.4f} kg*m^2, centre: {point}}}\n"
    for i in range(int(rng.integers(1, 3))):
        link = str(rng.choice(names))
        point = str(rng.choice(list(mech.link(link).points)))
        told += (
            f"  M_q{i}: {{on: {link}, size: {rng.integers(-30, 30) or 7} N*m}}\n"
            if rng.random() < 0.4
            else f"  F_q{i}: {{on: {link}, at: {point}, size: {rng.integers(20, 900)} N, direction: "
            f"{rng.integers(-179, 180)} deg}}\n"
        )
    keys = "m_e, F_e" if mech.drive.slide else "J_e, M_e"
    bare = re.sub(r"^find:.*\n", f"find: [{keys}]\n", text if text.endswith("\n") else text + "\n", flags=re.MULTILINE)
    weight = "weight: yes\n" if rng.random() < 0.4 else ""
    return f"{bare}loads:\n{told}masses:\n{masses}{weight}"


def the_machine_is_as_even_as_was_asked(solution: Solution) -> str:
    """With the flywheel found: of ω² = 2 (T_0 + E) / (J_F + J_e), with ω_max given, ω_min comes out."""
    problem = solution.problem
    mech, machine = problem.mechanism, problem.machine
    assert machine is not None and machine.steady is not None
    run, delta = machine.steady, machine.steady.delta
    assert delta is not None
    answers = {key: float(np.real(one.exact)) for key, one in solution.answers.items()}
    turn = np.linspace(0.0, 2 * np.pi, FINE + 1)
    motion = solve(mech, turn, order=0)
    inertia, work = np.zeros(FINE), np.zeros(FINE)
    for mass in machine.loads.masses:
        body = motion.bodies[mass.link]
        gone = np.abs(np.diff(np.broadcast_to(body.point(mech.link(mass.link).points[mass.centre]), turn.shape)))
        spun = np.angle(np.broadcast_to(body.unit, turn.shape)[1:] / np.broadcast_to(body.unit, turn.shape)[:-1])
        inertia += (mass.mass * gone**2 + mass.inertia * spun**2) / (turn[1] - turn[0]) ** 2
    for load in machine.loads.moments:
        window = load.law.windows[0] if load.law is not None else None
        middle = np.degrees((turn[1:] + turn[:-1]) / 2)
        acts = (middle > np.degrees(window.low)) & (middle < np.degrees(window.high)) if window is not None else True  # type: ignore[union-attr]
        unit = motion.bodies[load.link].unit
        spun = np.angle(np.broadcast_to(unit, turn.shape)[1:] / np.broadcast_to(unit, turn.shape)[:-1])
        work += np.where(acts, (load.size or 0.0) * spun, 0.0)
    energy = np.cumsum(work - work.sum() / FINE)
    whole = answers["J_F"] + inertia
    if answers["J_F"] == 0:
        return ""
    top = run.speed * (1 + delta / 2)
    start = float(np.min(top**2 * whole / 2 - energy))
    slowest = float(np.sqrt(np.min(2 * (start + energy) / whole)))
    wanted = run.speed * (1 - delta / 2)
    wrong = abs(slowest - wanted) > SPREAD * run.speed * delta + 1e-6 * run.speed
    return f"with this flywheel ω_min is {slowest}, not {wanted}" if wrong else ""


@family("machine-flywheels", also=the_machine_is_as_even_as_was_asked, often=1, first=3)
def flywheel(rng: np.random.Generator) -> str:
    """A crank-rocker whose rocker meets a moment during part of the turn."""
    crank = rng.uniform(60, 110)
    coupler, rocker = (crank * rng.uniform(2.2, 3.5) for _ in range(2))
    base = rng.uniform(max(abs(coupler - rocker) + crank * 1.1, crank * 1.6), coupler + rocker - 1.1 * crank)
    first, long, way = rng.integers(5, 200), rng.integers(40, 150), rng.choice(["cw", "ccw"])
    side = rng.choice(["left", "right"])
    return (
        f"id: machine\ntitle: machine\nframe: {{A: [0 mm, 0 mm], D: [{base:.3f} mm, 0 mm]}}\n"
        f"links: {{1: {{AB: {crank:.3f} mm}}, 2: {{BC: {coupler:.3f} mm}}, 3: {{CD: {rocker:.3f} mm}}}}\n"
        f"input: {{link: 1, phi: {rng.integers(10, 350)} deg, omega: {rng.integers(30, 300)} r/min ccw}}\n"
        f"branch: [C {side} of BD]\nloads:\n"
        f"  M_q: {{on: 3, size: {rng.integers(50, 900)} N*m {way}, during: [{first} deg, {first + long} deg]}}\n"
        f"  M_c: {{on: 1, size: constant}}\nmasses:\n"
        f"  1: {{mass: 5 kg, inertia: {rng.uniform(0.01, 0.1):.4f} kg*m^2, centre: A}}\n"
        f"  2: {{mass: {rng.uniform(1, 9):.3f} kg, inertia: {rng.uniform(0.01, 0.1):.4f} kg*m^2, "
        f"centre: {{along: BC, at: {coupler / 2:.3f} mm}}}}\n"
        f"  3: {{mass: {rng.uniform(1, 9):.3f} kg, inertia: {rng.uniform(0.01, 0.1):.4f} kg*m^2, "
        f"centre: {{along: DC, at: {rocker / 2:.3f} mm}}}}\n"
        f"machine: {{n: {rng.integers(60, 200)} r/min, delta: {rng.uniform(0.02, 0.2):.4f}}}\n"
        "find: [M_c, dW_max, J_F, J_F_areas, phi_max, phi_min]\n"
    )
