"""Centres that are read off: the pin, at infinity across the guide, the point where links roll;
of a sliding contact the common normal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from ...mechanism.asked.centres import Pair, pair_of, real_links, sliding_pairs
from ...mechanism.groups.assur import hinges
from ...mechanism.model import FRAME, Contact, Prismatic, Rolling
from ...plane import Line, nominal
from ..desk import Desk
from .geometry import Centre


@dataclass(frozen=True, slots=True, kw_only=True)
class Direct:
    """What is seen of one pair of links: its centre, or the normal on which it lies;
    `where`: the letter of the pin or contact."""

    pair: Pair
    where: str
    joint: Prismatic | Rolling | Contact | None = None  # None: a pin
    centre: Centre | None = None
    normal: Line | None = None


def direct_centres(desk: Desk) -> tuple[Direct, ...]:
    """The pins, slides, rolling and sliding contacts of the mechanism as drawn (mm on the diagram)."""
    return (*_pins(desk), *_slides(desk), *_slots(desk), *_rolling(desk), *_contacts(desk))


def pins(found: tuple[Direct, ...]) -> tuple[Direct, ...]:
    """Those that are pins."""
    return tuple(one for one in found if one.joint is None)


def of_kind(found: tuple[Direct, ...], *kinds: type) -> tuple[Direct, ...]:
    """Those that come from joints of these kinds."""
    return tuple(one for one in found if isinstance(one.joint, kinds))


def normals(found: tuple[Direct, ...]) -> Mapping[Pair, Line]:
    """The common normals of the contacts."""
    return {one.pair: one.normal for one in found if one.normal is not None}


def _pins(desk: Desk) -> list[Direct]:
    real = set(real_links(desk.mech))
    out = []
    for point, names in hinges(desk.mech).items():
        there = [name for name in names if name in real]
        out += [
            Direct(pair=pair_of(desk.mech, a, b), where=point, centre=Centre(at=desk.at[point]))
            for i, a in enumerate(there)
            for b in there[i + 1 :]
        ]
    return out


def _slides(desk: Desk) -> list[Direct]:
    across = [(joint, desk.board.turn(1j * desk.guide_line(joint).along)) for joint in sliding_pairs(desk.mech)]
    return [
        Direct(
            pair=pair_of(desk.mech, joint.guide, joint.block), where=joint.pin, joint=joint, centre=Centre(along=along)
        )
        for joint, along in across
    ]


def _slots(desk: Desk) -> list[Direct]:
    """A pin that runs in a slot: a contact whose common normal stands on the slot at the pin."""
    real, out = set(real_links(desk.mech)), []
    thought = desk.mech.substitutes
    for joint in desk.mech.joints:
        if (
            isinstance(joint, Prismatic)
            and joint.pin_in_slot
            and joint.block not in real | thought
            and joint.guide in real
        ):
            carrier = next(name for name in desk.mech.links_at(joint.pin) if name in real)
            normal = Line(desk.at[joint.pin], desk.board.turn(1j * desk.guide_line(joint).along))
            out.append(
                Direct(pair=pair_of(desk.mech, carrier, joint.guide), where=joint.pin, joint=joint, normal=normal)
            )
    return out


def _rolling(desk: Desk) -> list[Direct]:
    return [
        Direct(
            pair=pair_of(desk.mech, joint.gear.link, joint.on.link),
            where=joint.point,
            joint=joint,
            centre=Centre(at=desk.contact(joint)),
        )
        for joint in desk.mech.joints
        if isinstance(joint, Rolling)
    ]


def _contacts(desk: Desk) -> list[Direct]:
    return [
        Direct(
            pair=pair_of(desk.mech, *contact.links),
            where=contact.point,
            joint=contact,
            normal=Line(desk.contact_of(contact), desk.board.turn(desk.normal_of(contact))),
        )
        for contact in desk.mech.contacts
    ]


def fixed(pair: Pair) -> bool:
    """Whether one of the links is the frame: an absolute centre."""
    return FRAME in pair


def scaled(found: tuple[Direct, ...], factor: float) -> tuple[Direct, ...]:
    """The same on a figure that is drawn larger or smaller by a factor."""
    return tuple(
        Direct(
            pair=one.pair,
            where=one.where,
            joint=one.joint,
            centre=None if one.centre is None else moved(one.centre, factor),
            normal=None if one.normal is None else Line(one.normal.at * factor, one.normal.along),
        )
        for one in found
    )


def moved(centre: Centre, factor: float) -> Centre:
    """A centre of the diagram on that figure."""
    return centre if centre.at is None else Centre(at=centre.at * factor)


def spot(one: Direct) -> complex:
    """Where the pin, block or contact is (nominal, mm)."""
    at = (
        one.centre.at
        if one.centre is not None and one.centre.at is not None
        else one.normal.at
        if one.normal is not None
        else 0j
    )
    return complex(nominal(at))
