"""Epicyclic trains of every sort by any two speeds; flywheels of powers, of both curves, on another shaft, with a rim.

Third parties: rolling without slip at both pitch points; work and inertia by small steps and in the finished ring.
"""

from __future__ import annotations

from math import pi

import numpy as np

from vecpoly.devices.dynamics.flywheel import Flywheel
from vecpoly.devices.dynamics.given import Torques
from vecpoly.devices.gears.epicyclic import Epicyclic
from vecpoly.solution import Solution

from ..family import family
from .statics import Random, file

STEPS = 200_001
NEAR = 1e-9


def rolls(solution: Solution) -> str:
    """Both gears at a pitch point move alike, and the given speeds are kept."""
    train, found = solution.problem.device, solution.answers
    assert isinstance(train, Epicyclic)
    half = train.m.si / 2
    arm, first = half * (train.sun + train.planet[0]), half * train.planet[0]
    inner = train.ring is not None
    module = arm / (train.other - train.planet[-1] if inner else train.other + train.planet[-1])
    last, outer = module * train.planet[-1], module * train.other
    omega = {link: found[f"omega_{link}"].exact for link in ("1", "2", "3", "H")}
    at_a = omega["H"] * arm - omega["2"] * first - omega["1"] * half * train.sun
    at_c = omega["H"] * arm + (last if inner else -last) * omega["2"] - omega["3"] * outer
    size = max(map(abs, omega.values())) * max(arm, outer)
    kept = [abs(omega[key] - one.si) for key, one in train.omegas.items() if one is not None]
    speeds = {"v_A": omega["1"] * half * train.sun, "v_O2": omega["H"] * arm, "v_C": omega["3"] * outer}
    off = max(abs(found[key].exact - value) for key, value in speeds.items() if key in found)
    if max(abs(at_a), abs(at_c), off) > NEAR * size or max(kept) > NEAR * size / arm:
        return f"slips by {at_a:g} and {at_c:g} m/s, given speeds off by {kept}, points by {off:g}"
    return ""


@family("device-epicyclic", also=rolls, often=3)
def epicyclic(rng: Random) -> str:
    """Plain or stepped planets, in a ring or between two suns, any two speeds."""
    sun, planet = (int(z) for z in rng.integers(12, 60, 2))
    match int(rng.integers(3)):
        case 0:
            teeth = f"sun: {sun}, planet: {planet}, ring: {sun + 2 * planet}"
        case 1:
            second = int(rng.integers(12, 60))
            teeth = f"sun: {sun}, planet: [{planet}, {second}], ring: {second + int(rng.integers(8, 70))}"
        case _:
            teeth = f"sun: {sun}, planet: [{planet}, {rng.integers(12, 60)}], sun_2: {rng.integers(12, 60)}"
    speeds = [
        f"omega_{key}: {rng.choice([0, 1]) * rng.uniform(-60, 60):.2f} rad/s" for key in rng.permutation(list("13H"))
    ]
    speeds[0] = speeds[0].replace(": 0.00", ": 12.5").replace(": -0.00", ": 12.5")
    return file("epicyclic", f"{teeth}, m: {rng.choice([1, 2, 2.5, 4])} mm, {speeds[0]}, {speeds[1]}")


def turns_evenly(solution: Solution) -> str:
    """The constant moment, ΔW_max, what is needed, and the ring, from the data alone."""
    wheel, found = solution.problem.device, {key: one.exact for key, one in solution.answers.items()}
    assert isinstance(wheel, Flywheel) and isinstance(wheel.load, Torques)
    load = wheel.load
    fine = np.linspace(0, load.period, STEPS)
    middle, step = (fine[1:] + fine[:-1]) / 2, fine[1]
    curves = [np.interp(middle, *np.array(one.over(load.period)).T) for one in (load.driving, load.resisting)]
    rest = [np.mean(curves[1 - n]) if load.sought == key else curves[n] for n, key in enumerate("dr")]
    surplus = rest[0] - rest[1]
    swing = float(np.ptp(np.r_[0.0, np.cumsum(surplus) * step]))
    near = 3e-4 * float(np.sum(np.abs(surplus))) * step + 1e-9
    if abs(found["dW_max"] - swing) > near:
        return f"ΔW_max {found['dW_max']:g}, by small steps {swing:g} J"
    has, speed, exact = wheel.J.si if wheel.J is not None else 0.0, abs(wheel.n.si), found["dW_max"]
    if wheel.delta is None:
        worked = {"delta": exact / (has * speed**2)}
    else:
        own = max(exact / (wheel.delta.si * speed**2) - has, 0.0)
        worked = {"J_F": own, "GD2": 4 * 9.81 * own, "delta": exact / ((has + own) * speed**2)}
        if wheel.shaft is not None:
            worked["J_F2"] = own * speed**2 / wheel.shaft.si**2
    worked |= {
        "n_max": speed * (1 + worked["delta"] / 2) * 30 / pi,
        "n_min": speed * (1 - worked["delta"] / 2) * 30 / pi,
    }
    for key, value in worked.items():
        if key in found and abs(found[key] - value) > NEAR * max(abs(value), 1e-9):
            return f"{key} = {found[key]:g}, by the data {value:g}"
    return _ring(wheel, found, speed)


