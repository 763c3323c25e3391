"""A whole cycle of A 27 in steps of 0.01° (36,001 positions) against a numpy closed form written by hand,
and its memory.

Both give angle (ours without jumps), ω, α of the slotted link, the slider's distance, ω and α of coupler and follower;
they run in turn, and the ratio is that of the least CPU times. Run: python -m benchmarks.cycle
"""

from __future__ import annotations

import tracemalloc

import numpy as np

from vecpoly.cycle import Cycle, cycle

from .oracle_sixbar import Reals, by_hand, cpu_time, mechanism

POSITIONS, ROUNDS = 36001, 12
KEYS = ("phi_5", "omega_5", "alpha_5", "s_45", "omega_2", "omega_3", "alpha_2", "alpha_3")
MECH = mechanism()


def ours(count: int = POSITIONS) -> tuple[Reals, ...]:
    """The eight columns from the cycle, of a mechanism whose plan is known."""
    turn: Cycle = cycle(MECH, count)
    return tuple(np.asarray(column, np.float64) for column in turn.read(*KEYS))


def peak(count: int) -> int:
    """Bytes at the most."""
    tracemalloc.start()
    ours(count)
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return most


def run() -> str:
    """Check that both agree, then time them in turn: one line of the report."""
    theta = np.linspace(0.0, 2 * np.pi, POSITIONS)
    hand = by_hand(theta)
    worst = max(
        float(np.abs(np.angle(np.exp(1j * (a - b)))).max() if i == 0 else np.abs(a - b).max() / np.abs(b).max())
        for i, (a, b) in enumerate(zip(ours(), hand, strict=True))
    )
    assert worst < 1e-12, worst
    rounds = [(cpu_time(ours), cpu_time(lambda: by_hand(theta))) for _ in range(ROUNDS)]
    mine, his = (min(column) for column in zip(*rounds, strict=True))
    bytes_each = [peak(n) / n for n in (9001, 36001, 144001)]
    return (
        f"cycle, six-bar A 27, {POSITIONS} positions: {1e3 * mine:.1f} ms = {mine / his:.2f} × numpy closed "
        f"form by hand ({1e3 * his:.1f} ms); aim ≤ 1.5; largest relative difference {worst:.1e}; memory "
        f"{', '.join(f'{b:.0f}' for b in bytes_each)} bytes a position at 9,001, 36,001, 144,001"
    )


if __name__ == "__main__":
    print(run())
