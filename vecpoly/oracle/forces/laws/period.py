"""The constant moment that does over a period the work of all other loads."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from ....errors import EquilibriumError
from ....foundation.slotted import replace
from ....mechanism.loads import Loads
from ....mechanism.model import Mechanism
from ....words import Words
from ...pieces import followed
from ...state import Reals
from ..acting import given
from .corners import corners
from .drives import drive_range
from .returning import turns_of

PIECE = np.radians(10.0)  # no piece of the period is longer


def cuts_of(mech: Mechanism, loads: Loads) -> Reals:
    """Ends of pieces of the period between the loads' corners (rad).

    Raises EquilibriumError where the drive has no period: it slides, or does not turn right round.
    """
    low, high, whole = drive_range(mech)
    if not whole:
        raise EquilibriumError(_aperiodic(mech, loads, low, high), code="no-period")
    high = low + 2 * np.pi * turns_of(mech, loads, low)
    even = np.linspace(low, high, round((high - low) / PIECE) + 1)
    return np.unique(np.concatenate([even, corners(mech, loads)]))


@lru_cache(maxsize=64)
def constant_size(mech: Mechanism, loads: Loads) -> float:
    """M = -∮ ΣP / ω dφ / T of the driving link (N·m): with it the work of all loads over the period T is nothing.

    ΣP are the powers of loads, springs and weights at even motion, in which inertia does no work over a period; where
    there is friction the moment is the mean of the one that balances at each place. Raises EquilibriumError.
    """
    assert loads.constant is not None
    even = replace(mech, drives=(replace(mech.drive, accel=0.0), *mech.drives[1:]))
    cuts, (balance,) = followed(lambda places: (_balance(even, loads, places),), cuts_of(even, loads))
    size = float(np.diff(cuts) @ balance[:, 0] / (cuts[-1] - cuts[0]))
    scale = float(np.abs(balance).sum(axis=1).max())
    size = 0.0 if abs(size) <= 1e-12 * scale else size
    _refuse_role(mech, loads, size)
    return size


def _balance(mech: Mechanism, loads: Loads, places: Reals) -> Reals:
    """What balances on the driving link at every place (N·m)."""
    from ... import solve
    from ..balanced import balanced

    if loads.friction:
        return np.asarray(balanced(mech, loads, places, strict=True).wet.load, np.float64)
    bodies = solve(mech, places, order=1).bodies
    powers = (act.power(bodies) for act in given(mech, replace(loads, inertia=False), bodies, places))
    return np.asarray(-sum(powers, np.zeros(places.shape)) / mech.drive.rate, np.float64)


def _refuse_role(mech: Mechanism, loads: Loads, size: float) -> None:
    """EquilibriumError where the moment does not do what the problem says of it."""
    one = loads.constant
    assert one is not None
    gives = size * mech.drive.rate
    if one.role and gives and (gives > 0) != (one.role == "driving"):
        does = Words("阻力矩", "resist") if gives < 0 else Words("驱动力矩", "drive")
        other = "resisting" if gives < 0 else "driving"
        raise EquilibriumError(
            Words(
                f"载荷 {one.name} 注明为 {one.role}，但其余载荷一周期内所作的功要求它为{does.zh}（{size:.4g} N·m）；"
                f"请改变其余载荷的方向，或写 role: {other}",
                f"load {one.name} is called {one.role}, but the work of the other loads over the period wants it to "
                f"{does.en} ({size:.4g} N·m): turn round the other loads, or write role: {other}",
            ),
            code="role",
        )


def _aperiodic(mech: Mechanism, loads: Loads, low: float, high: float) -> Words:
    drive, name = mech.drive, loads.constant.name if loads.constant is not None else "M"
    a, b = (f"{1e3 * x:.4g} mm" if drive.slide else f"{np.degrees(drive.told(x)):.4g}°" for x in (low, high))
    return Words(
        f"{name} 为一周期内的常数，而原动件 {drive.link} 不作整周运动（只能在 {a} 至 {b} 之间），没有周期；"
        '请写 size: "?" 求该位置的平衡力矩',
        f"{name} is constant over a period, but the drive {drive.link} makes no whole turns (it goes from {a} to {b} "
        'only) and there is no period; write size: "?" for what balances at this position',
    )
