"""What slides and what leads it: slots, rods, fixed guides, blocks."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..board.paper.marks import Block, FixedGuide, LinkNumber, Mark, Role, Segment, Slot, Weld
from ..foundation.slotted import replace
from ..mechanism.model import FRAME, Prismatic, Revolute
from ..problem.problem import Shape
from .bars import weld
from .posed import Posed, Way

HALF_SLOT = 15.0  # mm from the pin to either end of a slot, and of a fixed guide
BEYOND = 12.0  # mm a rod sticks out behind its block
HALF_BLOCK = 2.5  # mm from the middle of a block to its long side
BUSH, PLAY = 8.0, 1.5  # mm: half of a fixed bush in which a rod runs, from the rod to it
BESIDE = 0.3  # mm: nearer to a line a point stands on it
RIM = 2.0  # mm of a block past the reaction of its guide
STEEP = 0.26  # sine of the angle at which a rod leaves a block through its guide, and not beside it
LONGEST = 20.0  # mm: farther out a reaction is not reached by its block
ARM = 3.0  # mm: a point farther beside a slot is joined to it by an arm


def guide_body(posed: Posed, link: str, joint: Prismatic, shape: Shape) -> Iterator[Mark]:
    """A slotted link or a rod: from its own points along the guide to a little past the block.

    A slot in which a block slides, and which leads through a pin of its link, is drawn as its line with the block on
    it, as GB/T 4460 draws a guide bar: how long the slot is, nobody says.
    """
    line, own = posed.guide(joint), posed.spots(link)
    pin = posed.at.get(joint.pin, line.at)
    barred = not joint.pin_in_slot and any(abs(line.off(spot)) < BESIDE for spot in own)
    if shape is Shape.SLOT and not barred:
        yield from _slot(posed, joint, own, pin)
    else:
        yield from through(line, pin, BEYOND, own)


def is_slot(posed: Posed, link: str, joint: Prismatic) -> bool:
    """Whether a bar guides its block beside its own line, or beyond its ends: then it has a slot there."""
    if joint.pin not in posed.at:
        return False
    line = posed.guide(joint)
    travels = [line.travel(spot) for spot in posed.spots(link) if abs(line.off(spot)) < BESIDE]
    return len(travels) < 2 or not min(travels) < line.travel(posed.at[joint.pin]) < max(travels)


def link_number(posed: Posed, link: str, shape: Shape, guide: Prismatic | None) -> LinkNumber:
    """The number of a link beside its line, which is its guide where it has one."""
    spots = posed.spots(link)
    a, b = spots[0], spots[1] if len(spots) > 1 else spots[0]
    if shape in (Shape.SLOT, Shape.ROD) and guide is not None and guide.pin in posed.at:
        line = posed.guide(guide)
        a, b = line.foot(spots[0]), line.foot(posed.at[guide.pin])
        reach = HALF_SLOT if shape is Shape.SLOT else BEYOND
        if abs(b - a) < reach:  # the block covers it: beside all of the guide that is drawn
            a, b = b - line.along * reach, b + line.along * reach
    return LinkNumber(a=a, b=b, number=posed.name(link))


def sliding_pair(posed: Posed, joint: Prismatic) -> Iterator[Mark]:
    """The block on its guide, and the guide where it is fixed."""
    line, pin = posed.guide(joint), posed.at[joint.pin]
    middle, along = line.foot(pin), line.along
    if joint.guide == FRAME:
        along = -along if _other_side(posed, joint, middle, along) else along
        yield rail_under(middle, along, HALF_SLOT)
        yield from _from_its_point(posed, joint, middle)
    elif posed.shapes.get(joint.guide) is Shape.ROD and joint.block == FRAME:
        yield from bush(middle, along)
        return
    yield from block_marks(posed, joint, along)


def _from_its_point(posed: Posed, joint: Prismatic, middle: complex) -> Iterator[Segment]:
    """The centre line on to the fixed point through which a guide is told to run, where nothing else stands there."""
    pinned = {one.point for one in posed.mech.joints if isinstance(one, Revolute)}
    for letter in posed.mech.frame:
        away = posed.at[letter] - middle if letter in posed.at and letter not in pinned else 0j
        if abs(away) > HALF_SLOT and abs(posed.guide(joint).off(posed.at[letter])) < BESIDE:
            yield Segment(a=middle + HALF_SLOT * away / abs(away), b=posed.at[letter], role=Role.CENTRE)


def rail_under(middle: complex, along: complex, half: float) -> FixedGuide:
    """The fixed guide of a block, half of it to either side; the block lies to its left."""
    under = middle - 1j * along * HALF_BLOCK
    return FixedGuide(a=under - along * half, b=under + along * half, about=middle)


def bush(middle: complex, along: complex, half: float = BUSH, play: float = PLAY) -> Iterator[FixedGuide]:
    """The fixed bush in which a rod runs: half of it to either side, so far from the rod."""
    for way in (along, -along):
        yield FixedGuide(a=middle - way * complex(half, play), b=middle + way * complex(half, -play))


def fixed_slot(posed: Posed, joint: Prismatic) -> Iterator[Mark]:
    """The fixed slot in which a pin runs: its two sides, and the centre line to the point through which it is told to
    run."""
    middle = posed.guide(joint).foot(posed.at[joint.pin])
    for side in bush(middle, posed.guide(joint).along, HALF_SLOT, HALF_BLOCK):
        yield replace(side, about=middle)
    yield from _from_its_point(posed, joint, middle)


def block_marks(posed: Posed, joint: Prismatic, along: complex | None = None) -> Iterator[Mark]:
    """The block of a sliding pair; an arm to its pin where that stands beside the guide."""
    line, pin = posed.guide(joint), posed.at[joint.pin]
    middle = line.foot(pin)
    if not _is_in_fixed_guide(posed, joint):
        yield Block(at=middle, along=along or line.along, on_rod=posed.shapes.get(joint.guide) is Shape.ROD)
    if abs(pin - middle) > HALF_BLOCK:
        yield Segment(a=middle, b=pin, role=Role.LINK)


def _is_in_fixed_guide(posed: Posed, joint: Prismatic) -> bool:
    """Whether the block of this pair slides in a fixed guide, too, where it is drawn: a block is one body."""
    others = (one for one in posed.slides() if one.block == joint.block and one.guide == FRAME)
    return joint.guide != FRAME and any(one.pin == joint.pin for one in others)


def reaching(block: Block, pressed: tuple[complex, ...]) -> Block:
    """The block as long as it must be to reach past reactions of its guide, which friction and moments move away."""
    away = max((abs(at - block.at) for at in pressed), default=0.0)
    return replace(block, length=max(block.length, 2 * (away + RIM))) if away < LONGEST else block


def _slot(posed: Posed, joint: Prismatic, own: list[complex], pin: complex) -> Iterator[Mark]:
    line = posed.guide(joint)
    t = line.travel(pin)
    start, end = line.spot(t - HALF_SLOT), line.spot(t + HALF_SLOT)
    yield Slot(a=start, b=end)
    for spot in own:
        near, off = min((start, end), key=lambda s: abs(s - spot)), abs(line.off(spot))
        if abs(spot - near) <= HALF_BLOCK:
            continue  # inside the rounded end of the slot
        near += HALF_BLOCK * (spot - near) / abs(spot - near)
        if abs(line.travel(spot) - t) > HALF_SLOT or off > ARM:
            yield Segment(a=spot, b=near, role=Role.LINK)
        if off > ARM:
            yield weld(near, spot - near, pin - near)


def through(line: Way, pin: complex, half: float, own: Sequence[complex]) -> Iterator[Segment | Weld]:
    """A rod, or a flat face, past what slides or presses on it, on to the link's own places;
    one beside it is joined to it at right angles."""
    t, feet = line.travel(pin), [line.travel(spot) for spot in own]
    yield Segment(a=line.spot(min([t - half, *feet])), b=line.spot(max([t + half, *feet])), role=Role.LINK)
    for spot in own:
        if abs(line.off(spot)) >= BESIDE:
            foot = line.foot(spot)
            yield Segment(a=foot, b=spot, role=Role.LINK)
            yield weld(foot, spot - foot, (pin if abs(pin - foot) > BESIDE else line.spot(t + half)) - foot)


def _other_side(posed: Posed, joint: Prismatic, middle: complex, along: complex) -> bool:
    """Whether the sliding link lies to the right of the guide, where its hatching would be, or a rod that is pinned to
    the block leaves it there, and none to the left."""
    letters = [*posed.letters(joint.block), *(j.pin for j in posed.slides() if j.guide == joint.block)]
    spots = [posed.at[letter] for letter in letters if letter in posed.at]
    if min(((along.conjugate() * (s - middle)).imag for s in spots), default=0.0) < -HALF_BLOCK:
        return True
    leaning = [(along.conjugate() * way / abs(way)).imag for way in _rods(posed, joint, middle)]
    return min(leaning, default=0.0) < -STEEP and max(leaning) <= STEEP


def _rods(posed: Posed, joint: Prismatic, middle: complex) -> Iterator[complex]:
    """The ways from a block along the links that are pinned to it."""
    for letter in posed.letters(joint.block):
        for link in posed.pinned(letter):
            if link not in (FRAME, joint.block) and posed.is_located(link):
                ways = (spot - middle for spot in posed.spots(link))
                yield from (way for way in ways if abs(way) > HALF_SLOT)
