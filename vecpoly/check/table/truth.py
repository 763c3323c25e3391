"""The exact values of a mechanism over the rows of a table, and how sensitive each quantity is to the lengths."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ... import oracle
from ...errors import VecpolyError
from ...foundation.frozen import FrozenMap
from ...mechanism.model import Mechanism
from ...oracle import Motion
from ...oracle.run import wrapped
from ..slips.lengths import Length, lengths
from .target import Reals, Target

STEP = 1e-6  # relative change of a length, for its derivative
SHORT, KEPT = (
    128,
    2048,
)  # rows of a table whose trials are kept, and how many: those of one mechanism, for the next table too


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """A mechanism solved at the drive's positions (rad or m);
    `sensitivity` by key of the target, SI per relative change of all lengths."""

    mech: Mechanism
    positions: Reals
    motion: Motion
    lengths: tuple[Length, ...]
    sensitivity: Mapping[str, Reals]

    @property
    def is_iterated(self) -> bool:
        """Whether a group of the mechanism is solved by iteration, walked to from the own position."""
        return oracle.is_iterated(self.mech)

    def of(self, target: Target) -> Reals:
        """The exact values of a quantity."""
        return target.of(self.motion)


def solved(mech: Mechanism, positions: Reals) -> Motion | None:
    """The motion, NaN where it fails; None where it cannot be assembled at all."""
    return _kept(mech, positions.tobytes()) if positions.size <= SHORT else _solved(mech, positions)


@lru_cache(maxsize=KEPT)
def _kept(mech: Mechanism, positions: bytes) -> Motion | None:
    """A length is tried for one column after another, often at the same values."""
    return _solved(mech, np.frombuffer(positions))


def _solved(mech: Mechanism, positions: Reals) -> Motion | None:
    try:
        return oracle.solve(mech, positions, strict=False)
    except (VecpolyError, ValueError, ArithmeticError):
        return None


def truth_of(mech: Mechanism, positions: Reals, targets: Sequence[Target]) -> Truth | None:
    """Solve the mechanism once, and once more for each length changed a little."""
    motion = solved(mech, positions)
    if motion is None:
        return None
    known = lengths(mech)
    moved = [solved(length.instead(length.value * (1 + STEP)), positions) for length in known]
    moved.append(solved(mech, positions + STEP * (mech.scale if mech.drive.slide else 1.0)))
    here = [target.of(motion) for target in targets]
    sums = {target.key: np.zeros(len(positions)) for target in targets}
    for other in moved:
        for target, value in zip(targets, here, strict=True):
            change = np.zeros_like(value) if other is None else target.of(other) - value
            if target.is_angle:
                change = wrapped(change)
            sums[target.key] += np.nan_to_num(np.abs(change)) / STEP
    return Truth(mech, positions, motion, known, FrozenMap(sums))
