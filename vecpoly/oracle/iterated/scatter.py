"""Random starts for Newton, the same every time, and the assemblies to which they lead."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ...mechanism.model import Mechanism
from ..run import wrapped

STARTS = 384  # at will: every assembly of a small group is met many times
SEEDS = 255  # about a guess
NEAR = 1e-6  # of the mechanism's size, and rad: solutions nearer than this are one


def random_starts(mech: Mechanism, links: int) -> NDArray[np.float64]:
    """Starts × links × (x, y, φ): about the fixed points, turned at will; the same every time."""
    random = np.random.default_rng(0)
    places = list(mech.frame.values()) or [0j]
    middle = complex(np.mean(places))
    starts = random.normal(size=(STARTS, links, 3)) * (0.7 * mech.scale, 0.7 * mech.scale, 0.0) + (
        middle.real,
        middle.imag,
        0.0,
    )
    starts[..., 2] = random.uniform(-np.pi, np.pi, starts.shape[:2])
    return np.asarray(starts)


def distinct(found: NDArray[np.float64], size: float) -> NDArray[np.float64]:
    """Of solutions (NaN where none), each assembly once, the one met most often first."""
    kept: list[NDArray[np.float64]] = []
    times: list[int] = []
    for state in found[~np.isnan(found).any(axis=(1, 2))]:
        same = [
            i
            for i, other in enumerate(kept)
            if np.abs(state[:, :2] - other[:, :2]).max() < NEAR * size
            and np.abs(wrapped(state[:, 2] - other[:, 2])).max() < NEAR
        ]
        if same:
            times[same[0]] += 1
        else:
            kept.append(state)
            times.append(1)
    order = sorted(range(len(kept)), key=lambda i: -times[i])
    return np.array([kept[i] for i in order]).reshape(len(kept), *found.shape[1:])


def scattered(guess: NDArray[np.float64], size: float, wide: float) -> NDArray[np.float64]:
    """Further starts about the first guess (size: of the mechanism, m; wide: how far, of that size): half of them near
    it, the others turned at will."""
    random = np.random.default_rng(0)
    scatter = random.normal(size=(SEEDS, *guess.shape[1:])) * (wide * size, wide * size, 0.7)
    scatter[SEEDS // 2 :, :, 2] = random.uniform(-np.pi, np.pi, scatter[SEEDS // 2 :, :, 2].shape)
    return np.asarray(guess + scatter)
