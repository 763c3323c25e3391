"""Random engines: in line, against the harmonics of all pistons; one cylinder, against its force at many places."""

from __future__ import annotations

import numpy as np

from vecpoly.devices.balancing.engine import InlineEngine
from vecpoly.devices.balancing.shaking import ShakingForce
from vecpoly.solution import Solution

from .family import family

TURN = np.linspace(0.0, 2 * np.pi, 720, endpoint=False)


def of_all_pistons(solution: Solution) -> str:
    """The first two harmonics of the sum of all inertia forces, and of their moments."""
    engine = solution.problem.subject
    assert isinstance(engine, InlineEngine)
    phi = TURN[:, None] + np.array([crank.si for crank in engine.cranks])
    size = engine.m.si * engine.r.si * engine.n.si**2
    force = size * (np.cos(phi) + engine.r.si / engine.l.si * np.cos(2 * phi))
    far = max(map(abs, engine.z), default=0.0) or 1.0
    for letter, total, scale in (("F", force.sum(axis=1), 1.0), ("M", (force * np.array(engine.z)).sum(axis=1), far)):
        harmonics = 2 * np.abs(np.fft.rfft(total)) / len(TURN)
        for order, key in ((1, f"{letter}_I"), (2, f"{letter}_II")):
            drawn = solution.answers[key].drawn
            if abs(drawn - harmonics[order]) > 1e-9 * size * scale * len(engine.cranks):
                return f"{key} drawn {drawn}, of the pistons {harmonics[order]}"
    return ""


@family("engine in line", of_all_pistons, often=3)
def in_line(rng: np.random.Generator) -> str:
    """Two to eight cylinders, cranks anywhere, in any firing order."""
    count = int(rng.integers(2, 9))
    cranks = ", ".join(f"{rng.uniform(0, 360):.2f} deg" for _ in range(count))
    order = ", ".join(str(i + 1) for i in rng.permutation(count))
    sizes = f"pitch: {rng.integers(60, 150)} mm, m: {rng.uniform(0.2, 2):.3f} kg, r: {rng.integers(30, 80)} mm"
    rest = f"l: {rng.integers(120, 300)} mm, n: {rng.integers(500, 6000)} r/min"
    data = f"{{cranks: [{cranks}], {sizes}, {rest}, order: [{order}]}}"
    return f"id: engine\ntitle: An engine\ndevice: in-line-engine\ndata: {data}\n"


def nowhere_larger(solution: Solution) -> str:
    """The force on a dense row of places is nowhere larger, and somewhere as large."""
    engine = solution.problem.subject
    assert isinstance(engine, ShakingForce)
    found = {key: answer.drawn for key, answer in solution.answers.items()}
    along = found["F_1"] * np.cos(TURN) + found["F_2"] * np.cos(2 * TURN)
    size = np.abs(along - found.get("c", engine.c.si) * found["F_1"] * np.exp(1j * TURN))
    if abs(float(size.max()) - found["F_max"]) > 1e-4 * found["F_1"]:
        return f"F_max {found['F_max']}, on a row of places {size.max()}"
    return ""


@family("engine single", nowhere_larger, often=2)
def single(rng: np.random.Generator) -> str:
    """Any masses, any fraction."""
    r, l_ = int(rng.integers(30, 90)), int(rng.integers(150, 400))
    masses = ", ".join(f"m{i}: {rng.uniform(0.2, 3):.3f} kg" for i in (1, 2, 3))
    place = f"BS2: {rng.integers(10, 140)} mm, r_c: {rng.integers(30, 120)} mm"
    turn = f"c: {rng.uniform(0.05, 1.2):.3f}, at: {rng.integers(0, 360)} deg"
    data = f"{{r: {r} mm, l: {l_} mm, n: {rng.integers(300, 4000)} r/min, {masses}, {place}, {turn}}}"
    return f"id: engine\ntitle: An engine\ndevice: shaking-force\ndata: {data}\n"
