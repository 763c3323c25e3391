"""Machines let go from a state: what they do by energy alone, told from positions; nothing is drawn of it."""

from __future__ import annotations

from math import degrees, radians
from typing import Any

import numpy as np
from numpy.typing import NDArray

from vecpoly import loads
from vecpoly.check.truth import exact_values
from vecpoly.mechanism.laws.windows import During
from vecpoly.mechanism.loads import GRAVITY, Loads
from vecpoly.mechanism.model import Mechanism
from vecpoly.oracle import solve

from ..family import OnText, family
from ..library import data_of
from ..running.machines import Random, crank_rocker, driven, slider_crank, weighed
from .loads import number

FINE = 60_001
CLOSE = 2e-5  # of a speed, or a time: the energy is told from places
Reals = NDArray[np.float64]


def by_energy(text: str) -> str:
    """(J_e + J_F) ω² / 2 grows by the work done on the way; the time is that of so many places."""
    problem, data = loads(text), data_of(text)
    values, run = exact_values(problem), data["machine"]
    assert problem.machine is not None
    known, mech = problem.machine.loads, problem.mechanism
    start, omega = radians(number(run["start"]["phi"])), number(run["start"]["omega"])
    sense = float(np.sign(omega))
    ways = [radians(number(text)) for text in (*run["at"], run["until"])]
    phi = start + sense * np.linspace(0.0, max(ways), FINE)
    inertia, work = _along(mech, known, phi)
    whole = inertia + number(run.get("J_F", "0"))
    square = (whole[0] * omega**2 + 2 * work) / whole
    if square.min() <= 1e-3 * omega**2:
        return ""  # it comes near to standing still: an affair of the last digits
    speed = sense * np.sqrt(square)
    pace = 1 / np.abs(speed)
    time = np.concatenate([[0.0], np.cumsum((pace[1:] + pace[:-1]) / 2 * np.abs(np.diff(phi)))])
    wanted = {"omega_end": _at(ways[-1], phi, speed, start), "t_end": _at(ways[-1], phi, time, start)}
    for way in ways[:-1]:
        name = f"{degrees(way):.10g}"
        wanted |= {f"omega_at_{name}": _at(way, phi, speed, start), f"t_at_{name}": _at(way, phi, time, start)}
    wanted["phi_end"] = degrees(start + sense * ways[-1])
    for key, value in wanted.items():
        if key in values and abs(complex(values[key]).real - value) > CLOSE * max(abs(value), 1e-3):
            return f"{key} is {values[key]}, by energy {value}"
    return "" if wanted.keys() & values.keys() else "nothing is answered"


def _at(way: float, phi: Reals, of: Reals, start: float) -> float:
    return float(np.interp(way, np.abs(phi - start), of))


def _along(mech: Mechanism, known: Loads, phi: Reals) -> tuple[Reals, Reals]:
    """J_e and the work since the start, at every place, from the places of the links alone."""
    motion = solve(mech, phi, order=0)
    inertia, work = np.zeros(FINE), np.zeros(FINE)
    for mass in known.masses:
        body = motion.bodies[mass.link]
        path = np.broadcast_to(body.point(mech.link(mass.link).points[mass.centre]), phi.shape)
        gone, spun = (np.gradient(of, phi, edge_order=2) for of in (path, _angle(body, phi)))
        inertia += mass.mass * np.abs(gone) ** 2 + mass.inertia * spun**2
        work -= mass.mass * GRAVITY * (path - path[0]).imag if known.weight else 0.0
    for load in known.moments:
        work += (load.size or 0.0) * _turned(load, _angle(motion.bodies[load.link], phi), phi)
    return np.asarray(inertia), np.asarray(work)


def _angle(body: Any, phi: Reals) -> Reals:
    return np.asarray(np.unwrap(np.angle(np.broadcast_to(body.unit, phi.shape))))


def _turned(load: Any, angle: Reals, phi: Reals) -> Reals:
    """By how much the link has turned since the start while the moment acted, place by place."""
    if load.law is None or not load.law.windows:
        return np.asarray(angle - angle[0])
    [window] = load.law.windows
    assert isinstance(window, During)
    wide = (window.high - window.low) % window.period
    whole: Reals = np.zeros(FINE)
    order = np.argsort(phi)
    first = np.floor((phi.min() - window.low) / window.period)
    for low in window.low + window.period * np.arange(first, first + 4):
        inside = np.clip(phi, low, low + wide)
        there = np.interp(inside, phi[order], angle[order])
        whole += there - there[0]
    return whole


