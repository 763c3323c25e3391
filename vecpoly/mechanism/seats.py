"""Which link carries the pin of a multiple joint, and so which links press on each other there.

A pin is fixed in one link; every other link turns on it, and presses on that link alone. It is the frame, if the frame
is there; else the driving link; else the link that is placed first when the mechanism is put together group by group
from the drive, for on it the later groups hang; of two links of one group that are pinned to each other there, the one
nearer to the frame: the rocker or the slider, not the connecting rod. None of this depends on the numbers of the links.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ..errors import MobilityError
from ..foundation.slotted import replace
from .groups.assur import decompose, ends, hinges
from .model import FRAME, Joint, Mechanism, Revolute

Rank = tuple[int, int, int, tuple[str, ...], int]


def seated(mech: Mechanism, chosen: Mapping[str, str] | None = None) -> Mechanism:
    """The mechanism with the joints of its multiple joints as they press:
    the link that carries the pin with each of the others.

    chosen: letter → link, where the problem itself says which link carries the pin.
    """
    compound = {point: names for point, names in hinges(mech).items() if len(names) > 2}
    if not compound:
        return mech
    ranks, thought = _ranks(mech), {*mech.substitutes, *mech.slot_pins}
    seats = {
        point: (chosen or {}).get(point) or min((n for n in names if n not in thought), key=ranks.__getitem__)
        for point, names in compound.items()
    }
    joints: list[Joint] = []
    for joint in mech.joints:
        if not isinstance(joint, Revolute) or joint.point not in compound:
            joints.append(joint)
        elif joint.point in seats:
            joints += _pins(mech, joint.point, compound[joint.point], seats.pop(joint.point))
    return replace(mech, joints=tuple(joints))


def seat(mech: Mechanism, point: str) -> str | None:
    """The link that carries the pin of a multiple joint, as its joints say;
    None at a pin of two links that runs in no slot."""
    pins = [
        {joint.a, joint.b}
        for joint in mech.joints
        if isinstance(joint, Revolute) and joint.point == point and not {joint.a, joint.b} & mech.substitutes
    ]
    if (
        len(pins) < 2 or len(set().union(*pins) - mech.slot_pins.keys()) < 2
    ):  # of one link, however many slots its pin runs in
        return None
    return next(iter(set.intersection(*pins)), None)


def _pins(mech: Mechanism, point: str, names: tuple[str, ...], carrier: str) -> Iterator[Revolute]:
    """The carrier with every other link; what stands for a higher pair turns on the link of its own disc."""
    for name in names:
        own = next(
            (c.disc.link if c.disc.centre == point else c.on.link for c in mech.contacts if c.substitute == name),
            carrier,
        )
        if name != carrier:
            first, last = sorted((own, name), key=names.index)
            yield Revolute(point=point, a=first, b=last)


def _ranks(mech: Mechanism) -> dict[str, Rank]:
    """How much a link is preferred as carrier of a pin: the smallest is."""
    near, driven = _distances(mech, FRAME), _distances(mech, mech.drives[0].link if mech.drives else FRAME)
    order = _order(mech)
    names = [*(link.name for link in mech.links), FRAME]
    return {
        name: (
            order.get(name, len(names)),
            near.get(name, len(names)),
            driven.get(name, len(names)),
            tuple(sorted(mech.link(name).points)),
            i,
        )
        for i, name in enumerate(names)
    }


def _order(mech: Mechanism) -> dict[str, int]:
    """Link → when it is placed: the frame, the drives, group after group;
    nothing where no groups can be taken apart."""
    try:
        groups = decompose(mech)
    except MobilityError:
        groups = ()
    placed = [(FRAME,), tuple(drive.link for drive in mech.drives), *(group.links for group in groups)]
    return {name: i for i, links in enumerate(placed) for name in links}


def _distances(mech: Mechanism, start: str) -> dict[str, int]:
    """Link → how many joints it is away."""
    meeting = [set(names) for names in hinges(mech).values()] + [
        set(ends(joint)) for joint in mech.joints if not isinstance(joint, Revolute)
    ]
    found, edge = {start: 0}, {start}
    while edge:
        edge = {name for names in meeting if names & edge for name in names} - set(found)
        found |= dict.fromkeys(edge, max(found.values()) + 1)
    return found
