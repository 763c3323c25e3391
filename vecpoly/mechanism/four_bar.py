"""Four-bars whose opposite sides are equal: as a parallelogram they move without a change of figure, through every change point."""

from __future__ import annotations

from .assur import Dyad
from .model import Mechanism, Revolute

EQUAL = 1e-12  # of the mechanism's size


def fourth_corner(mech: Mechanism, dyad: Dyad) -> str | None:
    """The hinge A of the two known links on which an RRR dyad B-C-D hangs, where AB = CD and BC = AD; None of any other dyad."""
    if not (isinstance(dyad.outer_j, Revolute) and isinstance(dyad.inner, Revolute) and isinstance(dyad.outer_k, Revolute)):
        return None
    b, c, d = dyad.outer_j.point, dyad.inner.point, dyad.outer_k.point
    first, second = (mech.link(name).points for name in (dyad.parent_j, dyad.parent_k))
    arms = [abs(points[c] - points[p]) for points, p in ((mech.link(dyad.link_j).points, b), (mech.link(dyad.link_k).points, d))]
    for a in first:
        if a in second and dyad.parent_j != dyad.parent_k:
            sides = abs(first[b] - first[a]), abs(second[d] - second[a])
            if max(abs(arms[0] - sides[1]), abs(arms[1] - sides[0])) <= EQUAL * mech.scale and min(sides) > EQUAL * mech.scale:
                return a
    return None
