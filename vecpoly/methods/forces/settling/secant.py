"""From friction couples put in and those that come out to couples that stay: the secant of a linear relation."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ....plane import Reals, nominal

Couples = Mapping[tuple[str, str], Reals]


def gap(before: Couples, after: Couples) -> float:
    """Largest change by the nominal hand, of the largest couple."""
    largest = max((abs(float(nominal(c))) for c in after.values()), default=0.0)
    changes = [abs(float(nominal(c - before.get(k, 0.0)))) for k, c in after.items()]
    return max(changes, default=0.0) / largest if largest else 0.0


def secant(couples: Couples, after: Couples, slope: np.ndarray) -> dict[tuple[str, str], Reals]:
    """x − (G − 1)⁻¹ (g(x) − x), by every hand."""
    if not couples:
        return {}
    rest = np.stack(np.broadcast_arrays(*[after[k] - couples[k] for k in couples]))
    move = np.linalg.solve(slope - np.eye(len(couples)), rest.reshape(len(couples), -1)).reshape(rest.shape)
    return {key: (couples[key] - move[i])[()] for i, key in enumerate(couples)}
