"""Sliding pairs as drawn: slotted links and rods from their points to the block, blocks, fixed guides."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from ....board.paper.marks import Block, FixedGuide, Mark, Role, Segment, Slot
from ....mechanism.model import FRAME, Link, Prismatic
from ....plane import nominal
from ....problem.problem import Shape
from ...desk import Desk
from .bars import weld
from .cam import contact_replaced

HALF_SLOT = 15.0  # mm from the pin to either end of a slot, and of a fixed guide
BEYOND = 12.0  # mm a rod sticks out behind its block
HALF_BLOCK = 2.5  # mm from the middle of a block to its long side


def late_guides(desk: Desk, links: tuple[str, ...]) -> list[Prismatic]:
    """Guides on links drawn before, whose blocks are only now located."""
    return [
        j
        for j in desk.mech.joints
        if isinstance(j, Prismatic)
        and j.block in links
        and j.guide not in links
        and j.guide != FRAME
        and not contact_replaced(desk.mech, j.block)
    ]


def spot_of(desk: Desk, name: str) -> complex:
    """The place of a lettered point on the nominal sheet (mm)."""
    return complex(nominal(desk.at[name]))


def guide_body(desk: Desk, body: Link, joint: Prismatic, shape: Shape) -> Iterator[Mark]:
    """A slotted link or a rod: from its own points along the guide to a little past the block."""
    line = desk.guide_line(joint)
    at, along = complex(nominal(line.at)), complex(nominal(line.along))

    def travel(p: complex) -> float:
        return float((np.conj(along) * (p - at)).real)

    pin = spot_of(desk, joint.pin) if joint.pin in desk.at else at
    own = [spot_of(desk, p) for p in body.points]
    t = travel(pin)
    if shape is Shape.SLOT:
        start, end = at + along * (t - HALF_SLOT), at + along * (t + HALF_SLOT)
        yield Slot(a=start, b=end)
        for p in own:
            near = min((start, end), key=lambda s: abs(s - p))
            near += HALF_BLOCK * (p - near) / abs(p - near)  # the rounded end of the slot
            off = abs((np.conj(along) * (p - at)).imag)
            if abs(travel(p) - t) > HALF_SLOT or off > 3:
                yield Segment(a=p, b=near, role=Role.LINK)
            if off > 3:
                yield weld(near, p - near, pin - near)
        return
    feet = [travel(p) for p in own]
    yield Segment(a=at + along * min(*feet, t - BEYOND), b=at + along * max(*feet, t + BEYOND), role=Role.LINK)
    for p in own:
        if abs((np.conj(along) * (p - at)).imag) >= 0.3:
            foot = at + along * travel(p)
            yield Segment(a=foot, b=p, role=Role.LINK)
            yield weld(foot, p - foot, pin - foot)


def is_slot(desk: Desk, body: Link, joint: Prismatic) -> bool:
    """Whether a bar guides its block beside its own line, or beyond its ends: then it has a slot there."""
    line, pin = desk.guide_line(joint), spot_of(desk, joint.pin) if joint.pin in desk.at else None
    at, along = complex(nominal(line.at)), complex(nominal(line.along))
    places = [np.conj(along) * (spot_of(desk, p) - at) for p in body.points]
    travels = [float(place.real) for place in places if abs(place.imag) < 0.3]
    return pin is not None and (
        len(travels) < 2 or not min(travels) < float((np.conj(along) * (pin - at)).real) < max(travels)
    )


def sliding_pair(desk: Desk, joint: Prismatic, shapes: Mapping[str, Shape]) -> Iterator[Mark]:
    """The block on its guide, and a fixed guide or a guide through which a rod runs."""
    line = desk.guide_line(joint)
    at, along = complex(nominal(line.at)), complex(nominal(line.along))
    pin = spot_of(desk, joint.pin)
    middle = at + along * float((np.conj(along) * (pin - at)).real)
    if joint.guide == FRAME:
        if _other_side(desk, joint, middle, along):
            along = -along
        yield FixedGuide(
            a=middle - along * HALF_SLOT - 1j * along * HALF_BLOCK,
            b=middle + along * HALF_SLOT - 1j * along * HALF_BLOCK,
        )
    elif shapes.get(joint.guide) is Shape.ROD and joint.block == FRAME:
        for side in (1, -1):
            a, b = middle - side * along * 8, middle + side * along * 8
            yield FixedGuide(a=a - 1j * side * along * 1.5, b=b - 1j * side * along * 1.5)
        return
    yield Block(at=middle, along=along, on_rod=shapes.get(joint.guide) is Shape.ROD)
    if abs(pin - middle) > 0.3 and abs(pin - middle) > HALF_BLOCK:
        yield Segment(a=middle, b=pin, role=Role.LINK)


def _other_side(desk: Desk, joint: Prismatic, middle: complex, along: complex) -> bool:
    """Whether the sliding link lies to the right of the guide, where its hatching would be."""
    spots = [spot_of(desk, p) for p in desk.letters(joint.block) if p in desk.at]
    spots += [
        spot_of(desk, j.pin)
        for j in desk.mech.joints
        if isinstance(j, Prismatic) and j.guide == joint.block and j.pin in desk.at
    ]
    return min(((np.conj(along) * (s - middle)).imag for s in spots), default=0.0) < -HALF_BLOCK
