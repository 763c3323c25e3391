"""The kinematic diagram in its found position: links, hinges, sliders and guides with the symbols of GB/T 4460."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np

from ....board.construction import View
from ....board.paper.marks import Block, Dot, Ground, LinkNumber, Mark, Point, Role, Segment
from ....mechanism.model import FRAME, Link, Prismatic, Rack, Revolute, Rolling
from ....names import subscripted
from ....plane import nominal
from ....problem.problem import Shape
from ...desk import Desk
from .bars import bar
from .cam import contact_replaced, contacts_of
from .cam_profile import cam_body, draw_contacts, fixed_guide, guided_follower
from .cylinder import cylinder_joint, cylinder_part, is_cylinder
from .follower import face_marks, stem_marks
from .gears import draw_gears, guided_rack
from .guides import BEYOND, HALF_BLOCK, HALF_SLOT, guide_body, is_slot, late_guides, sliding_pair, spot_of


def draw_frame(desk: Desk, shapes: Mapping[str, Shape]) -> None:
    """What is there before anything moves: fixed pivots, and points of the frame from which guides are set out."""
    pinned = {j.point for j in desk.mech.joints if isinstance(j, Revolute)}
    for name, at in desk.mech.frame.items():
        if name in pinned:
            desk.board.mark(View.MECHANISM, Ground(at=at * desk.mm(1.0), down=-1j), owner="frame")
        desk.board.plot(View.MECHANISM, at * desk.mm(1.0), name, Dot.JOINT if name in pinned else Dot.POINT)


def draw_links(desk: Desk, shapes: Mapping[str, Shape], links: tuple[str, ...]) -> None:
    """The links of one group, once they are located."""
    for name in links:
        body = desk.mech.link(name)
        desk.board.mark(View.MECHANISM, *_link(desk, body, shapes.get(name, Shape.BAR)), owner=f"link {name}")
    for late in late_guides(desk, links):
        body, shape = desk.mech.link(late.guide), shapes.get(late.guide, Shape.SLOT)
        shape = Shape.SLOT if shape is Shape.BAR and is_slot(desk, body, late) else shape
        desk.board.mark(View.MECHANISM, *guide_body(desk, body, late, shape), owner=f"link {body.name}")
        if len(body.points) == 1:
            desk.board.mark(View.MECHANISM, _number(desk, body, shape, late), owner=f"link {body.name}")
    for joint in desk.mech.joints:
        if isinstance(joint, Prismatic) and {joint.guide, joint.block} & set(links) and is_cylinder(joint, shapes):
            for part in (joint.guide, joint.block):
                desk.board.mark(View.MECHANISM, *cylinder_part(desk, part, joint), owner=f"link {part}")
        elif isinstance(joint, Prismatic) and {joint.guide, joint.block} & set(links):
            drawn = {joint.guide, joint.block} <= {*desk.pose, FRAME} and shapes.get(joint.block) is not Shape.PIN
            if (
                drawn
                and not guided_follower(desk, joint)
                and (joint.guide != FRAME or guided_rack(desk, joint.block) is None)
            ):
                desk.board.mark(View.MECHANISM, *sliding_pair(desk, joint, shapes), owner=f"link {joint.block}")
    draw_gears(desk, links, shapes)
    draw_contacts(desk)
    _letters(desk, links)


def link_alone(desk: Desk, name: str, shapes: Mapping[str, Shape]) -> Iterator[Mark]:
    """The marks of one link without its neighbours: its body, its block, its lettered points."""
    body = desk.mech.link(name)
    ram = cylinder_joint(desk, name, shapes)
    yield from _link(desk, body, shapes.get(name, Shape.BAR)) if ram is None else cylinder_part(desk, name, ram)
    blocks = [
        j
        for j in desk.mech.joints
        if isinstance(j, Prismatic)
        and j.block == name
        and not guided_follower(desk, j)
        and shapes.get(name) not in (Shape.ROD, Shape.PISTON)
    ]
    for joint in blocks:
        line, pin = desk.guide_line(joint), spot_of(desk, joint.pin)
        along = complex(nominal(line.along))
        middle = complex(nominal(line.at)) + along * float((np.conj(along) * (pin - complex(nominal(line.at)))).real)
        yield Block(at=middle, along=along, on_rod=shapes.get(joint.guide) is Shape.ROD)
        if abs(pin - middle) > HALF_BLOCK:
            yield Segment(a=middle, b=pin, role=Role.LINK)
    for contact in contacts_of(desk.mech, name):
        if isinstance(contact.on, Rack) and contact.on.link == name:
            yield from face_marks(desk, contact)
        if (guide := fixed_guide(desk, name)) is not None:
            yield from (
                m for m in stem_marks(desk, contact, name, guide) if isinstance(m, Segment) and m.role is Role.LINK
            )
    hinged = _hinged(desk)
    for letter in body.points:
        if letter in desk.at and not letter.endswith("'"):
            yield Point(
                at=spot_of(desk, letter), label=subscripted(letter), dot=Dot.JOINT if letter in hinged else Dot.POINT
            )


def _hinged(desk: Desk) -> set[str]:
    """Letters of the pins that exist, without those of a contact's substitute."""
    return {
        j.point
        for j in desk.mech.joints
        if isinstance(j, Revolute) and not any(contact_replaced(desk.mech, x) for x in (j.a, j.b))
    }


