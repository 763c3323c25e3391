"""The shaking force and the shaking moment as columns of a cycle: what the masses do to the frame."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..mechanism.groups.assur import pivot_of
from ..mechanism.model import Mechanism
from ..oracle.machine.shaking import shaking_force, shaking_moment
from ..words import Words
from .column import Column

if TYPE_CHECKING:
    from .sample import Points, Reals, Sample

FORCE = Column(key="shaking_F", symbol="F_I", unit="N", words=Words("机构的惯性力", "shaking force"), is_vector=True)
MOMENT = Column(key="shaking_M", symbol="M_I", unit="N·m", words=Words("机构的惯性力矩", "shaking moment"))
SHAKING = {column.key: column for column in (FORCE, MOMENT)}


def about(mech: Mechanism) -> str:
    """The letter about which the shaking moment is taken: the drive's fixed pivot, else the first fixed point."""
    return pivot_of(mech, mech.drive.link) or next(iter(mech.frame))


def shaken(sample: Sample, key: str) -> Points | Reals:
    """−Σ m a_S (N), or −Σ [(r_S − r_O) × m a_S + J α] (N·m)."""
    assert sample.loads is not None
    if key == FORCE.key:
        return shaking_force(sample.motion, sample.loads.masses)
    return shaking_moment(sample.motion, sample.loads.masses, sample.mech.frame[about(sample.mech)])
