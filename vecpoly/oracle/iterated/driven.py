"""A drive between two moving links as an equation for Newton, and the assemblies that a group with such a drive has.

Slide: Re e^{-iθ} (pin - origin) = s(t) in the coordinates of the guide line; turn: φ_b - φ_a = φ(t).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...errors import MobilityError
from ...foundation.slotted import dataclass
from ...mechanism.model import Drive, Mechanism, Prismatic
from ...mechanism.rams import driven_joint
from ...words import Words
from ..run import wrapped
from ..state import STILL, Bodies, Body, Points, Reals
from .rows import TURN, Blocks, Guided


@dataclass(frozen=True, slots=True)
class Driven:
    """One real equation between the links a and b of the driven joint; `gap` leaves the drive's position out (see
    `off`)."""

    drive: Drive
    leads: bool  # whether the positions asked for are this drive's
    a: str
    b: str
    slide: Guided | None
    scale: float
    held: bool = True
    rolls: bool = False

    def off(self, value: Reals, q: Reals) -> Reals:
        """What the gap is with the drive at q (m)."""
        return value - q if self.slide else self.scale * wrapped(value - q)

    def asked(self, q: Reals) -> Reals:
        """The positions of this drive."""
        return q if self.leads else np.full(1, self.drive.position)

    def gap(self, a: Body, b: Body, ref_a: Body, ref_b: Body) -> Points:
        """Travel (m) or relative angle (rad) as it is."""
        if self.slide is None:
            return np.asarray(np.angle(b.unit * a.unit.conj()) + 0j)
        return np.asarray(self._along(a, b).real + 0j)

    def _along(self, a: Body, b: Body) -> Points:
        assert self.slide is not None
        return np.asarray((a.unit * self.slide.along).conj() * (b.point(self.slide.pin) - a.point(self.slide.origin)))

    def rate(self, a: Body, b: Body) -> Points:
        if self.slide is None:
            return np.asarray(self.scale * (b.omega - a.omega - self.drive.rate) + 0j)
        back = (a.unit * self.slide.along).conj()
        speed = b.velocity_of(self.slide.pin) - a.velocity_of(self.slide.origin)
        return np.asarray((back * speed - 1j * a.omega * self._along(a, b)).real - self.drive.rate + 0j)

    def accel(self, a: Body, b: Body) -> Points:
        if self.slide is None:
            return np.asarray(self.scale * (b.alpha - a.alpha - self.drive.accel) + 0j)
        back = (a.unit * self.slide.along).conj()
        speed = b.velocity_of(self.slide.pin) - a.velocity_of(self.slide.origin)
        pull = b.acceleration_of(self.slide.pin) - a.acceleration_of(self.slide.origin)
        spin = 1j * a.alpha + a.omega * a.omega
        return np.asarray(
            (back * (pull - 2j * a.omega * speed) - spin * self._along(a, b)).real - self.drive.accel + 0j
        )

    def jac(self, a: Body, b: Body) -> Blocks:
        if self.slide is None:
            one = np.broadcast_to(self.scale * TURN + 0j, (len(np.broadcast_to(a.unit, b.unit.shape)), 3))
            return -one, one
        back, along = (a.unit * self.slide.along).conj(), self._along(a, b)
        arm_a, arm_b = 1j * (a.unit * self.slide.origin), 1j * (b.unit * self.slide.pin)
        of_a = np.stack(np.broadcast_arrays(-back, -1j * back, -back * arm_a - 1j * along), axis=-1)
        of_b = np.stack(np.broadcast_arrays(back, 1j * back, back * arm_b), axis=-1)
        return of_a.real + 0j, of_b.real + 0j


def driven(mech: Mechanism, drive: Drive) -> Driven:
    """The equation of a drive; MobilityError where the two links have no joint that it could drive."""
    joint = driven_joint(mech, drive)
    if joint is None:
        raise MobilityError(
            Words(
                f"构件 {drive.link} 与 {drive.on} 之间没有可供驱动的{'移动副' if drive.slide else '转动副'}；"
                "请写出该运动副",
                f"links {drive.link} and {drive.on} have no "
                f"{'sliding pair' if drive.slide else 'hinge'} that the input could "
                "drive; write that joint",
            ),
            code="no-driven-joint",
        )
    if isinstance(joint, Prismatic):
        along = complex(np.exp(1j * joint.direction))
        pin = mech.link(joint.block).points[joint.pin]
        line = Guided(joint.guide, joint.block, joint.origin, along, joint.offset, pin, mech.scale)
        return Driven(drive, drive is mech.drive, joint.guide, joint.block, line, mech.scale)
    return Driven(drive, drive is mech.drive, drive.on, drive.link, None, mech.scale)


def drives_in(rows: Sequence[object]) -> tuple[Driven, ...]:
    """The equations of drives among these."""
    return tuple(row for row in rows if isinstance(row, Driven))


def asked_of(rows: Sequence[object], q: Reals) -> dict[str, Body]:
    """The positions of the drives, in the guise of bodies, so that they are picked as those are."""
    return {
        f"drive {i}": Body(0j, STILL, np.ones(1, np.complex128), one.asked(q)) for i, one in enumerate(drives_in(rows))
    }


def less_asked(gap: NDArray[np.float64], rows: Sequence[object], here: Bodies) -> None:
    """Take the drives' positions off their equations, which are the last columns."""
    drives = drives_in(rows)
    for i, one in enumerate(drives):
        q, column = here[f"drive {i}"].turn, gap.shape[1] - len(drives) + i
        assert q is not None
        gap[:, column] = one.off(gap[:, column], q)
