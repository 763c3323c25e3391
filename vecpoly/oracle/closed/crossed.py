"""RPP in closed form: a link that keeps the direction of what it slides on, where two lines meet."""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import Group
from ..run import Run
from ..state import Bodies, Body, Reals
from .dyads import line_line, shares
from .loci import Line


@dataclass(frozen=True, slots=True)
class Crossed:
    """RPP: link j keeps the angle of k's parent; k slides along j and along its own parent: two lines meet.

    pivot: j's outer hinge on its parent, pin: on j; turn: unit of j's direction against k's. outer: the line of
    a point of k on its parent; inner: the line of the same point on j.
    """

    group: Group
    parent: str
    pivot: complex
    pin: complex
    turn: complex
    outer: Line
    inner: Line
    joint: str
    sign: float = 1.0
    two: bool = False

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """j about its pivot, k where the lines meet."""
        unit = bodies[self.outer.parent].unit * self.outer.turn * self.turn
        j = Body(self.pin, bodies[self.parent].point(self.pivot), unit)
        both = {**bodies, self.inner.parent: j}
        base = self.outer.base(both)
        at = line_line(base, self.outer.direction(both), self.inner.base(both), self.inner.direction(both))
        return {self.inner.parent: j, self.outer.link: self.outer.body(at, base, both, run)}

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """One ω for all; two sliding speeds from w_o + λ_o d_o = w_i + λ_i d_i."""
        turning, parent = bodies[self.outer.parent], bodies[self.parent]
        j = bodies[self.inner.parent].moving(
            parent.velocity_of(self.pivot), turning.omega, parent.acceleration_of(self.pivot), turning.alpha
        )
        both, own = {**bodies, self.inner.parent: j}, bodies[self.outer.link]
        v, _, a, _ = shares(both, run, self.group.links, (self.outer, own), (self.inner, own))
        return {self.inner.parent: j, self.outer.link: self.outer.moving(both, own, v, a)}

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """Parallel guides never meet."""
        return np.full(1, np.inf)
