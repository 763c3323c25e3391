"""A driven cylinder as one side of a dyad: its end is on a circle whose radius follows the drive.

With u the guide line's direction, C the inner hinge and D the outer one, C - D = u z, z = ± travel + constant:
    v_C = v_D + u z' + ω i (C - D),    a_C = a_D + u z'' + 2iω u z' - ω² (C - D) + α i (C - D).
"""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.model import Drive, Mechanism
from ...mechanism.rams import Ram
from ..run import Run
from ..state import Bodies, Body, Points, Reals
from .loci import Locus, Share


@dataclass(frozen=True, slots=True)
class Telescope:
    """The cylinder and its rod, pinned at `centre` of the parent; near:
    the link there, link: the one that carries the inner hinge."""

    drive: Drive
    leads: bool  # whether the positions asked for are this drive's
    link: str
    near: str
    parent: str
    centre: complex  # D on its parent
    near_pin: complex  # D on its own link
    far_pin: complex  # C on its own link
    near_unit: complex  # link's direction against the line's
    far_unit: complex
    sense: float  # 1.0 where the guide is on the near link: travel then goes from D to C
    rest: complex  # z = sense × travel + rest

    def ray(self, run: Run) -> Points:
        """z: from D to C in the coordinates of the guide line (m)."""
        travel = run.q if self.leads else np.full(1, self.drive.position)
        return np.asarray(self.sense * travel + self.rest, np.complex128)

    def base(self, bodies: Bodies) -> Points:
        """D."""
        return bodies[self.parent].point(self.centre)

    def placed(self, at: Points, base: Points, run: Run) -> dict[str, Body]:
        """Both links with the inner hinge at this place."""
        line = (at - base) / self.ray(run)
        line = line / np.abs(line)
        return {
            self.near: Body(self.near_pin, base + 0 * at, line * self.near_unit),
            self.link: Body(self.far_pin, at, line * self.far_unit),
        }

    def velocity(self, bodies: Bodies, own: Body) -> tuple[Points, Points]:
        """w = v_D + u z' and d = i (C - D)."""
        lengthening = own.unit * (np.conj(self.far_unit) * self.sense * self.drive.rate)
        return bodies[self.parent].velocity_of(self.centre) + lengthening, 1j * (own.at - self.base(bodies))

    def acceleration(self, bodies: Bodies, own: Body, d: Points, rate: Reals) -> tuple[Points, Points]:
        """a_D, and q = a_D + u z'' + 2iω u z' - ω² (C - D)."""
        base, line = bodies[self.parent].acceleration_of(self.centre), own.unit * (np.conj(self.far_unit) * self.sense)
        return base, base + line * (self.drive.accel + 2j * rate * self.drive.rate) + 1j * (rate * rate) * d

    def moved(self, bodies: Bodies, v: Share, a: Share) -> dict[str, Body]:
        """Both links' rates from the cylinder's ω and α."""
        foot = bodies[self.parent].velocity_of(self.centre)
        return {
            self.near: bodies[self.near].moving(foot, v.rate, a.base, a.rate),
            self.link: bodies[self.link].moving(v.full, v.rate, a.full, a.rate),
        }


def telescope(mech: Mechanism, ram: Ram, drive: Drive) -> Telescope:
    """The cylinder's data in the coordinates of its guide line."""
    pair, leads = ram.pair, drive is mech.drive
    near, far, parent = (mech.link(name) for name in (ram.near, ram.far, ram.parent))
    d, c = near.points[ram.outer.point], far.points[ram.inner.point]
    turn, back = complex(np.exp(1j * pair.turn)), complex(np.exp(-1j * pair.direction))
    pin, on_guide = mech.link(pair.block).points[pair.pin], ram.near == pair.guide
    guided, sliding = (d, c) if on_guide else (c, d)
    apart = (
        turn * (sliding - pin) + 1j * pair.offset - back * (guided - pair.origin)
    )  # from the guide's hinge to the block's, less the travel
    guide_unit, sense = back, 1.0 if on_guide else -1.0
    units = (guide_unit, turn) if on_guide else (turn, guide_unit)
    return Telescope(
        drive,
        leads,
        far.name,
        near.name,
        parent.name,
        parent.points[ram.outer.point],
        d,
        c,
        *units,
        sense,
        sense * apart,
    )


def radius_of(locus: Locus | Telescope, run: Run) -> Reals | np.float64:
    """The radius of a circle (m); 1 for a line."""
    return np.asarray(np.abs(locus.ray(run))) if isinstance(locus, Telescope) else np.float64(locus.size)


def placed(locus: Locus | Telescope, at: Points, base: Points, bodies: Bodies, run: Run) -> dict[str, Body]:
    """The link, or the cylinder's two, with the inner hinge at this place."""
    return (
        locus.placed(at, base, run) if isinstance(locus, Telescope) else {locus.link: locus.body(at, base, bodies, run)}
    )


def moved(locus: Locus | Telescope, bodies: Bodies, own: Body, v: Share, a: Share) -> dict[str, Body]:
    """The rates of the link, or of the cylinder's two."""
    return locus.moved(bodies, v, a) if isinstance(locus, Telescope) else {locus.link: locus.moving(bodies, own, v, a)}
