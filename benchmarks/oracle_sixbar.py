"""The oracle over a whole cycle against a numpy closed form written by hand for the same mechanism.

Six-bar of report A, problem 27 (double crank with a slotted link) at 3,601 positions; both give angle, ω, α of the
slotted link, the slider's distance, and ω, α of coupler and follower. Both run in turn, many times; the ratio is
that of the least CPU times. Run: python benchmarks/oracle_sixbar.py
"""

from __future__ import annotations

from collections.abc import Callable
from time import process_time

import numpy as np
from numpy.typing import NDArray

from vecpoly.mechanism.model import Drive, Link, Mechanism, Prismatic, Revolute, Side, SideOf
from vecpoly.oracle import solve

Reals = NDArray[np.float64]
AB, BC, CD, D_Y, BE, EF, G_X, G_Y, RATE = 0.28, 0.35, 0.32, 0.16, 0.175, 0.22, -0.025, 0.08, 10.0
POSITIONS: Reals = np.linspace(0.0, 2 * np.pi, 3601)
ROUNDS, REPEATS = 60, 20


def by_hand(theta: Reals) -> tuple[Reals, ...]:
    """φ5, ω5, α5, s, ω2, ω3, α2, α3: real arithmetic for this mechanism and nothing else."""
    bx, by = AB * np.cos(theta), AB * np.sin(theta)
    vbx, vby, abx, aby = -RATE * by, RATE * bx, -RATE * RATE * bx, -RATE * RATE * by
    dx, dy = -bx, D_Y - by
    d2 = dx * dx + dy * dy
    a = (BC * BC - CD * CD + d2) / (2 * d2)
    h = -np.sqrt(BC * BC / d2 - a * a)
    ux, uy = a * dx - h * dy, a * dy + h * dx
    px, py = bx + ux, by + uy - D_Y
    det = ux * py - uy * px
    w2, w3 = -(vbx * px + vby * py) / det, -(vbx * ux + vby * uy) / det
    rx, ry = abx - w2 * w2 * ux + w3 * w3 * px, aby - w2 * w2 * uy + w3 * w3 * py
    al2, al3 = -(rx * px + ry * py) / det, -(rx * ux + ry * uy) / det
    k1, k2 = BE / BC, EF / BC
    fx, fy = k1 * ux - k2 * uy, k1 * uy + k2 * ux
    qx, qy = bx + fx - G_X, by + fy - G_Y
    vfx, vfy = vbx - w2 * fy, vby + w2 * fx
    afx, afy = abx - al2 * fy - w2 * w2 * fx, aby + al2 * fx - w2 * w2 * fy
    r2 = qx * qx + qy * qy
    w5 = (qx * vfy - qy * vfx) / r2
    al5 = (qx * afy - qy * afx - 2 * (qx * vfx + qy * vfy) * w5) / r2
    return np.arctan2(qy, qx), w5, al5, np.sqrt(r2), w2, w3, al2, al3


def mechanism() -> Mechanism:
    """The same six-bar as the oracle gets it: C right of B-D."""
    links = (
        Link(name="1", points={"A": 0j, "B": AB}),
        Link(name="2", points={"B": 0j, "C": BC, "F": BE + 1j * EF}),
        Link(name="3", points={"D": 0j, "C": CD}),
        Link(name="4", points={"F": 0j}),
        Link(name="5", points={"G": 0j}),
    )
    pins = (("A", "0", "1"), ("B", "1", "2"), ("C", "2", "3"), ("D", "3", "0"), ("F", "2", "4"), ("G", "5", "0"))
    return Mechanism(
        frame={"A": 0j, "D": 1j * D_Y, "G": G_X + 1j * G_Y},
        links=links,
        joints=(
            *(Revolute(point=p, a=a, b=b) for p, a, b in pins),
            Prismatic(guide="5", block="4", origin=0j, direction=0.0, pin="F", through="G"),
        ),
        drives=(Drive(link="1", position=0.0, rate=RATE),),
        branches=(SideOf(point="C", side=Side.RIGHT, ref=("B", "D")),),
    )


def by_oracle(mech: Mechanism, theta: Reals) -> tuple[Reals, ...]:
    """The same eight answers from the general solver."""
    motion = solve(mech, theta)
    distance = np.abs(motion.position("F") - motion.position("G"))
    return (
        motion.angle("5"),
        motion.omega("5"),
        motion.alpha("5"),
        distance,
        motion.omega("2"),
        motion.omega("3"),
        motion.alpha("2"),
        motion.alpha("3"),
    )


def cpu_time(work: Callable[[], object]) -> float:
    """CPU seconds of one call, averaged over REPEATS calls."""
    start = process_time()
    for _ in range(REPEATS):
        work()
    return (process_time() - start) / REPEATS


def run() -> str:
    """Check that both agree, then time them in turn: one line of the report."""
    mech = mechanism()
    worst = max(
        float(np.abs(a - b).max() / np.abs(b).max())
        for a, b in zip(by_oracle(mech, POSITIONS), by_hand(POSITIONS), strict=True)
    )
    assert worst < 1e-12, worst
    rounds = [
        (cpu_time(lambda: by_oracle(mech, POSITIONS)), cpu_time(lambda: by_hand(POSITIONS))) for _ in range(ROUNDS)
    ]
    oracle, hand = (min(column) for column in zip(*rounds, strict=True))
    return (
        f"oracle, six-bar A 27, {len(POSITIONS)} positions: {1e6 * oracle:.0f} µs = {oracle / hand:.2f} × numpy "
        f"closed form by hand ({1e6 * hand:.0f} µs); aim ≤ 2; largest relative difference {worst:.1e}"
    )


if __name__ == "__main__":
    print(run())
