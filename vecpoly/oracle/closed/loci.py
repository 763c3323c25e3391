"""What an outer joint leaves free: the inner hinge of a dyad moves on a circle or a line of the known parent.

With the parent's motion known, the hinge C has
    v_C = w + λ d,    a_C = q(λ) + μ d,
with one unknown λ (the arm's ω, or the sliding speed) and, from it, one unknown μ (the arm's α, or the sliding
acceleration). A gear whose centre is the hinge rolls as it goes: its ω and α follow from λ and μ (`Gearing`).
"""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.model import Circle, Link, Prismatic, Rack, Rolling, Side
from ..iterated.standing import Turned
from ..run import Run
from ..state import Bodies, Body, Points, Reals


@dataclass(frozen=True, slots=True)
class Share:
    """The hinge's velocity or acceleration: full = lead + rate d. base: that of the outer hinge or the guide."""

    base: Points
    lead: Points
    rate: Reals
    d: Points

    @property
    def full(self) -> Points:
        return self.lead + self.rate * self.d


@dataclass(frozen=True, slots=True)
class Gearing:
    """No slip: φ = a φ_parent + b λ-coordinate, the coordinate being the arm's angle (rad) or the travel (m)."""

    a: float
    b: float
    start: Turned

    def turn(self, bodies: Bodies, parent: Body, coordinate: Reals, run: Run, own: Body) -> Reals:
        """The gear's angle (rad); at the problem's own position it is the start. own: the gear, its centre placed."""
        assert run.track is not None
        turned = run.track.follow(np.angle(parent.unit)) if parent.turn is None else parent.turn
        value = self.a * np.broadcast_to(turned, run.q.shape) + self.b * coordinate
        zero = np.broadcast_to(self.start.zero({self.start.link: own, **bodies}), run.q.shape)[run.track.own]
        return np.asarray(value - value[run.track.own] + zero)

    def moving(self, parent: Body, own: Body, v: Share, a: Share) -> Body:
        """The gear's rates: those of its centre, and ω and α by the same law."""
        omega = self.a * parent.omega + self.b * v.rate
        return own.moving(v.full, omega, a.full, self.a * parent.alpha + self.b * a.rate)


@dataclass(frozen=True, slots=True)
class Arc:
    """The hinge at distance |arm| from the parent's point `centre`: a link pinned there, or a gear on a gear.

    arm: from the outer hinge to the inner, in the link's coordinates (for a gear: its centre distance).
    """

    link: str
    parent: str
    centre: complex
    start: complex  # the outer hinge (for a gear its centre) in the link's coordinates
    arm: complex
    gearing: Gearing | None = None

    @property
    def size(self) -> float:
        return abs(self.arm)

    def base(self, bodies: Bodies) -> Points:
        return bodies[self.parent].point(self.centre)

    def body(self, at: Points, base: Points, bodies: Bodies, run: Run) -> Body:
        """The link with the inner hinge at this place."""
        if self.gearing is None:
            return Body(self.start, base, (at - base) * (1 / self.arm))
        assert run.track is not None
        turn = self.gearing.turn(
            bodies,
            bodies[self.parent],
            run.track.follow(np.angle(at - base)),
            run,
            Body(self.start, at, np.full(1, np.nan + 0j)),
        )
        return Body(self.start, at, np.exp(1j * turn), turn)

    def velocity(self, bodies: Bodies, own: Body) -> tuple[Points, Points]:
        """w = v_B and d = i(C - B)."""
        ray = own.unit * (1j * self.arm) if self.gearing is None else 1j * (own.at - self.base(bodies))
        return bodies[self.parent].velocity_of(self.centre), ray

    def acceleration(self, bodies: Bodies, own: Body, d: Points, rate: Reals) -> tuple[Points, Points]:
        """a_B, and q = a_B - λ² (C - B)."""
        base = bodies[self.parent].acceleration_of(self.centre)
        return base, base + 1j * (rate * rate) * d

    def moving(self, bodies: Bodies, own: Body, v: Share, a: Share) -> Body:
        """The link's rates from the arm's ω and α."""
        if self.gearing is None:
            return own.moving(v.base, v.rate, a.base, a.rate)
        return self.gearing.moving(bodies[self.parent], own, v, a)


