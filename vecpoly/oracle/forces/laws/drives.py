"""How far the drive goes, and the drive at unit rate."""

from __future__ import annotations

import numpy as np

from ....foundation.slotted import replace
from ....mechanism.model import Mechanism


def unit_drive(mech: Mechanism) -> Mechanism:
    """The mechanism with its drive moving at unit rate: for virtual velocities where the drive itself rests."""
    return replace(mech, drives=(replace(mech.drive, rate=1.0, accel=0.0), *mech.drives[1:]))


def drive_range(mech: Mechanism) -> tuple[float, float, bool]:
    """The ends of the drive's range in which its position lies (rad, or m), and whether it is a whole turn."""
    from ... import spans

    drive, full = mech.drive, 2 * np.pi
    for low, high in spans(mech):
        if not drive.slide and high - low >= full * (1 - 1e-12):
            return low, low + full, True
        turn = 0.0 if drive.slide else full * float(np.floor((drive.position - low) / full + 1e-9))
        if low - 1e-9 <= drive.position - turn <= high + 1e-9:
            return low + turn, high + turn, False
    return drive.position, drive.position, False
