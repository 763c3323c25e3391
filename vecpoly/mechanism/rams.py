"""Links that a drive joins: a cylinder and its rod are, at one moment, a bar of known length.

So they count as one link where the mechanism is taken apart. With one more link they are a dyad of which that bar is
one side (`Ram`); other groups with a driven pair have no class of their own.
"""

from __future__ import annotations

from collections.abc import Iterable

from ..foundation.slotted import dataclass
from ..words import Words
from .model import Drive, Joint, Mechanism, Prismatic, Revolute

NEAR = 1e-9  # m: a hinge so near the origin of the guide is that


@dataclass(frozen=True, slots=True, kw_only=True)
class Ram:
    """A cylinder of known length, pinned at `outer` on `parent` and at `inner` on `link`,
    which hangs on `link_parent` by `link_joint`.

    pair: the driven sliding joint; near: of its two links the one with the outer hinge, far:
    the one with the inner hinge.
    """

    pair: Prismatic
    near: str
    outer: Revolute
    parent: str
    far: str
    inner: Revolute
    link: str
    link_joint: Revolute | Prismatic
    link_parent: str


def units(mech: Mechanism) -> tuple[tuple[str, ...], ...]:
    """The moving links that no drive holds against the frame, in the order of the mechanism;
    those between which a drive acts stand together."""
    held = {drive.link for drive in mech.drives if not drive.between}
    found = [{link.name} for link in mech.links if link.name not in held]
    for drive in mech.drives:
        joined = [unit for unit in found if unit & drive.pair]
        if len(joined) == 2:
            joined[0] |= joined[1]
            found.remove(joined[1])
    order = [link.name for link in mech.links]
    return tuple(tuple(sorted(unit, key=order.index)) for unit in found)


def stretched(mech: Mechanism, drive: Drive) -> tuple[str, ...]:
    """The hinges of a cylinder whose distance its length is, that of its barrel first; none of another drive, nor where
    its rod passes beside a hinge."""
    joint = driven_joint(mech, drive)
    if not isinstance(joint, Prismatic) or joint.guide not in mech.bodies:
        return ()
    foot, at = next(iter(mech.link(joint.guide).points.items()), ("", 0j))
    return (foot, joint.pin) if max(abs(at - joint.origin), abs(joint.offset)) < NEAR else ()


def driven_joint(mech: Mechanism, drive: Drive) -> Joint | None:
    """The joint in which the drive acts, if there is one of its kind."""
    for joint in mech.joints:
        match joint:
            case Prismatic() if drive.slide and {joint.guide, joint.block} == drive.pair:
                return joint
            case Revolute() if not drive.slide and {joint.a, joint.b} == drive.pair:
                return joint
            case _:
                continue
    return None


def drives_within(mech: Mechanism, links: Iterable[str]) -> tuple[Drive, ...]:
    """The drives that act between two of these links."""
    names = set(links)
    return tuple(drive for drive in mech.drives if drive.between and drive.pair <= names)


Hung = tuple[Joint, str, str]  # an outer joint, the link that hangs on it, the known link


def ram_of(pair: Joint | None, inner: tuple[Joint, ...], outer: tuple[Hung, Hung]) -> Ram | None:
    """The cylinder and the link that it moves,
    where these joints (the driven one left out of `inner`) make such a dyad; else None."""
    if not isinstance(pair, Prismatic) or len(inner) != 1 or not isinstance(inner[0], Revolute):
        return None
    sides, hinge = {pair.guide, pair.block}, inner[0]
    own = [hung for hung in outer if hung[1] in sides]
    other = [hung for hung in outer if hung[1] not in sides]
    if len(own) != 1 or len(other) != 1:
        return None
    (pin, near, parent), (joint, link, link_parent) = own[0], other[0]
    far = next(iter(sides - {near}))
    if (
        not isinstance(pin, Revolute)
        or not isinstance(joint, Revolute | Prismatic)
        or {hinge.a, hinge.b} != {far, link}
    ):
        return None
    return Ram(
        pair=pair,
        near=near,
        outer=pin,
        parent=parent,
        far=far,
        inner=hinge,
        link=link,
        link_joint=joint,
        link_parent=link_parent,
    )


def driven_kind(
    mech: Mechanism, drives: tuple[Drive, ...], inner: tuple[Joint, ...], outer: tuple[Hung, ...]
) -> tuple[str, Ram | None]:
    """The kind of a group inside which a drive acts: a dyad with a cylinder as one of its bars, or any other."""
    ram = None
    if len(drives) == 1 and len(outer) == 2:
        pair = driven_joint(mech, drives[0])
        ram = ram_of(pair, tuple(joint for joint in inner if joint != pair), (outer[0], outer[1]))
    return (
        ("driven", None) if ram is None else (f"cylinder {'RR' if isinstance(ram.link_joint, Revolute) else 'RP'}", ram)
    )


def driver_words(mech: Mechanism) -> Words:
    """What drives: a link, a cylinder, or a motor in a hinge."""
    drive = mech.drive
    if not drive.between:
        return Words(f"构件 {drive.link} ", f"link {drive.link}")
    pair = f"{drive.on}-{drive.link}"
    return (
        Words(f"油缸 {pair} ", f"the cylinder {pair}")
        if drive.slide
        else Words(f"构件 {drive.on}、{drive.link} 间的电机", f"the motor between links {drive.on} and {drive.link}")
    )
