"""Flywheels of any machine under any load, and the constant moment alone."""

from __future__ import annotations

from ..family import family
from .machines import SORTS, Random, driven, loaded, weighed

HEAD = "id: machine\ntitle: machine\n"


@family("machine-any-load", often=1, first=8)
def any_load(rng: Random) -> str:
    """A constant moment makes good what the loads take over the period."""
    made = SORTS[int(rng.integers(len(SORTS)))](rng)
    run = f"machine: {{n: {rng.integers(40, 200)} r/min, delta: {rng.uniform(0.02, 0.3):.4f}}}\n"
    asked = "find: [M_c, dW_max, J_F, J_F_areas, phi_max, phi_min, omega_max, omega_min]\n"
    loads = f"loads:\n{loaded(rng, made)}  M_c: {{on: 1, size: constant}}\n"
    return f"{HEAD}{driven(rng, made)}{loads}{weighed(rng, made)}{run}{asked}"


@family("forces-constant", often=1, first=3)
def constant(rng: Random) -> str:
    """The constant moment and what balances at the given position, with no speed demanded."""
    made = SORTS[int(rng.integers(len(SORTS)))](rng)
    masses = weighed(rng, made) if rng.random() < 0.5 else ""
    loads = f"loads:\n{loaded(rng, made)}  M_c: {{on: 1, size: constant}}\n"
    return f"{HEAD}{driven(rng, made)}{loads}{masses}find: [M_c, M_b]\n"
