"""The grid on which a cycle is looked through, made finer where the motion changes too fast for it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from .. import oracle
from ..errors import AssemblyError
from ..mechanism.model import Mechanism
from ..words import Words
from .sample import sample

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
STEPS = 1440  # of the grid to begin with
CLOSE = 1e-5  # part of a range
FAIR = 1e-6  # of a quantity's range over the cycle: how near a cubic through its neighbours must come to each value
NOISE = 1e-10  # of the natural size of its kind: rounding
UNSURE = 1e-7  # the same beside change points
ROUNDS = 24  # halvings of a step
MOST = 16 * STEPS


def places(mech: Mechanism, low: float, high: float, whole: bool) -> Reals:
    """Positions of the drive between which every link's motion is as good as a cubic.

    A whole turn begins in steps of a quarter of a degree, a little off the round degrees, and goes two steps on; a
    range is ever finer towards its ends: near a dead point quantities go with the square root of the distance, which is
    smooth in ϑ: φ = low + (high - low) (1 - cos ϑ) / 2. Nearer than 1e-5 of the range rounding spoils the rates. Steps
    are halved wherever a cubic through the neighbours misses a value: beside a nearly folded group, or all about a
    slider whose travel is long against the links.
    """
    full = high - low
    if whole:
        steps = STEPS * round(full / (2 * np.pi))
        return _finer(mech, np.asarray(low + full / steps * (0.4142 + np.arange(steps + 2)), np.float64))
    part = (1 - np.cos(np.pi / STEPS * np.arange(STEPS + 1))) / 2
    inside = np.asarray(low + full * part[np.minimum(part, 1 - part) > CLOSE], np.float64)
    return np.concatenate([[low], _finer(mech, inside), [high]])


def noise(mech: Mechanism) -> float:
    """How far rounding may move a value, of the natural size of its kind."""
    return UNSURE if oracle.changes(mech) else NOISE


def _finer(mech: Mechanism, phi: Reals) -> Reals:
    rows = _motion(mech, phi)
    least = noise(mech) * _sizes(mech, rows)
    for _ in range(ROUNDS):
        step = np.flatnonzero(_coarse(phi, rows, least))
        if not step.size or len(phi) > MOST:
            break
        middle = (phi[step] + phi[step + 1]) / 2
        rows = np.insert(rows, step + 1, _motion(mech, middle), axis=2)
        phi = np.insert(phi, step + 1, middle)
    return phi


def _motion(mech: Mechanism, phi: Reals) -> Points:
    """Place, direction and their rates, of every link that moves: kinds × links × positions."""
    bodies = sample(mech, None, phi).motion.bodies.values()
    kinds = zip(*((b.at, b.unit, b.velocity, b.omega, b.acceleration, b.alpha) for b in bodies), strict=True)
    return np.array([[np.broadcast_to(row, phi.shape) for row in kind] for kind in kinds], np.complex128)


def _sizes(mech: Mechanism, rows: Points) -> Reals:
    """Natural size of every kind: with the fastest spin ω and the scale L: L, 1, ω L, ω, ω² L, ω²."""
    scale = mech.scale
    spin = max(float(np.nanmax(np.abs(rows[2]), initial=0.0)) / scale, float(np.nanmax(np.abs(rows[3]), initial=0.0)))
    return np.array([scale, 1.0, spin * scale, spin, spin**2 * scale, spin**2])[:, None, None]


def _coarse(phi: Reals, rows: Points, least: Reals) -> NDArray[np.bool_]:
    """Steps beside the values that the cubic through two neighbours on either side misses."""
    away = [phi[i : len(phi) - 4 + i] - phi[2:-2] for i in (0, 1, 3, 4)]
    near = [rows[..., i : len(phi) - 4 + i] for i in (0, 1, 3, 4)]
    weights = [np.prod([q / (q - p) for q in away if q is not p], axis=0) for p in away]
    middle = rows[..., 2:-2]
    with np.errstate(invalid="ignore", over="ignore"):
        known = np.where(np.isfinite(rows), rows, 0.0)
        reach = np.abs(known - known.mean(axis=2, keepdims=True)).max(axis=2, keepdims=True)
        missed = np.abs(sum(w * f for w, f in zip(weights, near, strict=True)) - middle) > FAIR * reach + least
    beside = np.flatnonzero(missed.any(axis=(0, 1))) + 2
    coarse = np.zeros(len(phi) - 1, np.bool_)
    for i in (-2, -1, 0, 1):
        coarse[beside + i] = True
    return coarse


def range_of(mech: Mechanism) -> tuple[float, float, bool]:
    """Ends of the range of the drive in which the given position lies, told on its turn; whether it is a whole turn."""
    drive, full = mech.drive, 2 * np.pi
    for low, high in oracle.spans(mech):
        if not drive.slide and high - low >= full * (1 - 1e-12):
            return low, low + full, True
        turn = 0.0 if drive.slide else full * float(np.floor((drive.position - low) / full + 1e-9))
        if low - 1e-9 <= drive.position - turn <= high + 1e-9:
            return low + turn, high + turn, False
    raise AssemblyError(
        Words("原动件在任何位置机构都不能装配", "the drive can stand in no position: the mechanism cannot be assembled")
    )
