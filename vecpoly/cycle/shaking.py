"""The shaking force and the shaking moment as columns of a cycle: what the masses do to the frame."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..mechanism.groups.assur import pivot_of
from ..mechanism.loads import Loads
from ..mechanism.model import Mechanism
from ..oracle import Motion
from ..oracle.machine.shaking import shaking_force, shaking_moment
from ..words import Words
from .column import Column

FORCE = Column(key="shaking_F", symbol="F_I", unit="N", words=Words("机构的惯性力", "shaking force"), is_vector=True)
MOMENT = Column(key="shaking_M", symbol="M_I", unit="N·m", words=Words("机构的惯性力矩", "shaking moment"))
SHAKING = {column.key: column for column in (FORCE, MOMENT)}


def about(mech: Mechanism) -> str:
    """The letter about which the shaking moment is taken: the drive's fixed pivot, else the first fixed point."""
    return pivot_of(mech, mech.drive.link) or next(iter(mech.frame))


def shaken(motion: Motion, loads: Loads, key: str) -> NDArray[np.complex128] | NDArray[np.float64]:
    """−Σ m a_S (N), or −Σ [(r_S − r_O) × m a_S + J α] (N·m)."""
    if key == FORCE.key:
        return shaking_force(motion, loads.masses)
    return shaking_moment(motion, loads.masses, motion.mech.frame[about(motion.mech)])
