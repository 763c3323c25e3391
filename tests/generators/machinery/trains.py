"""Trains of machines in series and in parallel; shafts with a hoist; characteristics of every sort, run-up and braking.

Third parties: powers added from the ends back; the motion by a hundred thousand small steps of the speed.
"""

from __future__ import annotations

from math import pi

import numpy as np
from numpy.typing import NDArray

from vecpoly.devices.dynamics.characteristic import Characteristic, Kloss, Measured, Polynomial
from vecpoly.devices.dynamics.run_up import RunUp
from vecpoly.devices.power_train import PowerTrain
from vecpoly.devices.train import Train
from vecpoly.solution import Solution

from ..family import family
from .statics import Random, file

KINDS = ("belt", "chain", "gear", "worm", "bearing", "coupling", "screw")
ENDS = ("conveyor", "winch", "pump", "machine")
STEPS = 100_001
Reals = NDArray[np.float64]


def _taken(train: Train) -> float:
    """The power that goes in (W)."""
    last = train[-1]
    if last.parallel is not None:
        power = sum(_taken(branch) for branch in last.parallel)
    else:
        power = (last.P.si if last.P is not None else last.F.si * last.v.si) / last.eta  # type: ignore[union-attr]
    for part in train[:-1]:
        power /= part.eta
    return power


def powers_add_up(solution: Solution) -> str:
    """P of the motor from the ends of the branches back."""
    device = solution.problem.device
    assert isinstance(device, PowerTrain)
    found, true = solution.answers["P"].exact, _taken(device.train)
    return "" if min(abs(found - true), abs(1e3 * found - true)) <= 1e-9 * true else f"P = {found}, but {true} W"


def _row(rng: Random, deep: int, names: list[str]) -> str:
    parts = [f"{rng.choice(KINDS)}: {rng.uniform(0.5, 0.99):.3f}" for _ in range(int(rng.integers(1, 4)))]
    if deep and rng.random() < 0.6:
        branches = [_row(rng, deep - 1, names) for _ in range(int(rng.integers(2, 4)))]
        return f"[{', '.join([*parts, 'parallel: [' + ', '.join(branches) + ']'])}]"
    out = (
        f"P: {rng.uniform(0.2, 30):.3g} kW"
        if rng.random() < 0.5
        else f"F: {rng.integers(50, 9000)} N, v: {rng.uniform(0.1, 4):.3g} m/s"
    )
    return f"[{', '.join(parts)}, {{{rng.choice(ENDS)}: {rng.uniform(0.4, 0.98):.3f}, name: {names.pop(0)}, {out}}}]"


@family("device-power-train", also=powers_add_up)
def power_train(rng: Random) -> str:
    """Rows that part into branches, which may part again."""
    return file("power-train", f"train: {_row(rng, 2, list('ABCDEFGHIJKLMNOPQRSTUVWXYZ'))}")


def _curve(rng: Random, motor: bool) -> str:
    """A characteristic as it may be written."""
    a = int(rng.integers(60, 400)) if motor else int(rng.integers(1, 50))
    match int(rng.integers(4 if motor else 3)):
        case 0:
            return f"{a} N*m" if not motor else f"[{a} N*m, {rng.uniform(0.3, 3):.3f} N*m*s]"
        case 1:
            return f"[{a} N*m, {rng.uniform(0.3, 2) if motor else rng.uniform(0, 0.2):.3f} N*m*s]"
        case 2:
            speeds = np.sort(rng.integers(20, 300, size=2))
            sizes = (a, 0.8 * a, 0.0) if motor else (a, 1.2 * a, 1.5 * a)
            rows = zip((0, *map(int, speeds)), sizes, strict=True)
            return "[" + ", ".join(f"[{w} rad/s, {m:.4g} N*m]" for w, m in rows) + "]"
    slip, speed = rng.uniform(0.1, 0.3), rng.integers(600, 3000)
    return f"{{M_k: {a} N*m, s_k: {slip:.3f}, n_s: {speed} r/min}}"


