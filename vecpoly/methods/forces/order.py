"""In which order a loaded mechanism is taken apart:
the link that closes, the groups from the far end, and the links on which they hang."""

from __future__ import annotations

from dataclasses import dataclass

from ...errors import MobilityError
from ...foundation.slotted import replace
from ...mechanism.groups.assur import Group, decompose, ends
from ...mechanism.loads import Force, Loads, Moment
from ...mechanism.model import FRAME, Drive, Joint, Mechanism, Prismatic, Revolute, Rolling
from .balance.power_alone import is_drawn, is_plain
from .hubs import on_groups
from .lines.links_of_group import Held


@dataclass(frozen=True, slots=True, kw_only=True)
class Order:
    """The link that closes, with its joint to the frame, and the groups from the far end; mech: with the pins where the
    groups hang.

    The link that closes is the one that the balancing load acts on. known: another one, since that has no fixed pin (or
    guide, for a force) or since from it the mechanism comes apart into groups above class II: then the balancing load
    must be known before. held is None where no link on the frame closes.
    """

    held: Held | None
    groups: tuple[Group, ...]
    mech: Mechanism
    known: bool = False


def order_of(mech: Mechanism, loads: Loads, moving: frozenset[str]) -> Order:
    """The order; the pins stay in the links to which the problem gives them wherever the groups come apart so.
    moving: the links that do not all but stand still."""
    link = loads.unknown.link
    joint = fixed_joint(_held(mech, replace(mech.drive, link=link, on=FRAME)), link)
    if joint is None or (isinstance(loads.unknown, Moment) and not isinstance(joint, Revolute)):
        return _known_before(mech, moving)
    own = replace(
        _apart(mech, replace(mech.drive, link=link, on=FRAME)), held=Held(link=link, parent=FRAME, joint=joint)
    )
    if is_plain(own.groups):
        return own
    other = _known_before(mech, moving)
    return other if is_plain(other.groups) or (is_drawn(other.groups) and not is_drawn(own.groups)) else own


def _known_before(mech: Mechanism, moving: frozenset[str]) -> Order:
    """The order from the driving link, or from another on the frame from which all groups are drawn
    (取另一构件为原动件拆组): from one link a mechanism may be of class III, and from another of class II.

    A group of class III is solved as it is only where no link on the frame that moves makes class II of it: from one
    that stands still, as at the end of its swing, class II groups are at a change point.
    """
    drive = mech.drive
    own = _apart(mech, drive)
    joint = fixed_joint(own.mech, drive.link) if drive.on == FRAME else None
    first = replace(own, held=None if joint is None else Held(link=drive.link, parent=FRAME, joint=joint), known=True)
    if joint is not None and is_plain(own.groups):
        return first
    for link in sorted(mech.numbered, key=lambda one: (one not in moving, one in (drive.link, drive.on))):
        if link not in moving and joint is not None and is_drawn(own.groups):
            break
        if link != drive.link and (found := _from_link(mech, link)) is not None:
            return found
    return first


def _from_link(mech: Mechanism, link: str) -> Order | None:
    """The order from another link on the frame, where all its groups are plain."""
    moved = Drive(link=link, position=0.0, rate=1.0)
    joint = fixed_joint(_held(mech, moved), link)
    if joint is None:
        return None
    try:
        other = _apart(mech, replace(moved, slide=isinstance(joint, Prismatic)))
    except MobilityError:
        return None
    plain = bool(other.groups) and is_plain(other.groups)
    return replace(other, held=Held(link=link, parent=FRAME, joint=joint), known=True) if plain else None


def order_without(mech: Mechanism, thrust: Force) -> Order:
    """The order once a cylinder between two moving links has given way to its thrust, which is known:
    any link on the frame closes."""
    own = {thrust.link, thrust.against}
    rest = replace(
        mech,
        links=tuple(link for link in mech.links if link.name not in own),
        joints=tuple(j for j in mech.joints if not own & set(ends(j))),
    )
    for link in rest.bodies:
        joint = fixed_joint(rest, link)
        drive = Drive(link=link, position=0.0, rate=1.0, slide=isinstance(joint, Prismatic))
        if joint is not None and (groups := _pressing(rest, drive)) is not None and is_drawn(groups):
            return Order(held=Held(link=link, parent=FRAME, joint=joint), groups=groups, mech=mech)
    return Order(held=None, groups=decompose(mech), mech=mech)


def fixed_joint(mech: Mechanism, link: str) -> Joint | None:
    """The joint of a link to the frame; teeth are none, they hold it in one direction alone."""
    return next(
        (
            j
            for j in mech.joints
            if not isinstance(j, Rolling)
            and not (isinstance(j, Prismatic) and j.guide != FRAME)
            and set(ends(j)) == {FRAME, link}
        ),
        None,
    )


def _held(mech: Mechanism, drive: Drive) -> Mechanism:
    """The mechanism, its pins where the groups hang if only so the driving link is pinned to the frame: it may sit on
    the pin of another link there."""
    hung = on_groups(mech, drive)
    return hung if fixed_joint(mech, drive.link) is None and fixed_joint(hung, drive.link) is not None else mech


def _apart(mech: Mechanism, drive: Drive) -> Order:
    """The groups when this drive moves the mechanism:
    with the pins as the problem has them, else where the groups hang.

    Raises MobilityError where it comes apart neither way.
    """
    hung, mech = on_groups(mech, drive), _held(mech, drive)
    found = _pressing(mech, drive)
    if found is not None and is_plain(found):
        return Order(held=None, groups=found, mech=mech)
    other = found if hung.joints == mech.joints else _pressing(hung, drive)
    both = ((found, mech), (other, hung))
    ways = [Order(held=None, groups=groups, mech=one) for groups, one in both if groups is not None]
    for suits in (is_plain, is_drawn):
        for way in ways:
            if suits(way.groups):
                return way
    if ways:
        return ways[0]
    return Order(held=None, groups=decompose(replace(mech, drives=(drive,)), pressing=True), mech=mech)


def _pressing(mech: Mechanism, drive: Drive) -> tuple[Group, ...] | None:
    """The groups of the links that press on each other, from the far end; None where they are none."""
    try:
        return tuple(reversed(decompose(replace(mech, drives=(drive,)), pressing=True)))
    except MobilityError:
        return None
