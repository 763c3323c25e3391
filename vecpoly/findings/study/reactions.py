"""Which reactions are told: one of two that are everywhere as large, as at both ends of a two-force link."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...cycle import Cycle


def reactions(whole: Cycle) -> list[str]:
    """The keys of all reactions that are computed over the cycle."""
    return [c.key for c in whole.columns if c.key.startswith("R_")]


def are_alike(turn: Cycle, one: str, two: str) -> bool:
    """Whether two reactions are everywhere as large."""
    if not (one.startswith("R_") and two.startswith("R_")):
        return False
    return bool(np.allclose(turn.real(one), turn.real(two), rtol=1e-9, atol=0.0, equal_nan=True))


def without_twins(turn: Cycle, keys: Sequence[str]) -> tuple[str, ...]:
    """Those of the keys that are no reaction as large as one before it; none of what exists nowhere."""
    told = [key for key in keys if np.isfinite(turn.real(key)).any()]
    return tuple(key for i, key in enumerate(told) if not any(are_alike(turn, key, other) for other in told[:i]))
