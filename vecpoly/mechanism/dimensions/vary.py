"""The dimensions of a mechanism, each varied alone: the one way to have another length, angle, place or drive.

    one = Bar(link="1")
    value(mech, one)             # 0.03 m
    varied(mech, one, 0.04)      # the mechanism with l_AB = 40 mm, all else as it was

All that is set out from what is varied follows it: placed points, guide lines through letters.
"""

from __future__ import annotations

import cmath
from collections.abc import Iterator
from math import cos, sin
from typing import TypeGuard, assert_never

from ...foundation.slotted import replace
from ..model import (
    FRAME,
    ByAngle,
    ByLengths,
    ByOffsets,
    Circle,
    Contact,
    Link,
    Mechanism,
    Placement,
    Prismatic,
    Rack,
    Side,
)
from .set_out import firm, moved, set_out
from .values import Bar, Coordinate, Dimension, Driven, Led, Part, Placed, Profile


def dimensions(mech: Mechanism) -> Iterator[Dimension]:
    """Every dimension of a mechanism: of its links, its fixed points, its guides, its discs, its drives."""
    for link in mech.links:
        yield from of_link(mech, link)
    yield from (Coordinate(letter=letter, axis=axis) for letter in mech.frame for axis in "xy")
    for i, joint in enumerate(mech.joints):
        if isinstance(joint, Prismatic) and joint.block not in mech.substitutes:
            yield from of_guide(i, joint)
    yield from dict.fromkeys(disc for contact in mech.contacts for disc in of_contact(contact))
    for i in range(len(mech.drives)):
        yield from (Driven(part=part, drive=i) for part in (Part.POSITION, Part.RATE, Part.ACCEL))


def of_link(mech: Mechanism, link: Link) -> Iterator[Bar | Placed]:
    """The distance of a link's first two points, then what sets out the others."""
    if len(firm(link)) == 2 and link.name not in mech.substitutes:
        yield Bar(link=link.name)
    for i, placement in enumerate(link.placements):
        yield from (Placed(link=link.name, places=(i,), part=part) for part in _parts(placement))


def of_guide(i: int, guide: Prismatic) -> Iterator[Led]:
    """The place of a fixed guide, or its direction where it runs through a letter; offset and turn if any."""
    if guide.guide == FRAME and not guide.towards:
        yield Led(joint=i, part=Part.DIRECTION if guide.through else Part.PLACE)
    if guide.offset:
        yield Led(joint=i, part=Part.OFFSET)
    if guide.turn:
        yield Led(joint=i, part=Part.TURN)


def of_contact(contact: Contact) -> Iterator[Profile]:
    """The radii of the discs; that of a knife edge is none."""
    for disc in (contact.disc, contact.on):
        if isinstance(disc, Circle) and disc.radius:
            yield Profile(link=disc.link, centre=disc.centre)


def value(mech: Mechanism, dimension: Dimension) -> float:
    """What the dimension is now (SI)."""
    match dimension:
        case Bar(link=name):
            first, second = firm(mech.link(name)).values()
            return abs(second - first)
        case Placed(link=name, places=places, part=part):
            return _placed(mech.link(name).placements[places[0]], part)
        case Coordinate(letter=letter, axis=axis):
            return mech.frame[letter].real if axis == "x" else mech.frame[letter].imag
        case Led(joint=i, part=part):
            return _of_led(_guide(mech, i), part)
        case Profile():
            return next(
                disc.radius for contact in mech.contacts for disc in (contact.disc, contact.on) if _is(disc, dimension)
            )
        case Driven(drive=i, part=part):
            return float(getattr(mech.drives[i], part.value))
        case _:
            assert_never(dimension)


