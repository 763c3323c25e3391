"""Can the printed answers belong to this mechanism at all? Every crank angle and every assembly is tried.

A drawing slip moves one number by a few per cent. Where several printed numbers are far off together, they may belong
to another position, another assembly, or to no position at all:
then the data as printed and the printed solution contradict each other.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from ... import oracle
from ...errors import VecpolyError
from ...foundation.slotted import replace
from ...mechanism.assembly.branch import opposite
from ...mechanism.model import Mechanism, Statement
from ...names import Rel
from ...problem.problem import Printed, Problem

POSITIONS = 721


@dataclass(frozen=True, slots=True, kw_only=True)
class BestFit:
    """The position of the input (rad) and assembly with the smallest largest
    misfit (relative) to the printed magnitudes."""

    misfit: float
    position: float
    assembly: tuple[Statement, ...]


def best_fit(problem: Problem, printed: Sequence[Printed]) -> BestFit | None:
    """Try all positions and assemblies against the printed magnitudes; None where fewer than two can be compared."""
    targets = [p for p in printed if isinstance(p.rel, Rel) and p.value]
    if len(targets) < 2:
        return None
    fits = [fit for mech in _assemblies(problem.mechanism) if (fit := _sweep(mech, targets)) is not None]
    return min(fits, key=lambda fit: fit.misfit, default=None)


def _assemblies(mech: Mechanism) -> Iterator[Mechanism]:
    for flips in product((False, True), repeat=len(mech.branches)):
        branches = tuple(opposite(b) if flip else b for b, flip in zip(mech.branches, flips, strict=True))
        yield replace(mech, branches=branches)


def _sweep(mech: Mechanism, targets: Sequence[Printed]) -> BestFit | None:
    angles = np.linspace(0.0, 2 * np.pi, POSITIONS)
    try:
        motion = oracle.solve(mech, angles, strict=False)
        misfits = [np.abs(np.abs(motion.value(t.rel)) / abs(t.value) - 1.0) for t in targets if isinstance(t.rel, Rel)]
    except VecpolyError:
        return None
    worst = np.max(np.broadcast_arrays(*misfits), axis=0)
    if not np.isfinite(worst).any():
        return None
    i = int(np.nanargmin(worst))
    return BestFit(misfit=float(worst[i]), position=float(angles[i]), assembly=mech.branches)