def _letters(desk: Desk, links: tuple[str, ...]) -> None:
    """Letter the points of these links that have no letter yet; hinges are open circles."""
    done = {m.label for m in desk.board.marks(View.MECHANISM) if isinstance(m, Point)}
    hinged = _hinged(desk)
    contacts = {j.point for j in desk.mech.joints if isinstance(j, Rolling)}
    for link in links:
        for name in desk.letters(link):
            if subscripted(name) not in done and name in desk.at and not name.endswith("'"):
                dot = (
                    Dot.JOINT if name in hinged else (Dot.POINT if name in contacts or name not in hinged else Dot.NONE)
                )
                desk.board.plot(View.MECHANISM, desk.at[name], subscripted(name), dot)
                done.add(subscripted(name))


def _link(desk: Desk, body: Link, shape: Shape) -> Iterator[Mark]:
    spots = [complex(nominal(desk.at[p])) for p in body.points]
    if contacts_of(desk.mech, body.name):
        yield from cam_body(desk, body)
        return
    if shape in (Shape.GEAR, Shape.PIN, Shape.CYLINDER, Shape.PISTON):
        return
    if shape is Shape.BLOCK and len(spots) > 1:
        for spot in spots[1:]:
            yield Segment(a=spots[0], b=spot, role=Role.LINK)
    guide = next((j for j in desk.mech.joints if isinstance(j, Prismatic) and j.guide == body.name), None)
    if shape in (Shape.SLOT, Shape.ROD) and guide is not None:
        if guide.block == FRAME or guide.block in desk.pose:
            yield from guide_body(desk, body, guide, shape)
    elif len(spots) >= 2 and shape is not Shape.BLOCK:
        yield from bar(spots)
        if guide is not None and is_slot(desk, body, guide) and (guide.block == FRAME or guide.block in desk.pose):
            yield from guide_body(desk, body, guide, Shape.SLOT)
    if spots and shape is not Shape.BLOCK:
        if len(spots) > 1 or guide is None or guide.pin in desk.at:
            yield _number(desk, body, shape, guide)
    elif spots:
        yield LinkNumber(a=spots[0], b=spots[-1], number=body.name)


def _number(desk: Desk, body: Link, shape: Shape, guide: Prismatic | None) -> LinkNumber:
    """The number of a link beside its line, which is its guide where it has one."""
    spots = [spot_of(desk, p) for p in body.points]
    a, b = spots[0], spots[1] if len(spots) > 1 else spots[0]
    if shape in (Shape.SLOT, Shape.ROD) and guide is not None and guide.pin in desk.at:
        line = desk.guide_line(guide)
        at, along = complex(nominal(line.at)), complex(nominal(line.along))
        a, b = (
            at + along * float((np.conj(along) * (spot - at)).real) for spot in (spots[0], spot_of(desk, guide.pin))
        )
        reach = HALF_SLOT if shape is Shape.SLOT else BEYOND
        if abs(b - a) < reach:  # the block covers it: beside all of the guide that is drawn
            a, b = b - along * reach, b + along * reach
    return LinkNumber(a=a, b=b, number=body.name)
