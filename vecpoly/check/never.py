"""Loads that are accepted and never act: what they wait for does not come in the whole range of the drive."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import degrees

import numpy as np

from .. import oracle
from ..mechanism.laws.windows import During, Moving, Turning
from ..mechanism.loads import Load, Loads
from ..mechanism.model import Mechanism
from ..oracle.forces.laws.drives import drive_range
from ..oracle.forces.laws.returning import laps
from ..oracle.motion import Motion
from ..words import Words

PLACES = 180  # of the drive in its range
STILL = 1e-9  # of the mechanism's size, or of the drive's turning, per unit of the drive: no motion


def never_acting(mech: Mechanism, loads: Loads) -> Iterator[Words]:
    """A remark on each load that waits for a motion that never comes."""
    waiting = [(load, load.law.windows) for load in loads.all if load.law is not None]
    if not any(not isinstance(window, During) for _, windows in waiting for window in windows):
        return
    low, high, whole = drive_range(mech)
    count = laps(mech, low) if whole else 1
    drive = replace(mech.drive, rate=-1.0 if mech.drive.rate < 0 else 1.0, accel=0.0)
    moving = replace(mech, drives=(drive, *mech.drives[1:]))
    motion = oracle.solve(
        moving, np.linspace(low, low + count * (high - low), count * PLACES + 1), order=1, strict=False
    )
    for load, windows in waiting:
        for window in windows:
            if not isinstance(window, During) and not _comes(mech, motion, window):
                yield _said(mech, load, window)


def _comes(mech: Mechanism, motion: Motion, window: Moving | Turning) -> bool:
    body = motion.body(window.link)
    if isinstance(window, Turning):
        return bool(np.nanmax(body.omega * window.sense) > STILL)
    velocity = body.velocity_of(mech.link(window.link).points[window.point])
    along = np.real(velocity * np.exp(-1j * window.direction))
    return bool(np.nanmax(along) > STILL * mech.scale)


def _said(mech: Mechanism, load: Load, window: Moving | Turning) -> Words:
    if isinstance(window, Turning):
        link, ccw = mech.number(window.link), window.sense > 0
        why = Words(
            f"构件 {link} 从不{'逆' if ccw else '顺'}时针转动",
            f"link {link} never turns {'counter-' if ccw else ''}clockwise",
        )
    else:
        towards = f"{degrees(window.direction):.4g}"
        why = Words(f"{window.point} 点从不向 {towards}° 方向运动", f"{window.point} never moves towards {towards} deg")
    return Words(
        f"loads.{load.name}：{why.zh}，这个载荷从不起作用；请检查 while",
        f"loads.{load.name}: {why.en}, so this load never acts; check 'while'",
    )
