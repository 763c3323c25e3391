"""What is asked of a loaded mechanism where the file does not say."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from ...errors import MobilityError
from ...foundation.slotted import replace
from ...mechanism.asked.forces import pairs, press_named
from ...mechanism.groups.assur import decompose, ends
from ...mechanism.groups.stars import has_plate
from ...mechanism.loads import Force, Loads
from ...mechanism.model import FRAME, Drive, Mechanism, Prismatic, Revolute
from ...names import Named
from .asks import AskNamed


def default_asks(mech: Mechanism, loads: Loads, forces: Mapping[str, Named]) -> tuple[AskNamed, ...]:
    """What is asked where the file does not say:
    the unknown load, with friction also without it and η, and every reaction.

    Where the reactions are not drawn (groups that are not, from whichever link): the load alone.
    """
    name = loads.unknown.name
    if not loads.friction and not _comes_apart(mech, loads):
        return (AskNamed(rel=forces[name]),)
    keys = [name, *([f"{name}_0", "eta"] if loads.friction else [])]
    # between a cylinder and its piston there is only the thrust
    rams = [{force.link, force.against} for force in loads.forces]
    keys += [press_named(mech, by, on).key for by, on in pairs(mech) if {by, on} not in rams]
    return tuple(AskNamed(rel=forces[key]) for key in keys)


def _comes_apart(mech: Mechanism, loads: Loads) -> bool:
    """Whether from the driving link, or from another on the frame, there are dyads, cylinders, single gears and racks,
    central links on three legs alone: of these the reactions are drawn.

    A cylinder whose links carry more than its thrust is no two-force member, and none is drawn. One that drives
    between two moving links gives way to its own thrust where that is sought.
    """
    unknown = loads.unknown
    pushed = any(force.against for force in loads.forces)
    if any(force.against and loads.burdens(force) for force in loads.forces):
        return False
    if mech.drive.between and isinstance(unknown, Force) and unknown.against:
        rest = _without(mech, mech.drive.pair)
        return any(_is_drawn(rest, _turned(name), pushed) for name in rest.bodies if _on_frame(rest, name))
    drives = (mech.drive, *(_turned(name) for name in mech.numbered if _on_frame(mech, name)))
    return any(_is_drawn(mech, drive, pushed) for drive in drives)


def _turned(link: str) -> Drive:
    return Drive(link=link, position=0.0, rate=1.0)


def _without(mech: Mechanism, pair: Collection[str]) -> Mechanism:
    """The mechanism without the two links of a cylinder."""
    return replace(
        mech,
        links=tuple(link for link in mech.links if link.name not in pair),
        joints=tuple(j for j in mech.joints if not set(pair) & set(ends(j))),
    )


def _on_frame(mech: Mechanism, link: str) -> bool:
    """Whether a hinge or a slide joins the link to the frame."""
    return any({link, FRAME} == set(ends(j)) for j in mech.joints if isinstance(j, Revolute | Prismatic))


def _is_drawn(mech: Mechanism, drive: Drive, pushed: bool) -> bool:
    try:
        groups = decompose(replace(mech, drives=(drive,)))
    except MobilityError:
        return drive in mech.drives  # what is wrong with it is told elsewhere
    return all(
        group.dyad is not None
        or (pushed and group.ram is not None)
        or group.kind in ("gear", "rack")
        or has_plate(group)
        for group in groups
    )
