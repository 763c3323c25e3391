"""Random rotors: balanced in one plane, at fixed places, in two planes, by Dalby, within a grade, and where they run.

The third opinion adds up forces and couples of the finished rotor, from the data alone.
"""

from __future__ import annotations

from cmath import rect
from collections.abc import Iterable
from math import radians

import numpy as np

from vecpoly.devices.balancing.field import FieldBalancing
from vecpoly.devices.balancing.rotor import Rotor
from vecpoly.solution import Solution

from .family import family

Placed = tuple[complex, float]  # a product (kg·m), and where it is along the axis (m)


def in_balance(solution: Solution) -> str:
    """ΣW = 0, and of more than one plane ΣW z = 0 about a third point, with all that was added or drilled out."""
    rotor = solution.problem.subject
    assert isinstance(rotor, Rotor)
    for which in _answers(rotor):
        there = [*_given(rotor, solution, which), *_added(rotor, solution)]
        if wrong := _closes(there, couples=not rotor.static):
            return wrong
    return ""


def _closes(there: list[Placed], *, couples: bool) -> str:
    whole, far = sum(abs(w) for w, _ in there), max(abs(z) for _, z in there) + 0.3
    force = abs(sum(w for w, _ in there))
    couple = abs(sum(w * (z + 0.3) for w, z in there)) if couples else 0.0
    if force > 1e-7 * whole or couple > 1e-7 * whole * far:
        return f"the finished rotor has the force {force:g} kg·m and the couple {couple:g} kg·m² of {whole:g} kg·m"
    return ""


def _answers(rotor: Rotor) -> tuple[str, ...]:
    keys = [named.key for named in rotor.quantities()]
    return ("_1", "_2") if rotor.sought and any(key.endswith("_2") for key in keys) else ("",)


def _given(rotor: Rotor, solution: Solution, which: str) -> Iterable[Placed]:
    """The unbalances, those that were sought with what was found of them."""
    for name, mass in rotor.masses.items():
        if not mass.unknown:
            yield mass.vector, mass.place
            continue
        assert mass.r is not None
        size = solution.answers[f"m_{name}{which}"].drawn if "m" in mass.unknown else mass.size
        turn = solution.answers[f"theta_{name}{which}"].drawn if "at" in mass.unknown else np.degrees(mass.at.si)
        yield rect(size * mass.r.si / rotor.weighing.masses, radians(turn)), mass.place


def _added(rotor: Rotor, solution: Solution) -> Iterable[Placed]:
    """What balances each plane: a weight, a hole by its own diameter, or two weights at their places."""
    unit = rotor.weighing
    for end, plane in rotor.planes.items():
        found = {key: answer.drawn for key, answer in solution.answers.items()}
        if plane.through:
            assert plane.b is not None and plane.density is not None and plane.r is not None
            hole = np.pi / 4 * (found[f"d_b{end}"] * 1e-3) ** 2 * plane.b.si * plane.density.si
            yield -rect(hole * plane.r.si, radians(found[f"theta_h{end}"])), plane.at
        elif plane.places is not None:
            assert plane.r is not None
            for i in (1, 2):
                size = found[f"m_b{end}_{i}"] / unit.masses * plane.r.si
                yield rect(size, radians(found[f"theta_b{end}_{i}"])), plane.at
        else:
            yield (solution.answers[f"W_b{end}"].drawn_vector or 0j) / unit.products, plane.at


def silenced(solution: Solution) -> str:
    """The vibration that is left with the correction, by the linear law that all readings follow."""
    device = solution.problem.subject
    assert isinstance(device, FieldBalancing)
    (trial,) = device.trials
    v0, v1 = (rect(one.size, one.phase or 0.0) for one in (device.initial, trial.reading))
    per_kg = (v1 - v0) / rect(trial.m.si * trial.r.si, trial.at.si)
    weight = solution.answers["m_b"].drawn * 1e-3 * device.correct.r.si
    rest = v0 if device.correct.trial == "removed" else v1
    left = rest + per_kg * rect(weight, radians(solution.answers["theta_b"].drawn))
    return "" if abs(left) < 1e-7 * abs(v0) else f"a vibration of {abs(left):g} is left"


def as_was_hidden(solution: Solution) -> str:
    """The unbalance from which the readings of the runs were made, kept in the title."""
    hidden, at = (float(part) for part in solution.problem.title.en.split())
    found = solution.answers
    off = abs((found["theta_b"].drawn - at + 180) % 360 - 180)
    wrong = abs(found["m_b"].drawn - hidden) > 1e-3 * hidden or off > 0.1
    return f"{hidden} g at {at}° was hidden" if wrong else ""


HEAD = "id: rotor\ntitle: A rotor\ndevice: rotor\ndata:\n"


