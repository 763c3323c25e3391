"""The mechanism as thin lines: each link through its points,
each moving guide from its pivot to the pin of its block."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ..cycle import Cycle
from ..mechanism.model import FRAME, Prismatic

Points = NDArray[np.complex128]


def skeleton(cycle: Cycle, phi: NDArray[np.float64]) -> list[Points]:
    """For every line of the mechanism its points at these positions of the drive (mm): shape (points, positions)."""
    mech = cycle.mech
    lines = [list(mech.link(name).points) for name in mech.bodies]
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and FRAME not in (joint.guide, joint.block) and joint.pin:
            lines.append([*list(mech.link(joint.guide).points)[:1], joint.pin])
    found = []
    for letters in lines:
        if len(set(letters)) > 1:
            places = np.array([1e3 * np.asarray(cycle.at(f"p_{letter}", phi), np.complex128) for letter in letters])
            found.append(np.vstack([places, places[:1]]) if len(letters) > 2 else places)
    return found