def _moment(curve: Characteristic, omega: Reals) -> Reals:
    """M of a characteristic at these speeds."""
    match curve:
        case Polynomial(terms=terms):
            return np.asarray(np.polynomial.polynomial.polyval(omega, terms))
        case Kloss(greatest=most, slip=worst, synchronous=speed):
            slip = 1 - omega / speed
            return np.asarray(2 * most * slip * worst / (slip**2 + worst**2))
        case Measured() as rows:
            return np.interp(omega, rows.speeds, rows.sizes)
    raise AssertionError(curve)


def small_steps(solution: Solution) -> str:
    """Time and turns between the speeds of the run by sums over the speed."""
    run = solution.problem.device
    assert isinstance(run, RunUp)
    answers = solution.answers
    if "t" not in answers or run.motor is None:
        return ""
    low = run.start.si if run.start is not None else 0.0
    high = answers["omega_s"].exact * run.share
    omega = np.linspace(low, high, STEPS)
    surplus = _moment(run.motor, omega) - (_moment(run.load, omega) if run.load is not None else 0.0)
    time = float(np.trapezoid(run.J.si / surplus, omega))
    turns = float(np.trapezoid(run.J.si * omega / surplus, omega)) / (2 * pi)
    off = max(abs(time - answers["t"].exact) / time, abs(turns - answers["N"].exact) / turns)
    return "" if off < 1e-5 else f"{time} s and {turns} turns by small steps"


@family("device-run-up", also=small_steps, often=1, first=1)
def run_up(rng: Random) -> str:
    """Motors and loads by every sort of characteristic, run-up or running down with a brake."""
    inertia = f"J: {rng.uniform(0.1, 20):.3g} kg*m^2"
    if rng.random() < 0.35:
        load = _curve(rng, motor=False)
        brake = f", brake: {rng.integers(10, 200)} N*m" if rng.random() < 0.7 else ""
        text = file("run-up", f"load: {load}, {inertia}, start: {rng.integers(100, 1500)} r/min{brake}")
        return text + f"find: [t, N{', t_b, N_b' if brake else ''}]\n"
    share = int(rng.integers(50, 98))
    data = f"motor: {_curve(rng, motor=True)}, load: {_curve(rng, motor=False)}, {inertia}, to: {share} %"
    return file("run-up", data) + "find: [omega_s, t, N]\n"


@family("device-hoist", often=2)
def hoist(rng: Random) -> str:
    """Shafts in a row with gears or belts, the last with a drum that lifts."""
    count = int(rng.integers(2, 5))
    shafts = [f"1: {{J: {rng.uniform(0.01, 1):.3g} kg*m^2, drives: {rng.integers(150, 900)} N*m}}"]
    shafts += [f"{k}: {{J: {rng.uniform(0.01, 1):.3g} kg*m^2}}" for k in range(2, count)]
    shafts.append(
        f"{count}: {{J: {rng.uniform(0.5, 9):.3g} kg*m^2, drum: {rng.integers(100, 600)} mm, "
        f"lifts: {rng.integers(20, 900)} kg}}"
    )
    pairs = [
        f"{k} to {k + 1} by {rng.integers(15, 40)}/{rng.integers(60, 160)}"
        if rng.random() < 0.7
        else f"{k} to {k + 1} by {rng.integers(80, 200)} mm/{rng.integers(250, 600)} mm"
        for k in range(1, count)
    ]
    run = f"until: {rng.integers(200, 1500)} r/min" if rng.random() < 0.5 else f"after: {rng.uniform(0.1, 3):.3g} s"
    asked = "J_e, M_r, M_d, M_e, alpha_1, N, lift, F_rope" + (", t" if run.startswith("until") else ", omega_1")
    data = f"shafts: {{{', '.join(shafts)}}}, pairs: [{', '.join(pairs)}], to: 1, {run}"
    return file("reduced-train", data) + f"find: [{asked}]\n"
