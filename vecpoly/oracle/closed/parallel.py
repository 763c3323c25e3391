"""RRR whose links turn as known ones do:
a parallelogram ABCD, in which BC stays parallel to AD, or a folded kite, in which C stays on A."""

from __future__ import annotations

import numpy as np

from ...foundation.slotted import dataclass
from ...mechanism.groups.assur import Group
from ...mechanism.model import Mechanism, Revolute
from ..run import Run
from ..state import Bodies, Body, Reals


@dataclass(frozen=True, slots=True)
class Arm:
    """One link of the dyad: pinned to one known link, and as parallel to the other as it was drawn. turn: unit of its
    direction against that link's."""

    link: str
    parent: str
    along: str
    at: complex  # the outer hinge on the parent
    start: complex  # the same on the link
    turn: complex

    def body(self, bodies: Bodies) -> Body:
        return Body(self.start, bodies[self.parent].point(self.at), bodies[self.along].unit * self.turn)

    def moving(self, bodies: Bodies) -> Body:
        """It turns as the link does to which it is parallel."""
        parent, along = bodies[self.parent], bodies[self.along]
        return bodies[self.link].moving(
            parent.velocity_of(self.at), along.omega, parent.acceleration_of(self.at), along.alpha
        )


@dataclass(frozen=True, slots=True)
class Parallel:
    """The step of the dyad B-C-D on the two known links that are pinned to each other in A."""

    group: Group
    arms: tuple[Arm, Arm]
    joint: str
    sign: float = 1.0
    two: bool = False

    def place(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """Both links where their parallels lie."""
        return {arm.link: arm.body(bodies) for arm in self.arms}

    def move(self, bodies: Bodies, run: Run) -> dict[str, Body]:
        """ω_BC = ω_AD, ω_CD = ω_AB, and so α."""
        return {arm.link: arm.moving(bodies) for arm in self.arms}

    def miss(self, bodies: Bodies, run: Run) -> Reals:
        """There is no position in which it does not close."""
        return np.full(1, np.inf)


def parallel(mech: Mechanism, group: Group, corner: str) -> Parallel:
    """The parallelogram with the known links' hinge `corner`: each arm parallel to the other known link."""
    ends, inner = _ends(group)
    arms = [_arm(mech, one, (other[1], corner, other[2]), inner) for one, other in (ends, ends[::-1])]
    return Parallel(group, (arms[0], arms[1]), inner)


def folded(mech: Mechanism, group: Group, corner: str) -> Parallel:
    """The kite folded on the known links' hinge `corner`: each arm lies on its own known link."""
    ends, inner = _ends(group)
    arms = [_arm(mech, one, (one[1], one[2], corner), inner) for one in ends]
    return Parallel(group, (arms[0], arms[1]), inner)


def _ends(group: Group) -> tuple[tuple[tuple[str, str, str], tuple[str, str, str]], str]:
    """Link, known link and outer hinge of both arms; the inner hinge."""
    dyad = group.dyad
    assert (
        dyad is not None
        and isinstance(dyad.inner, Revolute)
        and isinstance(dyad.outer_j, Revolute)
        and isinstance(dyad.outer_k, Revolute)
    )
    return (
        (dyad.link_j, dyad.parent_j, dyad.outer_j.point),
        (dyad.link_k, dyad.parent_k, dyad.outer_k.point),
    ), dyad.inner.point


def _arm(mech: Mechanism, mine: tuple[str, str, str], ray: tuple[str, str, str], inner: str) -> Arm:
    """The arm from its outer hinge to the inner one, parallel to a ray of a known link (link, start, end)."""
    (name, parent, pin), (along, start, end) = mine, ray
    own, led = mech.link(name).points, mech.link(along).points
    turn = (led[end] - led[start]) / (own[inner] - own[pin])
    return Arm(name, parent, along, mech.link(parent).points[pin], own[pin], turn / abs(turn))