@family("keys-motion", also=OnText(by_energy), often=2)
def motion(rng: Random) -> str:
    """A machine let go at a speed, with a flywheel in some, moments that act for a part of the turn, or always."""
    made = (crank_rocker, slider_crank)[int(rng.integers(2))](rng)
    told = f"  M_q: {{on: 1, size: {rng.integers(-40, 40)} N*m}}\n"
    if rng.random() < 0.6:
        link, low = made.rocker or "1", int(rng.integers(0, 360))
        during = f"during: [{low} deg, {(low + int(rng.integers(30, 200))) % 360} deg]"
        told += f"  M_w: {{on: {link}, size: {rng.integers(5, 60)} N*m {rng.choice(['cw', 'ccw'])}, {during}}}\n"
    start = f"{{phi: {rng.integers(0, 360)} deg, omega: {rng.integers(8, 40) * rng.choice([-1, 1])} rad/s}}"
    until = int(rng.integers(100, 700))
    at = sorted({int(one) for one in rng.integers(10, until, size=int(rng.integers(1, 4)))}, key=lambda _: rng.random())
    wheel = f", J_F: {rng.uniform(0.2, 4):.3f} kg*m^2" if rng.random() < 0.5 else ""
    places = ", ".join(f"{one} deg" for one in at)
    asked = ["omega_end", "t_end", "phi_end", *(f"{what}_at_{one}" for one in at for what in ("omega", "t"))]
    return (
        f"id: machine\ntitle: machine\n{driven(rng, made)}loads:\n{told}{weighed(rng, made)}"
        f"machine: {{start: {start}, until: {until} deg, at: [{places}]{wheel}}}\nfind: [{', '.join(asked)}]\n"
    )


def as_uneven_as_its_wheel(text: str) -> str:
    """With the flywheel that is there, δ, ω_max and ω_min by energy; ω_m is half of what both make."""
    problem, data = loads(text), data_of(text)
    values, run = exact_values(problem), data["machine"]
    assert problem.machine is not None
    mech, known = problem.mechanism, problem.machine.loads
    mean, way = number(run["n"]) * np.pi / 30, float(np.sign(mech.drive.rate))
    phi = way * np.linspace(0.0, 2 * np.pi, FINE)
    inertia, work = _along(mech, known, phi)
    surplus = work - work[-1] * np.linspace(0.0, 1.0, FINE)
    whole = inertia + number(run["J_F"])
    low, high = -2 * surplus.min(), 100 * mean**2 * whole.max()
    for _ in range(200):  # the kinetic energy with which the period begins, for the mean speed that is given
        middle = (low + high) / 2
        square = (middle + 2 * surplus) / whole
        fast, slow = np.sqrt(square.max()), np.sqrt(max(square.min(), 0.0))
        low, high = (middle, high) if (fast + slow) / 2 < mean else (low, middle)
    wanted = {"omega_max": fast, "omega_min": slow, "delta": (fast - slow) / mean}
    for key, value in wanted.items():
        if (
            abs(abs(complex(values[key]).real) - value)
            > 1e-4 * wanted["delta"] * (1 if key == "delta" else mean) + 1e-9
        ):
            return f"{key} is {values[key]}, by energy {value}"
    return ""


@family("keys-wheel-there", also=OnText(as_uneven_as_its_wheel), often=2)
def wheel_there(rng: Random) -> str:
    """The flywheel is there, and δ is sought."""
    made = (crank_rocker, slider_crank)[int(rng.integers(2))](rng)
    low = int(rng.integers(0, 360))
    told = f"  M_q: {{on: {made.rocker or '1'}, size: {rng.integers(50, 900)} N*m {rng.choice(['cw', 'ccw'])}, "
    told += f"during: [{low} deg, {(low + int(rng.integers(30, 200))) % 360} deg]}}\n  M_c: {{on: 1, size: constant}}\n"
    run = f"machine: {{n: {rng.integers(60, 200)} r/min, J_F: {rng.uniform(2, 80):.3f} kg*m^2}}\n"
    return (
        f"id: machine\ntitle: machine\n{driven(rng, made)}loads:\n{told}{weighed(rng, made)}{run}"
        "find: [delta, omega_max, omega_min]\n"
    )
