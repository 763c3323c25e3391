"""The mechanism solved at some positions of its drive, and every quantity there by its key."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import oracle
from ..errors import EquilibriumError
from ..mechanism.asked.forces import quantities
from ..mechanism.asked.machine import equivalent_of, reduced_quantities
from ..mechanism.loads import Loads
from ..mechanism.machine import known_of
from ..mechanism.model import Mechanism, Prismatic
from ..mechanism.rams import driven_joint
from ..names import parse_rel
from ..oracle.forces import Forces, forces
from ..oracle.machine import Reduced, reduce
from ..words import Words
from .columns import dyads, slides
from .facts.transmission import angle_of, arm_of
from .shaking import SHAKING, shaken

Points = NDArray[np.complex128]
Reals = NDArray[np.float64]
READERS = 512  # kept: a quantity is read at one handful of positions after another


@dataclass(frozen=True, eq=False)
class Sample:
    """Kinematics (and, with loads, equilibrium) at the positions phi (rad,
    or m for a sliding drive); NaN where none exists."""

    mech: Mechanism
    loads: Loads | None
    phi: Reals
    motion: oracle.Motion

    @cached_property
    def statics(self) -> Forces:
        """The equilibrium at the same positions; NaN where it locks."""
        if self.loads is None or not self.loads.balancing:
            raise EquilibriumError(
                Words(
                    "题目没有载荷，不能求反力；请在题目中给出 loads",
                    "there are no loads: reactions cannot be asked for; give the problem `loads`",
                )
            )
        return forces(self.mech, self.loads, self.phi, strict=False)

    @cached_property
    def reduced(self) -> Reduced:
        """The equivalent link at the same positions; NaN where there is none."""
        assert self.loads is not None
        return reduce(self.mech, known_of(self.loads), self.phi, strict=False)

    def value(self, key: str) -> Points | Reals:
        """The quantity with this key (see `columns`): complex for a vector, SI;
        angles within -π..π where links do not roll.

        Raises UnknownNameError for a key that this mechanism does not have.
        """
        return reader(self.mech, self.loads, key)(self)

    def slide(self, stem: str, joint: Prismatic) -> Reals:
        """Travel s of the block's pin along the guide from the lettered point (else the line's origin),
        its rate v, its second rate a: as they are given where a drive prescribes them."""
        motion = self.motion
        if stem == "s":
            return travel(motion, joint, self.mech.link(joint.guide).points.get(joint.through, joint.origin))
        order = {"v": 1, "a": 2}[stem]
        guide, block = motion.moving(joint.guide, order), motion.moving(joint.block, order)
        pin = self.mech.link(joint.block).points[joint.pin]
        along = guide.unit * complex(np.exp(1j * joint.direction))
        here = block.point(pin)
        moved = block.velocity_of(pin) - guide.velocity_at(here)
        if stem == "a":
            moved = block.acceleration_of(pin) - guide.acceleration_at(here) - 2j * guide.omega * moved
        found = dot(along, moved)
        drive = next((one for one in self.mech.drives if one.slide and driven_joint(self.mech, one) == joint), None)
        return found if drive is None else np.where(np.isfinite(found), (drive.rate, drive.accel)[order - 1], np.nan)


def travel(motion: oracle.Motion, joint: Prismatic, base: complex) -> Reals:
    """How far along the guide from this point of it (m, in its own axes) the block's pin is (m)."""
    guide, block = motion.body(joint.guide), motion.body(joint.block)
    pin = motion.mech.link(joint.block).points[joint.pin]
    along = guide.unit * complex(np.exp(1j * joint.direction))
    return dot(along, block.point(pin) - guide.point(base))


def dot(a: Points, b: Points) -> Reals:
    """a · b = a_x b_x + a_y b_y."""
    found: Reals = a.real * b.real + a.imag * b.imag
    return found


Reader = Callable[[Sample], Points | Reals]


@lru_cache(maxsize=READERS)
def reader(mech: Mechanism, loads: Loads | None, key: str) -> Reader:
    """How the quantity is read off a sample of this mechanism; UnknownNameError for a key that it does not have."""
    base, dotted, part = key.partition(".")
    if dotted:
        whole = reader(mech, loads, base)
        return lambda s: _part(whole(s), part)
    stem, _, rest = key.partition("_")
    if stem == "phi" and rest in mech.numbered:
        return lambda s: s.motion.angle(rest)
    if stem in ("s", "v", "a") and (joint := slides(mech).get(rest)):
        return lambda s: _full(s, s.slide(stem, joint))
    if stem in ("gamma", "d") and (dyad := dyads(mech).get(rest)):
        read = angle_of if stem == "gamma" else arm_of
        return lambda s: _full(s, read(s.motion, dyad))
    if loads is not None and loads.masses and key in SHAKING:
        acting = loads
        return lambda s: _full(s, shaken(s.motion, acting, key))
    if loads is not None and key in reduced_quantities(mech):
        to, read_inertia = equivalent_of(mech, key), key[0] in "Jm"
        return lambda s: s.reduced.inertia(to) if read_inertia else s.reduced.load(to)
    if loads is not None and loads.balancing and key in quantities(mech, loads):
        return lambda s: s.statics.value(key)
    rel = parse_rel(key)
    return lambda s: s.motion.value(rel)


def sample(mech: Mechanism, loads: Loads | None, phi: ArrayLike, order: int = 2) -> Sample:
    """The mechanism at these positions; NaN where it cannot be assembled or stands at a dead point. order: 0 for
    positions alone."""
    at = np.asarray(phi, dtype=np.float64)
    return Sample(mech, loads, at, oracle.solve(mech, at, order=order, strict=False))


def _part(value: Points | Reals, part: str) -> Reals:
    match part:
        case "x":
            return np.real(value)
        case "y":
            return np.imag(value)
        case "abs":
            return np.abs(value)
        case _:
            return np.angle(value)


def _full(sample: Sample, values: Points | Reals) -> Points | Reals:
    """One element for every position, where the quantity does not change."""
    return values if values.shape == sample.phi.shape else np.full(sample.phi.shape, values.ravel()[0])