@dataclass(frozen=True, slots=True)
class Line:
    """The hinge on a line of the parent through `base` in direction e^{iθ} = `along`: a slider, or a gear on a rack.

    turn: unit of the link's direction against the parent's.
    """

    link: str
    parent: str
    base_local: complex
    along: complex
    turn: complex
    start: complex  # the inner hinge in the link's coordinates
    gearing: Gearing | None = None

    @property
    def size(self) -> float:
        return 1.0

    def base(self, bodies: Bodies) -> Points:
        return bodies[self.parent].point(self.base_local)

    def direction(self, bodies: Bodies) -> Points:
        return bodies[self.parent].unit * self.along

    def body(self, at: Points, base: Points, bodies: Bodies, run: Run) -> Body:
        """The link with the inner hinge at this place."""
        parent = bodies[self.parent]
        if self.gearing is None:
            return Body(self.start, at, parent.unit * self.turn)
        travel = (self.direction(bodies).conj() * (at - base)).real
        turn = self.gearing.turn(bodies, parent, travel, run, Body(self.start, at, np.full(1, np.nan + 0j)))
        return Body(self.start, at, np.exp(1j * turn), turn)

    def velocity(self, bodies: Bodies, own: Body) -> tuple[Points, Points]:
        """w = velocity of the parent's point at C, d = the line's direction."""
        return bodies[self.parent].velocity_at(own.at), self.direction(bodies)

    def acceleration(self, bodies: Bodies, own: Body, d: Points, rate: Reals) -> tuple[Points, Points]:
        """Acceleration of the parent's point at C, and q = this + 2iω λ d (Coriolis)."""
        parent = bodies[self.parent]
        base = parent.acceleration_at(own.at)
        return base, base + 2j * (parent.omega * rate) * d

    def moving(self, bodies: Bodies, own: Body, v: Share, a: Share) -> Body:
        """The link's rates from the sliding speed and acceleration."""
        parent = bodies[self.parent]
        if self.gearing is None:
            return own.moving(v.full, parent.omega, a.full, parent.alpha)
        return self.gearing.moving(parent, own, v, a)


Locus = Arc | Line


def slide(joint: Prismatic, link: str, point: complex, pin: complex) -> Line:
    """The line on which a point of `link` (guide or block of the joint) moves against the other link.

    pin: the block's pin in the block's coordinates.
    """
    guide, turn = complex(np.exp(1j * joint.direction)), complex(np.exp(1j * joint.turn))
    if link == joint.block:
        base = joint.origin + guide * (1j * joint.offset + turn * (point - pin))
        return Line(link, joint.guide, base, guide, guide * turn, point)
    back = 1 / (guide * turn)
    base = pin + back * (point - joint.origin - 1j * joint.offset * guide)
    return Line(link, joint.block, base, -1 / turn, back, point)


def roll(joint: Rolling, gear: Link, parent: Link, stands: Turned) -> Locus | None:
    """The path of the gear's centre against its partner; None where the rack rolls on the known gear."""
    mine, other = (joint.gear, joint.on) if joint.gear.link == gear.name else (joint.on, joint.gear)
    if not isinstance(mine, Circle):
        return None
    start = gear.points[mine.centre]
    if isinstance(other, Rack):
        along = complex(np.exp(1j * other.direction))
        side = 1.0 if joint.side is Side.LEFT else -1.0
        law = Gearing(1.0, -side / mine.radius, stands)
        base = other.origin + 1j * side * mine.radius * along
        return Line(gear.name, parent.name, base, along, 1, start, law)
    ratio = other.radius / mine.radius * (-1 if joint.internal else 1)
    reach = abs(other.radius - mine.radius) if joint.internal else other.radius + mine.radius
    law = Gearing(-ratio, 1 + ratio, stands)
    return Arc(gear.name, parent.name, parent.points[other.centre], start, complex(reach), law)
