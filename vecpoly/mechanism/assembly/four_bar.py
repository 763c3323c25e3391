"""Four-bars whose opposite, or adjacent, sides are equal:
parallelograms and folded kites keep their figure through every change point."""

from __future__ import annotations

from ..groups.assur import Dyad
from ..model import Mechanism, Revolute

EQUAL = 1e-12  # of the mechanism's size


def folded_corner(mech: Mechanism, dyad: Dyad) -> str | None:
    """The hinge A of the two known links on which an RRR dyad B-C-D hangs, where AB = BC and AD = CD (a kite), so that
    C can come to lie on A and stay."""
    return _corner(mech, dyad, crossed=False)


def fourth_corner(mech: Mechanism, dyad: Dyad) -> str | None:
    """The hinge A of the two known links on which an RRR dyad B-C-D hangs,
    where AB = CD and BC = AD; None of any other dyad."""
    return _corner(mech, dyad, crossed=True)


def _corner(mech: Mechanism, dyad: Dyad, crossed: bool) -> str | None:
    """The common hinge from which the known links reach as far as the dyad's arms do;
    crossed: each as far as the other's arm."""
    if not (
        isinstance(dyad.outer_j, Revolute) and isinstance(dyad.inner, Revolute) and isinstance(dyad.outer_k, Revolute)
    ):
        return None
    b, c, d = dyad.outer_j.point, dyad.inner.point, dyad.outer_k.point
    first, second = (mech.link(name).points for name in (dyad.parent_j, dyad.parent_k))
    arms = [
        abs(points[c] - points[p])
        for points, p in ((mech.link(dyad.link_j).points, b), (mech.link(dyad.link_k).points, d))
    ]
    for a in first:
        if a in second and dyad.parent_j != dyad.parent_k:
            sides = abs(first[b] - first[a]), abs(second[d] - second[a])
            own, other = arms[::-1] if crossed else arms
            if (
                max(abs(own - sides[0]), abs(other - sides[1])) <= EQUAL * mech.scale
                and min(sides) > EQUAL * mech.scale
            ):
                return a
    return None
