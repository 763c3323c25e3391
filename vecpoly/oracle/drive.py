"""The driving link: it turns about its frame pivot, or slides on its frame guide."""

from __future__ import annotations

import numpy as np

from ..errors import MobilityError
from ..foundation.slotted import dataclass
from ..mechanism.groups.assur import ends, hinges
from ..mechanism.model import FRAME, Drive, Mechanism, Prismatic
from ..words import Words
from .closed.loci import Line, slide
from .state import NONE, STILL, Body, Points, Reals


@dataclass(frozen=True, slots=True)
class Driver:
    """A drive with its pivot (place in the frame, point of the link), or its line."""

    drive: Drive
    pivot: complex = 0j
    pin: complex = 0j
    line: Line | None = None

    def body(self, q: Reals) -> Body:
        """The driving link at the positions q (rad, or m of travel along the guide)."""
        rate, accel = np.full(1, self.drive.rate), np.full(1, self.drive.accel)
        if self.line is None:
            unit: Points = np.empty(q.shape, np.complex128)
            unit.real, unit.imag = np.cos(q), np.sin(q)
            return Body(self.pin, np.full(1, self.pivot, np.complex128), unit, q, STILL, rate, STILL, accel)
        line = self.line
        at: Points = np.asarray(line.base_local + line.along * q, np.complex128)
        unit, turn = np.full(1, line.turn, np.complex128), np.full(1, np.angle(line.turn))
        return Body(line.start, at, unit, turn, line.along * rate, NONE, line.along * accel, NONE)


def driver(mech: Mechanism, drive: Drive) -> Driver:
    """Where the driving link hangs on the frame; MobilityError where it does not."""
    if not drive.slide:
        point = next((p for p, names in hinges(mech).items() if FRAME in names and drive.link in names), None)
        if point is None:
            raise MobilityError(
                Words(
                    f"原动件 {drive.link} 没有固定铰链；请将其铰接于机架，或写成移动输入",
                    f"the driving link {drive.link} has no frame pivot; pin it there, or say slide",
                )
            )
        return Driver(drive, mech.frame[point], mech.link(drive.link).points[point])
    for joint in mech.joints:
        if isinstance(joint, Prismatic) and set(ends(joint)) == {FRAME, drive.link}:
            pin = mech.link(joint.block).points[joint.pin]
            # travel is told at the pin: the block's, or the frame's where the guide moves
            foot = joint.origin + 1j * joint.offset * complex(np.exp(1j * joint.direction))
            start = pin if joint.block == drive.link else foot
            return Driver(drive, line=slide(joint, drive.link, start, pin))
    raise MobilityError(
        Words(
            f"原动件 {drive.link} 没有固定导路，却给了移动输入",
            f"the driving link {drive.link} has no guide on the frame, yet is said to slide",
        )
    )
