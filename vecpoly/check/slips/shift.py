"""The drive's angle from another zero, or counted the other way: found by fit, at any angle."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, radians

import numpy as np

from ...foundation.slotted import replace
from ...words import Words
from ..table.target import Reals
from ..table.truth import Truth, solved
from ..table.weigh import Column, deviations
from .fit import as_good, misfit, thinned
from .guess import Slip, Told

STEP = 5  # degrees of the coarse search
ROUNDS = 6
NEAR = 0.2  # misfit, as a relative error of the lengths, from which a refinement is worth while


def shifts_found(columns: Sequence[Column], thin: Truth, truth: Truth) -> list[Told]:
    """Motions with another zero of the drive's angle with which one of these columns fits well."""
    if truth.mech.drive.slide or not columns:
        return []
    part = thinned(len(truth.positions))
    few = [replace(column, values=column.values[part], half=column.half[part]) for column in columns]
    found: dict[tuple[int, float], Told] = {}
    for sign in (1, -1):
        angles = [radians(k) for k in range(-180 + STEP, 181, STEP)]
        motions = [solved(thin.mech, sign * thin.positions + angle) for angle in angles]
        for narrow, column in zip(few, columns, strict=True):
            misfits = [
                float("inf") if motion is None else misfit(narrow, thin, column.target.of(motion)) for motion in motions
            ]
            k = int(np.argmin(misfits))
            if misfits[k] > NEAR or (angle := _refined(column, truth, sign, angles[k])) is None:
                continue
            name = sign, round(degrees(angle), 4)
            positions = sign * truth.positions + angle
            # told as a column shifted by one row
            row = sign > 0 and abs(abs(angle) - abs(float(np.median(np.diff(truth.positions))))) < 1e-6
            if (
                name not in found
                and not row
                and (sign < 0 or name[1])
                and (motion := solved(truth.mech, positions)) is not None
            ):
                found[name] = Slip.DRIVE, _words(*name), motion, positions
    return list(found.values())


def _words(sign: int, shift: float) -> Words:
    deg = f"{shift:+.6g}°".replace("-", "−")
    turned = ["曲柄转角按反方向计量"] * (sign < 0), ["the crank angle counted the other way round"] * (sign < 0)
    zero = [f"曲柄转角零位差 {deg}"] * bool(shift), [f"the zero of the crank angle shifted by {deg}"] * bool(shift)
    return Words("，".join([*turned[0], *zero[0]]), ", ".join([*turned[1], *zero[1]]))


def _refined(column: Column, truth: Truth, sign: int, angle: float) -> float | None:
    """Gauss and Newton; then the roundest number of degrees that fits as well."""
    for _ in range(ROUNDS):
        here, there = (_units(column, truth, sign, a) for a in (angle, angle + 1e-6))
        if here is None or there is None:
            return None
        slope = (there - here) / 1e-6
        kept = np.isfinite(here) & np.isfinite(slope)
        if not kept.any():
            return None
        kept &= np.abs(here) <= max(3 * float(np.median(np.abs(here[kept]))), 3.0)
        if not (steep := float((slope[kept] ** 2).sum())):
            return None
        step = float(np.clip(-float((here[kept] * slope[kept]).sum()) / steep, -0.1, 0.1))
        angle += step
        if abs(step) < 1e-10:
            break
    best = _units(column, truth, sign, angle)
    if best is None:
        return None
    kept = np.abs(best) <= max(5 * float(np.nanmedian(np.abs(best))), 3.0)
    for whole in (
        round(degrees(angle) / 5) * 5.0,
        round(degrees(angle)),
        round(degrees(angle), 1),
        round(degrees(angle), 2),
    ):
        units = _units(column, truth, sign, radians(whole))
        if units is not None and as_good(units[kept], np.maximum(np.abs(best[kept]), 0.5)):
            return radians(whole)
    return angle


def _units(column: Column, truth: Truth, sign: int, angle: float) -> Reals | None:
    """Deviations in half units of the last digit."""
    motion = solved(truth.mech, sign * truth.positions + angle)
    return (
        None
        if motion is None
        else (deviations(column, column.target.of(motion)) / np.maximum(column.half, 1e-300))[column.there]
    )
