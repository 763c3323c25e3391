"""The links of a mechanism with the symbols of GB/T 4460: those of one group at a time, or one link by itself."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..board.paper.marks import Block, Dot, FixedGuide, LinkNumber, Mark, Passing, Point, Role, Segment, Weld
from ..board.paper.symbols import Symbol
from ..foundation.slotted import replace
from ..mechanism.model import FRAME, Circle, Prismatic, Rack, Rolling
from ..names import subscripted
from ..problem.problem import Shape
from .bars import bar
from .cams.contact import cam_body, contact_replaced, contacts_of, guided_follower, thought_guide
from .cams.follower import face_marks, stem
from .cylinders import cylinder_joint, cylinder_part, is_cylinder
from .gears import gear_marks, guided_rack, rack_marks
from .guides import block_marks, fixed_slot, guide_body, is_slot, link_number, reaching, sliding_pair
from .owners import link as owner
from .owners import owned
from .pins import BESIDE, lines_of, passing, welds
from .posed import Posed

ALONE = {Dot.MULTIPLE: Dot.JOINT}  # a link by itself has one half of each pin
NEAR = 1e-6  # mm
_NO_BAR = (Shape.GEAR, Shape.PIN, Shape.CYLINDER, Shape.PISTON)


def links_drawn(posed: Posed, links: tuple[str, ...], drawn: tuple[Mark, ...] = ()) -> Iterator[Symbol]:
    """The links of one group, just located, beside what is drawn already: bodies, guides, blocks, gears."""
    paper = list(drawn)
    for name, marks in _drawn(posed, links, paper):
        for symbol in owned(owner(name), marks):
            paper += [replace(mark, owner=symbol.owner) for mark in symbol.marks]
            yield symbol


def link_alone(posed: Posed, name: str, *, lettered: bool = True, pressed: tuple[complex, ...] = ()) -> Symbol:
    """One link without its neighbours: its body, its block, its lettered points.

    pressed: where the reactions of its guides act, past which its blocks reach.
    """
    marks = [reaching(mark, pressed) if isinstance(mark, Block) else mark for mark in _alone(posed, name)]
    marks += _rigid(marks)
    return Symbol.of(owner(name), (mark for mark in marks if lettered or not isinstance(mark, Point)))


def _alone(posed: Posed, name: str) -> Iterator[Mark]:
    ram = cylinder_joint(posed, name)
    yield from body(posed, name) if ram is None else cylinder_part(posed, name, ram)
    if posed.shapes.get(name) not in (Shape.ROD, Shape.PISTON):
        for joint in (j for j in posed.slides() if j.block == name and not _own_body(posed, j)):
            yield from block_marks(posed, joint)
    for contact in contacts_of(posed.mech, name):
        if isinstance(contact.on, Rack) and contact.on.link == name:
            yield from face_marks(posed, contact)
        if (guide := posed.fixed_guide(name)) is not None:
            yield stem(posed, contact, name, guide)
    yield from (mark for mark in _teeth(posed, name) if not isinstance(mark, FixedGuide))  # that is the frame's
    thought = contact_replaced(posed.mech, name)
    if thought is not None and isinstance(thought.on, Rack):
        yield from thought_guide(posed, thought)
    hinged = posed.hinged()
    for letter in posed.body(name).points:
        if letter in posed.at and not letter.endswith("'"):
            dot = posed.dot(letter)
            own = [*body(posed, name)] if letter in hinged else []
            yield from _joining(posed, posed.at[letter], posed.pinned(letter), name, own)
            yield Point(at=posed.at[letter], label=subscripted(letter), dot=ALONE.get(dot, dot))


def _teeth(posed: Posed, name: str) -> Iterator[Mark]:
    """The pitch circles and pitch lines of one link, each once."""
    drawn: list[Mark] = []
    for rolling in (joint for joint in posed.mech.joints if isinstance(joint, Rolling)):
        for circle in (rolling.gear, rolling.on):
            if isinstance(circle, Circle) and circle.link == name:
                drawn += gear_marks(posed, circle, rolling, tuple(drawn))
        if isinstance(rolling.on, Rack) and rolling.on.link == name:
            drawn += rack_marks(posed, rolling, rolling.on)
    for circle in (one for one in posed.mech.idle if one.link == name):
        drawn += gear_marks(posed, circle, None, tuple(drawn))
    yield from drawn


def body(posed: Posed, name: str) -> Iterator[Mark]:
    """The lines of a link with its number; its guide where the block is located too."""
    shape, spots = posed.shape(name), posed.spots(name)
    if contacts_of(posed.mech, name):
        yield from cam_body(posed, posed.body(name))
        return
    if shape in _NO_BAR:
        return
    if shape is Shape.BLOCK:
        yield from (Segment(a=spots[0], b=spot, role=Role.LINK) for spot in spots[1:])
        yield from (LinkNumber(a=spots[0], b=spots[-1], number=posed.name(name)),) if spots else ()
        return
    guide = next((joint for joint in posed.slides() if joint.guide == name), None)
    led = guide is not None and posed.is_located(guide.block)
    if shape in (Shape.SLOT, Shape.ROD) and guide is not None:
        yield from guide_body(posed, name, guide, shape) if led else ()
    elif len(spots) >= 2:
        yield from bar(spots)
        if guide is not None and led and is_slot(posed, name, guide):
            yield from guide_body(posed, name, guide, Shape.SLOT)
    if len(spots) > 1 or (spots and (guide is None or guide.pin in posed.at)):
        yield link_number(posed, name, shape, guide)


def _drawn(posed: Posed, links: tuple[str, ...], paper: list[Mark]) -> Iterator[tuple[str, Iterator[Mark]]]:
    for name in links:
        yield name, body(posed, name)
    for joint in posed.slides():
        if _is_late(posed, joint, links):
            yield joint.guide, _late_guide(posed, joint)
    for joint in posed.slides():
        if not {joint.guide, joint.block} & set(links):
            continue
        if is_cylinder(posed, joint):
            yield from ((part, cylinder_part(posed, part, joint)) for part in (joint.guide, joint.block))
        elif _has_block(posed, joint):
            yield joint.block, sliding_pair(posed, joint)
        elif joint.pin_in_slot and joint.guide == FRAME and posed.is_located(joint.block):
            yield joint.block, fixed_slot(posed, joint)
    for rolling in (joint for joint in posed.mech.joints if isinstance(joint, Rolling)):
        for circle in (rolling.gear, rolling.on):
            if isinstance(circle, Circle) and _turns_up(circle, rolling, links):
                yield circle.link, gear_marks(posed, circle, rolling, paper)
        both = {rolling.gear.link, rolling.on.link}
        if isinstance(rolling.on, Rack) and both & set(links) and posed.is_located(*both):
            yield rolling.on.link, rack_marks(posed, rolling, rolling.on)
    for circle in (one for one in posed.mech.idle if one.link in links):
        yield circle.link, gear_marks(posed, circle, None, paper)
    for name in dict.fromkeys(joint.block for joint in posed.slides() if _has_block(posed, joint)):
        yield name, _welded(name, paper)
    for letter in posed.hinged() | posed.rollers():
        pinned = posed.pinned(letter)
        if posed.is_located(*pinned):
            at = posed.at[letter]
            yield from ((name, _joined(posed, at, pinned, name, paper)) for name in pinned if name != FRAME)


def _rigid(marks: Sequence[Mark]) -> Iterator[Weld]:
    """Where the bars of a link leave its blocks."""
    return welds((mark for mark in marks if isinstance(mark, Block)), tuple(lines_of(marks)))


def _welded(name: str, paper: Sequence[Mark]) -> Iterator[Mark]:
    """The corners of a link's blocks on the paper that are not filled yet: a bar from one may end in another."""
    own = [mark for mark in paper if mark.owner == owner(name)]
    filled = [(mark.at + mark.off, mark.u) for mark in own if isinstance(mark, Weld)]
    for mark in _rigid(own):
        place = (mark.at + mark.off, mark.u)
        if not any(abs(place[0] - at) < NEAR and abs(place[1] - way) < NEAR for at, way in filled):
            filled.append(place)
            yield mark