def varied(mech: Mechanism, dimension: Dimension, to: float) -> Mechanism:
    """The mechanism with this value (SI) of one dimension, all else that is given as it was.

    A point whose triangle does not close lies at NaN.
    """
    match dimension:
        case Bar(link=name):
            link = mech.link(name)
            (first, start), (second, end) = firm(link).items()
            return set_out(
                mech, link, {first: start, second: start + to * (end - start) / abs(end - start)}, link.placements
            )
        case Placed(link=name, places=places, part=part):
            link = mech.link(name)
            anew = tuple(_replaced(one, part, to) if i in places else one for i, one in enumerate(link.placements))
            return set_out(mech, link, firm(link), anew)
        case Coordinate(letter=letter, axis=axis):
            at = mech.frame[letter]
            return moved(
                mech, FRAME, {**mech.frame, letter: complex(to, at.imag) if axis == "x" else complex(at.real, to)}
            )
        case Led(joint=i, part=part):
            return _with_joint(mech, i, _led(_guide(mech, i), part, to))
        case Profile():
            for i in range(len(mech.contacts)):
                mech = _profiled(mech, i, dimension, to)
            return mech
        case Driven(drive=i, part=part):
            drive = replace(mech.drives[i], **{part.value: to})  # type: ignore[arg-type]  # its parts are its fields
            return replace(mech, drives=(*mech.drives[:i], drive, *mech.drives[i + 1 :]))
        case _:
            assert_never(dimension)


def _parts(placement: Placement) -> tuple[Part, ...]:
    match placement:
        case ByAngle():
            return Part.DISTANCE, Part.ANGLE
        case ByLengths():
            return Part.FIRST, Part.SECOND
        case ByOffsets():
            return Part.ALONG, Part.LEFT
        case _:
            assert_never(placement)


def _placed(placement: Placement, part: Part) -> float:
    if isinstance(placement, ByLengths):
        return placement.lengths[part is Part.SECOND]
    return float(getattr(placement, part.value))


def _replaced(placement: Placement, part: Part, to: float) -> Placement:
    if isinstance(placement, ByLengths):
        p, q = placement.lengths
        return replace(placement, lengths=(to, q) if part is Part.FIRST else (p, to))
    return replace(placement, **{part.value: to})  # type: ignore[arg-type]  # its parts are its fields


def _guide(mech: Mechanism, i: int) -> Prismatic:
    joint = mech.joints[i]
    assert isinstance(joint, Prismatic)
    return joint


def upright(guide: Prismatic) -> bool:
    """Whether a guide is nearer to the vertical: its place is then an x."""
    return abs(sin(guide.direction)) > abs(cos(guide.direction))


def _of_led(guide: Prismatic, part: Part) -> float:
    if part is Part.PLACE:
        return guide.origin.real if upright(guide) else guide.origin.imag
    return float(getattr(guide, part.value))


def _led(guide: Prismatic, part: Part, to: float) -> Prismatic:
    if part is Part.PLACE:
        origin = complex(to, guide.origin.imag) if upright(guide) else complex(guide.origin.real, to)
        return replace(guide, origin=origin)
    return replace(guide, **{part.value: to})  # type: ignore[arg-type]


def _with_joint(mech: Mechanism, i: int, joint: Prismatic) -> Mechanism:
    return replace(mech, joints=(*mech.joints[:i], joint, *mech.joints[i + 1 :]))


def _is(disc: Circle | Rack, profile: Profile) -> TypeGuard[Circle]:
    return isinstance(disc, Circle) and (disc.link, disc.centre) == (profile.link, profile.centre)


def _profiled(mech: Mechanism, i: int, profile: Profile, to: float) -> Mechanism:
    """Another radius, and the link that replaces the contact: between the centres, or led along the face."""
    contact = mech.contacts[i]
    disc, on = (replace(one, radius=to) if _is(one, profile) else one for one in (contact.disc, contact.on))
    if (disc, on) == (contact.disc, contact.on):
        return mech
    assert isinstance(disc, Circle)
    mech = replace(mech, contacts=(*mech.contacts[:i], replace(contact, disc=disc, on=on), *mech.contacts[i + 1 :]))
    if not isinstance(on, Circle):
        return _off_the_face(mech, contact, disc.radius - contact.disc.radius)
    bar = mech.link(contact.substitute)
    (first, start), (second, _) = bar.points.items()
    reach = on.radius - disc.radius if contact.internal else disc.radius + on.radius
    return moved(mech, bar.name, {first: start, second: complex(reach)})


def _off_the_face(mech: Mechanism, contact: Contact, more: float) -> Mechanism:
    """The line of the disc's centre so much (m) further from the face."""
    i = next(
        i for i, joint in enumerate(mech.joints) if isinstance(joint, Prismatic) and joint.block == contact.substitute
    )
    guide, left = _guide(mech, i), 1j if contact.side is Side.LEFT else -1j
    return _with_joint(mech, i, replace(guide, origin=guide.origin + more * left * cmath.rect(1.0, guide.direction)))
