"""Equivalent inertia and moment of every link: the same energy and power, told by the rate of another link."""

from __future__ import annotations

import numpy as np

from vecpoly.solution import Solution

from ..family import family
from .machines import SORTS, Random, driven, weighed

CLOSE = 1e-9


def of_one_energy(solution: Solution) -> str:
    """J_e ω² and M_e ω are the same whatever link they are told of."""
    answers = {key: float(np.real(one.exact)) for key, one in solution.answers.items()}
    rates = {"1": answers["omega_1"], "3": answers.get("omega_3", np.nan)} if "omega_1" in answers else {}
    energy, power = answers["J_e"] * rates["1"] ** 2, answers["M_e"] * rates["1"]
    for key, turns in (("3", rates.get("3", np.nan)),):
        if f"J_e{key}" in answers:
            off = abs(answers[f"J_e{key}"] * turns**2 - energy) / max(energy, 1e-12)
            lost = abs(answers[f"M_e{key}"] * turns - power) / max(abs(power), 1e-3)
            if max(off, lost) > CLOSE:
                return f"link {key} has {off} more energy, {lost} more power"
    return ""


@family("machine-every-equivalent", also=of_one_energy, often=1)
def every_equivalent(rng: Random) -> str:
    """Of the crank, of a rocker or a slider, at any position, alone or beside an equilibrium."""
    made = SORTS[int(rng.integers(len(SORTS)))](rng)
    asked = ["J_e", "M_e", "omega_1"]
    loads = ""
    if made.rocker is not None:
        asked += ["J_e3", "M_e3", "omega_3"]
        loads += f"  M_q: {{on: 3, size: {rng.integers(20, 300)} N*m}}\n"
    if made.slider is not None:
        link, point = made.slider
        asked += [f"m_e{link}", f"F_e{link}"]
        way = rng.integers(0, 360)
        loads += f"  F_q: {{on: {link}, at: {point}, size: {rng.integers(50, 900)} N, direction: {way} deg}}\n"
    if rng.random() < 0.5:  # the equilibrium is drawn too
        loads += '  X: {on: 1, size: "?"}\n'
        asked += ["X"]
    text = f"id: machine\ntitle: machine\n{driven(rng, made)}loads:\n{loads}{weighed(rng, made)}"
    return f"{text}find: [{', '.join(asked)}]\n"