def _ring(wheel: Flywheel, found: dict[str, float], speed: float) -> str:
    """A ring of these sizes and this density weighs so much, has its mass on D, and ends where it moves so fast."""
    rim = wheel.rim
    if rim is None or "h" not in found or not found["h"]:
        return ""
    high, wide = found["h"], found["b"]
    mass = rim.density.si * wide * pi / 4 * ((rim.D.si + high) ** 2 - (rim.D.si - high) ** 2)
    thin = found["m_rim"] * rim.D.si**2 / 4
    edge = speed * (rim.D.si + high) / 2
    pairs = {
        "m_rim": (found["m_rim"], mass),
        "J_F": (found.get("J_F", thin), thin),
        "b/h": (wide / high, rim.ratio.si),
        "v_rim": (found["v_rim"], edge),
        "J_rim": (found["J_rim"], mass * ((rim.D.si + high) ** 2 + (rim.D.si - high) ** 2) / 8),
    }
    for key, (one, other) in pairs.items():
        if abs(one - other) > 1e-7 * abs(other):
            return f"the ring: {key} = {one:g} and {other:g}"
    if rim.v_max is not None and "v_allowed" in found and bool(found["v_allowed"]) is not (edge <= rim.v_max.si):
        return f"v = {edge:g} m/s, [v] = {rim.v_max.text}: {found['v_allowed']}"
    return ""


@family("flywheel anything", also=turns_evenly, often=3)
def flywheel(rng: Random) -> str:
    """Powers over angles or curves with their period told, sized or judged, with a rim or on another shaft."""
    if rng.random() < 0.5:
        cuts = np.diff([0, *np.sort(rng.choice(np.arange(10, 351, 5), int(rng.integers(1, 7)), replace=False)), 360])
        rows = ", ".join(f"[{cut} deg, {rng.choice([0, 1, 1, 1]) * rng.integers(200, 9000)} W]" for cut in cuts)
        load = f"powers: [{rows}]"
    else:
        period = int(rng.choice([180, 360, 720]))
        place = int(rng.integers(20, period - 20))
        curve = (
            f"[0 deg, {rng.integers(0, 200)} N*m], [{place} deg, {rng.integers(200, 900)} N*m], [{period} deg, 0 N*m]"
        )
        load = f"{rng.choice(['M_d', 'M_r'])}: [{curve}], period: {period} deg"
    judged = rng.random() < 0.3
    sizes = f"J: {rng.uniform(5, 60):.3g} kg*m^2" if judged else f"delta: {rng.uniform(0.01, 0.2):.3g}"
    if not judged:
        sizes += f", J: {rng.uniform(0.01, 0.5):.3g} kg*m^2" if rng.random() < 0.4 else ""
        sizes += f", shaft: {rng.integers(100, 3000)} r/min" if rng.random() < 0.3 else ""
        if rng.random() < 0.5:
            allowed = f", v_max: {rng.integers(10, 60)} m/s" if rng.random() < 0.6 else ""
            sizes += (
                f", rim: {{D: {rng.integers(300, 1500)} mm, b/h: {rng.uniform(0.5, 3):.2g}, "
                f"density: {rng.choice([7200, 7800])} kg/m^3{allowed}}}"
            )
    measured = f", measured: {rng.choice(['squares', 'planimeter'])}" if rng.random() < 0.5 else ""
    return file("flywheel", f"{load}, n: {rng.integers(60, 1200)} r/min, {sizes}{measured}")
