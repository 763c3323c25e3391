"""Random machines in steady motion, trains on one shaft, runs of motors; each checked by a third party: small steps."""

from __future__ import annotations

from math import tau

import numpy as np

from vecpoly.devices.dynamics.flywheel import Flywheel
from vecpoly.devices.dynamics.given import Torques
from vecpoly.devices.dynamics.reduced import ReducedTrain
from vecpoly.devices.dynamics.run_up import RunUp
from vecpoly.solution import Solution

from .family import family

STEPS = 100_001


def _file(kind: str, data: str, find: str) -> str:
    return f"id: x\ntitle: x\ndevice: {kind}\ndata: {data}\nfind: [{find}]\n"


def of_small_steps(solution: Solution) -> str:
    """ΔW_max as the range of the running sum of the work."""
    wheel = solution.problem.device
    assert isinstance(wheel, Flywheel)
    load = wheel.load
    if isinstance(load, Torques):
        fine = np.linspace(0, load.period, STEPS)
        middle, step = (fine[1:] + fine[:-1]) / 2, fine[1]
        curves = [np.interp(middle, *np.array(one.over(load.period)).T) for one in (load.driving, load.resisting)]
        rest = [np.mean(curves[1 - n]) if load.sought == key else curves[n] for n, key in enumerate("dr")]
        energy = np.cumsum(rest[0] - rest[1]) * step
        near = 3e-4 * float(np.sum(np.abs(rest[0] - rest[1]))) * step
    else:
        energy, near = np.cumsum(load.sizes) * load.scale, 0.02 * float(np.sum(np.abs(load.sizes))) * load.scale
    swing, exact = float(np.ptp(np.r_[0.0, energy])), solution.answers["dW_max"].exact
    return "" if abs(swing - exact) <= near + 1e-9 else f"{swing} J by small steps, {exact} J exact"


@family("flywheel by curves", of_small_steps)
def by_curves(rng: np.random.Generator) -> str:
    """Either moment constant, or both of one mean; corners and jumps."""
    period = int(rng.choice([180, 360, 720]))
    places = np.sort(rng.choice(np.arange(5, period - 4, 5), size=int(rng.integers(1, 8)), replace=False))
    rows = [(0, int(rng.integers(-100, 600)))]
    for place in places:
        rows += [(int(place), int(rng.integers(-100, 600))) for _ in range(int(rng.integers(1, 3)))]
    rows.append((period, int(rng.integers(-100, 600))))
    curve = ", ".join(f"[{phi} deg, {moment} N*m]" for phi, moment in rows)
    key = str(rng.choice(["M_d", "M_r"]))
    own = f", J: {rng.uniform(0.01, 5):.4g} kg*m^2" if rng.random() < 0.5 else ""
    data = f"{{{key}: [{curve}], n: {rng.integers(60, 3000)} r/min, delta: {rng.uniform(0.005, 0.2):.3g}{own}}}"
    return _file("flywheel", data, "dW_max, J_F, phi_max, phi_min, n_max")


@family("flywheel by areas", of_small_steps)
def by_areas(rng: np.random.Generator) -> str:
    """Areas in turn, or neighbours of one sign; the last closes the period, now and then a little misread."""
    sizes = [int(size) for size in rng.integers(20, 600, size=int(rng.integers(2, 9)))]
    signed = [size * int(rng.choice([1, -1])) for size in sizes[:-1]]
    last = -sum(signed) + int(rng.integers(-2, 3))
    areas = [*signed, last] if last else [*signed, 40, -40]
    data = (
        f"{{areas: {areas}, mu_A: {rng.uniform(0.5, 30):.3g} J/mm^2, n: {rng.integers(60, 3000)} r/min, J: 3 kg*m^2}}"
    )
    return _file("flywheel", data, "dW_max, delta, n_min")


def of_energy(solution: Solution) -> str:
    """The power of all moments is what the energies of all shafts gain."""
    train = solution.problem.device
    assert isinstance(train, ReducedTrain)
    turns = {name: solution.answers[f"i_{name}_{train.main}"].drawn for name in train.shafts if name != train.main}
    turns[train.main] = 1.0
    gained = sum(
        sum(one.si for one in shaft.J) * turns[name] * solution.answers[f"alpha_{name}"].drawn
        for name, shaft in train.shafts.items()
    )
    power = sum(
        turns[name] * ((shaft.drives.si if shaft.drives else 0) - (shaft.resists.si if shaft.resists else 0))
        for name, shaft in train.shafts.items()
    )
    return "" if abs(gained - power) <= 1e-9 * (abs(power) + 1) else f"{gained} gained, {power} supplied"


@family("reduced train", of_energy)
def reduced_train(rng: np.random.Generator) -> str:
    """Two to five shafts, in a row or branching."""
    names = ["1", "2", "3", "4", "5"][: int(rng.integers(2, 6))]
    shafts = [f"{names[0]}: {{J: {rng.uniform(0.01, 2):.3g} kg*m^2, drives: {rng.integers(50, 500)} N*m}}"]
    shafts += [f"{n}: {{J: {rng.uniform(0.01, 2):.3g} kg*m^2, resists: {rng.integers(1, 90)} N*m}}" for n in names[1:]]
    pairs = [
        f"{names[int(rng.integers(0, n))]} to {name} by {rng.integers(15, 40)}/{rng.integers(20, 90)}"
        for n, name in enumerate(names[1:], 1)
    ]
    asked = ["J_e", "M_e", *(f"alpha_{n}" for n in names)] + [f"i_{n}_1" for n in names[1:]]
    return _file("reduced-train", f"{{shafts: {{{', '.join(shafts)}}}, pairs: [{', '.join(pairs)}]}}", ", ".join(asked))


def of_runge_kutta(solution: Solution) -> str:
    """Time and turns by a thousand steps of the equation of motion between its speeds."""
    run = solution.problem.device
    assert isinstance(run, RunUp) and solution.problem.source is not None
    first, low, b, load, drag, fan = (float(part) for part in str(solution.problem.source.en).split())
    omega = np.linspace(low, solution.answers["omega_s"].exact * run.share, STEPS)
    surplus = first - b * omega - load - drag * omega - fan * omega**2
    time, angle = (float(np.trapezoid(run.J.si * part / surplus, omega)) for part in (omega**0, omega))
    turns = angle / tau
    off = [abs(value - solution.answers[key].exact) / abs(value) for key, value in (("t", time), ("N", turns))]
    return "" if max(off) < 1e-5 else f"{time} s and {turns} turns by small steps"


@family("run-up", of_runge_kutta, often=1, first=1)
def run_up(rng: np.random.Generator) -> str:
    """A motor of straight characteristic against a load that rises with the speed."""
    a, load = int(rng.integers(60, 400)), int(rng.integers(1, 50))
    b, drag, fan = (round(float(rng.uniform(*span)), 4) for span in ((0.2, 4), (0, 1), (0, 0.02)))
    share = int(rng.integers(50, 98))
    data = (
        f"{{motor: [{a} N*m, {b} N*m*s], load: [{load} N*m, {drag} N*m*s, {fan} N*m*s^2], "
        f"J: {rng.uniform(0.1, 20):.3g} kg*m^2, to: {share} %}}"
    )
    return _file("run-up", data, "omega_s, t, N") + f"source: '{a} 0 {b} {load} {drag} {fan}'\n"