def _masses(rng: np.random.Generator, axial: bool) -> str:
    rows = []
    for i in range(1, int(rng.integers(1, 6)) + 1):
        hole = rng.random() < 0.3
        size = f"hole: {rng.integers(20, 60)} mm" if hole else f"m: {rng.uniform(0.2, 9):.3f} kg"
        place = f", z: {rng.integers(-200, 1200)} mm" if axial else ""
        rows.append(f"    {i}: {{{size}, r: {rng.integers(60, 300)} mm, at: {rng.uniform(0, 360):.2f} deg{place}}}")
    return "  disc: {b: 40 mm, density: 7850 kg/m^3}\n  masses:\n" + "\n".join(rows) + "\n"


@family("rotor one plane", in_balance, often=3)
def one_plane(rng: np.random.Generator) -> str:
    """Lumps and holes, balanced by a weight, a hole, or two weights at fixed places."""
    way = ["", ", hole: through", f", places: {rng.choice([20, 30, 45, 60])} deg"][int(rng.integers(0, 3))]
    return f"{HEAD}{_masses(rng, axial=False)}  correct: {{I: {{r: {rng.integers(80, 300)} mm{way}}}}}\n"


@family("rotor two planes", in_balance, often=3)
def two_planes(rng: np.random.Generator) -> str:
    """Masses between and outside the planes, some within a grade."""
    one, span = int(rng.integers(-100, 200)), int(rng.integers(250, 900))
    grade = (
        f"  tolerance: {{G: 6.3 mm/s, mass: 80 kg, n: 1450 r/min, z: {one + span * rng.uniform(0.2, 0.8):.0f} mm}}\n"
        if rng.random() < 0.4
        else ""
    )
    planes = f"  correct: {{I: {{z: {one} mm, r: 250 mm}}, II: {{z: {one + span} mm}}}}\n"
    return f"{HEAD}{_masses(rng, axial=True)}{planes}{grade}"


@family("rotor dalby", in_balance, often=3)
def dalby(rng: np.random.Generator) -> str:
    """One mass wholly unknown, and of others two directions, two sizes, one of each, or all of one."""
    unknown = [("at", "at"), ("m", "m"), ("m", "at"), ("both", "")][int(rng.integers(0, 4))]
    rows = ['    A: {m: "?", r: 120 mm, at: "?", z: 0 mm}']
    for name, what in zip("BCDE", ("", *unknown, ""), strict=True):
        m = '"?"' if what in ("m", "both") else f"{rng.uniform(2, 8):.3f} kg"
        at = '"?"' if what in ("at", "both") else f"{rng.uniform(0, 360):.2f} deg"
        z = int(rng.choice([-1, 1])) * int(rng.integers(150, 900))
        rows.append(f"    {name}: {{m: {m}, r: {rng.integers(80, 200)} mm, at: {at}, z: {z} mm}}")
    return f"{HEAD}  masses:\n" + "\n".join(rows) + "\n"


FIELD = "device: field-balancing\ndata:\n"


@family("field influence", silenced, often=3)
def influence(rng: np.random.Generator) -> str:
    """Two readings with phases."""
    v0, v1 = (f"{rng.uniform(1, 12):.3f} um at {rng.uniform(0, 360):.2f} deg" for _ in range(2))
    trial = f"{{m: 10 g, r: {rng.integers(50, 200)} mm, at: {rng.uniform(0, 360):.1f} deg, reading: {v1}}}"
    stays = rng.choice(["removed", "left"])
    correct = f"{{r: {rng.integers(50, 200)} mm, trial: {stays}}}"
    return f"id: field\ntitle: In place\n{FIELD}  initial: {v0}\n  trials: [{trial}]\n  correct: {correct}\n"


@family("field four runs", as_was_hidden, often=3)
def four_runs(rng: np.random.Generator) -> str:
    """Readings made of a hidden unbalance, which is told in the title."""
    first, share, heavy = rng.uniform(4, 15), rng.uniform(0.2, 0.9), rng.uniform(0, 360)
    start, gaps = rng.uniform(0, 360), rng.uniform(70, 140, 2)
    turns = [round(float(start + sum(gaps[:i])), 3) for i in range(3)]
    rows = [
        f"    - {{m: 10 g, r: 100 mm, at: {at} deg, reading: "
        f"{abs(rect(share, radians(at)) - rect(1, radians(heavy))) * first:.9f} mm/s}}"
        for at in turns
    ]
    title = f'"{10 / share:.6f} {heavy:.6f}"'
    runs = "\n".join(rows)
    return (
        f"id: runs\ntitle: {title}\n{FIELD}  initial: {first:.9f} mm/s\n  trials:\n{runs}\n  correct: {{r: 100 mm}}\n"
    )
