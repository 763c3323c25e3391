"""Links that stand still wherever the drive is: all that their group hangs on does not move."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from ...errors import MobilityError
from ...foundation.slotted import dataclass
from ..model import FRAME, Mechanism, Revolute
from .assur import decompose, hinges
from .group import Group, Outer

NOTHING = 1e-9  # of the mechanism's size: two points are one


@dataclass(frozen=True, slots=True, kw_only=True)
class Resting:
    """The links of a group at rest, and the pins on which it hangs; slides: whether it hangs on a guide too."""

    links: tuple[str, ...]
    pins: tuple[str, ...]
    slides: bool


def resting(mech: Mechanism) -> tuple[Resting, ...]:
    """The groups that stand still, in order of solution; none of a mechanism that does not come apart, or that is moved
    by a profile, whose law is not in its joints."""
    if mech.cams:
        return ()
    try:
        return tuple(_resting(mech, decompose(mech)))
    except MobilityError:
        return ()


def _resting(mech: Mechanism, groups: tuple[Group, ...]) -> Iterator[Resting]:
    still = {FRAME}
    driven = set(chain.from_iterable(drive.pair for drive in mech.drives if drive.between))
    for group in groups:
        if not driven & set(group.links) and all(_stands(mech, outer, still) for outer in group.outer):
            still |= {*group.links}
            pins = [outer.joint.point for outer in group.outer if isinstance(outer.joint, Revolute)]
            named = tuple(name for name in group.links if name in mech.numbered)
            yield Resting(links=named, pins=tuple(dict.fromkeys(pins)), slides=len(pins) < len(group.outer))


def _stands(mech: Mechanism, outer: Outer, still: set[str]) -> bool:
    """Whether the joint does not move: it is on a link at rest, or in the pin about which its link turns."""
    if outer.parent in still:
        return True
    if not isinstance(outer.joint, Revolute):
        return False
    points = mech.link(outer.parent).points
    pivots = [points[pin] for pin, names in hinges(mech).items() if outer.parent in names and still & {*names}]
    return any(abs(points[outer.joint.point] - pivot) <= NOTHING * mech.scale for pivot in pivots)