def _joined(posed: Posed, at: complex, pinned: tuple[str, ...], name: str, paper: Sequence[Mark]) -> Iterator[Mark]:
    """The joining half where a line of the link on the paper runs on past a pin, which it may do as soon as a block on
    its guide is drawn; each half once."""
    own = [mark for mark in paper if mark.owner == owner(name)]
    if any(isinstance(mark, Passing) and abs(mark.at - at) < BESIDE for mark in own):
        return iter(())
    return _joining(posed, at, pinned, name, own)


def _joining(posed: Posed, at: complex, pinned: tuple[str, ...], name: str, own: Sequence[Mark]) -> Iterator[Mark]:
    """Where the link runs on past a pin: its joining half, away from the other links pinned there and from ground."""
    others = [link for link in pinned if link != name]
    ways = [spot - at for link in others if link != FRAME for spot in posed.spots(link)]
    return passing(at, tuple(lines_of(own)), ways + [-1j] * (FRAME in others))


def _is_late(posed: Posed, joint: Prismatic, links: tuple[str, ...]) -> bool:
    """Whether it guides, on a link drawn before, a block that is only now located."""
    outside = joint.guide not in links and joint.guide != FRAME
    before = outside and posed.is_located(joint.guide)
    return joint.block in links and before and not contact_replaced(posed.mech, joint.block)


def _late_guide(posed: Posed, joint: Prismatic) -> Iterator[Mark]:
    link, shape = joint.guide, posed.shape(joint.guide, Shape.SLOT)
    if shape is not Shape.BAR:
        yield from guide_body(posed, link, joint, shape)
    elif is_slot(posed, link, joint):
        yield from guide_body(posed, link, joint, Shape.SLOT)  # else the block stands on the bar that is drawn already
    if len(posed.body(link).points) == 1:
        yield link_number(posed, link, shape, joint)


def _has_block(posed: Posed, joint: Prismatic) -> bool:
    """Whether a sliding pair has its block drawn: followers, racks and pins in slots have symbols of their own."""
    if not posed.is_located(joint.guide, joint.block) or posed.shapes.get(joint.block) is Shape.PIN:
        return False
    return not _own_body(posed, joint)


def _own_body(posed: Posed, joint: Prismatic) -> bool:
    """Whether what slides is drawn as a follower, or as the rack that it is, and not as a block."""
    rack = joint.guide == FRAME and guided_rack(posed, joint.block) is not None
    return rack or guided_follower(posed, joint)


def _turns_up(circle: Circle, joint: Rolling, links: tuple[str, ...]) -> bool:
    """Whether a gear is to be drawn now: with its link, or, fixed to the frame, with the first that rolls on it."""
    return circle.link in links or (circle.link == FRAME and joint.gear.link in links)
